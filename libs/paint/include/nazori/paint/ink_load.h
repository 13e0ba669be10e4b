// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nazori/paint/amount.h"

namespace nazori::paint {

/// Pigments that can be wet on a sheet at one time.
inline constexpr int kSlots = 3;
/// One amount for each slot.
using PigmentAmounts = std::array<Amount, kSlots>;
/// Undiluted ink has kOne of pigment in kOne of water; 0..4 for each slot.
using Concentrations = std::array<double, kSlots>;

/// The ink in a brush: water and pigments apart, in the tip and in the root. Units are those of cells of 0.1
/// mm. The paper takes from the tip; the root follows, so that tip and root are always equally full. So a
/// brush that was dipped into thin ink and then with its tip into thick ink begins dark and ends pale.
struct InkLoad {
  /// Water and pigment in a part of the tuft.
  struct Part {
    TotalAmount water = 0;
    std::array<TotalAmount, kSlots> pigment{};
    friend bool operator==(const Part&, const Part&) = default;
  };
  Part tip, root;
  TotalAmount capacity = 0;  ///< water that fits; the tip is a quarter of it

  /// How full it is, 0..1.
  [[nodiscard]] double fullness() const;
  /// Pigment in a unit of the tip's water.
  [[nodiscard]] Concentrations concentration() const;
  /// Removes water and pigment from the tip and lets the root follow. @param water,pigment  at most what the
  /// tip has.
  void give(TotalAmount water, const std::array<TotalAmount, kSlots>& pigment);
  friend bool operator==(const InkLoad&, const InkLoad&) = default;
};

/// A brush that was dipped. @param capacity_m3  water that the tuft holds, 0..1e-5; a medium brush about
/// 1e-6.
/// @param paper_depth_m  depth of the water of one full cell; 2e-5 is a paper of 0.1 mm with a fifth of
/// holes.
/// @param fullness  0..1. @param tip,root  concentration of the ink there, 0..4.
[[nodiscard]] InkLoad dipped(double capacity_m3, double fullness, const Concentrations& tip,
                             const Concentrations& root, double paper_depth_m = 2e-5);

}  // namespace nazori::paint
