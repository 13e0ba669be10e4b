// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/recogniser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawing.h"

namespace nazori::writing::test {
namespace {

Recogniser small() {
  auto made = Recogniser::make({rest(), soil(), three(), eye()});
  EXPECT_TRUE(made);
  return std::move(*made);
}

char32_t first(const Recogniser& recogniser, const Ink& ink) {
  const auto found = recogniser.recognise(ink);
  EXPECT_TRUE(found);
  return found && !found->empty() ? found->front().character : 0;
}

TEST(Recogniser, KnowsEachCharacterWhateverItsOrderAndDirection) {
  const auto recogniser = small();
  EXPECT_EQ(recogniser.size(), 4);
  for (const auto& c : {rest(), soil(), three(), eye()}) {
    auto ink = trace(c);
    EXPECT_EQ(first(recogniser, ink), c.code_point);
    std::reverse(ink.strokes.begin(), ink.strokes.end());
    for (auto& s : ink.strokes) s = reversed(s);
    EXPECT_EQ(first(recogniser, ink), c.code_point);
  }
}

TEST(Recogniser, PutsUpWithAMissingAnExtraAndAJoinedStroke) {
  const auto recogniser = small();
  auto missing = trace(rest());
  missing.strokes.erase(missing.strokes.begin() + 1);
  EXPECT_EQ(first(recogniser, missing), U'休');
  auto extra = trace(rest());
  extra.strokes.push_back(InkStroke{{{80, 20}, {85, 30}}, {}, {}});
  EXPECT_EQ(first(recogniser, extra), U'休');
  auto together = trace(rest());
  together.strokes[4] = joined(together.strokes[4], together.strokes[5]);
  together.strokes.pop_back();
  EXPECT_EQ(first(recogniser, together), U'休');
}

TEST(Recogniser, GuessesFromTheBeginning) {
  const auto recogniser = small();
  auto ink = trace(rest());
  ink.strokes.resize(3);
  const auto found = recogniser.recognise(ink, {10, true});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->front().character, U'休');
}

TEST(Recogniser, RanksAndLimits) {
  const auto recogniser = small();
  const auto found = recogniser.recognise(trace(soil()), {2, false});
  ASSERT_TRUE(found);
  ASSERT_LE(found->size(), 2U);
  EXPECT_GT(found->front().likeness, 0.5);
  for (std::size_t i = 1; i < found->size(); ++i) EXPECT_GE((*found)[i - 1].likeness, (*found)[i].likeness);
}

TEST(Recogniser, RefusesBadInkAndEmptyCollections) {
  EXPECT_FALSE(small().recognise({}));
  EXPECT_FALSE(small().recognise(trace(rest()), {0, false}));
  EXPECT_FALSE(Recogniser::make(std::vector<kanji::Character>{}));
}

}  // namespace
}  // namespace nazori::writing::test
