// SPDX-License-Identifier: Apache-2.0
#include "../src/resistance.h"

#include <gtest/gtest.h>

namespace nazori::brush {
namespace {

void expect_resistance(const Resistance& found, double energy, double moment, double stiffness) {
  EXPECT_NEAR(found.energy, energy, 1e-12);
  EXPECT_NEAR(found.moment, moment, 1e-12);
  EXPECT_EQ(found.stiffness, stiffness);
}

/// Both sides: the mirror image has the same energy and the opposite moment.
void expect_keeping(double angle, double kept, double most, double rest, const Resistance& want) {
  constexpr double kStiffness = 3, kYield = 0.2;
  SCOPED_TRACE(angle);
  expect_resistance(keeping(angle, kept, kStiffness, kYield, most, rest), want.energy, want.moment,
                    want.stiffness);
  expect_resistance(keeping(-angle, -kept, kStiffness, kYield, most, -rest), want.energy, -want.moment,
                    want.stiffness);
}

TEST(Keeping, IsASpringUpToItsYield) {
  expect_keeping(0.25, 0.1, 0.5, 0, {0.5 * 3 * 0.15 * 0.15, 3 * 0.15, 3});
  expect_keeping(-0.05, 0.1, 0.5, 0, {0.5 * 3 * 0.15 * 0.15, -3 * 0.15, 3});
  expect_keeping(0.1, 0.1, 0.5, 0, {0, 0, 3});
}

TEST(Keeping, BeyondItsYieldTheMomentStaysWhileTheZeroFollows) {
  // The work is that of the spring up to its yield, then that of a constant moment.
  expect_keeping(0.6, 0.1, 0.5, 0, {0.5 * 3 * 0.04 + 3 * 0.2 * 0.3, 3 * 0.2, 0});
  // Down to the other limit there is a longer way.
  expect_keeping(-0.65, 0.1, 0.5, 0, {0.5 * 3 * 0.04 + 3 * 0.2 * 0.55, -3 * 0.2, 0});
}

TEST(Keeping, AtItsLimitTheZeroStaysAndTheSpringIsStretchedFurther) {
  // The zero goes from 0.1 to 0.2, or from 0.1 to -0.2.
  expect_keeping(0.6, 0.1, 0.2, 0, {3 * 0.2 * 0.1 + 0.5 * 3 * 0.4 * 0.4, 3 * 0.4, 3});
  expect_keeping(-0.6, 0.1, 0.2, 0, {3 * 0.2 * 0.3 + 0.5 * 3 * 0.4 * 0.4, -3 * 0.4, 3});
  // The limits lie around the angle at rest.
  expect_keeping(0.6, 0.1, 0.2, 0.05, {3 * 0.2 * 0.15 + 0.5 * 3 * 0.35 * 0.35, 3 * 0.35, 3});
  // A zero that is beyond its limit goes no further.
  expect_keeping(1.0, 0.5, 0.2, 0, {0.5 * 3 * 0.5 * 0.5, 3 * 0.5, 3});
}

TEST(Keeping, WhatKeepsNothingIsASpringHoweverFarItIsBent) {
  expect_keeping(1.0, 0.1, 0, 0.4, {0.5 * 3 * 0.9 * 0.9, 3 * 0.9, 3});
}

TEST(Slipping, IsASpringUpToItsSlipAndThenAConstantForce) {
  expect_resistance(slipping(0.1, 4, 0.25), 0.5 * 4 * 0.01, 0.4, 4);
  expect_resistance(slipping(-0.1, 4, 0.25), 0.5 * 4 * 0.01, -0.4, 4);
  expect_resistance(slipping(0.75, 4, 0.25), 0.5 * 4 * 0.0625 + 4 * 0.25 * 0.5, 1, 0);
  expect_resistance(slipping(-0.75, 4, 0.25), 0.5 * 4 * 0.0625 + 4 * 0.25 * 0.5, -1, 0);
  expect_resistance(slipping(0.25, 4, 0.25), 0.5 * 4 * 0.0625, 1, 0);
}

TEST(Slipping, WhatCannotHoldResistsNothing) {
  for (const double stretch : {0.0, 0.3, -0.3}) expect_resistance(slipping(stretch, 4, 0), 0, 0, 0);
}

}  // namespace
}  // namespace nazori::brush
