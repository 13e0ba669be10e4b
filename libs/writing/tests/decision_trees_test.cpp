// SPDX-License-Identifier: Apache-2.0
#include "decision_trees.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>

namespace nazori::writing {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr std::size_t kFeatures = 3;
constexpr unsigned char kAnswer = 255;

void put_node(Bytes& to, unsigned char feature, unsigned right, float value) {
  to.push_back(feature);
  for (unsigned shift = 0; shift < 16; shift += 8) to.push_back(static_cast<unsigned char>(right >> shift));
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (unsigned shift = 0; shift < 32; shift += 8) to.push_back(static_cast<unsigned char>(bits >> shift));
}

/// Up to 0.5 in feature 1 the answer is -2, else 3.
Bytes one_split() {
  Bytes bytes;
  put_node(bytes, 1, 2, 0.5F);
  put_node(bytes, kAnswer, 0, -2);
  put_node(bytes, kAnswer, 0, 3);
  return bytes;
}

/// Feature 0 up to 10: feature 2 up to -1 is 1, above 2; feature 0 above 10: 4.
Bytes split_on_the_left() {
  Bytes bytes;
  put_node(bytes, 0, 4, 10);
  put_node(bytes, 2, 2, -1);
  put_node(bytes, kAnswer, 0, 1);
  put_node(bytes, kAnswer, 0, 2);
  put_node(bytes, kAnswer, 0, 4);
  return bytes;
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

float answer_of(const Bytes& bytes, std::array<float, kFeatures> features) {
  const auto trees = DecisionTrees::read(bytes, kFeatures);
  EXPECT_TRUE(trees);
  return trees ? trees->answer(features) : std::numeric_limits<float>::quiet_NaN();
}

TEST(DecisionTrees, GoLeftUpToTheLimitAndRightAboveIt) {
  EXPECT_EQ(answer_of(one_split(), {9, 0.5F, 9}), -2);
  EXPECT_EQ(answer_of(one_split(), {9, -7, 9}), -2);
  EXPECT_EQ(answer_of(one_split(), {-9, 0.5001F, -9}), 3);
}

TEST(DecisionTrees, FindTheRightChildBehindTheWholeLeftOne) {
  EXPECT_EQ(answer_of(split_on_the_left(), {10, 0, -1}), 1);
  EXPECT_EQ(answer_of(split_on_the_left(), {10, 0, 0}), 2);
  EXPECT_EQ(answer_of(split_on_the_left(), {11, 0, -1}), 4);
}

TEST(DecisionTrees, AddTheirAnswers) {
  Bytes constant;
  put_node(constant, kAnswer, 0, 100);
  const auto bytes = constant + one_split() + split_on_the_left();
  EXPECT_EQ(answer_of(bytes, {0, 1, 0}), 105);
  EXPECT_EQ(answer_of(bytes, {20, 0, 0}), 102);
  EXPECT_EQ(DecisionTrees::read(bytes, kFeatures)->count(), 3U);
}

TEST(DecisionTrees, ThatAreNoneAnswerNothing) {
  EXPECT_EQ(answer_of({}, {1, 2, 3}), 0);
  EXPECT_EQ(DecisionTrees::read({}, kFeatures)->count(), 0U);
}

TEST(DecisionTrees, AreAsManyAsTwoBytesCountAndNoMore) {
  Bytes bytes;
  for (int tree = 0; tree < 65'535; ++tree) put_node(bytes, kAnswer, 0, 1);
  const auto most = DecisionTrees::read(bytes, kFeatures);
  ASSERT_TRUE(most);
  EXPECT_EQ(most->count(), 65'535U);
  put_node(bytes, kAnswer, 0, 1);
  EXPECT_FALSE(DecisionTrees::read(bytes, kFeatures));
}

TEST(DecisionTrees, CutOffAnywhereAreNotRead) {
  const auto whole = one_split() + split_on_the_left();
  for (std::size_t size = 1; size < whole.size(); ++size) {
    if (size == one_split().size()) continue;
    EXPECT_FALSE(DecisionTrees::read(std::span(whole).first(size), kFeatures)) << size;
  }
}

TEST(DecisionTrees, OfAFeatureThatIsNotThereAreNotRead) {
  EXPECT_TRUE(DecisionTrees::read(one_split(), 2));
  EXPECT_FALSE(DecisionTrees::read(one_split(), 1));
}

TEST(DecisionTrees, WhoseRightChildLiesElsewhereAreNotRead) {
  for (const unsigned right : {0U, 1U, 3U, 500U}) {
    Bytes bytes;
    put_node(bytes, 1, right, 0.5F);
    put_node(bytes, kAnswer, 0, -2);
    put_node(bytes, kAnswer, 0, 3);
    EXPECT_FALSE(DecisionTrees::read(bytes, kFeatures)) << right;
  }
}

TEST(DecisionTrees, WithAnAnswerThatHasAChildOrIsNoNumberAreNotRead) {
  Bytes with_child;
  put_node(with_child, kAnswer, 1, 3);
  EXPECT_FALSE(DecisionTrees::read(with_child, kFeatures));
  for (const float value :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    Bytes bytes;
    put_node(bytes, kAnswer, 0, value);
    EXPECT_FALSE(DecisionTrees::read(bytes, kFeatures));
  }
}

}  // namespace
}  // namespace nazori::writing
