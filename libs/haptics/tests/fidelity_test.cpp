// SPDX-License-Identifier: Apache-2.0
// What mesh-based renderers get wrong on the same work; the benchmark prints the figures.
#include "../bench/fidelity.h"

#include <gtest/gtest.h>

namespace nazori::haptics {
namespace {

TEST(Fidelity, TheForceIsThereInTheVeryFirstTickInside) {
  const fidelity::FirstTick found = fidelity::first_tick();
  EXPECT_EQ(found.dives, 1000);
  EXPECT_EQ(found.pushed, 1000);
  EXPECT_NEAR(found.least, 1, 1e-6);
}

TEST(Fidelity, OnAFlatPlateWithoutFrictionTheProxyDoesNotLagSideways) {
  EXPECT_LT(fidelity::sideways_lag_m(), 1e-15);
}

TEST(Fidelity, TheProxyIsNeverLeftHangingBehindARidge) {
  for (const int path : {0, 1, 2}) {
    const fidelity::Behind found = fidelity::behind_a_ridge(128, path);
    EXPECT_EQ(found.ticks, 200'000);
    EXPECT_EQ(found.behind, 0) << path;
    EXPECT_EQ(found.below, 0) << path;
    EXPECT_EQ(found.late, 0) << path;
  }
}

TEST(Fidelity, ASurfaceThatRisesUnderARestingStylusLiftsIt) {
  const fidelity::Lift found = fidelity::rising_surface();
  EXPECT_EQ(found.styluses, 1000);
  EXPECT_EQ(found.lifted, 1000);
  EXPECT_LE(found.worst_step_n, 0.2 * (1 + 1e-9));  // 200 N/s: no kick
}

TEST(Fidelity, ACurvedGrooveTracedSlowlyHasNoRipple) {
  for (const int size : {128, 512}) EXPECT_LT(fidelity::ripple_m(size), 2e-5) << size;
}

}  // namespace
}  // namespace nazori::haptics
