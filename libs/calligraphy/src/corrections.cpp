// SPDX-License-Identifier: Apache-2.0
#include "corrections.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "stroke_advice.h"

namespace nazori::calligraphy {
namespace {

using Kind = CorrectionMark::Kind;
using geometry::PaperPoint;

// In sides of the square.
constexpr double kStartArrow = 0.11;
constexpr double kCircle = 0.055;
constexpr double kLargeCircle = 0.49;

/// Strokes of the model that are drawn over the writing: those of mistakes, and of a wrong width or ending.
std::set<int> outlined(const CharacterAdvice& advice) {
  std::set<int> strokes;
  for (const auto& mistake : advice.grade->mistakes) {
    const bool is_of_form = mistake.kind != kanji::MistakeKind::order;
    if (is_of_form) strokes.insert(mistake.model.begin(), mistake.model.end());
    if (mistake.kind == kanji::MistakeKind::missing) strokes.insert(mistake.stroke);
  }
  for (const Advice& one : advice.advice) {
    switch (one.kind) {
      case AdviceKind::no_stop:
      case AdviceKind::no_hook:
      case AdviceKind::no_sweep:
      case AdviceKind::thin:
      case AdviceKind::thick:
        strokes.insert(one.stroke);
        break;
      default:
        break;
    }
  }
  return strokes;
}

CorrectionMark arrow(int stroke, PaperPoint from, PaperPoint to) {
  CorrectionMark mark{.kind = Kind::arrow, .stroke = stroke};
  mark.from = from;
  mark.to = to;
  return mark;
}

CorrectionMark circle(int stroke, PaperPoint middle, double radius_m) {
  CorrectionMark mark{.kind = Kind::circle, .stroke = stroke};
  mark.to = middle;
  mark.radius_m = radius_m;
  return mark;
}

/// The way on which the character belongs, from the advice about its centre of gravity.
PaperPoint way_to_centre(const CharacterAdvice& advice) {
  PaperPoint way;
  for (const Advice& one : advice.advice) {
    if (one.kind == AdviceKind::too_far_left) way.x += one.amount;
    if (one.kind == AdviceKind::too_far_right) way.x -= one.amount;
    if (one.kind == AdviceKind::too_low) way.y += one.amount;
    if (one.kind == AdviceKind::too_high) way.y -= one.amount;
  }
  return way;
}

}  // namespace

std::vector<CorrectionMark> marks_for(const WholePairs& pairs, const CharacterAdvice& advice) {
  const double side_m = pairs.square.side_m;
  std::vector<CorrectionMark> marks;
  const auto model = [&pairs](int number) -> const ModelStroke& {
    return pairs.model[static_cast<std::size_t>(number)];
  };
  const auto written = [&pairs](int number) { return pairs.written[static_cast<std::size_t>(number)]; };
  for (const int number : outlined(advice)) {
    if (number < 0 || static_cast<std::size_t>(number) >= pairs.model.size()) continue;
    marks.push_back({.kind = Kind::outline, .stroke = number, .outline = outline_of(model(number))});
  }
  const auto neighbours = neighbours_in(pairs.model, side_m);
  for (const Advice& one : advice.advice) {
    if (one.kind == AdviceKind::start_turned || one.kind == AdviceKind::hidden_tip) {
      const double angle = start_direction(even(model(one.stroke)), side_m);
      const PaperPoint way = PaperPoint{std::cos(angle), std::sin(angle)} * (kStartArrow * side_m);
      const PaperPoint start = written(one.stroke)->front().pen;
      marks.push_back(arrow(one.stroke, start, start + way));
    }
    if (one.kind == AdviceKind::wide_gap || one.kind == AdviceKind::narrow_gap) {
      const auto pair = std::find_if(neighbours.begin(), neighbours.end(), [&one](const Neighbours& two) {
        return two.first == one.stroke && two.second == one.second;
      });
      if (pair == neighbours.end()) continue;
      const PaperPoint at = middle_of(*written(one.second));
      const double right =
          geometry::dot(middle_of(model(one.second)) - middle_of(model(one.stroke)), pair->across);
      const double drawn = geometry::dot(at - middle_of(*written(one.stroke)), pair->across);
      marks.push_back(arrow(one.second, at, at + pair->across * (right - drawn)));
    }
  }
  const PaperPoint way = way_to_centre(advice);
  if (geometry::length(way) > 0)
    marks.push_back(arrow(-1, pairs.square.middle - way * side_m, pairs.square.middle));
  if (advice.is_good) {
    marks.push_back(circle(-1, pairs.square.middle, kLargeCircle * side_m));
    return marks;
  }
  for (const int number : advice.good)
    marks.push_back(circle(number, middle_of(*written(number)), kCircle * side_m));
  return marks;
}

}  // namespace nazori::calligraphy
