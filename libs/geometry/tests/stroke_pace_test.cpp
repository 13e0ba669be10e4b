// SPDX-License-Identifier: Apache-2.0
#include "nazori/geometry/stroke_pace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nazori::geometry {
namespace {

TEST(MinimumJerk, IsTheQuinticOfRestToRest) {
  // 10 t^3 - 15 t^4 + 6 t^5.
  for (const double t : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0})
    EXPECT_NEAR(minimum_jerk(t), 10 * std::pow(t, 3) - 15 * std::pow(t, 4) + 6 * std::pow(t, 5), 1e-14) << t;
  EXPECT_EQ(minimum_jerk(-1), 0);
  EXPECT_EQ(minimum_jerk(2), 1);
  // Its peak of speed is 15/8 of the mean, in the middle; at the ends it rests.
  constexpr double kStep = 1e-5;
  EXPECT_NEAR((minimum_jerk(0.5 + kStep) - minimum_jerk(0.5 - kStep)) / (2 * kStep), 1.875, 1e-6);
  EXPECT_NEAR(minimum_jerk(kStep) / kStep, 0, 1e-8);
  EXPECT_NEAR((1 - minimum_jerk(1 - kStep)) / kStep, 0, 1e-8);
}

TEST(StrokePace, WithoutMovementsIsAtTheStart) {
  StrokePace pace;
  EXPECT_TRUE(pace.empty());
  EXPECT_EQ(pace.duration_s(), 0);
  EXPECT_EQ(pace.at(1).along, 0);
  EXPECT_EQ(pace.speed_at(0), 0);
  pace.rest(0.5);
  EXPECT_TRUE(pace.empty());
  EXPECT_EQ(pace.duration_s(), 0.5);
  EXPECT_EQ(pace.at(0.5).along, 0);
}

TEST(StrokePace, AtOneSpeedTheWayIsSpeedTimesTime) {
  StrokePace pace;
  pace.rest(0.25);
  pace.move(3, 2);
  pace.move(4, 0.5);
  pace.rest(1);
  EXPECT_DOUBLE_EQ(pace.duration_s(), 0.25 + 1.5 + 2 + 1);
  EXPECT_DOUBLE_EQ(pace.length(), 4);
  EXPECT_EQ(pace.at(-1).along, 0);
  EXPECT_EQ(pace.at(0.25).along, 0);
  EXPECT_DOUBLE_EQ(pace.at(0.75).along, 1);
  EXPECT_EQ(pace.at(0.75).movement, 0U);
  EXPECT_DOUBLE_EQ(pace.at(1.75).along, 3);
  EXPECT_EQ(pace.at(1.75).movement, 1U);
  EXPECT_DOUBLE_EQ(pace.at(2.75).along, 3.5);
  EXPECT_DOUBLE_EQ(pace.at(4).along, 4) << "it rests at the end";
  EXPECT_DOUBLE_EQ(pace.at(9).along, 4);
  EXPECT_EQ(pace.speed_at(1), 2);
  EXPECT_EQ(pace.speed_at(3), 0.5);
  EXPECT_EQ(pace.speed_at(-1), 2);
  EXPECT_EQ(pace.speed_at(9), 0.5);
}

// v = v0 + k s has s(t) = v0 / k (e^(k t) - 1), and takes ln(v1 / v0) / k.
TEST(StrokePace, ASpeedThatIsLinearInTheWayGrowsExponentiallyInTime) {
  for (const double last : {0.5, 2.0, 8.0}) {
    constexpr double kFirst = 2;
    constexpr double kWay = 3;
    const double k = (last - kFirst) / kWay;
    StrokePace pace;
    pace.move(1, 4);
    pace.move(1 + kWay, kFirst, last);
    const double takes_s = k == 0 ? kWay / kFirst : std::log(last / kFirst) / k;
    EXPECT_NEAR(pace.duration_s(), 0.25 + takes_s, 1e-12) << last;
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
      const double t = share * takes_s;
      const double way = k == 0 ? kFirst * t : kFirst / k * (std::exp(k * t) - 1);
      EXPECT_NEAR(pace.at(0.25 + t).along, 1 + way, 1e-12) << last << ' ' << share;
      EXPECT_NEAR(pace.speed_at(1 + kWay * share), kFirst + (last - kFirst) * share, 1e-12);
      EXPECT_DOUBLE_EQ(pace.speed_at(1 + 2 * kWay), last) << "beyond the end";
    }
  }
}

TEST(StrokePace, SpeedsThatHardlyDifferTakeAsLongAsEqualOnes) {
  StrokePace even, nearly;
  even.move(5, 2);
  nearly.move(5, 2, 2 * (1 + 1e-15));
  EXPECT_NEAR(nearly.duration_s(), even.duration_s(), 1e-12);
  EXPECT_NEAR(nearly.at(1).along, even.at(1).along, 1e-12);
}

TEST(StrokePace, FromRestToRestItMovesWithTheLeastJerkAndRestsBetween) {
  StrokePace pace;
  pace.move_from_rest_to_rest(2, 4);
  pace.rest(1);
  pace.move_from_rest_to_rest(3, 2);
  pace.rest(1);
  EXPECT_DOUBLE_EQ(pace.duration_s(), 8);
  for (const double t : {0.4, 1.0, 2.0, 3.9})
    EXPECT_NEAR(pace.at(t).along, 2 * minimum_jerk(t / 4), 1e-14) << t;
  EXPECT_DOUBLE_EQ(pace.at(4.5).along, 2);
  EXPECT_EQ(pace.at(4.5).movement, 0U) << "a rest belongs to the movement before it";
  EXPECT_EQ(pace.at(5).movement, 1U);
  EXPECT_NEAR(pace.at(6).along, 2.5, 1e-14);
  EXPECT_EQ(pace.begin_of(1), 2);
  EXPECT_EQ(pace.end_of(1), 3);
  EXPECT_EQ(pace.speed_at(1), 0.5) << "the mean";
  EXPECT_EQ(pace.speed_at(2.5), 0.5);
}

TEST(StrokePace, AMovementOfNoLengthKeepsItsSpeed) {
  StrokePace pace;
  pace.move(0, 0.3);
  EXPECT_FALSE(pace.empty());
  EXPECT_EQ(pace.duration_s(), 0);
  EXPECT_EQ(pace.at(1).along, 0);
  EXPECT_EQ(pace.speed_at(0), 0.3);
  EXPECT_EQ(pace.speed_at(7), 0.3);
}

}  // namespace
}  // namespace nazori::geometry
