// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/tuft_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

namespace nazori::brush {
namespace {

TEST(TuftForm, HasTheSizesOfTheNumbers) {
  EXPECT_DOUBLE_EQ(tuft_form(1)->shaft_m, 0.015);
  EXPECT_DOUBLE_EQ(tuft_form(2)->shaft_m, 0.0145);
  EXPECT_DOUBLE_EQ(tuft_form(3)->shaft_m, 0.013);
  EXPECT_DOUBLE_EQ(tuft_form(4)->shaft_m, 0.011);
  EXPECT_DOUBLE_EQ(tuft_form(5)->shaft_m, 0.010);
  EXPECT_DOUBLE_EQ(tuft_form(6)->shaft_m, 0.0085);
  for (int number = kThickestBrush; number <= kThinnestBrush; ++number) {
    const auto ratio = [&](HairLength length) {
      const TuftForm form = *tuft_form(number, Hair::goat, length);
      return form.hair_m / form.shaft_m;
    };
    EXPECT_GE(ratio(HairLength::short_hair), 3.5);
    EXPECT_LT(ratio(HairLength::short_hair), 4.5);
    EXPECT_GE(ratio(HairLength::medium_hair), 4.5);
    EXPECT_LT(ratio(HairLength::medium_hair), 5.5);
    EXPECT_GE(ratio(HairLength::long_hair), 5.5);
    EXPECT_LE(ratio(HairLength::long_hair), 8);
  }
}

TEST(TuftForm, HairIsAsLongAsTheMiddleOfItsClassAndAsStiffAsEstimated) {
  EXPECT_DOUBLE_EQ(tuft_form(4, Hair::goat, HairLength::short_hair)->hair_m, 0.044);
  EXPECT_DOUBLE_EQ(tuft_form(4, Hair::goat, HairLength::medium_hair)->hair_m, 0.055);
  EXPECT_DOUBLE_EQ(tuft_form(4, Hair::goat, HairLength::long_hair)->hair_m, 0.07425);
  EXPECT_DOUBLE_EQ(tuft_form(4, Hair::goat)->stiffness_n_m2, 1e-4);
  EXPECT_DOUBLE_EQ(tuft_form(4, Hair::weasel)->stiffness_n_m2, 3e-4);
  // Loose hairs bend each for itself: as many more of them as the section is larger.
  EXPECT_DOUBLE_EQ(tuft_form(1, Hair::goat)->stiffness_n_m2, 1e-4 * (15.0 / 11) * (15.0 / 11));
  const TuftForm form = *tuft_form(4);
  EXPECT_DOUBLE_EQ(form.force_unit_n(), form.stiffness_n_m2 / (0.055 * 0.055));
}

TEST(TuftForm, HoldsInkInTheConeOfItsLowerHalfBetweenTheHairs) {
  for (const HairLength length : {HairLength::short_hair, HairLength::long_hair}) {
    const TuftForm form = *tuft_form(2, Hair::mixed, length);
    EXPECT_LT(2 * form.root_radius_m, form.shaft_m) << "it is a little thinner than the shaft";
    const double cone = std::numbers::pi * form.root_radius_m * form.root_radius_m * (form.hair_m / 2) / 3;
    EXPECT_NEAR(form.holds_m3, cone / 2, 1e-18);
  }
}

TEST(TuftForm, FrictionGoesInProportionFromDryToWetAndNoFurther) {
  const TuftForm form = *tuft_form(4);
  for (const double w : {-1.0, 0.0, 0.25, 1.0, 2.0}) {
    const double wet = std::clamp(w, 0.0, 1.0);
    const SpineFriction now = form.friction(w);
    for (double SpineFriction::*part :
         {&SpineFriction::paper, &SpineFriction::keeps_rad, &SpineFriction::yield_rad,
          &SpineFriction::inner_share, &SpineFriction::along_hair, &SpineFriction::exponent,
          &SpineFriction::inner_rad})
      EXPECT_NEAR(now.*part, form.dry.*part + wet * (form.wet.*part - form.dry.*part), 1e-15) << w;
  }
  EXPECT_NEAR(form.dry.paper, 1.3 * form.wet.paper, 1e-15);
  EXPECT_LT(form.wet.yield_rad, form.dry.yield_rad);
  EXPECT_LT(form.wet.inner_share, form.dry.inner_share);
}

TEST(TuftForm, EachKindOfHairHasItsFrictionAndStiffness) {
  struct Kind {
    Hair hair;
    double stiffness_n_m2, paper, keeps_rad;
  };
  for (const Kind& kind : {Kind{Hair::goat, 1e-4, 0.30, 0.16}, Kind{Hair::mixed, 2e-4, 0.28, 0.12},
                           Kind{Hair::weasel, 3e-4, 0.25, 0.06}}) {
    const TuftForm form = *tuft_form(4, kind.hair);
    EXPECT_DOUBLE_EQ(form.stiffness_n_m2, kind.stiffness_n_m2);
    EXPECT_DOUBLE_EQ(form.wet.paper, kind.paper);
    EXPECT_DOUBLE_EQ(form.dry.paper, 1.3 * kind.paper);
    EXPECT_DOUBLE_EQ(form.wet.keeps_rad, kind.keeps_rad);
    EXPECT_DOUBLE_EQ(form.dry.keeps_rad, 0.3 * kind.keeps_rad);
  }
}

TEST(TuftForm, AllBrushesHaveTheSameSpineAndYield) {
  for (const int number : {1, 6}) {
    const TuftForm form = *tuft_form(number, Hair::goat, HairLength::long_hair);
    EXPECT_DOUBLE_EQ(form.root_radius_m, 0.4 * form.shaft_m);
    EXPECT_EQ(form.spine.segments, 6);
    EXPECT_EQ(form.spine.tip_segment, 0.5);
    EXPECT_EQ(form.spine.taper, 0.1);
    EXPECT_EQ(form.spine.taper_power, 2);
    EXPECT_DOUBLE_EQ(form.spine.thickness, 0.35 * 0.4 / 6.75) << "of the radius at the root over the hair";
    for (const SpineFriction& friction : {form.wet, form.dry}) {
      EXPECT_EQ(friction.along_hair, 0.4);
      EXPECT_EQ(friction.exponent, 2);
      EXPECT_EQ(friction.inner_rad, 0.02);
    }
    EXPECT_EQ(form.wet.yield_rad, 0.15);
    EXPECT_EQ(form.dry.yield_rad, 0.25);
    EXPECT_EQ(form.wet.inner_share, 0.10);
    EXPECT_EQ(form.dry.inner_share, 0.20);
  }
}

TEST(TuftForm, ThereIsNoBrushBeyondTheNumbers) {
  for (const int number : {0, 7, -1}) {
    const auto form = tuft_form(number);
    ASSERT_FALSE(form.has_value());
    EXPECT_EQ(form.error().code, base::Errc::bad_argument);
    EXPECT_EQ(form.error().what,
              "there is no brush No. " + std::to_string(number) + "; brushes have the numbers 1 to 6");
    EXPECT_EQ(form.error().where, "brush");
  }
}

TEST(TuftForm, WeaselIsStifferThanGoatAndKeepsLessOfItsBend) {
  const TuftForm goat = *tuft_form(4, Hair::goat), mixed = *tuft_form(4, Hair::mixed),
                 weasel = *tuft_form(4, Hair::weasel);
  EXPECT_LT(goat.stiffness_n_m2, mixed.stiffness_n_m2);
  EXPECT_LT(mixed.stiffness_n_m2, weasel.stiffness_n_m2);
  EXPECT_GT(goat.friction(1).keeps_rad, weasel.friction(1).keeps_rad);
  EXPECT_GT(goat.friction(1).keeps_rad, goat.friction(0).keeps_rad);
  EXPECT_NEAR(goat.friction(0.5).paper, (goat.friction(0).paper + goat.friction(1).paper) / 2, 1e-12);
  EXPECT_GT(goat.friction(0).paper, goat.friction(1).paper);
  EXPECT_DOUBLE_EQ(goat.friction(7).paper, goat.friction(1).paper);
}

}  // namespace
}  // namespace nazori::brush
