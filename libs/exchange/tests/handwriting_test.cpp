// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/handwriting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace nazori::exchange {
namespace {

base::Result<writing::WrittenCharacter> read(const char* text) {
  return read_handwriting(json::parse(text).value());
}

TEST(Handwriting, IsStrokesOfPointsWithTimesAndPressures) {
  const auto ink = read(R"({"strokes": [[[1, 2], [3, 4, 99]], [[5.5, -6]]],
                            "times": [[0, 250], [1000]], "pressures": [[0, 0.5], [1]], "box": [10, 20, 30]})");
  ASSERT_TRUE(ink);
  ASSERT_EQ(ink->strokes.size(), 2U);
  EXPECT_EQ(ink->strokes[0][1].at.x, 3);
  EXPECT_EQ(ink->strokes[0][1].at.y, 4);
  EXPECT_EQ(ink->strokes[1][0].at.y, -6);
  EXPECT_EQ(ink->strokes[0][1].time_s, 0.25);
  EXPECT_EQ(ink->strokes[1][0].pressure, 1);
  ASSERT_TRUE(ink->box);
  EXPECT_EQ(ink->box->corner.x, 10);
  EXPECT_EQ(ink->box->corner.y, 20);
  EXPECT_EQ(ink->box->side, 30);
}

TEST(Handwriting, WithoutABoxIsInOneOfSideOneWhereAllPointsAre) {
  EXPECT_TRUE(read(R"({"strokes": [[[0, 0], [1, 1]]]})")->box);
  EXPECT_EQ(read(R"({"strokes": [[[0, 0], [1, 1]]]})")->box->side, 1);
  EXPECT_FALSE(read(R"({"strokes": [[[0, 0], [1, 1.01]]]})")->box);
  EXPECT_FALSE(read(R"({"strokes": [[[-0.01, 0], [1, 1]]]})")->box);
}

TEST(Handwriting, TimesOfOneStrokeMayBeLeftEmpty) {
  const auto ink = read(R"({"strokes": [[[1, 2]], [[3, 4]]], "times": [[], [7]]})");
  ASSERT_TRUE(ink);
  EXPECT_FALSE(ink->strokes[0][0].time_s);
  EXPECT_EQ(ink->strokes[1][0].time_s, 0.007);
}

TEST(Handwriting, WhatIsWrongIsNamedByItsPlace) {
  struct Wrong {
    const char* text;
    const char* where;
  };
  for (const auto& [text, where] :
       {Wrong{"{}", "strokes"}, Wrong{R"({"strokes": 1})", "strokes"},
        Wrong{R"({"strokes": [1]})", "strokes[0]"},
        Wrong{R"({"strokes": [[[1, 2]], [[3, 4], [5]]]})", "strokes[1][1]"},
        Wrong{R"({"strokes": [[[1, 2], {"x": 1}]]})", "strokes[0][1]"},
        Wrong{R"({"strokes": [[[1, "2"]]]})", "strokes[0][0]"},
        Wrong{R"({"strokes": [[[null, 2]]]})", "strokes[0][0]"},
        Wrong{R"({"strokes": [[[1, 2]]], "times": [[0], [1]]})", "times"},
        Wrong{R"({"strokes": [[[1, 2]]], "times": [["0"]]})", "times[0]"},
        Wrong{R"({"strokes": [[[1, 2]]], "times": [{"at": 0}]})", "times[0]"},
        Wrong{R"({"strokes": [[[1, 2]]], "times": [0]})", "times[0]"},
        Wrong{R"({"strokes": [[[1, 2]], [[1, 2]]], "times": [[0], [0, 1]]})", "stroke 2"},
        Wrong{R"({"strokes": [[[1, 2]]], "pressures": 1})", "pressures"},
        Wrong{R"({"strokes": [[[1, 2]]], "box": [1, 2]})", "box"},
        Wrong{R"({"strokes": [[[1, 2]]], "box": null})", "box"}}) {
    const auto ink = read(text);
    ASSERT_FALSE(ink) << text;
    EXPECT_EQ(ink.error().where, where) << text;
  }
}

TEST(Handwriting, ComesBackAsItWasWritten) {
  const auto ink =
      read(R"({"strokes": [[[1, 2], [3, 4]], [[5.5, 6]]], "times": [[0, 250], [1000]], "box": [0, 0, 109]})");
  ASSERT_TRUE(ink);
  const Value json = to_json(*ink);
  EXPECT_EQ(
      json::to_line(json),
      R"({"strokes":[[[1.0,2.0],[3.0,4.0]],[[5.5,6.0]]],"times":[[0.0,250.0],[1000.0]],"box":[0.0,0.0,109.0]})");
  const auto again = read_handwriting(json);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->strokes, ink->strokes);
}

TEST(Handwriting, IsWrittenWithoutTimesWhereOnePointHasNone) {
  auto ink = read(R"({"strokes": [[[1, 2], [3, 4]]], "times": [[0, 250]], "pressures": [[0.5, 0.5]]})");
  ink->strokes[0][1].time_s.reset();
  EXPECT_FALSE(to_json(*ink).contains("times"));
  EXPECT_TRUE(to_json(*ink).contains("pressures"));
  EXPECT_FALSE(to_json(*ink).contains("box"));
}

}  // namespace
}  // namespace nazori::exchange
