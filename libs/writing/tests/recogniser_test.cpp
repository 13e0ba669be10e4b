// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/recogniser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "drawing.h"

namespace nazori::writing::test {
namespace {

Recogniser small() {
  auto made = Recogniser::make({rest(), soil(), three(), eye()});
  EXPECT_TRUE(made);
  return std::move(*made);
}

char32_t first(const Recogniser& recogniser, const WrittenCharacter& ink) {
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
  extra.strokes.push_back(along({{80, 20}, {85, 30}}));
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

TEST(Recogniser, OfCharactersOfTheSameStrokesKanjiComeBeforeKanaAndThoseBeforeSigns) {
  const std::u32string kanji{0x3400, 0x9FFF, 0xF900, 0xFAFF, 0x20000, 0x4E8C};
  const std::u32string kana{0x3041, 0x3096, 0x30A1, 0x30FA};
  const std::u32string others{0x3040, 0x3097, 0x30A0, 0x30FB, 0x33FF, 0xA000, 0xF8FF, 0xFB00, 0x1FFFF};
  std::vector<kanji::Character> characters;
  for (const char32_t c : others + kana + kanji) {
    characters.push_back(soil());
    characters.back().code_point = c;
  }
  const auto recogniser = Recogniser::make(characters);
  ASSERT_TRUE(recogniser);
  const auto names = [&](const RecogniseOptions& options) {
    std::u32string found;
    const auto candidates = recogniser->recognise(trace(soil()), options);
    EXPECT_TRUE(candidates);
    for (const auto& c : *candidates) found += c.character;
    return found;
  };
  // Among equals the commoner comes first.
  EXPECT_EQ(names({19, false}), kanji + kana + others);
  EXPECT_EQ(names({19, true}), kanji + kana + others);
  EXPECT_EQ(names({}), kanji + kana) << "ten unless more are asked for";
  EXPECT_EQ(names({1, false}), kanji.substr(0, 1));
}

/// Which of 土 and a kana with the same strokes comes first where they stand at these places.
char32_t first_of_twins(std::size_t place_of_kana, std::size_t place_of_kanji) {
  std::vector<kanji::Character> characters(std::max(place_of_kana, place_of_kanji) + 1);
  for (const std::size_t place : {place_of_kana, place_of_kanji}) characters[place] = soil();
  characters[place_of_kana].code_point = U'ア';
  const auto recogniser = Recogniser::make(characters);
  EXPECT_TRUE(recogniser);
  return recogniser ? first(*recogniser, trace(soil())) : 0;
}

TEST(Recogniser, AKanjiComesBeforeTheKanaThatLooksTheSameUnlessHardlyAnybodyLooksForIt) {
  constexpr std::size_t kUnusual = 3285;
  EXPECT_EQ(first_of_twins(0, kUnusual - 1), U'土');
  EXPECT_EQ(first_of_twins(0, kUnusual), U'ア');
  EXPECT_EQ(first_of_twins(kUnusual, kUnusual + 1), U'土') << "the kana is as rare";
}

TEST(Recogniser, LikenessIsNearOneForTheModelAndFallsWithTheCost) {
  const auto found = small().recognise(trace(rest()));
  ASSERT_TRUE(found);
  EXPECT_GT(found->front().likeness, 0.94);
  EXPECT_LE(found->front().likeness, 1);
  for (std::size_t i = 1; i < found->size(); ++i) EXPECT_LT((*found)[i].likeness, 0.6);
}

TEST(Recogniser, PassesOverCharactersWithoutStrokesAndStrokesWithoutPoints) {
  auto holes = rest();
  holes.code_point = U'木';
  holes.strokes.push_back({});
  const auto recogniser = Recogniser::make({kanji::Character{}, holes, kanji::Character{}, soil()});
  ASSERT_TRUE(recogniser);
  EXPECT_EQ(recogniser->size(), 2);
  EXPECT_EQ(first(*recogniser, trace(rest())), U'木');
  EXPECT_EQ(first(*recogniser, trace(soil())), U'土');
}

TEST(Recogniser, ABeginningIsTheCharacterThatIsWholeBeforeThoseThatGoOn) {
  const auto one =
      character(U'一', {"㇐|M11,54.25c3.19,0.62,6.25,0.75,9.73,0.5c20.64-1.5,50.39-5.12,68.58-5.24"});
  const auto recogniser = Recogniser::make({three(), soil(), eye(), one});
  ASSERT_TRUE(recogniser);
  auto ink = trace(three());
  ink.strokes.resize(1);
  const auto found = recogniser->recognise(ink, {10, true});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->front().character, U'一');
  EXPECT_GE(found->size(), 3U) << "those that begin so are candidates too";
  ink.strokes = {trace(three()).strokes[0], trace(three()).strokes[1]};
  EXPECT_EQ(recogniser->recognise(ink, {10, true})->front().character, U'三');
}

TEST(Recogniser, RefusesBadInkAndEmptyCollections) {
  EXPECT_FALSE(small().recognise({}));
  EXPECT_FALSE(small().recognise(trace(rest()), {0, false}));
  EXPECT_FALSE(Recogniser::make(std::vector<kanji::Character>{}));
}

}  // namespace
}  // namespace nazori::writing::test
