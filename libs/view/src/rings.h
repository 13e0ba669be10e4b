// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace nazori::view {

/// The year rings of the wood: how much late wood there is, 0..1, by the distance from their axis in mean
/// widths of a ring. Early wood darkens slowly, late wood is a thin line that ends at once; rings are not
/// equally wide or strong.
class Rings {
 public:
  /// Made at the first call. Thread-safe.
  [[nodiscard]] static const Rings& shared();

  /// By its definition. Continuous. @param radius  0 or more.
  [[nodiscard]] static float late_wood(float radius);

  /// late_wood() within 0.004, between the values of a table. It is asked for each texel of a groove, and
  /// takes a fifth of the time. @param radius  0 or more.
  [[nodiscard]] float at(float radius) const {
    const float place = radius * kSteps;
    const auto i = static_cast<std::size_t>(place);
    if (i + 1 >= values_.size()) return late_wood(radius);
    const float part = place - static_cast<float>(i);
    return values_[i] + (values_[i + 1] - values_[i]) * part;
  }

 private:
  static constexpr int kCount = 48;     // as many as a tablet has, from its axis to a corner
  static constexpr float kSteps = 256;  // a ring; the edge of late wood is 18 of them wide
  Rings();
  std::vector<float> values_;
};

}  // namespace nazori::view
