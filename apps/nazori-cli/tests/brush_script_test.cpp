// SPDX-License-Identifier: Apache-2.0
// What a brush replays: every sample of a script.
#include "brush_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "program.h"

namespace nazori::cli::test {
namespace {

using brush::PenSample;
using testing::HasSubstr;

// 0.06 m/s where times are not known, a quarter of a second between strokes, 0.02 s for the way up and down.
constexpr double kSpeed_m_s = 0.06;
constexpr double kBetween_s = 0.25;
constexpr double kLift_s = 0.02;

class BrushScripts : public testing::Test {
 protected:
  base::Result<BrushScript> read(const std::string& text, const std::string& name = "a.json",
                                 double side_m = 0.1) {
    write(folder_ / name, text);
    return read_brush_script(folder_ / name, side_m);
  }
  std::string refused(const std::string& text, const std::string& name = "a.json") {
    const auto script = read(text, name);
    EXPECT_FALSE(script);
    return script ? std::string() : base::to_line(script.error());
  }
  TemporaryFolder folder_;
};

void expect_down(const PenSample& sample, double time_s, double x_m, double y_m) {
  EXPECT_NEAR(sample.time_s, time_s, 1e-9);
  EXPECT_NEAR(sample.at.x, x_m, 1e-12);
  EXPECT_NEAR(sample.at.y, y_m, 1e-12);
  EXPECT_TRUE(sample.down);
}
void expect_up(const PenSample& sample, double time_s, double x_m, double y_m) {
  EXPECT_NEAR(sample.time_s, time_s, 1e-9);
  EXPECT_NEAR(sample.at.x, x_m, 1e-12);
  EXPECT_NEAR(sample.at.y, y_m, 1e-12);
  EXPECT_FALSE(sample.down);
  EXPECT_FALSE(sample.pressure);
}

TEST_F(BrushScripts, HandwritingWithoutTimesIsWrittenAtOneSpeedWithPausesBetweenStrokes) {
  const auto script = read(R"({"char":"二","strokes":[[[0.5,0.5],[0.8,0.5],[0.8,0.9]],[[0,0],[0,1]]]})");
  ASSERT_TRUE(script) << base::to_line(script.error());
  EXPECT_EQ(script->character, U'二');
  const auto& s = script->samples;
  ASSERT_EQ(s.size(), 8U);
  // The middle of the box is the middle of the sheet; up is up.
  expect_down(s[0], 0, 0, 0);
  expect_down(s[1], 0.03 / kSpeed_m_s, 0.03, 0);
  expect_down(s[2], 0.07 / kSpeed_m_s, 0.03, -0.04);
  const double lifted_s = 0.07 / kSpeed_m_s + kLift_s;
  expect_up(s[3], lifted_s, 0.03, -0.04);
  const double down_s = lifted_s + kBetween_s;
  expect_up(s[4], down_s - kLift_s, -0.05, 0.05);
  expect_down(s[5], down_s, -0.05, 0.05);
  expect_down(s[6], down_s + 0.1 / kSpeed_m_s, -0.05, -0.05);
  expect_up(s[7], down_s + 0.1 / kSpeed_m_s + kLift_s, -0.05, -0.05);
  for (const PenSample& sample : s) EXPECT_FALSE(sample.pressure);
}

TEST_F(BrushScripts, TheBoxOfHandwritingIsTheSquareOfItsSide) {
  const auto script =
      read(R"({"box":[100,200,50],"strokes":[[[100,200],[150,225]]],"pressures":[[0,1]]})", "a.JSON", 0.02);
  ASSERT_TRUE(script) << base::to_line(script.error());
  ASSERT_EQ(script->samples.size(), 3U);
  expect_down(script->samples[0], 0, -0.01, 0.01);
  EXPECT_NEAR(script->samples[1].at.x, 0.01, 1e-12);
  EXPECT_NEAR(script->samples[1].at.y, 0, 1e-12);
  EXPECT_EQ(script->samples[0].pressure, 0);
  EXPECT_EQ(script->samples[1].pressure, 1);
  EXPECT_FALSE(script->character);
}

TEST_F(BrushScripts, TimesAreKeptFromTheFirstAndAMomentThatIsNotLaterIsLeftOut) {
  const auto script = read(R"({"strokes":[[[0.5,0.5],[0.6,0.5],[0.7,0.5],[0.8,0.5]],[[0.5,0.6],[0.5,0.7]]],
                               "times":[[5000,5400,5400,5500],[7000,7100]]})");
  ASSERT_TRUE(script) << base::to_line(script.error());
  const auto& s = script->samples;
  ASSERT_EQ(s.size(), 8U);
  expect_down(s[0], 0, 0, 0);
  expect_down(s[1], 0.4, 0.01, 0);
  expect_down(s[2], 0.5, 0.03, 0);
  expect_up(s[3], 0.5 + kLift_s, 0.03, 0);
  expect_up(s[4], 2 - kLift_s, 0, -0.01);
  expect_down(s[5], 2, 0, -0.01);
  expect_down(s[6], 2.1, 0, -0.02);
}

TEST_F(BrushScripts, TimesThatBeginAgainWithEachStrokeFollowEachOther) {
  const auto script = read(R"({"strokes":[[[0.5,0.5],[0.6,0.5]],[[0.5,0.6],[0.6,0.6]],[[0.5,0.7],[0.6,0.7]]],
               "times":[[0,1000],[0,1000],[0,1000]]})");
  ASSERT_TRUE(script) << base::to_line(script.error());
  const auto& s = script->samples;
  ASSERT_EQ(s.size(), 11U);
  const double second_s = 1 + kLift_s + kBetween_s;
  expect_down(s[4], second_s, 0, -0.01);
  expect_down(s[5], second_s + 1, 0.01, -0.01);
  expect_down(s[8], 2 * second_s, 0, -0.02);
  expect_down(s[9], 2 * second_s + 1, 0.01, -0.02);
}

TEST_F(BrushScripts, ATrajectoryKeepsItsMetresAndBeginsAtZero) {
  const auto script = read("t,x,y,z\n2,0.01,-0.02,0.003\n2.5,0.02,-0.03,-0.001\n", "a.csv");
  ASSERT_TRUE(script) << base::to_line(script.error());
  ASSERT_EQ(script->samples.size(), 2U);
  expect_down(script->samples[0], 0, 0.01, -0.02);
  expect_down(script->samples[1], 0.5, 0.02, -0.03);
  EXPECT_EQ(script->samples[0].height_m, 0.003);
  EXPECT_EQ(script->samples[1].height_m, -0.001);
}

TEST_F(BrushScripts, WhatIsWrongIsNamedWithTheFile) {
  EXPECT_THAT(refused("t,x,y,z\n0,0,0,nan\n", "b.csv"), HasSubstr("b.csv"));
  EXPECT_THAT(refused("", "b.txt"), HasSubstr("b.txt: has an unsupported file type"));
  EXPECT_THAT(refused("{"), HasSubstr("a.json"));
  EXPECT_THAT(refused("[1]"), HasSubstr("a.json: is not an object"));
  EXPECT_THAT(refused(R"({"strokes":[[[0,0]]],"char":7})"), HasSubstr("a.json: char: must be one character"));
  EXPECT_THAT(refused(R"({"strokes":[[[0,0]]],"char":""})"), HasSubstr("must be one character"));
  EXPECT_THAT(refused(R"({"strokes":[[[0,0],[9,9]]]})"), HasSubstr("a.json: box: is missing"));
  for (const char* pressure : {"-0.1", "1.1"})
    EXPECT_THAT(refused(std::string(R"({"strokes":[[[0,0]]],"pressures":[[)") + pressure + "]]}"),
                HasSubstr(std::string("has ") + pressure + ", but a pressure is 0 to 1"));
  EXPECT_FALSE(read_brush_script(folder_ / "none.json", 0.1));
}

}  // namespace
}  // namespace nazori::cli::test
