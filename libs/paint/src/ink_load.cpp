// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/ink_load.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace nazori::paint {
namespace {

constexpr double kCellArea_sqm = 1e-8;  // of 0.1 mm
constexpr TotalAmount kTipShare = 4;    // the tip is a quarter of the tuft
constexpr double kMostConcentration = 4;

/// `part` of `whole` that goes with `water` of `all`.
TotalAmount share(TotalAmount whole, TotalAmount water, TotalAmount all) {
  if (all <= 0) return 0;
  const double part = static_cast<double>(whole) * (static_cast<double>(water) / static_cast<double>(all));
  return std::clamp<TotalAmount>(static_cast<TotalAmount>(part), 0, whole);
}

InkLoad::Part part_of(TotalAmount water, const Concentrations& ink) {
  InkLoad::Part part{water, {}};
  for (std::size_t k = 0; k < kSlots; ++k)
    part.pigment[k] =
        static_cast<TotalAmount>(static_cast<double>(water) * std::clamp(ink[k], 0.0, kMostConcentration));
  return part;
}

}  // namespace

double InkLoad::fullness() const {
  if (capacity <= 0) return 0;
  return std::clamp(static_cast<double>(tip.water + root.water) / static_cast<double>(capacity), 0.0, 1.0);
}

Concentrations InkLoad::concentration() const {
  Concentrations ink{};
  if (tip.water <= 0) return ink;
  for (std::size_t k = 0; k < kSlots; ++k)
    ink[k] =
        std::min(static_cast<double>(tip.pigment[k]) / static_cast<double>(tip.water), kMostConcentration);
  return ink;
}

void InkLoad::give(TotalAmount water, const std::array<TotalAmount, kSlots>& pigment) {
  assert(water >= 0 && water <= tip.water);
  tip.water -= water;
  for (std::size_t k = 0; k < kSlots; ++k) {
    assert(pigment[k] >= 0 && pigment[k] <= tip.pigment[k]);
    tip.pigment[k] -= pigment[k];
  }
  // Afterwards the root has as many times the water of the tip as it is larger.
  const TotalAmount follows = (root.water - (kTipShare - 1) * tip.water) / kTipShare;
  if (follows <= 0) return;
  const TotalAmount before = root.water;
  root.water -= follows;
  tip.water += follows;
  for (std::size_t k = 0; k < kSlots; ++k) {
    const TotalAmount with_it = share(root.pigment[k], follows, before);
    root.pigment[k] -= with_it;
    tip.pigment[k] += with_it;
  }
}

InkLoad dipped(double capacity_m3, double fullness, const Concentrations& tip, const Concentrations& root,
               double paper_depth_m) {
  InkLoad load;
  // So many full cells that sums of several loads still fit.
  constexpr double kMostCells = 4e9;
  const double cells =
      std::min(std::clamp(capacity_m3, 0.0, 1e-5) / (kCellArea_sqm * paper_depth_m), kMostCells);
  load.capacity = static_cast<TotalAmount>(cells * kOne);
  const auto water =
      static_cast<TotalAmount>(static_cast<double>(load.capacity) * std::clamp(fullness, 0.0, 1.0));
  load.tip = part_of(water / kTipShare, tip);
  load.root = part_of(water - water / kTipShare, root);
  return load;
}

}  // namespace nazori::paint
