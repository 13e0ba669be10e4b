// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/advice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "corrections.h"
#include "nazori/geometry/frames.h"
#include "stroke_advice.h"
#include "whole_advice.h"

namespace nazori::calligraphy {
namespace {

constexpr double kLeastMove_m = 0.0001;  // nearer points of the pen do not change the form
constexpr int kMostPoints = 1000;        // of one stroke, for grading

bool contains(const RuledSquare& square, geometry::PaperPoint at) {
  return std::max(std::abs(at.x - square.middle.x), std::abs(at.y - square.middle.y)) <= square.side_m / 2;
}

/// The square in which most of a stroke lies; none where it lies in no square.
std::optional<std::size_t> square_of(const BrushStroke& stroke, std::span<const SheetModel> models) {
  std::optional<std::size_t> best;
  std::ptrdiff_t most = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const auto inside = std::count_if(stroke.begin(), stroke.end(), [&](const BrushPoint& point) {
      return contains(models[i].square, point.pen);
    });
    if (inside <= most) continue;
    most = inside;
    best = i;
  }
  return best;
}

/// The points of a stroke that say something about its form.
std::vector<const BrushPoint*> moves_of(const BrushStroke& stroke) {
  const std::size_t step = stroke.size() / kMostPoints + 1;
  std::vector<const BrushPoint*> moves;
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    const BrushPoint& point = stroke[i];
    const bool is_end = i + 1 == stroke.size();
    const bool is_new = moves.empty() || geometry::distance(moves.back()->pen, point.pen) > kLeastMove_m;
    if (is_end || (i % step == 0 && is_new)) moves.push_back(&point);
  }
  return moves;
}

writing::WrittenCharacter as_writing(std::span<const BrushStroke* const> strokes, const RuledSquare& square) {
  writing::WrittenCharacter ink;
  for (const BrushStroke* stroke : strokes) {
    writing::WrittenStroke line;
    // Paper counts upwards, writing downwards.
    for (const BrushPoint* point : moves_of(*stroke))
      line.push_back({writing::WritingPoint{point->pen.x, -point->pen.y}, point->time_s});
    ink.strokes.push_back(std::move(line));
  }
  const double half = square.side_m / 2;
  ink.box = {{square.middle.x - half, -square.middle.y - half}, square.side_m};
  return ink;
}

geometry::WrittenStrokes<geometry::GlyphFrame> in_glyph_units(std::span<const BrushStroke* const> strokes,
                                                              const RuledSquare& square) {
  geometry::WrittenStrokes<geometry::GlyphFrame> ink;
  std::optional<double> zero_s;
  const double half = square.side_m / 2;
  const double scale = geometry::kGlyphSide / square.side_m;
  for (const BrushStroke* stroke : strokes) {
    auto& line = ink.emplace_back();
    for (const BrushPoint* point : moves_of(*stroke)) {
      if (!zero_s) zero_s = point->time_s;
      const geometry::GlyphPoint at{(point->pen.x - square.middle.x + half) * scale,
                                    (square.middle.y + half - point->pen.y) * scale};
      line.push_back({at, point->time_s - *zero_s, point->pressure, {}});
    }
  }
  return ink;
}

bool is_hiragana(char32_t c) { return c >= 0x3041 && c <= 0x309F; }

/// The character with the lines of the model.
kanji::Character in_lines_of(const SheetModel& model) {
  kanji::Character form = model.character;
  for (std::size_t i = 0; i < model.strokes.size() && i < form.strokes.size(); ++i) {
    auto& points = form.strokes[i].line.points;
    points.clear();
    for (const carving::GroovePoint& point : model.strokes[i]) points.push_back(point.at);
  }
  return form;
}

/// Judges the strokes of one square.
CharacterAdvice advise_square(std::span<const BrushStroke* const> strokes, const SheetInk& ink,
                              const SheetModel& model, const AdviceOptions& options) {
  CharacterAdvice result;
  result.character = model.character.code_point;
  result.written = static_cast<int>(strokes.size());
  if (strokes.empty()) return result;
  result.ink = in_glyph_units(strokes, model.square);
  const auto form = writing::Model::make(in_lines_of(model));
  if (!form) return result;
  auto grade = writing::grade(as_writing(strokes, model.square), *form);
  if (!grade) return result;

  const auto lines = model.character.lines();
  WholePairs whole{.square = model.square, .model = strokes_of(model)};
  whole.written.resize(whole.model.size());
  int matched = 0;
  std::vector<bool> is_right(whole.model.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const auto& verdict = grade->strokes[i];
    if (!verdict.matched || static_cast<std::size_t>(*verdict.matched) >= whole.model.size()) continue;
    const auto number = static_cast<std::size_t>(*verdict.matched);
    if (!whole.written[number]) ++matched;
    // What runs the other way is a mistake already; its start and ending are not where they are looked for.
    whole.written[number] = strokes[i];
    is_right[number] = !verdict.reversed;
  }
  result.is_comparable = 2 * matched >= static_cast<int>(whole.model.size());
  if (!result.is_comparable) {
    result.grade = std::move(*grade);
    return result;
  }

  for (std::size_t number = 0; number < whole.model.size(); ++number) {
    if (!whole.written[number] || !is_right[number]) continue;
    const StrokePair pair{whole.written[number],    &whole.model[number], lines[number].ending,
                          static_cast<int>(number), model.square.side_m,  is_hiragana(result.character)};
    const auto advice = advice_on(pair);
    result.advice.insert(result.advice.end(), advice.begin(), advice.end());
    if (advice.empty() && is_near(pair)) result.good.push_back(pair.number);
  }
  add_whole_advice(whole, ink, options, result);
  const auto is_blamed = [&result, &grade](int number) {
    const auto names = [number](const writing::Mistake& mistake) {
      return std::find(mistake.model.begin(), mistake.model.end(), number) != mistake.model.end();
    };
    return std::any_of(
               result.advice.begin(), result.advice.end(),
               [number](const Advice& one) { return one.stroke == number || one.second == number; }) ||
           std::any_of(grade->mistakes.begin(), grade->mistakes.end(), names);
  };
  std::erase_if(result.good, is_blamed);
  result.is_good = result.advice.empty() && grade->accepted;
  result.grade = std::move(*grade);
  result.marks = marks_for(whole, result);
  return result;
}

}  // namespace

std::vector<ModelStroke> strokes_of(const SheetModel& model) {
  return model.strokes.empty() ? model_strokes(model.character.lines(), model.square)
                               : model_strokes(model.strokes, model.square);
}

std::vector<CharacterAdvice> advise(std::span<const BrushStroke> strokes, const SheetInk& ink,
                                    std::span<const SheetModel> models, const AdviceOptions& options) {
  std::vector<std::vector<const BrushStroke*>> in_square(models.size());
  for (const BrushStroke& stroke : strokes)
    if (const auto square = square_of(stroke, models)) in_square[*square].push_back(&stroke);
  std::vector<CharacterAdvice> all;
  for (std::size_t i = 0; i < models.size(); ++i)
    all.push_back(advise_square(in_square[i], ink, models[i], options));
  return all;
}

}  // namespace nazori::calligraphy
