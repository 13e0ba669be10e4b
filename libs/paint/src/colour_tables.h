// SPDX-License-Identifier: Apache-2.0
// Kubelka and Munk from tables, for pictures.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "nazori/paint/colour.h"
#include "nazori/paint/ink_load.h"

namespace nazori::paint {

using BandValues = std::array<float, 3>;

class ColourTables {
 public:
  ColourTables() = default;
  /// @param paper  what bare paper reflects, inside.
  ColourTables(const std::array<Pigment, kSlots>& palette, const Bands& paper);

  /// What is seen of one pigment on bare paper. @param amount  in kOne, >= 0.
  [[nodiscard]] BandValues on_paper(std::size_t slot, float amount) const {
    const float at = place_of(amount) * kSteps;
    const auto i = std::min(static_cast<std::size_t>(at), kSteps - 1);
    const float part = at - static_cast<float>(i);
    const BandValues &a = lines_[slot][i], &b = lines_[slot][i + 1];
    return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
  }
  /// What is seen of a mixture over a ground. @param ground  what it reflects, inside.
  [[nodiscard]] BandValues over_ground(const std::array<float, kSlots>& amounts,
                                       const BandValues& ground) const;
  /// The screen's value for linear light in 0..1.
  [[nodiscard]] static std::uint8_t screen(float linear) {
    // For each pixel: of what is not negative, this rounds as lround does.
    // NOLINTNEXTLINE(bugprone-incorrect-roundings)
    return screen_table()[static_cast<std::size_t>(std::clamp(linear, 0.0F, 1.0F) * kScreenSteps + 0.5F)];
  }

 private:
  static constexpr std::size_t kSteps = 1024;
  static constexpr std::size_t kNodes = 129;
  static constexpr std::size_t kScreenSteps = 8192;
  // Amounts of 0 to infinity lie in 0..1, close to each other where colours change fast.
  static constexpr float kHalfWay = 0.25F;

  [[nodiscard]] static float place_of(float amount) { return amount / (amount + kHalfWay); }
  [[nodiscard]] static double amount_at(double place);
  [[nodiscard]] static const std::array<std::uint8_t, kScreenSteps + 1>& screen_table();

  /// What a layer reflects and lets through, by its absorption and scattering: these add up for every
  /// mixture, so two dimensions serve any number of pigments.
  struct Node {
    float reflected = 0, transmitted = 1;
  };
  [[nodiscard]] static const std::vector<Node>& nodes();

  std::array<BandValues, kSlots> absorption_{}, scattering_{};
  std::array<std::vector<BandValues>, kSlots> lines_;
};

}  // namespace nazori::paint
