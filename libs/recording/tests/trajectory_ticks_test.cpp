// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/trajectory_ticks.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace nazori::recording {
namespace {

struct Ticks {
  double rate_hz = 0;
  std::vector<TrajectoryPoint> points;
  std::string trouble;
};

Ticks ticks(const std::string& text, std::optional<double> rate_hz = {}) {
  Ticks got;
  auto reader = TrajectoryReader::from(memory_source(text, "hand.csv"));
  if (!reader) {
    got.trouble = base::to_line(reader.error());
    return got;
  }
  auto source = TrajectoryTicks::create(std::move(*reader), rate_hz);
  if (!source) {
    got.trouble = base::to_line(source.error());
    return got;
  }
  got.rate_hz = source->rate_hz();
  TrajectoryPoint point;
  for (;;) {
    const auto more = source->next(point);
    if (!more) got.trouble = base::to_line(more.error());
    if (!more || !*more) return got;
    got.points.push_back(point);
  }
}

std::string rows(int count, double period_s) {
  std::string text = "t,x,y,z\n";
  for (int i = 0; i < count; ++i)
    text += fmt::format("{},{},{},{}\n", 5 + period_s * i, 1e-3 * i, -2e-3 * i, 3e-3 * i);
  return text;
}

TEST(TrajectoryTicks, AreTheRowsWhereNoRateIsAskedFor) {
  const Ticks got = ticks(rows(3000, 0.001));
  EXPECT_EQ(got.rate_hz, 1000);
  ASSERT_EQ(got.points.size(), 3000U);
  EXPECT_EQ(got.points[0].time_s, 5);
  EXPECT_EQ(got.points[2999].position_m.x, 2.999);
}

TEST(TrajectoryTicks, TheRateIsTheMedianSoThatAGapDoesNotCount) {
  EXPECT_EQ(ticks(rows(100, 0.00025)).rate_hz, 4000);
  EXPECT_NEAR(ticks(rows(100, 0.0003)).rate_hz, 3333.333, 0.4);
  EXPECT_EQ(ticks("t,x,y,z\n0,0,0,0\n0.001,0,0,0\n0.5,0,0,0\n0.501,0,0,0\n").rate_hz, 1000);
  EXPECT_EQ(ticks("t,x,y,z\n7,0,0,0\n").rate_hz, 1000);
}

TEST(TrajectoryTicks, TheRateIsWholeWhereItIsWithinAThousandthOfAWholeOne) {
  EXPECT_EQ(ticks(rows(100, 1 / 100.09)).rate_hz, 100);
  EXPECT_NEAR(ticks(rows(100, 1 / 100.11)).rate_hz, 100.11, 1e-6);
  EXPECT_NEAR(ticks(rows(100, 1 / 99.89)).rate_hz, 99.89, 1e-6);
  EXPECT_EQ(ticks(rows(100, 1 / 99.91)).rate_hz, 100);
}

TEST(TrajectoryTicks, OnlyRatesThatAServoMayHaveAreTaken) {
  EXPECT_NEAR(ticks(rows(30, 1 / 20.1)).rate_hz, 20.1, 1e-6);
  EXPECT_THAT(ticks(rows(30, 1 / 19.9)).trouble, testing::HasSubstr("not the rate of a servo"));
  EXPECT_NEAR(ticks(rows(30, 1 / 19'900.0)).rate_hz, 19'900, 1);
  EXPECT_THAT(ticks(rows(30, 1 / 20'100.0)).trouble, testing::HasSubstr("not the rate of a servo"));
  EXPECT_EQ(
      ticks("t,x,y,z\n0,0,0,0\n2,0,0,0\n").trouble,
      "t: the rows are 2 s apart, which is not the rate of a servo (give --rate 1000 to have points between "
      "them)");
}

TEST(TrajectoryTicks, RowsAtTheFirstAndTheLastRateAreTakenHoweverTheirTimesAreRounded) {
  for (const double start_s : {0.0, 0.1, 5.0, 1234.5, 86'400.0}) {
    const auto at = [start_s](double period_s) {
      std::string text = "t,x,y,z\n";
      for (int i = 0; i < 50; ++i) text += fmt::format("{},0,0,0\n", start_s + period_s * i);
      return text;
    };
    for (const double rate_hz : {20.0, 20'000.0}) {
      const Ticks got = ticks(at(1 / rate_hz));
      EXPECT_EQ(got.rate_hz, rate_hz) << start_s << ": " << got.trouble;
      EXPECT_EQ(got.points.size(), 50U);
    }
  }
}

TEST(TrajectoryTicks, TheFirstThousandDistancesGiveTheRate) {
  std::string text = rows(1001, 0.001);
  for (int i = 1; i <= 2000; ++i) text += fmt::format("{},0,0,0\n", 6 + 0.01 * i);
  const Ticks got = ticks(text);
  EXPECT_EQ(got.rate_hz, 1000);
  EXPECT_EQ(got.points.size(), 3001U);
}

TEST(TrajectoryTicks, PointsLieOnStraightLinesBetweenTheRows) {
  const Ticks got = ticks("t,x,y,z\n2,0,0,0\n2.25,1,2,-4\n3.05,1,10,4\n", 10);
  ASSERT_EQ(got.points.size(), 11U) << "from 2 to 3; the last row lies between two ticks";
  for (std::size_t i = 0; i < got.points.size(); ++i) {
    const double t = 0.1 * static_cast<double>(i);
    EXPECT_NEAR(got.points[i].time_s, 2 + t, 1e-12);
    EXPECT_NEAR(got.points[i].position_m.x, std::min(t / 0.25, 1.0), 1e-12);
    EXPECT_NEAR(got.points[i].position_m.y, t < 0.25 ? 8 * t : 10 * t - 0.5, 1e-12);
    EXPECT_NEAR(got.points[i].position_m.z, t < 0.25 ? -16 * t : 10 * t - 6.5, 1e-12);
  }
}

TEST(TrajectoryTicks, ATickThatRoundingPutsBehindTheLastRowIsNotLost) {
  // 0.1 + 0.2 is a little more than 0.3.
  const Ticks got = ticks("t,x,y,z\n0.1,0,0,0\n0.3,3,0,0\n", 10);
  ASSERT_EQ(got.points.size(), 3U);
  EXPECT_EQ(got.points[2].position_m.x, 3) << "and not beyond the row";
}

TEST(TrajectoryTicks, ALineStaysALineAtAnotherRate) {
  const Ticks got = ticks(rows(101, 0.01), 1000);  // one second
  EXPECT_EQ(got.rate_hz, 1000);
  ASSERT_EQ(got.points.size(), 1001U);
  for (std::size_t i = 0; i < got.points.size(); ++i) {
    const double s = static_cast<double>(i) * 1e-3;
    ASSERT_NEAR(got.points[i].time_s, 5 + s, 1e-12);
    ASSERT_NEAR(got.points[i].position_m.x, 0.1 * s, 1e-12);
    ASSERT_NEAR(got.points[i].position_m.y, -0.2 * s, 1e-12);
    ASSERT_NEAR(got.points[i].position_m.z, 0.3 * s, 1e-12);
  }
}

TEST(TrajectoryTicks, ALowerRateLeavesRowsOut) {
  const Ticks got = ticks(rows(1001, 0.001), 100);
  ASSERT_EQ(got.points.size(), 101U);
  EXPECT_NEAR(got.points[50].position_m.x, 0.5, 1e-9);
}

TEST(TrajectoryTicks, ASingleRowIsASingleTick) {
  EXPECT_EQ(ticks("t,x,y,z\n7,1,2,3\n", 1000).points.size(), 1U);
}

TEST(TrajectoryTicks, RowsThatAreNoRateOfAServoAskForOne) {
  EXPECT_THAT(ticks("t,x,y,z\n0,0,0,0\n1,0,0,0\n").trouble, testing::HasSubstr("--rate"));
  EXPECT_EQ(ticks("t,x,y,z\n0,0,0,0\n1,0,0,0\n", 1000).points.size(), 1001U);
}

TEST(TrajectoryTicks, TroubleInARowComesThrough) {
  EXPECT_THAT(ticks("t,x,y,z\n0,0,0,0\n0.1,0,0,oops\n", 100).trouble, testing::HasSubstr("hand.csv:3"));
  EXPECT_THAT(ticks("t,x,y,z\n0,0,0,0\n0.1,0,0,oops\n").trouble, testing::HasSubstr("hand.csv:3"));
}

}  // namespace
}  // namespace nazori::recording
