// SPDX-License-Identifier: Apache-2.0
#include "stroke_difference.h"

#include "stroke_summary.h"

namespace nazori::writing {
namespace {

/// `backwards` walks the drawn samples from the end.
template <bool backwards>
float sum_of_products(const Samples& d, const Samples& m) {
  float both = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t j = backwards ? kSamples - 1 - k : k;
    both += (d.x[j] - d.centre_x) * (m.x[k] - m.centre_x) + (d.y[j] - d.centre_y) * (m.y[k] - m.centre_y);
  }
  return both;
}

StrokeDifference compare_samples(const Samples& d, const Samples& m, float freedom) {
  const auto drawn = summary_of(d);
  const auto model = model_summary_of(m, freedom);
  return difference_of(drawn, model, centred_difference(drawn, model, [&](bool backwards) {
                         return backwards ? sum_of_products<true>(d, m) : sum_of_products<false>(d, m);
                       }));
}

}  // namespace

StrokeDifference compare(const Shape& drawn, const Shape& model, float far) {
  const auto d = summary_of(drawn.whole);
  const auto m = model_summary_of(model.whole, model.freedom);
  if (cost_of_place(d, m) > far) return difference_from_afar(d, m);
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
