// SPDX-License-Identifier: Apache-2.0
#include "did_you_mean.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace nazori::cli {
namespace {

const std::vector<std::string> kWords{"info", "search", "carve", "render", "record", "recognise", "study"};

TEST(DidYouMean, FindsAWordWithALetterLeftOutAddedChangedOrSwapped) {
  EXPECT_EQ(meant_word("carv", kWords), "carve");
  EXPECT_EQ(meant_word("ifno", kWords), "info");
  EXPECT_EQ(meant_word("carrve", kWords), "carve");
  EXPECT_EQ(meant_word("serach", kWords), "search");
  EXPECT_EQ(meant_word("sturdy", kWords), "study");
  EXPECT_EQ(meant_word("recor", kWords), "record");
  EXPECT_EQ(meant_word("rendre", kWords), "render");
}

TEST(DidYouMean, LongerWordsMayHaveMoreMistakes) {
  EXPECT_EQ(meant_word("recongize", kWords), "recognise");
  EXPECT_EQ(meant_word("rekongize", kWords), std::nullopt) << "three mistakes";
  EXPECT_EQ(meant_word("ikfo", kWords), "info");
  EXPECT_EQ(meant_word("ikno", kWords), std::nullopt) << "half of a short word is wrong";
}

TEST(DidYouMean, FindsTheOnlyWordThatBeginsSo) {
  EXPECT_EQ(meant_word("rend", kWords), "render");
  EXPECT_EQ(meant_word("recog", kWords), "recognise");
  EXPECT_EQ(meant_word("re", kWords), std::nullopt) << "render, record or recognise";
}

TEST(DidYouMean, TakesTheNearestAndOfEqualOnesTheFirst) {
  const std::vector<std::string> words{"size", "side", "sides"};
  EXPECT_EQ(meant_word("sie", words), "size");
  EXPECT_EQ(meant_word("siden", words), "side");
  EXPECT_EQ(meant_word("sidse", words), "side");
}

TEST(DidYouMean, SaysNothingWhereNothingIsNear) {
  EXPECT_EQ(meant_word("frobnicate", kWords), std::nullopt);
  EXPECT_EQ(meant_word("", kWords), std::nullopt);
  EXPECT_EQ(meant_word("x", std::vector<std::string>{"y"}), std::nullopt) << "nothing of it is right";
  EXPECT_EQ(meant_word(std::string(50'000, 'c'), kWords), std::nullopt);
  EXPECT_EQ(meant_word("carve", {}), std::nullopt);
}

}  // namespace
}  // namespace nazori::cli
