// SPDX-License-Identifier: Apache-2.0
// The shape of a tuft where it is known in closed form, and the speed of its bristles.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "nazori/brush/tuft.h"
#include "sweep_times.h"

namespace nazori::brush {
namespace {

using geometry::BristleSegment;
using geometry::PaperPoint;

constexpr double kPi = std::numbers::pi;
using Swept = std::vector<BristleSegment>;

TuftForm thick() { return *tuft_form(2); }

HolderPose above(double height_m) {
  HolderPose pose;
  pose.at = {0.01, 0.02};
  pose.depth_m = -height_m;
  return pose;
}

std::vector<TuftSection> sections_at(const HolderPose& pose, double wetness = 1) {
  Tuft tuft(thick());
  tuft.set_wetness(wetness);
  Swept swept;
  tuft.move_to(pose, swept);
  EXPECT_TRUE(swept.empty());
  return tuft.sections();
}

TEST(TuftShape, NarrowsToItsPointAndADryOneToABluntEnd) {
  const TuftForm form = thick();
  const Spine spine(form.spine);
  // In the air a dry tuft has split by 0.6, half as much at half of the wetness below which it splits.
  for (const auto& [wetness, tip] :
       {std::tuple{1.0, 0.04}, {0.5, 0.04}, {0.25, 0.04 + 0.2 * 0.3}, {0.0, 0.04 + 0.2 * 0.6}}) {
    const auto sections = sections_at(above(0.005), wetness);
    ASSERT_EQ(sections.size(), 7U);
    for (std::size_t k = 0; k < sections.size(); ++k) {
      const double full = 1 - std::pow(spine.along()[k], 4);
      const double radius = form.root_radius_m * (tip + (1 - tip) * full);
      EXPECT_NEAR(sections[k].half_width_m, radius, 1e-15) << wetness << " " << k;
      EXPECT_NEAR(sections[k].thickness_m, 2 * radius, 1e-15) << wetness << " " << k;
    }
  }
}

TEST(TuftShape, ADryTuftThatIsPressedSplitsFurther) {
  const TuftForm form = thick();
  Tuft tuft(form);
  tuft.set_wetness(0.1);
  Swept swept;
  HolderPose pose = above(-0.1 * form.hair_m);
  tuft.move_to(pose, swept);
  const double splitting = 0.8 * (0.6 + 0.4 * 0.5), spread = 1 + 0.7 * 0.1 / 0.35;
  EXPECT_NEAR(tuft.sections().back().half_width_m, form.root_radius_m * (0.04 + 0.2 * splitting) * spread,
              1e-12);
}

TEST(TuftShape, InTheAirItHangsStraightFromItsHolderToTheFoot) {
  const TuftForm form = thick();
  const Spine spine(form.spine);
  const double hair = form.hair_m;
  HolderPose pose = above(0.1 * hair);
  for (const double lean : {0.3, 0.8}) {
    pose.lean_rad = lean;
    pose.lean_to_rad = 0.7;
    const auto sections = sections_at(pose);
    for (std::size_t k = 0; k < sections.size(); ++k) {
      // Its own bend is five thousandths.
      const double from_tip = hair * (1 - spine.along()[k]);
      const double out = from_tip * std::sin(lean) + 0.1 * hair * std::tan(lean);
      EXPECT_NEAR(sections[k].at.x, 0.01 + std::cos(0.7) * out, 0.006 * hair) << k;
      EXPECT_NEAR(sections[k].at.y, 0.02 + std::sin(0.7) * out, 0.006 * hair) << k;
      EXPECT_NEAR(sections[k].z_m, from_tip * std::cos(lean) + 0.1 * hair, 0.006 * hair) << k;
      EXPECT_NEAR(sections[k].rise_rad, kPi / 2 - lean, 0.006) << k;
    }
  }
}

TEST(TuftShape, AHolderThatHardlyLeansTakesItsRootAsideOfTheBend) {
  // The tip points up to the left; the holder leans by less than a twentieth across that.
  const double hair = thick().hair_m;
  HolderPose pose = above(0.1 * hair);
  pose.lean_rad = 0.04;
  pose.lean_to_rad = 0.75 * kPi + kPi / 2;
  const auto sections = sections_at(pose);
  const double aside = 1.1 * hair * std::tan(0.04);
  EXPECT_NEAR(sections.front().at.x, 0.01 + aside * std::cos(pose.lean_to_rad), 1e-9);
  EXPECT_NEAR(sections.front().at.y, 0.02 + aside * std::sin(pose.lean_to_rad), 1e-9);
  EXPECT_NEAR(sections.front().z_m, 1.1 * hair, 1e-9);
}

TEST(TuftShape, FarAboveThePaperItsHeightIsNotFollowed) {
  const double hair = thick().hair_m;
  for (const double height : {0.25, 0.35, 3.0}) {
    Tuft tuft(thick());
    Swept swept;
    tuft.move_to(above(0.1 * hair), swept);
    tuft.move_to(above(height * hair), swept);
    EXPECT_NEAR(tuft.sections().front().z_m, std::min(1 + height, 1.3) * hair, 1e-9) << height;
  }
}

TEST(TuftShape, ThePatchLiesAtItsReachInTheDirectionOfTheTip) {
  Tuft tuft(thick());
  Swept swept;
  tuft.move_to(above(0.005), swept);
  EXPECT_EQ(tuft.reach_m(), 0);
  EXPECT_EQ(tuft.patch_m(), 0);
  EXPECT_EQ(tuft.width_m(), 0);
  EXPECT_EQ(tuft.patch_at(), (PaperPoint{0.01, 0.02}));
  HolderPose pose = above(-0.01);
  for (int i = 0; i < 40; ++i) {
    pose.at.x += 0.001;
    pose.time_s += 0.01;
    tuft.move_to(pose, swept);
  }
  ASSERT_GT(tuft.reach_m(), 0.005);
  const PaperPoint patch = tuft.patch_at();
  EXPECT_NEAR(geometry::distance(patch, pose.at), tuft.reach_m(), 1e-12);
  EXPECT_NEAR(std::atan2(patch.y - pose.at.y, patch.x - pose.at.x),
              std::remainder(tuft.points_to_rad(), 2 * kPi), 1e-9);
  tuft.reset(0.3);
  EXPECT_EQ(tuft.points_to_rad(), 0.3);
  EXPECT_EQ(tuft.reach_m(), 0);
  EXPECT_EQ(tuft.patch_m(), 0);
  EXPECT_EQ(tuft.width_m(), 0);
  EXPECT_FALSE(tuft.touching());
  tuft.reset();
  EXPECT_EQ(tuft.points_to_rad(), 0.75 * kPi);
}

TEST(TuftShape, AFootThatPassesOverItsPatchLeavesItBehind) {
  // Pressed harder, hair is pushed ahead.
  const double depth = 0.05;
  for (const double wetness : {0.0, 1.0}) {
    Tuft tuft(thick());
    tuft.set_wetness(wetness);
    tuft.reset(0);  // along +x
    Swept swept;
    HolderPose pose = above(0.005);
    tuft.move_to(pose, swept);
    pose.depth_m = depth * thick().hair_m;
    tuft.move_to(pose, swept);
    PaperPoint before = tuft.patch_at();
    for (int i = 0; i < 100; ++i) {
      pose.at.x += 0.01 * thick().hair_m;
      pose.time_s += 0.01;
      tuft.move_to(pose, swept);
      EXPECT_LT(geometry::distance(tuft.patch_at(), before), 0.12 * thick().hair_m) << wetness << " " << i;
      before = tuft.patch_at();
    }
    EXPECT_LT(before.x, pose.at.x) << wetness;
    EXPECT_NEAR(std::abs(std::remainder(tuft.points_to_rad(), 2 * kPi)), kPi, 1e-6);
    EXPECT_GT(tuft.reach_m(), 0);
  }
}

TEST(TuftShape, TheWidthsOfThePatchHoldItsBristles) {
  Tuft tuft(thick());
  Swept swept;
  HolderPose pose = above(0.005);
  tuft.reset(kPi);  // along -x
  tuft.move_to(pose, swept);
  pose.depth_m = 0.008;
  for (int i = 0; i < 30; ++i) {
    pose.at.x += 0.001;
    pose.time_s += 0.01;
    swept.clear();
    tuft.move_to(pose, swept);
  }
  ASSERT_NEAR(std::abs(std::remainder(tuft.points_to_rad(), 2 * kPi)), kPi, 0.01);
  double top = -1, bottom = 1, left = 1, right = -1;
  for (const BristleSegment& s : swept) {
    top = std::max(top, s.to.y + s.width_m / 2);
    bottom = std::min(bottom, s.to.y - s.width_m / 2);
    left = std::min(left, s.to.x - s.length_m / 2);
    right = std::max(right, s.to.x + s.length_m / 2);
  }
  EXPECT_NEAR(tuft.width_m(), top - bottom, 0.05 * tuft.width_m());
  EXPECT_NEAR(tuft.patch_m(), right - left, 0.25 * tuft.patch_m());
  EXPECT_NEAR(tuft.patch_at().y, (top + bottom) / 2, 0.1 * tuft.width_m());
}

TEST(TuftSweep, ABristleIsAsFastAsItsWayInItsTime) {
  const double hair = thick().hair_m;
  Tuft tuft(thick());
  Swept swept;
  HolderPose pose = above(0.005);
  tuft.move_to(pose, swept);
  pose.depth_m = 0.008;
  pose.time_s = 1;
  tuft.move_to(pose, swept);
  const auto move_by = [&](double x, double time_s) {
    pose.at.x += x;
    pose.time_s += time_s;
    swept.clear();
    tuft.move_to(pose, swept);
  };
  for (int i = 0; i < 60; ++i) move_by(0.001, 0.01);
  // A fiftieth of the hair at a time.
  move_by(0.9 * hair / 50, 0.01);
  EXPECT_GT(shares(swept, {0.01})[0], 0.8) << "one step";
  const std::size_t once = swept.size();
  // In three steps, of which two are swept together.
  move_by(2.9 * hair / 50, 0.03);
  const auto parts = shares(swept, {0.02, 0.01});
  EXPECT_GT(parts[0], 0.4);
  EXPECT_GT(parts[1], 0.4);
  EXPECT_NEAR(static_cast<double>(swept.size()), 2.0 * static_cast<double>(once),
              0.1 * static_cast<double>(once));
  // Without a time there is no speed.
  move_by(0.0005, 0);
  ASSERT_FALSE(swept.empty());
  for (const BristleSegment& s : swept) EXPECT_EQ(s.speed_m_s, 0);
}

TEST(TuftSweep, NoPressurePigmentOrWaterIsOverItsBounds) {
  Tuft tuft(thick());
  Swept swept;
  for (const auto& [given, kept] : {std::tuple{-1.0, 0.0}, {0.25, 0.25}, {7.0, 1.0}, {std::nan(""), 0.0}}) {
    tuft.set_pigment(given);
    tuft.set_wetness(given);
    EXPECT_EQ(tuft.wetness(), kept);
    swept.clear();
    HolderPose pose = above(0.005);
    tuft.reset();
    tuft.move_to(pose, swept);
    pose.depth_m = 0.004;
    tuft.move_to(pose, swept);
    ASSERT_FALSE(swept.empty());
    for (const BristleSegment& s : swept) {
      EXPECT_EQ(s.pigment, kept);
      EXPECT_EQ(s.wetness, kept);
    }
  }
}

}  // namespace
}  // namespace nazori::brush
