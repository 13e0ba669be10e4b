// SPDX-License-Identifier: Apache-2.0
#include "course.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nazori::writing {
namespace {

constexpr std::size_t kSteps = kSamples - 1;

/// Unit vectors of the steps, first to last.
struct Directions {
  std::array<float, kSteps> x{};
  std::array<float, kSteps> y{};
};

Directions directions(const Samples& s, bool backwards) {
  Directions d;
  for (std::size_t k = 0; k < kSteps; ++k) {
    const std::size_t from = backwards ? kSteps - k : k;
    const std::size_t to = backwards ? kSteps - k - 1 : k + 1;
    const float x = s.x[to] - s.x[from];
    const float y = s.y[to] - s.y[from];
    const float inverse = 1 / std::max(std::sqrt(x * x + y * y), 1e-6F);
    d.x[k] = x * inverse;
    d.y[k] = y * inverse;
  }
  return d;
}

float chord_turn(const Samples& drawn, const Samples& model, bool reversed) {
  const float sign = reversed ? -1.0F : 1.0F;
  const float dx = sign * (drawn.x.back() - drawn.x.front());
  const float dy = sign * (drawn.y.back() - drawn.y.front());
  const float mx = model.x.back() - model.x.front();
  const float my = model.y.back() - model.y.front();
  const float straight = std::min(std::sqrt(dx * dx + dy * dy) / std::max(drawn.length, 1e-3F),
                                  std::sqrt(mx * mx + my * my) / std::max(model.length, 1e-3F));
  return std::abs(std::atan2(mx * dy - my * dx, mx * dx + my * dy)) * straight;
}

/// The cheapest way through the table of differences from both starts to both ends. A step of one line alone
/// costs half of its difference, and a little for the shift.
float aligned(const Directions& d, const Directions& m) {
  constexpr std::size_t kBand = 5;
  constexpr float kShift = 0.05F;
  constexpr float kOutside = 1e9F;
  std::array<float, kSteps + 1> row{};  // one more, so that index 0 is outside
  row.fill(kOutside);
  row[0] = 0;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const std::size_t first = i > kBand ? i - kBand : 0;
    const std::size_t last = std::min(kSteps - 1, i + kBand);
    float diagonal = row[first];
    row[first] = kOutside;
    for (std::size_t j = first; j <= last; ++j) {
      const float difference = 1 - (d.x[i] * m.x[j] + d.y[i] * m.y[j]);
      const float alone = 0.5F * difference + kShift;
      const float above = row[j + 1];
      row[j + 1] = std::min({diagonal + difference, row[j] + alone, above + alone});
      diagonal = above;
    }
  }
  // The same directions can give a little less than 0.
  return std::max(row[kSteps], 0.0F) / static_cast<float>(kSteps);
}

}  // namespace

Course course(const Samples& drawn, const Samples& model, bool reversed) {
  return {chord_turn(drawn, model, reversed), aligned(directions(drawn, reversed), directions(model, false))};
}

}  // namespace nazori::writing
