// SPDX-License-Identifier: Apache-2.0
// What comparing two strokes needs to know of each, and the comparison itself.
#pragma once

#include <algorithm>
#include <cmath>

#include "stroke_difference.h"

namespace nazori::writing {

/// Strokes are compared as if they were longer by this, in glyph units: a touch has no length.
inline constexpr float kLengthFloor = 0.3F;

/// A stroke apart from its shape.
struct StrokeSummary {
  float x = 0;  ///< centre
  float y = 0;
  float length = 0;
  float per_length = 0;  ///< 1 by the length
  float length_log = 0;  ///< natural logarithm of the length and the floor
  float slope = 0;       ///< sine of the slope from start to end, 0 level, 1 upright
  float inertia = 0;     ///< Samples::inertia
};

[[nodiscard]] inline float slope_of(float dx, float dy) {
  return std::abs(dy) / std::max(std::sqrt(dx * dx + dy * dy), 1e-6F);
}

[[nodiscard]] inline float per_length(float length) { return 1 / std::max(length, 1e-3F); }

[[nodiscard]] inline StrokeSummary summary_of(const Samples& s) {
  return {s.centre_x,
          s.centre_y,
          s.length,
          per_length(s.length),
          std::log(s.length + kLengthFloor),
          slope_of(s.x.back() - s.x.front(), s.y.back() - s.y.front()),
          s.inertia};
}

/// A stroke of a model, with what squared differences from it cost.
struct ModelSummary {
  StrokeSummary stroke;
  float freedom = 1;
  float of_place = 0;
  float of_shape = 0;
  float of_proportion = 0;
};

/// Squares of what is natural for a stroke of that length.
[[nodiscard]] inline ModelSummary model_summary_of(const Samples& model, float freedom) {
  const float length = model.length;
  const float place = 2.9F + 0.035F * length;
  const float size = 1.45F + 0.058F * length;
  const float proportion = (0.04F + 0.46F / (length + 4.0F)) * freedom;
  return {summary_of(model), freedom, 1 / (place * place), 0.5F / (size * size),
          0.5F / (proportion * proportion)};
}

[[nodiscard]] inline float cost_of_place(const StrokeSummary& drawn, const ModelSummary& model) {
  const float x = drawn.x - model.stroke.x;
  const float y = drawn.y - model.stroke.y;
  return (x * x + y * y) * model.of_place;
}

/// What is left of two strokes that are laid on each other by their centres.
struct CentredDifference {
  float shape = 0;       ///< square of StrokeDifference::shape
  float proportion = 0;  ///< the same
  float cost = 0;        ///< with that of the place
  bool reversed = false;
};

/// @param along  gives the sum of the products of both strokes' samples about their centres, or the same with
///               the drawn stroke walked from its end (true)
template <class Along>
[[nodiscard]] CentredDifference centred_difference(const StrokeSummary& d, const ModelSummary& model,
                                                   Along&& along) {
  constexpr float kReversedPenalty = 4.0F;
  constexpr float kEach = 1 / static_cast<float>(kSamples);
  const auto& m = model.stroke;
  const float of_place = cost_of_place(d, model);
  const float dd = d.per_length * d.per_length;
  const float mm = m.per_length * m.per_length;
  // Both from one sum: |d - m|^2 = |d|^2 + |m|^2 - 2 dm.
  const auto measure = [&](float both, bool reversed) {
    CentredDifference c;
    c.shape = std::max(d.inertia + m.inertia - 2 * both, 0.0F) * kEach;
    c.proportion =
        std::max(d.inertia * dd + m.inertia * mm - 2 * both * d.per_length * m.per_length, 0.0F) * kEach;
    c.cost = of_place + model.of_shape * c.shape + model.of_proportion * c.proportion;
    c.reversed = reversed;
    return c;
  };
  const auto forwards = measure(along(false), false);
  if (forwards.cost <= of_place + kReversedPenalty) return forwards;
  auto back = measure(along(true), true);
  back.cost += kReversedPenalty;
  return back.cost < forwards.cost ? back : forwards;
}

[[nodiscard]] inline StrokeDifference difference_of(const StrokeSummary& d, const ModelSummary& model,
                                                    const CentredDifference& centred) {
  const auto& m = model.stroke;
  StrokeDifference e;
  e.offset_x = d.x - m.x;
  e.offset_y = d.y - m.y;
  e.shape = std::sqrt(centred.shape);
  e.proportion = std::sqrt(centred.proportion);
  e.length_log = d.length_log - m.length_log;
  e.model_length = m.length;
  e.steeper = d.slope - m.slope;
  e.freedom = model.freedom;
  e.reversed = centred.reversed;
  e.cost = centred.cost;
  return e;
}

/// Of strokes that lie too far apart to be looked at.
[[nodiscard]] inline StrokeDifference difference_from_afar(const StrokeSummary& d, const ModelSummary& m) {
  StrokeDifference away;
  away.offset_x = d.x - m.stroke.x;
  away.offset_y = d.y - m.stroke.y;
  away.model_length = m.stroke.length;
  away.freedom = m.freedom;
  away.cost = cost_of_place(d, m);
  away.shape =
      std::abs(std::sqrt(d.inertia) - std::sqrt(m.stroke.inertia)) / std::sqrt(static_cast<float>(kSamples));
  away.proportion = 1;
  return away;
}

}  // namespace nazori::writing
