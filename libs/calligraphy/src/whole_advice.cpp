// SPDX-License-Identifier: Apache-2.0
#include "whole_advice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "nazori/geometry/polyline.h"
#include "stroke_advice.h"

namespace nazori::calligraphy {
namespace {

using geometry::PaperPoint;

constexpr double kFlat = 1.3, kModelVaries = 1.8;  // thick over thin
constexpr double kLeastCovered = 0.7;
constexpr double kMostOutside = 0.3;
constexpr double kBleeds = 0.012;    // ink so near to the model is no fault [sides]
constexpr double kOffCentre = 0.04;  // [sides]
constexpr double kLarge = 1.2, kSmall = 0.8;
constexpr double kWideGap = 1.35, kNarrowGap = 0.65;
constexpr double kLeastGapChange = 0.03;  // [sides]
constexpr double kParallel = 20 * std::numbers::pi / 180;
constexpr double kStraight = 0.9;         // straight way over length
constexpr double kLeastNeighbour = 0.12;  // length [sides]
constexpr double kOverlap = 0.5;          // of the shorter one
constexpr double kRoom = 0.1;             // around the square, in which ink belongs to it [sides]

/// Thick over thin: of ten parts of the ink, the second thickest over the second thinnest.
double variation(std::vector<double> widths) {
  std::sort(widths.begin(), widths.end());
  const std::size_t tenth = widths.size() / 10;
  return widths[widths.size() - 1 - tenth] / std::max(widths[tenth], 1e-9);
}

std::optional<Advice> flat_advice(const WholePairs& pairs) {
  std::vector<double> written, model;
  const auto add = [](std::vector<double>& to, const EvenStroke& stroke) {
    to.insert(to.end(), stroke.half_width_m.begin(), stroke.half_width_m.end());
  };
  for (std::size_t i = 0; i < pairs.model.size(); ++i) {
    if (!pairs.written[i] || width_from(*pairs.written[i]) != WidthFrom::hand) continue;
    add(written, even(*pairs.written[i]));
    add(model, even(pairs.model[i]));
  }
  if (written.empty()) return {};
  const double ratio = variation(written);
  if (ratio >= kFlat || variation(model) < kModelVaries) return {};
  return Advice{.kind = AdviceKind::flat_width, .amount = ratio};
}

/// Where ink lies.
struct Mass {
  double cells = 0;
  PaperPoint centre;
};

template <class Take>
void for_each_cell(const SheetInk& ink, const RuledSquare& square, Take take) {
  const double half = (0.5 + kRoom) * square.side_m;
  for (int row = 0; row < ink.size; ++row)
    for (int column = 0; column < ink.size; ++column) {
      if (!ink.has(column, row)) continue;
      const PaperPoint at = ink.place(column, row);
      if (std::max(std::abs(at.x - square.middle.x), std::abs(at.y - square.middle.y)) <= half)
        take(column, row, at);
    }
}

Mass mass_of(const SheetInk& ink, const RuledSquare& square) {
  Mass mass;
  for_each_cell(ink, square, [&mass](int /*column*/, int /*row*/, PaperPoint at) {
    mass.cells += 1;
    mass.centre = mass.centre + at;
  });
  if (mass.cells > 0) mass.centre = mass.centre * (1 / mass.cells);
  return mass;
}

void add_coverage(const WholePairs& pairs, const SheetInk& ink, const AdviceOptions& options,
                  CharacterAdvice& result) {
  const double side_m = pairs.square.side_m;
  const SheetInk model = ink_of(pairs.model, ink.size);
  const Mass written = mass_of(ink, pairs.square), wanted = mass_of(model, pairs.square);
  if (written.cells <= 0 || wanted.cells <= 0) return;
  const PaperPoint off = (written.centre - wanted.centre) * (1 / side_m);

  SheetInk near = ink_of(pairs.model, ink.size, kBleeds * side_m);
  // Beside the model the place does not count: the ink is looked for where it would lie above the model.
  const int right = options.traced ? 0 : static_cast<int>(std::lround(off.x * side_m / ink.cell_m()));
  const int down = options.traced ? 0 : static_cast<int>(std::lround(-off.y * side_m / ink.cell_m()));
  const auto has = [](const SheetInk& of, int column, int row) {
    return column >= 0 && row >= 0 && column < of.size && row < of.size && of.has(column, row);
  };
  double covered = 0, outside = 0;
  for_each_cell(model, pairs.square, [&](int column, int row, PaperPoint /*at*/) {
    covered += has(ink, column + right, row + down) ? 1 : 0;
  });
  for_each_cell(ink, pairs.square, [&](int column, int row, PaperPoint /*at*/) {
    outside += has(near, column - right, row - down) ? 0 : 1;
  });
  result.covered = covered / wanted.cells;
  result.outside = outside / written.cells;
  // Thin strokes cover little, and a mouse cannot press more; missing strokes are named anyway.
  const bool by_hand = std::all_of(pairs.written.begin(), pairs.written.end(), [](const BrushStroke* stroke) {
    return stroke == nullptr || width_from(*stroke) == WidthFrom::hand;
  });
  if (by_hand && result.covered < kLeastCovered)
    result.advice.push_back({.kind = AdviceKind::uncovered, .amount = result.covered});
  if (result.outside > kMostOutside)
    result.advice.push_back({.kind = AdviceKind::outside, .amount = result.outside});
  if (std::abs(off.x) > kOffCentre)
    result.advice.push_back({.kind = off.x < 0 ? AdviceKind::too_far_left : AdviceKind::too_far_right,
                             .amount = std::abs(off.x)});
  if (std::abs(off.y) > kOffCentre)
    result.advice.push_back(
        {.kind = off.y < 0 ? AdviceKind::too_low : AdviceKind::too_high, .amount = std::abs(off.y)});
}

/// The diagonal of the box around lines.
class Box {
 public:
  void add(PaperPoint at) {
    low_ = {std::min(low_.x, at.x), std::min(low_.y, at.y)};
    high_ = {std::max(high_.x, at.x), std::max(high_.y, at.y)};
  }
  [[nodiscard]] double diagonal() const { return std::max(geometry::distance(low_, high_), 1e-9); }

 private:
  PaperPoint low_{1e9, 1e9}, high_{-1e9, -1e9};
};

/// The size of what is written over that of the same strokes of the model.
double scale_of(const WholePairs& pairs) {
  Box written, model;
  for (std::size_t i = 0; i < pairs.model.size(); ++i) {
    if (!pairs.written[i]) continue;
    for (const BrushPoint& point : *pairs.written[i]) written.add(point.pen);
    for (const PaperPoint at : pairs.model[i].points) model.add(at);
  }
  return written.diagonal() / model.diagonal();
}

/// A stroke that can stand beside another: nearly straight, and long enough.
struct Bar {
  PaperPoint from, to;
  double length_m = 0;
};

std::optional<Bar> bar_of(const ModelStroke& stroke, double side_m) {
  const double length = geometry::arc_length(std::span<const PaperPoint>(stroke.points));
  const Bar bar{stroke.points.front(), stroke.points.back(),
                geometry::distance(stroke.points.front(), stroke.points.back())};
  if (bar.length_m < kLeastNeighbour * side_m || bar.length_m < kStraight * length) return {};
  return bar;
}

}  // namespace

PaperPoint middle_of(const BrushStroke& stroke) { return even(stroke).at[EvenStroke::kPoints / 2]; }
PaperPoint middle_of(const ModelStroke& stroke) { return even(stroke).at[EvenStroke::kPoints / 2]; }

std::vector<Neighbours> neighbours_in(const std::vector<ModelStroke>& model, double side_m) {
  struct Candidate {
    Neighbours pair;
    double gap_m;
  };
  std::vector<Candidate> candidates;
  for (std::size_t a = 0; a < model.size(); ++a) {
    const auto one = bar_of(model[a], side_m);
    if (!one) continue;
    const PaperPoint way = (one->to - one->from) * (1 / one->length_m);
    for (std::size_t b = a + 1; b < model.size(); ++b) {
      const auto other = bar_of(model[b], side_m);
      if (!other) continue;
      if (geometry::angle_between(way, other->to - other->from) > kParallel) continue;
      double from = geometry::dot(other->from - one->from, way);
      double to = geometry::dot(other->to - one->from, way);
      if (from > to) std::swap(from, to);
      const double overlap = std::min(to, one->length_m) - std::max(from, 0.0);
      if (overlap < kOverlap * std::min(one->length_m, other->length_m)) continue;
      PaperPoint across{-way.y, way.x};
      double gap = geometry::dot(middle_of(model[b]) - middle_of(model[a]), across);
      if (gap < 0) across = across * -1.0;
      gap = std::abs(gap);
      candidates.push_back({{static_cast<int>(a), static_cast<int>(b), across}, gap});
    }
  }
  // The outer pair of three bars is none: its gap is the sum of the two others.
  std::vector<Neighbours> kept;
  for (const Candidate& wide : candidates) {
    const auto joins = [&wide, &candidates](const Candidate& narrow) {
      if (narrow.gap_m >= wide.gap_m) return false;
      const bool at_first = narrow.pair.first == wide.pair.first || narrow.pair.second == wide.pair.first;
      if (!at_first) return false;
      const int between = narrow.pair.first == wide.pair.first ? narrow.pair.second : narrow.pair.first;
      return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& rest) {
        return rest.gap_m < wide.gap_m &&
               ((rest.pair.first == between && rest.pair.second == wide.pair.second) ||
                (rest.pair.second == between && rest.pair.first == wide.pair.second));
      });
    };
    if (std::none_of(candidates.begin(), candidates.end(), joins)) kept.push_back(wide.pair);
  }
  return kept;
}

void add_whole_advice(const WholePairs& pairs, const SheetInk& ink, const AdviceOptions& options,
                      CharacterAdvice& result) {
  if (const auto flat = flat_advice(pairs)) result.advice.push_back(*flat);
  add_coverage(pairs, ink, options, result);
  const double scale = scale_of(pairs);
  if (scale > kLarge) result.advice.push_back({.kind = AdviceKind::too_large, .amount = scale});
  if (scale < kSmall) result.advice.push_back({.kind = AdviceKind::too_small, .amount = scale});
  const double side_m = pairs.square.side_m;
  for (const Neighbours& pair : neighbours_in(pairs.model, side_m)) {
    const auto first = static_cast<std::size_t>(pair.first), second = static_cast<std::size_t>(pair.second);
    if (!pairs.written[first] || !pairs.written[second]) continue;
    const double model =
        geometry::dot(middle_of(pairs.model[second]) - middle_of(pairs.model[first]), pair.across);
    // A character that is large as a whole has large gaps; that is said once.
    const double gap =
        geometry::dot(middle_of(*pairs.written[second]) - middle_of(*pairs.written[first]), pair.across) /
        scale;
    const double ratio = gap / std::max(model, 1e-9);
    if (std::abs(gap - model) < kLeastGapChange * side_m) continue;
    if (ratio > kWideGap)
      result.advice.push_back({AdviceKind::wide_gap, pair.first, pair.second, StrokePart::middle, ratio});
    if (ratio < kNarrowGap)
      result.advice.push_back({AdviceKind::narrow_gap, pair.first, pair.second, StrokePart::middle, ratio});
  }
}

}  // namespace nazori::calligraphy
