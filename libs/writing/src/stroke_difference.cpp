// SPDX-License-Identifier: Apache-2.0
#include "stroke_difference.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {
namespace {

struct Moments {
  float shape;
  float proportion;
};

/// Both from one sum: |d - m|^2 = |d|^2 + |m|^2 - 2 dm. `backwards` walks the drawn samples from the end.
template <bool backwards>
Moments distances(const Samples& d, const Samples& m) {
  float both = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t j = backwards ? kSamples - 1 - k : k;
    both += (d.x[j] - d.centre_x) * (m.x[k] - m.centre_x) + (d.y[j] - d.centre_y) * (m.y[k] - m.centre_y);
  }
  constexpr auto kCount = static_cast<float>(kSamples);
  const float fd = 1 / std::max(d.length, 1e-3F);
  const float fm = 1 / std::max(m.length, 1e-3F);
  const float shape = d.inertia + m.inertia - 2 * both;
  const float proportion = d.inertia * fd * fd + m.inertia * fm * fm - 2 * both * fd * fm;
  return {std::sqrt(std::max(shape, 0.0F) / kCount), std::sqrt(std::max(proportion, 0.0F) / kCount)};
}

float cost_of(const StrokeDifference& e) {
  const float length = e.model_length;
  const float place = 2.9F + 0.035F * length;
  const float size = 1.45F + 0.058F * length;
  const float proportion = (0.04F + 0.46F / (length + 4.0F)) * e.freedom;
  return (e.offset_x * e.offset_x + e.offset_y * e.offset_y) / (place * place) +
         0.5F * e.shape * e.shape / (size * size) +
         0.5F * e.proportion * e.proportion / (proportion * proportion);
}

/// Sine of the slope from start to end.
float slope(const Samples& s) {
  const float dx = s.x.back() - s.x.front();
  const float dy = s.y.back() - s.y.front();
  return std::abs(dy) / std::max(std::sqrt(dx * dx + dy * dy), 1e-6F);
}

StrokeDifference compare_samples(const Samples& d, const Samples& m, float freedom) {
  constexpr float kFloor = 0.3F;
  constexpr float kReversedPenalty = 4.0F;
  StrokeDifference e;
  e.offset_x = d.centre_x - m.centre_x;
  e.offset_y = d.centre_y - m.centre_y;
  e.model_length = m.length;
  e.freedom = freedom;
  e.length_log = std::log((d.length + kFloor) / (m.length + kFloor));
  e.steeper = slope(d) - slope(m);
  const float of_place = cost_of(e);
  const auto forward = distances<false>(d, m);
  e.shape = forward.shape;
  e.proportion = forward.proportion;
  e.cost = cost_of(e);
  if (e.cost <= of_place + kReversedPenalty) return e;
  StrokeDifference back = e;
  const auto backward = distances<true>(d, m);
  back.shape = backward.shape;
  back.proportion = backward.proportion;
  back.reversed = true;
  back.cost = cost_of(back) + kReversedPenalty;
  return back.cost < e.cost ? back : e;
}

}  // namespace

StrokeDifference compare(const Shape& drawn, const Shape& model, float far) {
  StrokeDifference away;
  away.offset_x = drawn.whole.centre_x - model.whole.centre_x;
  away.offset_y = drawn.whole.centre_y - model.whole.centre_y;
  away.model_length = model.whole.length;
  away.freedom = model.freedom;
  away.cost = cost_of(away);
  if (away.cost > far) {
    away.shape = std::abs(std::sqrt(drawn.whole.inertia) - std::sqrt(model.whole.inertia)) /
                 std::sqrt(static_cast<float>(kSamples));
    away.proportion = 1;
    return away;
  }
  auto best = compare_samples(drawn.whole, model.whole, model.freedom);
  const auto take = [&best](const StrokeDifference& other) {
    if (other.cost < best.cost) best = other;
  };
  if (model.body) take(compare_samples(drawn.whole, *model.body, model.freedom));
  if (drawn.body) take(compare_samples(*drawn.body, model.whole, model.freedom));
  if (drawn.body && model.body) take(compare_samples(*drawn.body, *model.body, model.freedom));
  return best;
}

}  // namespace nazori::writing
