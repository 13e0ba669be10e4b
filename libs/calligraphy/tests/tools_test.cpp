// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nazori/paint/colour.h"

namespace nazori::calligraphy {
namespace {

using paint::InkLoad;
using paint::TotalAmount;

constexpr double kHolds_m3 = 1e-6;
constexpr TotalAmount kSixteen = 16;

InkLoad empty() { return paint::dipped(kHolds_m3, 0, {}, {}); }
InkLoad full(int slot = 0) {
  InkLoad load = empty();
  dip_in_ink(load, slot);
  return load;
}

TEST(BrushTools, ADippedBrushIsAsTheOneThatPaintDips) {
  const InkLoad load = full(1);
  EXPECT_EQ(load, paint::dipped(kHolds_m3, 1, {0, 1, 0}, {0, 1, 0}));
  EXPECT_EQ(load.fullness(), 1);
  EXPECT_NEAR(strength_of(load), 1, 1e-9);
}

TEST(BrushTools, DippedInWaterOnlyItIsFullOfClearWater) {
  InkLoad load = empty();
  dip_in_ink(load, -1);
  EXPECT_EQ(load, paint::dipped(kHolds_m3, 1, {}, {}));
  EXPECT_EQ(strength_of(load), 0);
}

TEST(BrushTools, EveryDipIntoTheWaterHalvesTheInkAndKeepsTheBrushFull) {
  InkLoad load = full();
  for (double strength = 0.5; strength > 0.1; strength /= 2) {
    dip_in_water(load);
    EXPECT_EQ(load.fullness(), 1);
    EXPECT_NEAR(strength_of(load), strength, 1e-6);
    EXPECT_NEAR(load.concentration()[0], strength, 1e-6);
  }
}

TEST(BrushTools, ABrushThatWasDilutedAndDippedIsDarkAtTheTipAndPaleInTheRoot) {
  InkLoad load = full();
  dip_in_water(load);
  dip_in_ink(load, 0);
  EXPECT_NEAR(load.concentration()[0], 1, 1e-9);
  EXPECT_NEAR(static_cast<double>(load.root.pigment[0]) / static_cast<double>(load.root.water), 0.5, 1e-6);
  // The tip is a quarter.
  EXPECT_NEAR(strength_of(load), 0.25 + 0.75 * 0.5, 1e-6);
}

TEST(BrushTools, TheRootDrinksInkForWhatItHasGiven) {
  InkLoad load = paint::dipped(kHolds_m3, 0.5, {0.5, 0, 0}, {0.5, 0, 0});
  dip_in_ink(load, 0);
  EXPECT_EQ(load.fullness(), 1);
  EXPECT_NEAR(static_cast<double>(load.root.pigment[0]) / static_cast<double>(load.root.water), 0.75, 1e-6);
}

TEST(BrushTools, WipingTakesHalfOfWaterAndInk) {
  InkLoad load = full(2);
  wipe(load);
  EXPECT_NEAR(load.fullness(), 0.5, 1e-9);
  EXPECT_NEAR(strength_of(load), 1, 1e-9);
  wipe(load);
  EXPECT_NEAR(load.fullness(), 0.25, 1e-9);
}

TEST(BrushTools, AnotherBrushIsEquallyFullOfTheSameInk) {
  InkLoad load = paint::dipped(kHolds_m3, 0.6, {0.9, 0.1, 0}, {0.3, 0.2, 0});
  const InkLoad moved = moved_to_brush(load, kHolds_m3 / 4);
  EXPECT_EQ(moved.capacity, paint::dipped(kHolds_m3 / 4, 0, {}, {}).capacity);
  EXPECT_NEAR(moved.fullness(), 0.6, 1e-6);
  for (std::size_t k = 0; k < paint::kSlots; ++k)
    EXPECT_NEAR(moved.concentration()[k], load.concentration()[k], 1e-6);
  EXPECT_NEAR(strength_of(moved), strength_of(load), 1e-6);
  EXPECT_LT(moved.root.water * 3, load.root.water);
}

TEST(BrushTools, TheSameBrushKeepsItsInkToTheLastUnit) {
  InkLoad load = full();
  load.tip.water -= 1;
  load.root.pigment[0] -= kSixteen;
  EXPECT_EQ(moved_to_brush(load, kHolds_m3), load);
}

TEST(BrushTools, WhatWasNeverABrushStaysEmptyInOne) {
  EXPECT_EQ(moved_to_brush(InkLoad{}, kHolds_m3), empty());
  EXPECT_EQ(strength_of(InkLoad{}), 0);
}

TEST(BrushTools, BrushesGetThinnerAndKeepTheirProportions) {
  for (const auto hair : {brush::Hair::goat, brush::Hair::mixed, brush::Hair::weasel}) {
    double before = 1;
    for (const auto size : {BrushSize::large, BrushSize::medium, BrushSize::small, BrushSize::fine}) {
      const brush::TuftForm form = form_of({size, hair});
      EXPECT_LT(form.shaft_m, before);
      before = form.shaft_m;
      const brush::TuftForm known = brush::tuft_form(6, hair).value();
      EXPECT_NEAR(form.hair_m / form.shaft_m, known.hair_m / known.shaft_m, 1e-9);
      EXPECT_NEAR(form.root_radius_m / form.shaft_m, known.root_radius_m / known.shaft_m, 1e-9);
      // As tuft_form() does: the number of hairs grows with the cross-section, ink with the volume.
      const double scale = form.shaft_m / known.shaft_m;
      EXPECT_NEAR(form.stiffness_n_m2, known.stiffness_n_m2 * scale * scale, 1e-12);
      EXPECT_NEAR(form.holds_m3 / known.holds_m3, scale * scale * scale, 1e-9);
    }
  }
}

TEST(BrushTools, TheMediumBrushIsTheOneOfTheCommandLine) {
  const brush::TuftForm form = form_of({});
  const brush::TuftForm known = brush::tuft_form(6, brush::Hair::mixed).value();
  EXPECT_EQ(form.hair_m, known.hair_m);
  EXPECT_EQ(form.stiffness_n_m2, known.stiffness_n_m2);
  EXPECT_EQ(form_of({BrushSize::large, brush::Hair::goat}).hair_m,
            brush::tuft_form(4, brush::Hair::goat).value().hair_m);
}

TEST(BrushTools, EveryInkButWaterIsAPigment) {
  for (const auto ink : kInks) EXPECT_EQ(paint::find_pigment(ink).has_value(), ink != kWater) << ink;
}

constexpr double kDegree = std::numbers::pi / 180;

TEST(HolderTilt, APenThatLeansToTheRightLeansToPositiveX) {
  const HolderTilt tilt = holder_tilt(30, 0, false);
  EXPECT_NEAR(tilt.lean_rad, 30 * kDegree, 1e-12);
  EXPECT_NEAR(tilt.lean_to_rad, 0, 1e-12);
}

TEST(HolderTilt, APenThatLeansTowardsTheLearnerLeansToNegativeY) {
  const HolderTilt tilt = holder_tilt(0, 40, false);
  EXPECT_NEAR(tilt.lean_rad, 40 * kDegree, 1e-12);
  EXPECT_NEAR(tilt.lean_to_rad, -90 * kDegree, 1e-12);
}

TEST(HolderTilt, BothAnglesTogetherLeanAsTheSumOfTheirSlopes) {
  // tan^2 45 + tan^2 45 = 2
  const HolderTilt tilt = holder_tilt(45, 45, false);
  EXPECT_NEAR(tilt.lean_rad, std::atan(std::numbers::sqrt2), 1e-12);
  EXPECT_NEAR(tilt.lean_to_rad, -45 * kDegree, 1e-12);
}

TEST(HolderTilt, MirroredItLeansAsFarToTheOtherSide) {
  const HolderTilt tilt = holder_tilt(20, 30, false), mirrored = holder_tilt(20, 30, true);
  EXPECT_NEAR(mirrored.lean_rad, tilt.lean_rad, 1e-12);
  EXPECT_NEAR(std::cos(mirrored.lean_to_rad), -std::cos(tilt.lean_to_rad), 1e-12);
  EXPECT_NEAR(std::sin(mirrored.lean_to_rad), std::sin(tilt.lean_to_rad), 1e-12);
}

TEST(HolderTilt, AFlatPenIsFinite) {
  EXPECT_LT(holder_tilt(90, 0, false).lean_rad, 89.5 * kDegree);
  EXPECT_GT(holder_tilt(-90, 0, false).lean_rad, 88.5 * kDegree);
}

TEST(HolderTilt, WithoutAPenTheBrushLeansALittleToTheHand) {
  EXPECT_GT(assumed_tilt(false).lean_rad, 0.1);
  EXPECT_LT(assumed_tilt(false).lean_rad, 0.3);
  EXPECT_NEAR(assumed_tilt(false).lean_to_rad, -45 * kDegree, 1e-12);
  EXPECT_NEAR(assumed_tilt(true).lean_to_rad, -135 * kDegree, 1e-12);
}

}  // namespace
}  // namespace nazori::calligraphy
