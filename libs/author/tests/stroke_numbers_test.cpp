// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/stroke_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace nazori::author {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string text_of(const std::vector<int>& strokes) { return stroke_numbers_text(strokes); }

TEST(StrokeNumbers, AreWrittenFromOneWithRangesFromThreeOn) {
  EXPECT_EQ(text_of({}), "");
  EXPECT_EQ(text_of({0}), "1");
  EXPECT_EQ(text_of({0, 1}), "1, 2");
  EXPECT_EQ(text_of({0, 1, 2}), "1-3");
  EXPECT_EQ(text_of({0, 2, 3, 4, 8, 9}), "1, 3-5, 9, 10");
}

TEST(StrokeNumbers, AreReadInAnyOrderWithCommasOrSpaces) {
  EXPECT_THAT(*parse_stroke_numbers("1, 2", 5), ElementsAre(0, 1));
  EXPECT_THAT(*parse_stroke_numbers("2,1", 5), ElementsAre(0, 1));
  EXPECT_THAT(*parse_stroke_numbers("1 2  5", 5), ElementsAre(0, 1, 4));
  EXPECT_THAT(*parse_stroke_numbers(" 1-3, 5,", 5), ElementsAre(0, 1, 2, 4));
  EXPECT_THAT(*parse_stroke_numbers("1 - 3", 5), ElementsAre(0, 1, 2));
  EXPECT_THAT(*parse_stroke_numbers("4-4", 5), ElementsAre(3));
  EXPECT_THAT(*parse_stroke_numbers("1-3, 2-4, 3", 5), ElementsAre(0, 1, 2, 3)) << "each once";
}

TEST(StrokeNumbers, AnEmptyTextNamesNone) {
  EXPECT_THAT(*parse_stroke_numbers("", 5), IsEmpty());
  EXPECT_THAT(*parse_stroke_numbers(" , ", 0), IsEmpty());
}

TEST(StrokeNumbers, WhatIsNotAStrokeIsRefused) {
  for (const char* text : {"0", "6", "1, 6", "-1", "1-", "1-6", "3-1", "1--2", "1-2-3", "x", "1x", "1, 2;",
                           "1.5", "99999999999999999999", "1-99999999999999999999", "+1"})
    EXPECT_FALSE(parse_stroke_numbers(text, 5)) << text;
  EXPECT_FALSE(parse_stroke_numbers("1", 0));
  EXPECT_FALSE(parse_stroke_numbers(std::string("1\0", 2), 5));
  const auto refused = parse_stroke_numbers("7", 5);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::Errc::bad_argument);
  EXPECT_NE(refused.error().remedy.find("1 to 5"), std::string::npos);
}

TEST(StrokeNumbers, WhatIsWrittenIsReadAgain) {
  constexpr int kStrokes = 9;
  for (unsigned chosen = 0; chosen < 1U << kStrokes; ++chosen) {
    std::vector<int> strokes;
    for (int i = 0; i < kStrokes; ++i)
      if ((chosen >> i & 1U) != 0) strokes.push_back(i);
    EXPECT_EQ(parse_stroke_numbers(stroke_numbers_text(strokes), kStrokes), strokes);
  }
}

}  // namespace
}  // namespace nazori::author
