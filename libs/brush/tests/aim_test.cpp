// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/aim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace nazori::brush {
namespace {

constexpr double kPi = std::numbers::pi;

TuftForm medium() { return tuft_form(6, Hair::mixed).value(); }

TEST(Aim, TheFootIsAheadAsFarAsTheHairBends) {
  const TuftForm form = medium();
  Tuft tuft(form);
  std::vector<geometry::BristleSegment> swept;
  Aim aim(form);
  HolderPose above;
  above.depth_m = -0.005;
  tuft.move_to(above, swept);
  // The tip points up to the left, so the foot comes down to the lower right of the pen, farther the deeper.
  double before = 0;
  for (const double depth : {0.0, 1e-13, 0.1, 0.2, 0.3}) {
    Aim fresh(form);
    HolderPose pose;
    pose.at = {0.01, 0.02};
    pose.depth_m = depth * form.hair_m;
    fresh.lead(pose, tuft);
    const geometry::PaperPoint foot = pose.at;
    EXPECT_NEAR(foot.x - 0.01, -(foot.y - 0.02), 1e-9);
    const double lead = geometry::distance(foot, {0.01, 0.02});
    if (depth < 1e-9) {
      EXPECT_NEAR(lead, 0, 1e-12);
    } else {
      EXPECT_GT(lead, before);
    }
    EXPECT_LT(lead, form.hair_m);
    before = lead;
  }
}

/// The foot that an aim without a past gives to a pen that comes down, from the pen on.
geometry::PaperPoint first_lead(double depth, geometry::PaperPoint pen = {}) {
  Tuft tuft(medium());
  Aim aim(medium());
  HolderPose pose;
  pose.at = pen;
  pose.depth_m = depth * medium().hair_m;
  aim.lead(pose, tuft);
  return pose.at - pen;
}

TEST(Aim, LeadsByTheReachOfATuftThatWasDrawnOverItsLength) {
  const TuftForm form = medium();
  for (const double depth : {0.1, 0.3, 0.5}) {
    Tuft tuft(form);
    std::vector<geometry::BristleSegment> swept;
    HolderPose pose;
    pose.depth_m = depth * form.hair_m;
    for (int i = 0; i < 100; ++i) {
      pose.time_s += 0.01;
      pose.at.x += 0.02 * form.hair_m;
      tuft.move_to(pose, swept);
    }
    EXPECT_NEAR(geometry::length(first_lead(depth)), tuft.reach_m(), 0.08 * tuft.reach_m()) << depth;
  }
}

TEST(Aim, BetweenTwelveDepthsTheLeadIsInProportionAndBeyondThemItStays) {
  const auto lead = [](double depth) { return geometry::length(first_lead(depth)); };
  EXPECT_NEAR(lead(0.025), lead(0.05) / 2, 1e-12);
  EXPECT_NEAR(lead(0.3125), 0.75 * lead(0.3) + 0.25 * lead(0.35), 1e-12);
  EXPECT_NEAR(lead(0.575), (lead(0.55) + lead(0.6)) / 2, 1e-12);
  EXPECT_EQ(lead(0.7), lead(0.6));
}

TEST(Aim, TheFootSwingsToTheWayOfThePenOverTwoMillimetres) {
  Tuft tuft(medium());
  Aim aim(medium());
  const double lead = geometry::length(first_lead(0.3));
  for (const double way_m : {0.001, 0.004}) {
    HolderPose pose;
    pose.depth_m = 0.3 * medium().hair_m;
    pose.at = {0.01, 0};
    aim.lead(pose, tuft);
    // Upwards, from the lower right: by 135 degrees.
    HolderPose next = pose;
    next.at = {0.01, way_m};
    aim.lead(next, tuft);
    const double ahead = kPi * (-0.25 + 0.75 * (1 - std::exp(-way_m / 0.002)));
    EXPECT_NEAR(next.at.x, 0.01 + lead * std::cos(ahead), 1e-12) << way_m;
    EXPECT_NEAR(next.at.y, way_m + lead * std::sin(ahead), 1e-12) << way_m;
    pose.depth_m = 0;
    aim.lead(pose, tuft);
  }
}

TEST(Aim, HalfOfWhatTheInkMissedThePenByCountsAsItsWay) {
  Tuft tuft(medium());
  Aim aim(medium());
  std::vector<geometry::BristleSegment> swept;
  HolderPose pose;
  pose.depth_m = 0.3 * medium().hair_m;
  const geometry::PaperPoint pen = pose.at;
  aim.lead(pose, tuft);
  tuft.move_to(pose, swept);
  ASSERT_TRUE(tuft.touching());
  const geometry::PaperPoint moved{-0.0005, 0.001};
  const geometry::PaperPoint to = moved + (pen - tuft.patch_at()) * 0.5;
  const double turn = std::remainder(std::atan2(to.y, to.x) + kPi / 4, 2 * kPi);
  const double ahead = -kPi / 4 + (1 - std::exp(-geometry::length(moved) / 0.002)) * turn;
  HolderPose next = pose;
  next.at = pen + moved;
  const double reach = tuft.reach_m();
  aim.lead(next, tuft);
  EXPECT_NEAR(next.at.x, pen.x + moved.x + reach * std::cos(ahead), 1e-12);
  EXPECT_NEAR(next.at.y, pen.y + moved.y + reach * std::sin(ahead), 1e-12);
  // A deeper press bends the hair further.
  HolderPose deeper = next;
  deeper.at = pen + moved;
  deeper.depth_m = 0.4 * medium().hair_m;
  aim.lead(deeper, tuft);
  EXPECT_NEAR(geometry::distance(deeper.at, pen + moved),
              reach + geometry::length(first_lead(0.4)) - geometry::length(first_lead(0.3)), 1e-12);
}

TEST(Aim, OffThePaperTheFootIsThePenAndTheWayIsForgotten) {
  Tuft tuft(medium());
  Aim aim(medium());
  HolderPose pose;
  pose.depth_m = 0.2 * medium().hair_m;
  aim.lead(pose, tuft);
  HolderPose up;
  up.at = {0.03, 0.01};
  up.depth_m = -0.005;
  aim.lead(up, tuft);
  EXPECT_EQ(up.at, (geometry::PaperPoint{0.03, 0.01}));
  HolderPose again;
  again.at = {-0.02, 0.04};
  again.depth_m = pose.depth_m;
  aim.lead(again, tuft);
  const geometry::PaperPoint want = first_lead(0.2, {-0.02, 0.04});
  EXPECT_NEAR(again.at.x, -0.02 + want.x, 1e-15);
  EXPECT_NEAR(again.at.y, 0.04 + want.y, 1e-15);
}

}  // namespace
}  // namespace nazori::brush
