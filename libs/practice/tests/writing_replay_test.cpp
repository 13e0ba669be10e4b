// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_replay.h"

#include <gtest/gtest.h>

namespace nazori::practice {
namespace {

/// Two strokes of eleven points: one in the first second, one in the third.
std::vector<HandStroke> two_strokes() {
  HandStroke first, second;
  for (int i = 0; i <= 10; ++i) {
    first.push_back({{-0.03 + 0.006 * i, 0.03}, 5 + 0.1 * i, 0.5});
    second.push_back({{-0.03 + 0.006 * i, -0.03}, 7 + 0.1 * i, 0.5});
  }
  return {first, second};
}

Tablet upright_model() {
  return *tablet::CarvedTablet::from_lines({tablet::TabletLine({{54.5, 20}, {54.5, 89}})}, 128);
}

TEST(WritingReplay, ShowsTheWritingAtItsOwnSpeed) {
  WritingReplay replay;
  EXPECT_EQ(replay.duration_s(), 0);
  EXPECT_EQ(replay.points_written(-1), 0U);
  replay.set(two_strokes(), upright_model());
  EXPECT_EQ(replay.points_written(-1), 22U) << "before and after a replay everything is there";
  EXPECT_EQ(replay.points_written(0), 1U);
  EXPECT_EQ(replay.points_written(0.55), 6U);
  EXPECT_EQ(replay.written(0, 0.55).size(), 6U);
  EXPECT_TRUE(replay.written(1, 1.5).empty());
  EXPECT_EQ(replay.points_written(2.05), 12U);
  EXPECT_EQ(replay.points_written(100), 22U);
  EXPECT_EQ(replay.written(1, -1).size(), 11U);
}

TEST(WritingReplay, LastsAsLongAsTheLongerOfBoth) {
  WritingReplay replay;
  replay.set({}, upright_model());
  const double model_s = replay.duration_s();
  EXPECT_GT(model_s, 0.5);
  auto slow = two_strokes();
  slow[1].back().time_s = 105.5;
  replay.set(slow, upright_model());
  EXPECT_EQ(replay.duration_s(), 100.5);
  replay.set({{{{0, 0}, 1, 0.5}, {{0.01, 0}, 1.01, 0.5}}}, upright_model());
  EXPECT_EQ(replay.duration_s(), model_s);
}

TEST(WritingReplay, TheModelIsWrittenAtOnceWithIt) {
  WritingReplay replay;
  replay.set(two_strokes(), upright_model());
  ASSERT_EQ(replay.model_strokes(), 1);
  const auto all = replay.model_written(1, -1);
  ASSERT_GE(all.size(), 2U);
  EXPECT_NEAR(all.front().y - all.back().y, (89 - 20) / 109.0 * 0.1, 1e-9);
  EXPECT_TRUE(replay.model_written(1, 0).size() < 2);
  const auto half = replay.model_written(1, 0.7);
  ASSERT_FALSE(half.empty());
  EXPECT_GT(half.back().y, all.back().y);
  EXPECT_LT(half.back().y, all.front().y);
}

TEST(WritingReplay, AnotherModelReplacesTheFirst) {
  WritingReplay replay;
  replay.set({}, upright_model());
  replay.set({},
             *tablet::CarvedTablet::from_lines(
                 {tablet::TabletLine({{20, 20}, {80, 20}}), tablet::TabletLine({{20, 80}, {80, 80}})}, 128));
  EXPECT_EQ(replay.model_strokes(), 2);
}

}  // namespace
}  // namespace nazori::practice
