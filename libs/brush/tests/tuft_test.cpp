// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/tuft.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace nazori::brush {
namespace {

using geometry::BristleSegment;
using geometry::PaperPoint;

constexpr double kPi = std::numbers::pi;
using Swept = std::vector<BristleSegment>;

TuftForm number_4() { return *tuft_form(4); }

HolderPose upright(double x, double depth_m, double time_s = 0) {
  HolderPose pose;
  pose.time_s = time_s;
  pose.at = {x, 0};
  pose.depth_m = depth_m;
  return pose;
}

/// Drags `tuft` along +x for 0.1 m at 0.1 m/s, from where it was pressed down.
Swept drag(Tuft& tuft, double depth_m) {
  Swept swept;
  tuft.move_to(upright(0, -0.005), swept);
  tuft.move_to(upright(0, depth_m), swept);
  for (int i = 1; i <= 100; ++i) tuft.move_to(upright(0.001 * i, depth_m, 0.01 * i), swept);
  return swept;
}

/// Squares of 0.1 mm that the bands cover, within x from `left` to `right`.
double area_mm2(const Swept& swept, double left = -1, double right = 1) {
  constexpr double kCell = 0.0001;
  constexpr int kSide = 2400;  // 0.24 m around the centre of the sheet
  std::vector<bool> covered(static_cast<std::size_t>(kSide) * kSide);
  int count = 0;
  for (const BristleSegment& s : swept) {
    const PaperPoint way = s.to - s.from;
    const double length = geometry::length(way);
    const PaperPoint along = length > 0 ? way * (1 / length) : PaperPoint{1, 0};
    const double half = s.width_m / 2;
    const auto cell = [&](double v) {
      return std::clamp(static_cast<int>(std::floor(v / kCell)) + kSide / 2, 0, kSide - 1);
    };
    for (int i = cell(std::min(s.from.x, s.to.x) - half); i <= cell(std::max(s.from.x, s.to.x) + half); ++i)
      for (int j = cell(std::min(s.from.y, s.to.y) - half); j <= cell(std::max(s.from.y, s.to.y) + half);
           ++j) {
        const PaperPoint at{(i - kSide / 2 + 0.5) * kCell, (j - kSide / 2 + 0.5) * kCell};
        const double t = std::clamp(geometry::dot(at - s.from, along), 0.0, length);
        const std::size_t index = static_cast<std::size_t>(i) * kSide + static_cast<std::size_t>(j);
        if (covered[index] || at.x < left || at.x > right) continue;
        if (geometry::distance(at, s.from + along * t) > half) continue;
        covered[index] = true;
        ++count;
      }
  }
  return count * 0.01;
}

TEST(Tuft, TouchesNothingInTheAir) {
  Tuft tuft(number_4());
  Swept swept;
  for (int i = 0; i < 20; ++i) tuft.move_to(upright(0.001 * i, -0.001), swept);
  EXPECT_TRUE(swept.empty());
  EXPECT_FALSE(tuft.touching());
  EXPECT_EQ(tuft.push_n(), 0);
  EXPECT_EQ(tuft.width_m(), 0);
}

TEST(Tuft, FirstTouchesWhereThePenPointsWhateverItsLean) {
  for (const double lean : {0.0, 0.4, 0.9}) {
    Tuft tuft(number_4());
    Swept swept;
    HolderPose pose;
    pose.at = {0.01, 0.02};
    pose.lean_rad = lean;
    pose.lean_to_rad = -0.8;
    pose.depth_m = -0.001;
    tuft.move_to(pose, swept);
    EXPECT_TRUE(swept.empty());
    pose.depth_m = 0.0008;
    tuft.move_to(pose, swept);
    ASSERT_FALSE(swept.empty()) << lean;
    for (const BristleSegment& s : swept) {
      EXPECT_NEAR(s.to.x, 0.01, 0.0025) << lean;
      EXPECT_NEAR(s.to.y, 0.02, 0.0025) << lean;
    }
  }
}

TEST(Tuft, ALineIsWiderTheDeeperItIsPressed) {
  double before = 0;
  for (int i = 1; i <= 10; ++i) {
    Tuft tuft(number_4());
    drag(tuft, 0.0025 * i);
    EXPECT_GE(tuft.width_m(), 0.99 * before) << i;
    before = std::max(before, tuft.width_m());
  }
  EXPECT_GT(before, 0.006);
  EXPECT_LT(before, 0.012);
}

TEST(Tuft, PressingWidensTheFootprintStepByStep) {
  for (const double lean : {0.2, 0.4, 0.8}) {
    Tuft tuft(number_4());
    Swept swept;
    double before = 0;
    for (int i = 0; i <= 120; ++i) {
      HolderPose pose = upright(0, 0.00025 * i);
      pose.lean_rad = lean;
      tuft.move_to(pose, swept);
      EXPECT_GE(tuft.width_m(), 0.97 * before) << lean << " " << i;
      before = std::max(before, tuft.width_m());
    }
    EXPECT_GT(before, 0.007);
    EXPECT_GT(tuft.push_n(), 0);
  }
}

TEST(Tuft, TheAreaOfASectionStaysWhileItSpreads) {
  Tuft tuft(number_4());
  Swept swept;
  tuft.move_to(upright(0, 0.001), swept);
  const auto light = tuft.sections();
  tuft.move_to(upright(0, 0.02), swept);
  const auto deep = tuft.sections();
  ASSERT_EQ(light.size(), 7U);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_GT(deep[k].half_width_m, 1.2 * light[k].half_width_m);
    EXPECT_NEAR(deep[k].half_width_m * deep[k].thickness_m, light[k].half_width_m * light[k].thickness_m,
                1e-9);
  }
}

TEST(Tuft, SpreadsBySevenTenthsAtMostAndByHalfOfThatAtAQuarterOfItsHair) {
  const TuftForm form = number_4();
  Tuft tuft(form);
  Swept swept;
  tuft.move_to(upright(0, -0.005), swept);
  for (const double depth : {0.0, 0.25, 0.5}) {
    tuft.move_to(upright(0, depth * form.hair_m, depth + 1), swept);
    const auto sections = tuft.sections();
    const double spread = 1 + 0.7 * depth / (depth + 0.25);
    EXPECT_NEAR(sections.front().half_width_m, form.root_radius_m * spread, 1e-12) << depth;
    // A wet tuft ends in a point of 4 % of its root.
    EXPECT_NEAR(sections.back().half_width_m, 0.04 * form.root_radius_m * spread, 1e-12) << depth;
  }
}

TEST(Tuft, AHolderThatTurnsItsLeanInOneReportTurnsTheWayOfManySmallOnes) {
  const auto turned = [](int reports) {
    Tuft tuft(number_4());
    Swept swept;
    HolderPose pose = upright(0, -0.005);
    pose.lean_rad = 0.5;
    tuft.move_to(pose, swept);
    pose.depth_m = 0.008;
    tuft.move_to(pose, swept);
    for (int i = 1; i <= reports; ++i) {
      pose.time_s = 0.1 * i / reports;
      pose.lean_to_rad = 0.6 * i / reports;
      tuft.move_to(pose, swept);
    }
    return tuft.sections();
  };
  const auto one = turned(1);
  const auto many = turned(12);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_NEAR(geometry::distance(one[k].at, many[k].at), 0, 0.0004) << k;
    EXPECT_NEAR(one[k].z_m, many[k].z_m, 0.0004) << k;
  }
}

TEST(Tuft, TheTipTrailsBehindTheHolder) {
  for (const double start : {0.5, 2.5, -2.0}) {
    Tuft tuft(number_4());
    tuft.reset(start);
    drag(tuft, 0.012);
    EXPECT_NEAR(std::abs(std::remainder(tuft.points_to_rad(), 2 * kPi)), kPi, 0.15) << start;
  }
}

// The curve of a towed point: tan(angle / 2) falls with exp(-way / length of the tow).
TEST(Tuft, TurnsBehindTheHolderOnATractrix) {
  Tuft tuft(number_4());
  tuft.reset(2.0);
  Swept swept;
  tuft.move_to(upright(0, 0.012), swept);
  tuft.move_to(upright(0.02, 0.012), swept);
  double logs[3];
  for (int i = 0; i < 3; ++i) {
    tuft.move_to(upright(0.03 + 0.01 * i, 0.012), swept);
    logs[i] = std::log(std::tan((kPi - tuft.points_to_rad()) / 2));
  }
  EXPECT_NEAR(logs[0] - logs[1], logs[1] - logs[2], 0.03 * (logs[0] - logs[1]));
  const double tow_m = 0.01 / (logs[0] - logs[1]);
  EXPECT_GT(tow_m, 0.012);
  EXPECT_LT(tow_m, 0.045);
}

TEST(Tuft, ALeaningHolderPointsItsTipToTheOtherSide) {
  Tuft tuft(number_4());
  Swept swept;
  HolderPose pose = upright(0, 0.01);
  pose.lean_rad = 0.5;
  pose.lean_to_rad = 0.7;
  tuft.move_to(pose, swept);
  EXPECT_NEAR(std::remainder(tuft.points_to_rad() - 0.7 - kPi, 2 * kPi), 0, 1e-6);
  double towards = 0;
  for (const BristleSegment& s : swept) towards += std::cos(0.7) * s.to.x + std::sin(0.7) * s.to.y;
  EXPECT_LT(towards, 0);
  EXPECT_GT(tuft.sections().front().at.x * std::cos(0.7), 0.005);
}

TEST(Tuft, BristlesSweepAsFastAsTheHolderMoves) {
  Tuft tuft(number_4());
  drag(tuft, 0.012);
  Swept swept;
  tuft.move_to(upright(0.101, 0.012, 1.01), swept);
  ASSERT_GT(swept.size(), 50U);
  for (const BristleSegment& s : swept) {
    EXPECT_NEAR(s.speed_m_s, 0.1, 0.02);
    EXPECT_NEAR(s.to.x - s.from.x, 0.001, 0.0002);
    EXPECT_GT(s.pressure, -1e-12);
    EXPECT_LE(s.pressure, 1);
    EXPECT_GE(s.width_m, 0.00008);
    EXPECT_LT(s.length_m, 0.03);
  }
}

TEST(Tuft, ARestingBristleSweepsAPoint) {
  Tuft tuft(number_4());
  Swept swept;
  tuft.move_to(upright(0, 0.012, 0), swept);
  swept.clear();
  tuft.move_to(upright(0, 0.012, 0.1), swept);
  ASSERT_EQ(static_cast<int>(swept.size()), tuft.bristles_touching());
  for (const BristleSegment& s : swept) {
    EXPECT_LT(geometry::distance(s.from, s.to), 1e-5);
    EXPECT_LT(s.speed_m_s, 1e-3);
  }
}

/// Least, greatest and mean pressure of the bristles of an upright tuft that is pressed down and rests.
struct Pressures {
  double least = 1, greatest = 0, mean = 0;
};
Pressures pressures(double depth_m) {
  Tuft tuft(number_4());
  Swept swept;
  tuft.move_to(upright(0, depth_m), swept);
  swept.clear();
  tuft.move_to(upright(0, depth_m, 0.1), swept);
  Pressures made;
  for (const BristleSegment& s : swept) {
    made.least = std::min(made.least, s.pressure);
    made.greatest = std::max(made.greatest, s.pressure);
    made.mean += s.pressure / static_cast<double>(swept.size());
  }
  return made;
}

TEST(Tuft, ABristleAtTheEdgeOfTheFootprintPressesLessThanOneThatLiesOnThePaper) {
  for (const double depth_m : {0.004, 0.012}) {
    const Pressures found = pressures(depth_m);
    EXPECT_GE(found.least, 0) << depth_m;
    EXPECT_LT(found.least, 0.75 * found.greatest) << depth_m;
  }
}

TEST(Tuft, BristlesPressHarderTheDeeperTheTuftIsPressed) {
  // Half of the greatest pressure at a tenth of the length of the hair.
  const double hair = number_4().hair_m;
  const double light = pressures(0.05 * hair).greatest, half = pressures(0.1 * hair).greatest,
               deep = pressures(0.3 * hair).greatest;
  EXPECT_NEAR(light / half, (1.0 / 3) / (1.0 / 2), 0.1);
  EXPECT_NEAR(deep / half, (3.0 / 4) / (1.0 / 2), 0.1);
  EXPECT_LT(deep, 0.75 + 1e-9);
}

/// A curved stroke whose pressure rises and falls, with `per_s` reports a second.
Swept stroke(double per_s) {
  Tuft tuft(number_4());
  Swept swept;
  const double seconds = 1.0;
  const int events = static_cast<int>(seconds * per_s);
  for (int i = 0; i <= events; ++i) {
    const double t = static_cast<double>(i) / events;
    HolderPose pose;
    pose.time_s = t * seconds;
    pose.at = {0.03 * std::cos(3 * t), 0.03 * std::sin(3 * t)};
    pose.depth_m = -0.002 + 0.018 * std::sin(kPi * t);
    pose.lean_rad = 0.2 * t;
    tuft.move_to(pose, swept);
  }
  return swept;
}

TEST(Tuft, DrawsTheSameWhetherThePenIsReported60Or240Or1000TimesASecond) {
  const double fine = area_mm2(stroke(1000));
  EXPECT_NEAR(area_mm2(stroke(240)), fine, 0.02 * fine);
  EXPECT_NEAR(area_mm2(stroke(60)), fine, 0.02 * fine);
  EXPECT_GT(fine, 100);
}

TEST(Tuft, ADryTuftSplitsSoThatGapsStayInItsLine) {
  double covered[2], width[2];
  for (int dry = 0; dry < 2; ++dry) {
    Tuft tuft(number_4());
    tuft.set_wetness(dry == 1 ? 0.05 : 1.0);
    const Swept swept = drag(tuft, 0.015);
    covered[dry] = area_mm2(swept, 0.03, 0.06) / (30 * 1000 * tuft.width_m());
    width[dry] = tuft.width_m();
  }
  EXPECT_GT(covered[0], 0.9);
  EXPECT_LT(covered[1], 0.85 * covered[0]);
  EXPECT_GT(width[1], 0.7 * width[0]);
}

TEST(Tuft, BristlesOfferWhatTheTuftHolds) {
  Tuft tuft(number_4());
  tuft.set_wetness(0.6);
  tuft.set_pigment(0.3);
  Swept swept;
  tuft.move_to(upright(0, 0.01), swept);
  ASSERT_FALSE(swept.empty());
  EXPECT_DOUBLE_EQ(swept.back().wetness, 0.6);
  EXPECT_DOUBLE_EQ(swept.back().pigment, 0.3);
  tuft.set_wetness(2);
  EXPECT_DOUBLE_EQ(tuft.wetness(), 1);
  tuft.set_wetness(std::numeric_limits<double>::quiet_NaN());
  EXPECT_DOUBLE_EQ(tuft.wetness(), 0);
}

TEST(Tuft, TurningTheHolderBringsOtherBristlesOntoThePaperWithinTheSameWidth) {
  Tuft tuft(number_4());
  Swept swept;
  HolderPose pose = upright(0, 0.015);
  tuft.move_to(pose, swept);
  const double width = tuft.width_m();
  const int touching = tuft.bristles_touching();
  swept.clear();
  pose.twist_rad = 1.5;
  tuft.move_to(pose, swept);
  EXPECT_NEAR(tuft.width_m(), width, 0.12 * width);
  EXPECT_NEAR(tuft.bristles_touching(), touching, 0.15 * touching);
  // They are dragged aside by the turn.
  double most = 0;
  for (const BristleSegment& s : swept) most = std::max(most, std::abs(s.to.y - s.from.y));
  EXPECT_GT(most, 1e-5);
}

TEST(Tuft, LiftsAndTouchesAgainWithoutALineBetween) {
  Tuft tuft(number_4());
  Swept swept;
  tuft.move_to(upright(0, 0.008, 0), swept);
  tuft.move_to(upright(0, -0.010, 0.1), swept);
  EXPECT_FALSE(tuft.touching());
  swept.clear();
  tuft.move_to(upright(0.05, -0.010, 0.2), swept);
  EXPECT_TRUE(swept.empty());
  tuft.move_to(upright(0.05, 0.008, 0.3), swept);
  ASSERT_FALSE(swept.empty());
  for (const BristleSegment& s : swept) EXPECT_GT(s.from.x, 0.02);
}

TEST(Tuft, APoseThatIsNoNumberIsIgnored) {
  Tuft tuft(number_4());
  Swept swept;
  tuft.move_to(upright(0, 0.008), swept);
  const double push = tuft.push_n();
  swept.clear();
  for (int i = 0; i < 7; ++i) {
    HolderPose pose = upright(0, 0.008);
    double* numbers[] = {&pose.time_s,   &pose.at.x,        &pose.at.y,     &pose.depth_m,
                         &pose.lean_rad, &pose.lean_to_rad, &pose.twist_rad};
    *numbers[i] =
        i % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
    tuft.move_to(pose, swept);
  }
  EXPECT_TRUE(swept.empty());
  EXPECT_EQ(tuft.push_n(), push);
}

TEST(Tuft, ADepthOrLeanBeyondAllHandsIsLimited) {
  Tuft tuft(number_4());
  Swept swept;
  HolderPose pose = upright(0, 5);
  pose.lean_rad = 9;
  tuft.move_to(pose, swept);
  EXPECT_TRUE(std::isfinite(tuft.push_n()));
  for (const TuftSection& section : tuft.sections()) EXPECT_GE(section.z_m, 0);
  tuft.move_to(upright(1e6, 0.01), swept);
  for (const BristleSegment& s : swept) ASSERT_TRUE(std::isfinite(s.to.x) && std::isfinite(s.width_m));
}

TEST(Tuft, PushesWithTheForceOfARealBrush) {
  for (int number = kThickestBrush; number <= kThinnestBrush; ++number)
    for (const Hair hair : {Hair::goat, Hair::mixed, Hair::weasel}) {
      const TuftForm form = *tuft_form(number, hair);
      Tuft tuft(form);
      Swept swept;
      HolderPose pose = upright(0, 0.3 * form.hair_m);
      pose.lean_rad = 15 * kPi / 180;
      tuft.move_to(pose, swept);
      EXPECT_GT(tuft.push_n(), 0.015) << number;
      EXPECT_LT(tuft.push_n(), 0.5) << number;
    }
}

TEST(Tuft, TheSamePosesSweepTheSame) {
  const Swept a = stroke(240), b = stroke(240);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].from, b[i].from);
    ASSERT_EQ(a[i].to, b[i].to);
    ASSERT_EQ(a[i].width_m, b[i].width_m);
  }
}

}  // namespace
}  // namespace nazori::brush
