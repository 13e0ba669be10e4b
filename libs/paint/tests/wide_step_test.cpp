// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "inside.h"

namespace nazori::paint {
namespace {

StepRules some_rules() {
  StepRules rules;
  rules.conductivity = 1e-9F;
  rules.conductivity_loss = 4e-10F;
  rules.pinning = 1e5F;
  rules.pinning_height = 5e5F;
  rules.pinning_density = 2e5F;
  rules.absorption = kOne / 40;
  rules.evaporation = kOne / 3000;
  rules.rim_evaporation = kOne / 9000;
  rules.fixing = 0.002F;
  rules.granulation = {0.3F, 0, 0.9F};
  rules.mobility = {0.9F, 0.6F, 0.3F};
  return rules;
}

/// A tile with pools, dry cells, full cells and three pigments. The same seed gives the same tile.
void fill(Tile& tile, unsigned seed) {
  std::mt19937 luck(seed);
  const auto amount = [&luck](Amount most) {
    const auto kind = luck() % 4;
    return kind == 0 ? 0 : kind == 1 ? most : static_cast<Amount>(luck() % static_cast<unsigned>(most));
  };
  for (std::size_t i = 0; i < kCells; ++i) {
    tile.surface[i] = amount(kOne / 2);
    tile.fibre[i] = amount(kOne);
    for (std::size_t k = 0; k < kSlots; ++k) {
      tile.moving[k][i] = amount(2 * kOne);
      tile.fixed[k][i] = amount(kMostFixed);
    }
  }
  for (auto& h : tile.height) h = static_cast<std::uint16_t>(luck());
  for (auto& d : tile.density) d = static_cast<std::uint16_t>(luck());
  tile.slots = static_cast<std::uint8_t>(seed % 8);
  tile.is_wet = true;
  publish_edges(tile);
}

TEST(WideStep, ComputesTheSameBitsOnProcessorsWithAndWithoutAvx2) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2";
  const StepRules rules = some_rules();
  for (unsigned seed = 1; seed <= 24; ++seed) {
    Tile beside, plain, wide;
    fill(beside, seed + 100);
    fill(plain, seed);
    fill(wide, seed);
    // Some tiles lie at the border of the sheet.
    const std::array<const Edge*, 4> neighbours{
        &beside.edges[right], seed % 2 == 0 ? nullptr : &beside.edges[left],
        seed % 3 == 0 ? nullptr : &beside.edges[bottom], &beside.edges[top]};
    for (int step = 0; step < 5; ++step) {
      ASSERT_EQ(step_tile_plain(rules, plain, neighbours), step_tile_avx2(rules, wide, neighbours));
      ASSERT_EQ(plain.surface, wide.surface) << seed;
      ASSERT_EQ(plain.fibre, wide.fibre) << seed;
      ASSERT_EQ(plain.moving, wide.moving) << seed;
      ASSERT_EQ(plain.fixed, wide.fixed) << seed;
      ASSERT_EQ(plain.evaporated, wide.evaporated) << seed;
      ASSERT_EQ(plain.slots, wide.slots);
      ASSERT_EQ(plain.is_wet, wide.is_wet);
    }
  }
}

}  // namespace
}  // namespace nazori::paint
