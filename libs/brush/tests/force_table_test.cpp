// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/force_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nazori/haptics/soft_contact.h"

namespace nazori::brush {
namespace {

const ForceTable& number_4() {
  static const ForceTable table(*tuft_form(4));
  return table;
}
const ForceTable& of(Hair hair) {
  static const ForceTable goat(*tuft_form(4, Hair::goat)), weasel(*tuft_form(4, Hair::weasel));
  return hair == Hair::goat ? goat : weasel;
}

TEST(ForceTable, PushesAsTheSpineAtTheSameDepthAndLean) {
  const TuftForm form = *tuft_form(4);
  for (const double lean : {0.1, 0.4, 0.8})
    for (const double depth : {0.05, 0.17, 0.3}) {
      Spine spine(form.spine);
      spine.place({{0, 1.1}, lean});
      const double height = std::cos(lean) - depth;
      for (int i = 0; i <= 100; ++i) spine.move_to({{0, 1.1 + 0.01 * i * (height - 1.1)}, lean});
      const double want = spine.push() * form.force_unit_n();
      EXPECT_NEAR(number_4().push_n(depth * form.hair_m, lean), want, 0.03 * want) << lean << " " << depth;
    }
}

TEST(ForceTable, DoesNotPushAboveThePaper) {
  EXPECT_EQ(number_4().push_n(0, 0.3), 0);
  EXPECT_EQ(number_4().push_n(-0.01, 0.3), 0);
  EXPECT_EQ(number_4().stored_j(-0.01, 0.3), 0);
  EXPECT_EQ(number_4().push_n(std::numeric_limits<double>::quiet_NaN(), 0.3), 0);
}

TEST(ForceTable, ThePushIsTheSlopeOfTheEnergy) {
  const double hair = number_4().form().hair_m;
  for (const double lean : {0.0, 0.25, 0.7, 1.1})
    for (int i = 1; i < 700; i += 7) {
      const double depth = 0.00103 * i * hair, h = 1e-6 * hair;
      const double slope =
          (number_4().stored_j(depth + h, lean) - number_4().stored_j(depth - h, lean)) / (2 * h);
      ASSERT_NEAR(slope, number_4().push_n(depth, lean), 1e-4 * slope + 1e-9) << lean << " " << depth / hair;
    }
}

TEST(ForceTable, BetweenItsValuesThePushIsInProportion) {
  const double hair = number_4().form().hair_m;
  const auto push = [&](double depth, double lean) { return number_4().push_n(depth * hair, lean); };
  for (const double lean : {0.0, 0.3, 1.0}) {
    const double low = push(0.12, lean), high = push(0.13, lean);
    ASSERT_GT(std::abs(high - low), 1e-6);
    EXPECT_NEAR(push(0.1225, lean), 0.75 * low + 0.25 * high, 1e-12) << lean;
    EXPECT_NEAR(push(0.12, lean + 0.025), 0.75 * low + 0.25 * push(0.12, lean + 0.1), 1e-9) << lean;
  }
  EXPECT_EQ(push(0.2, -1), push(0.2, 0));
  EXPECT_EQ(push(0.2, std::numeric_limits<double>::quiet_NaN()), push(0.2, 0));
  EXPECT_NEAR(push(0.2, 1.1 - 1e-9), push(0.2, 1.1), 1e-6);
  EXPECT_LT(push(1e-6, 0.3), 1e-3 * push(0.01, 0.3)) << "it begins at nothing";
}

TEST(ForceTable, TheEnergyIsTheSumOfThePush) {
  const double hair = number_4().form().hair_m;
  for (const double lean : {0.0, 0.55, 1.1}) {
    double sum = 0;
    constexpr int kParts = 4000;
    for (int i = 0; i < kParts; ++i) sum += number_4().push_n((i + 0.5) / kParts * 0.345 * hair, lean);
    sum *= 0.345 * hair / kParts;
    EXPECT_NEAR(number_4().stored_j(0.345 * hair, lean), sum, 1e-5 * sum) << lean;
    const double deepest = number_4().push_n(hair, lean);
    EXPECT_NEAR(number_4().stored_j(0.7 * hair, lean) - number_4().stored_j(0.6 * hair, lean),
                deepest * 0.1 * hair, 1e-9)
        << "deeper it pushes as there";
  }
}

TEST(ForceTable, PushesMoreTheDeeperALeaningBrushIsPressed) {
  const double hair = number_4().form().hair_m;
  double before = 0;
  for (const double depth : {0.05, 0.2, 0.3, 0.4, 0.5}) {
    const double push = number_4().push_n(depth * hair, 0.3);
    EXPECT_GT(push, before) << depth;
    before = push;
  }
  EXPECT_EQ(number_4().push_n(hair, 0.3), number_4().push_n(ForceTable::kDeepest * hair, 0.3));
  EXPECT_EQ(number_4().push_n(0.2 * hair, 5), number_4().push_n(0.2 * hair, ForceTable::kMostLean_rad));
}

TEST(ForceTable, ATrueBrushPushesWithHundredthsToTenthsOfANewton) {
  for (int number = kThickestBrush; number <= kThinnestBrush; ++number)
    for (const Hair hair : {Hair::goat, Hair::mixed, Hair::weasel}) {
      const ForceTable table(*tuft_form(number, hair));
      const double hair_m = table.form().hair_m;
      EXPECT_GT(table.push_n(0.3 * hair_m, 0.26), 0.015);
      const haptics::SoftTip tip = soft_tip(table, 0.26, 1, Feel::true_force);
      for (const double push : tip.push_n) EXPECT_LE(push, 0.5);
      const haptics::SoftTip strong = soft_tip(table, 0.26, 1, Feel::strengthened);
      for (const double push : strong.push_n) EXPECT_LE(push, 1);
    }
}

TEST(SoftTip, OfABrushIsItsTableAtOneLean) {
  const haptics::SoftTip tip = soft_tip(number_4(), 0.25, 1, Feel::true_force);
  const haptics::SoftTipTable felt(tip, 1e4, 10);
  for (int i = 0; i <= 60; ++i)
    EXPECT_NEAR(felt.push_n(tip.step_m * i), std::min(0.5, number_4().push_n(tip.step_m * i, 0.25)), 1e-9);
  EXPECT_DOUBLE_EQ(tip.friction, number_4().form().wet.paper);
  EXPECT_DOUBLE_EQ(tip.along_hair, number_4().form().wet.along_hair);
}

TEST(SoftTip, StrengthenedIsFourTimesAsMuchUpToOneNewton) {
  const haptics::SoftTip truly = soft_tip(of(Hair::goat), 0.3, 1, Feel::true_force);
  const haptics::SoftTip strong = soft_tip(of(Hair::goat), 0.3, 1, Feel::strengthened);
  ASSERT_EQ(truly.push_n.size(), strong.push_n.size());
  for (std::size_t i = 0; i < truly.push_n.size(); ++i)
    EXPECT_NEAR(strong.push_n[i], std::min(1.0, 4 * truly.push_n[i]), 1e-12);
  EXPECT_NEAR(strong.sideways_n_m, 4 * truly.sideways_n_m, 1e-9);
  EXPECT_EQ(strong.friction, truly.friction);
}

TEST(SoftTip, HasAStepOfTheTableTheStiffnessOfABeamAndATowOfTwoFifths) {
  const TuftForm& form = number_4().form();
  for (const double wetness : {0.0, 0.5, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const haptics::SoftTip tip = soft_tip(number_4(), 0.3, wetness, Feel::true_force);
    EXPECT_EQ(tip.push_n.size(), 61U);
    EXPECT_DOUBLE_EQ(tip.step_m, 0.01 * form.hair_m);
    EXPECT_DOUBLE_EQ(tip.tow_m, 0.4 * form.hair_m);
    EXPECT_DOUBLE_EQ(tip.sideways_n_m, 12 * form.stiffness_n_m2 / (form.hair_m * form.hair_m * form.hair_m));
    EXPECT_DOUBLE_EQ(tip.friction, form.friction(std::isfinite(wetness) ? wetness : 0).paper);
    EXPECT_DOUBLE_EQ(tip.along_hair, 0.4);
  }
}

TEST(SoftTip, OfADryBrushRubsMore) {
  EXPECT_GT(soft_tip(of(Hair::weasel), 0.3, 0, Feel::true_force).friction,
            soft_tip(of(Hair::weasel), 0.3, 1, Feel::true_force).friction);
}

TEST(SoftTip, SlipsWithinAFractionOfTheHair) {
  const haptics::SoftTip tip = soft_tip(of(Hair::goat), 0.3, 1, Feel::true_force);
  const double push = tip.push_n[30];
  EXPECT_GT(tip.friction * push / tip.sideways_n_m, 0.0003);
  EXPECT_LT(tip.friction * push / tip.sideways_n_m, 0.2 * of(Hair::goat).form().hair_m);
}

}  // namespace
}  // namespace nazori::brush
