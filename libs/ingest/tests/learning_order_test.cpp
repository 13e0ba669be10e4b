// SPDX-License-Identifier: Apache-2.0
#include "learning_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace nazori::ingest {
namespace {

using kanji::CharacterKind;

TEST(CharacterKinds, EndWhereTheBlocksOfUnicodeDo) {
  using Range = std::pair<char32_t, char32_t>;
  const std::pair<CharacterKind, std::vector<Range>> kinds[] = {
      {CharacterKind::hiragana, {{0x3041, 0x3096}}},
      {CharacterKind::katakana, {{0x30A1, 0x30FA}, {0x30FC, 0x30FC}}},
      {CharacterKind::latin, {{U'0', U'9'}, {U'A', U'Z'}, {U'a', U'z'}}},
      {CharacterKind::ideograph,
       {{0x2E80, 0x2FDF}, {0x3005, 0x3007}, {0x3400, 0x9FFF}, {0xF900, 0xFAFF}, {0x20000, 0x3FFFF}}}};
  for (const auto& [kind, ranges] : kinds)
    for (const auto& [first, last] : ranges) {
      EXPECT_EQ(kind_of(first), kind) << std::hex << static_cast<std::uint32_t>(first);
      EXPECT_EQ(kind_of(last), kind) << std::hex << static_cast<std::uint32_t>(last);
      EXPECT_EQ(kind_of(first - 1), CharacterKind::other) << std::hex << static_cast<std::uint32_t>(first);
      EXPECT_EQ(kind_of(last + 1), CharacterKind::other) << std::hex << static_cast<std::uint32_t>(last);
    }
}

kanji::DictionaryEntry entry(std::optional<int> frequency, std::optional<int> grade) {
  kanji::DictionaryEntry e;
  e.frequency = frequency;
  e.grade = grade;
  return e;
}

TEST(LearningOrder, IsKanaLettersKanjiSignsAndThenWhatIsNotDrawn) {
  const std::map<char32_t, kanji::DictionaryEntry> dictionary{
      {U'一', entry(2, 1)},   {U'二', entry(9, 1)},     {U'丁', entry({}, 3)}, {U'七', entry({}, 1)},
      {U'万', entry({}, {})}, {U'丈', entry(2501, {})}, {U'日', entry(1, 1)},  {U'月', entry({}, 1)},
      {U'丨', entry({}, {})}, {U'上', entry(9, 2)}};
  const std::u32string drawn = U"一二丁七万丈上々、あガアぁがんーヷ9Aa";
  const auto order = learning_order({drawn.begin(), drawn.end()}, dictionary);
  EXPECT_EQ(std::u32string(order.begin(), order.end()), U"あんがぁアガヷー9Aa一二上丈七丁々万、日月丨");
}

TEST(LearningOrder, OfKanaIsTheTableOfFiftySoundsInBothScripts) {
  const std::u32string hiragana =
      U"あいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめもやゆよらりるれろわをん"
      U"がぎぐげござじずぜぞだぢづでどばびぶべぼぱぴぷぺぽぁぃぅぇぉっゃゅょゎゐゑゔゕゖ";
  std::u32string katakana;
  for (const char32_t c : hiragana) katakana += c + 0x60;
  const auto all = hiragana + katakana;
  const auto order = learning_order({all.begin(), all.end()}, {});
  EXPECT_EQ(std::u32string(order.begin(), order.end()), all);
}

EdictEntry word(const std::string& text, const std::string& gloss = "x", bool common = true) {
  EdictEntry e;
  e.text = text;
  e.senses = {{gloss}};
  e.common = common;
  return e;
}

TEST(WordPlaces, CountHiraganaHalfAndSumTheRanksOfTheRest) {
  const std::map<char32_t, kanji::DictionaryEntry> dictionary{{U'休', entry(642, 1)}, {U'鬱', entry({}, 8)}};
  const auto place = [&](const std::string& text) { return place_of_word(word(text), dictionary); };
  EXPECT_EQ(place("休み"), (WordPlace{true, false, false, 3, 642}));
  EXPECT_EQ(place("ああ"), (WordPlace{true, false, false, 2, 0}));
  EXPECT_EQ(place("鬱"), (WordPlace{true, false, false, 2, 2502}))
      << "without a rank it comes after all that have one";
  EXPECT_EQ(place("ペン"), (WordPlace{true, false, false, 4, 2 * 2502}));
  EXPECT_EQ(place("休休あ"), (WordPlace{true, false, false, 5, 2 * 642}));
}

TEST(WordPlaces, AreLateForUncommonAndUnusualWords) {
  EXPECT_TRUE(place_of_word(word("あ", "x", false), {}).uncommon);
  EXPECT_FALSE(place_of_word(word("あ"), {}).uncommon);
  for (const char* mark :
       {"(arch)", "(obs)", "(obsc)", "(rare)", "(ok)", "(oK)", "(ik)", "(iK)", "(io)", "(X)"})
    EXPECT_TRUE(place_of_word(word("あ", std::string("(uk) ") + mark + " old"), {}).unusual) << mark;
  EXPECT_FALSE(place_of_word(word("あ", "(uk) new"), {}).unusual);
  auto later = word("あ");
  later.senses.push_back({"(arch) old"});
  EXPECT_FALSE(place_of_word(later, {}).unusual) << "only its first gloss counts";
  EXPECT_LT((WordPlace{true, false, true, 9, 9}), (WordPlace{true, true, false, 0, 0}));
  EXPECT_LT((WordPlace{true, false, false, 9, 9}), (WordPlace{true, false, true, 0, 0}));
  EXPECT_LT((WordPlace{true, false, false, 1, 9}), (WordPlace{true, false, false, 2, 0}));
  EXPECT_LT((WordPlace{true, false, false, 1, 1}), (WordPlace{true, false, false, 1, 2}));
}

}  // namespace
}  // namespace nazori::ingest
