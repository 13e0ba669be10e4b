// SPDX-License-Identifier: Apache-2.0
#include "drawing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nazori/geometry/polyline.h"
#include "nazori/geometry/svg_path.h"

namespace nazori::writing::test {

kanji::Character character(char32_t code_point, const std::vector<std::string>& strokes) {
  kanji::Character c;
  c.code_point = code_point;
  for (const auto& text : strokes) {
    const auto bar = text.find('|');
    kanji::Stroke stroke;
    stroke.type = text.substr(0, bar);
    stroke.path = text.substr(bar + 1);
    const auto path = geometry::parse_svg_path(stroke.path);
    EXPECT_TRUE(path) << text;
    if (path) stroke.line.points = geometry::flatten(*path, 0.05);
    c.strokes.push_back(std::move(stroke));
  }
  return c;
}

// clang-format off
kanji::Character rest() {
  return character(U'休', {
    "㇒|M35,16.5c0.25,1.75,0.25,4.25-0.88,6.8C28.91,35.01,22.37,46.02,10.5,60.29",
    "㇑|M26.28,42.5c0.72,1.25,1.26,3.48,1.26,4.75c0,12.75-0.07,29.88-0.26,42.25c-0.02,1.54-0.04,2.97-0.04,4.25",
    "㇐|M37.65,38.83c2.45,0.97,5.18,0.75,7.73,0.54c11.76-0.97,24.94-3.35,37.49-4.01c2.65-0.14,5.39-0.22,7.99,0.39",
    "㇑|M61.43,14c0.82,0.75,1.87,2.12,1.87,3.7c0,8.8,0.05,53.72-0.12,72.05c-0.03,2.88-0.06,4.91-0.08,5.75",
    "㇒|M62.43,38.32c0,2.18-1.1,4.31-1.9,6.04C54.57,57.4,44.96,71.84,35,78.75",
    "㇏|M64.12,38.08c4.45,8.37,16.21,25.33,24.99,33.19c1.96,1.76,4.35,4.18,6.9,5",
  });
}
kanji::Character soil() {
  return character(U'土', {
    "㇐|M26.63,50.89c1.63,0.4,4.64,0.6,6.26,0.4C43.5,50,62.12,48,75.66,46.92c2.71-0.22,4.36,0.19,5.72,0.39",
    "㇑a|M52.17,17.37c1.17,1.17,2.02,3.13,2.02,4.64c0,10.25,0.14,61.06,0.14,63.36",
    "㇐|M15.38,87.73c2.12,0.54,6.01,0.73,8.12,0.54C46,86.25,69,84.62,90.34,83.79c3.53-0.14,5.65,0.26,7.41,0.53",
  });
}
kanji::Character samurai() {
  kanji::Character made = soil();
  made.code_point = U'士';
  auto& upper = made.strokes[0].line.points;
  auto& lower = made.strokes[2].line.points;
  std::swap(upper, lower);
  const double shift = lower.front().y - upper.front().y;
  for (auto& p : upper) p.y += shift;
  for (auto& p : lower) p.y -= shift;
  return made;
}
kanji::Character three() {
  return character(U'三', {
    "㇐|M27.5,23.65c3.09,0.73,6.29,0.36,9.4,0.06c10.2-1,27-2.94,38.97-3.57c3.06-0.16,6.09-0.2,9.14,0.23",
    "㇐|M28.75,55.14c3.13,0.76,6.46,0.43,9.64,0.2c10.03-0.72,23.97-2.63,34.73-3.12c2.7-0.12,5.45-0.16,8.13,0.3",
    "㇐|M13,87.83c3.94,1.01,7.72,0.96,11.75,0.72c18.41-1.07,41.27-3.39,61.12-4.07c3.63-0.13,7.2-0.1,10.75,0.78",
  });
}
kanji::Character eye() {
  return character(U'目', {
    "㇑|M29.75,19.05c1.35,1.35,1.86,3.21,1.86,5.47c0,1.77,0.19,42.37,0.06,60.23c-0.04,4.91-0.06,8.11-0.06,8.36",
    "㇕a|M32.54,21.39c10.92-1.23,38.33-4.11,41.42-4.38c3.25-0.28,5.54,1.25,5.54,4.18c0,8.95-0.26,39.93-0.26,64.82c0,3,0.01,3.75,0.01,6",
    "㇐a|M33.05,43.64c12.45-1.51,34.83-3.51,45.18-4.09",
    "㇐a|M32.9,65.95C44.25,65,66,62.88,77.72,62.56",
    "㇐a|M33,90.5c9.75-0.5,33.25-2.5,44.79-2.53",
  });
}
// clang-format on

WrittenCharacter trace(const kanji::Character& character) {
  WrittenCharacter ink;
  for (const auto& s : character.strokes) {
    WrittenStroke& stroke = ink.strokes.emplace_back();
    for (const auto& p : s.line.points) stroke.push_back({{p.x, p.y}});
  }
  ink.box = WritingBox{{0, 0}, geometry::kGlyphSide};
  return ink;
}

WrittenStroke along(const geometry::Polyline<WritingFrame>& line, const std::vector<double>& times_s,
                    const std::vector<double>& pressures) {
  WrittenStroke stroke = geometry::written_along(line);
  for (std::size_t i = 0; i < times_s.size(); ++i) stroke.at(i).time_s = times_s[i];
  for (std::size_t i = 0; i < pressures.size(); ++i) stroke.at(i).pressure = pressures[i];
  return stroke;
}

WrittenStroke shortened(const WrittenStroke& stroke, double share) {
  const auto whole = geometry::line_of(stroke);
  const std::span<const WritingPoint> line(whole);
  const double length = geometry::arc_length(line) * share;
  geometry::Polyline<WritingFrame> out{line.front()};
  double walked = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    walked += geometry::distance(line[i - 1], line[i]);
    if (walked >= length) break;
    out.push_back(line[i]);
  }
  out.push_back(geometry::point_at(line, length));
  return along(out);
}

WrittenStroke joined(const WrittenStroke& first, const WrittenStroke& second) {
  WrittenStroke out = first;
  out.insert(out.end(), second.begin(), second.end());
  return out;
}

WrittenStroke reversed(WrittenStroke stroke) {
  std::reverse(stroke.begin(), stroke.end());
  return stroke;
}

WrittenStroke resampled(const WrittenStroke& stroke, std::size_t count) {
  return along(geometry::resample<WritingFrame>(geometry::line_of(stroke), count));
}

WrittenCharacter mapped(WrittenCharacter ink, double a, double b, double c, double d, double e, double f) {
  for (auto& s : ink.strokes)
    for (auto& p : s) p.at = {a * p.at.x + b * p.at.y + e, c * p.at.x + d * p.at.y + f};
  ink.box.reset();
  return ink;
}

WrittenCharacter shaken(WrittenCharacter ink, double sigma, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> deviate(0, sigma);
  for (auto& s : ink.strokes)
    for (auto& p : s) p.at = {p.at.x + deviate(random), p.at.y + deviate(random)};
  return ink;
}

std::vector<std::string> mistake_names(const Grade& grade) {
  static const char* const kNames[] = {"order", "reversed", "missing", "extra", "joined",
                                       "split", "wrong",    "other",   "ending"};
  std::vector<std::string> names;
  for (const auto& f : grade.mistakes)
    names.push_back(std::string(kNames[static_cast<std::size_t>(f.kind)]) + "@" + std::to_string(f.stroke));
  return names;
}

Grade graded(const WrittenCharacter& ink, const Model& model, double strictness) {
  const auto result = grade(ink, model, {strictness, false});
  EXPECT_TRUE(result) << base::to_line(result.error());
  return result ? *result : Grade{};
}

Model model_of(const kanji::Character& character) {
  auto model = Model::make(character);
  EXPECT_TRUE(model);
  return *model;
}

}  // namespace nazori::writing::test
