// SPDX-License-Identifier: Apache-2.0
// Models, and writings of them whose truth is known.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "nazori/calligraphy/advice.h"
#include "nazori/geometry/svg_path.h"

namespace nazori::calligraphy::test {

using geometry::PaperPoint;
using kanji::StrokeEnding;

struct PlainStroke {
  const char* path;
  StrokeEnding ending;
};
inline kanji::Character character(char32_t code_point, const std::vector<PlainStroke>& strokes) {
  kanji::Character made;
  made.code_point = code_point;
  for (const auto& [path, ending] : strokes) {
    kanji::Stroke stroke;
    stroke.path = path;
    stroke.line.points = geometry::flatten(geometry::parse_svg_path(path).value(), 0.05);
    stroke.line.ending = ending;
    made.strokes.push_back(std::move(stroke));
  }
  return made;
}

// KanjiVG 20220427 (Ulrich Apel, CC BY-SA 3.0), main forms.
inline kanji::Character rest() {
  return character(
      U'休',
      {{"M35,16.5c0.25,1.75,0.25,4.25-0.88,6.8C28.91,35.01,22.37,46.02,10.5,60.29", StrokeEnding::taper},
       {"M26.28,42.5c0.72,1.25,1.26,3.48,1.26,4.75c0,12.75-0.07,29.88-0.26,42.25c-0.02,1.54-0.04,2.97-0.04,"
        "4.25",
        StrokeEnding::stop},
       {"M37.65,38.83c2.45,0.97,5.18,0.75,7.73,0.54c11.76-0.97,24.94-3.35,37.49-4.01c2.65-0.14,5.39-0.22,7."
        "99,0.39",
        StrokeEnding::stop},
       {"M61.43,14c0.82,0.75,1.87,2.12,1.87,3.7c0,8.8,0.05,53.72-0.12,72.05c-0.03,2.88-0.06,4.91-0.08,5.75",
        StrokeEnding::stop},
       {"M62.43,38.32c0,2.18-1.1,4.31-1.9,6.04C54.57,57.4,44.96,71.84,35,78.75", StrokeEnding::taper},
       {"M64.12,38.08c4.45,8.37,16.21,25.33,24.99,33.19c1.96,1.76,4.35,4.18,6.9,5", StrokeEnding::taper}});
}
inline kanji::Character three() {
  return character(
      U'三', {{"M27.5,23.65c3.09,0.73,6.29,0.36,9.4,0.06c10.2-1,27-2.94,38.97-3.57c3.06-0.16,6.09-0.2,9.14,"
               "0.23",
               StrokeEnding::stop},
              {"M28.75,55.14c3.13,0.76,6.46,0.43,9.64,0.2c10.03-0.72,23.97-2.63,34.73-3.12c2.7-0.12,5.45-0."
               "16,8.13,0.3",
               StrokeEnding::stop},
              {"M13,87.83c3.94,1.01,7.72,0.96,11.75,0.72c18.41-1.07,41.27-3.39,61.12-4.07c3.63-0.13,7.2-0."
               "1,10.75,0.78",
               StrokeEnding::stop}});
}
/// A character of one straight bar and a hook: 亅 with plain numbers.
inline kanji::Character hook() { return character(U'亅', {{"M60,15L60,90L45,78", StrokeEnding::hook}}); }

/// Which points a hand writes for a stroke, and when.
using Change = std::function<void(BrushStroke&)>;

inline constexpr double kSpeed_m_s = 0.06;

/// The time of each point, for a speed along the stroke. @param speed  by the share of the length.
inline void pace(BrushStroke& stroke, const std::function<double(double)>& speed) {
  double length = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i)
    length += geometry::distance(stroke[i - 1].pen, stroke[i].pen);
  double along = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    const double way = geometry::distance(stroke[i - 1].pen, stroke[i].pen);
    along += way;
    stroke[i].time_s = stroke[i - 1].time_s + way / speed(along / length);
  }
}

/// The models of a character written exactly, all strokes at one speed.
inline std::vector<BrushStroke> exactly(const SheetModel& model) {
  std::vector<BrushStroke> written;
  double begins_s = 0;
  for (const ModelStroke& shape : strokes_of(model)) {
    BrushStroke stroke;
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      BrushPoint point;
      point.pen = point.at = shape.points[i];
      point.half_width_m = shape.half_width_m[i];
      stroke.push_back(point);
    }
    stroke.front().time_s = begins_s;
    pace(stroke, [](double) { return kSpeed_m_s; });
    begins_s = stroke.back().time_s + 1;
    written.push_back(std::move(stroke));
  }
  return written;
}

inline void move(BrushStroke& stroke, PaperPoint by) {
  for (BrushPoint& point : stroke) {
    point.pen = point.pen + by;
    point.at = point.at + by;
  }
}

/// The first part of a stroke turned about its start; what follows is shifted, so that nothing breaks.
inline void turn_start(BrushStroke& stroke, double angle_rad, double over_m) {
  const PaperPoint start = stroke.front().pen;
  double along = 0;
  PaperPoint shift;
  PaperPoint before = start;
  for (BrushPoint& point : stroke) {
    along += geometry::distance(before, point.pen);
    before = point.pen;
    if (along <= over_m) {
      const PaperPoint way = point.pen - start;
      const PaperPoint turned{way.x * std::cos(angle_rad) - way.y * std::sin(angle_rad),
                              way.x * std::sin(angle_rad) + way.y * std::cos(angle_rad)};
      shift = start + turned - point.pen;
    }
    point.pen = point.pen + shift;
    point.at = point.at + shift;
  }
}

/// The advice on strokes whose ink is their own shape.
inline CharacterAdvice advice_for(const std::vector<BrushStroke>& strokes, const SheetModel& model,
                                  const AdviceOptions& options = {}) {
  std::vector<ModelStroke> shapes;
  for (const BrushStroke& stroke : strokes) shapes.push_back(shape_of(stroke));
  constexpr int kCells = 256;
  return advise(strokes, ink_of(shapes, kCells), std::vector{model}, options).front();
}

/// "flat_width", "no_stop@2", "wide_gap@0-1".
inline std::vector<std::string> names(const CharacterAdvice& result) {
  static constexpr const char* kNames[] = {
      "start_turned", "hidden_tip", "no_stop",   "no_hook",   "no_sweep", "thin",         "thick",
      "flat_width",   "hasty",      "halting",   "uncovered", "outside",  "too_far_left", "too_far_right",
      "too_high",     "too_low",    "too_large", "too_small", "wide_gap", "narrow_gap"};
  std::vector<std::string> all;
  for (const Advice& one : result.advice) {
    std::string name = kNames[static_cast<std::size_t>(one.kind)];
    if (one.stroke >= 0) name += '@' + std::to_string(one.stroke);
    if (one.second >= 0) name += '-' + std::to_string(one.second);
    all.push_back(std::move(name));
  }
  return all;
}

inline bool has(const CharacterAdvice& result, const std::string& name) {
  const auto all = names(result);
  return std::find(all.begin(), all.end(), name) != all.end();
}

}  // namespace nazori::calligraphy::test
