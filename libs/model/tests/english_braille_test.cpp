// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/english_braille.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace nazori::model {
namespace {

using testing::Optional;
using testing::SizeIs;

std::u32string patterns(std::string_view text, EnglishBraille how = EnglishBraille::contracted) {
  const auto made = english_braille(text, how);
  if (!made || !*made) return U"none";
  std::u32string out;
  for (const BrailleCell cell : **made) out += static_cast<char32_t>(0x2800 + cell);
  return out;
}

using Examples = std::vector<std::pair<std::string, std::u32string>>;

void expect_all(const Examples& examples) {
  for (const auto& [text, cells] : examples) EXPECT_EQ(patterns(text), cells) << text;
}

/// @source The Rules of Unified English Braille, second edition 2013 (International Council on English
/// Braille), section 10.1, alphabetic wordsigns.
TEST(ContractedBraille, ALetterAloneIsAWord) {
  expect_all({{"but", U"⠃"},    {"can", U"⠉"},    {"do", U"⠙"},   {"every", U"⠑"}, {"from", U"⠋"},
              {"go", U"⠛"},     {"have", U"⠓"},   {"just", U"⠚"}, {"like", U"⠇"},  {"more", U"⠍"},
              {"not", U"⠝"},    {"people", U"⠏"}, {"so", U"⠎"},   {"quite", U"⠟"}, {"that", U"⠞"},
              {"rather", U"⠗"}, {"us", U"⠥"},     {"very", U"⠧"}, {"will", U"⠺"},  {"knowledge", U"⠅"},
              {"it", U"⠭"},     {"you", U"⠽"},    {"as", U"⠵"}});
}

/// @source as above, sections 10.2 to 10.4: strong wordsigns, strong contractions, strong groupsigns.
TEST(ContractedBraille, StrongSignsAreUsed) {
  expect_all({{"child", U"⠡"},
              {"shall", U"⠩"},
              {"this", U"⠹"},
              {"which", U"⠱"},
              {"out", U"⠳"},
              {"still", U"⠌"},
              {"and", U"⠯"},
              {"for", U"⠿"},
              {"of", U"⠷"},
              {"the", U"⠮"},
              {"with", U"⠾"},
              {"rest", U"⠗⠑⠌"},
              {"walking", U"⠺⠁⠇⠅⠬"}});
}

/// @source as above, sections 10.7 to 10.9: initial-letter contractions, final-letter groupsigns, shortforms.
TEST(ContractedBraille, SignsOfTwoCellsAndShortformsAreUsed) {
  expect_all({{"day", U"⠐⠙"},
              {"mother", U"⠐⠍"},
              {"father", U"⠐⠋"},
              {"character", U"⠐⠡"},
              {"work", U"⠐⠺"},
              {"upon", U"⠘⠥"},
              {"word", U"⠘⠺"},
              {"these", U"⠘⠮"},
              {"cannot", U"⠸⠉"},
              {"world", U"⠸⠺"},
              {"spirit", U"⠸⠎"},
              {"many", U"⠸⠍"},
              {"mountain", U"⠍⠨⠞⠁⠔"},
              {"action", U"⠁⠉⠰⠝"},
              {"about", U"⠁⠃"},
              {"receive", U"⠗⠉⠧"}});
}

/// @source as above, sections 7 (punctuation), 8 (capitals) and 6 (numbers).
TEST(ContractedBraille, CapitalsBracketsAndNumbersHaveTheirSigns) {
  expect_all(
      {{"Braille", U"⠠⠃⠗⠇"}, {"(go)", U"⠐⠣⠛⠐⠜"}, {"12", U"⠼⠁⠃"}, {"don't", U"⠙⠕⠝⠄⠞"}, {"day off", U"⠐⠙⠀⠷⠋"}});
}

TEST(ContractedBraille, IsTheSameAtEachCall) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(patterns("rest"), U"⠗⠑⠌");
}

TEST(ContractedBraille, WhatIsNotLatinHasNoCells) {
  EXPECT_EQ(patterns("休"), U"none");
  EXPECT_EQ(patterns("a\nb"), U"none");
  EXPECT_EQ(patterns("\xFF"), U"none");
  EXPECT_EQ(patterns(""), U"");
  EXPECT_EQ(patterns("caf\u00E9"), U"⠉⠁⠋⠘⠌⠑");  // the acute accent before its letter: section 4.2
}

TEST(ContractedBraille, LatinLettersAndTheirPunctuationAreTakenUpToTheirBounds) {
  for (const char* text : {"\x1F", "\x7F", "\u00A0", "\u0180", "\u2012", "\u201E", "\u2025", "\u2027"})
    EXPECT_EQ(patterns(text), U"none") << text;
  for (const char* text : {" ", "~", "\u00A1", "\u017E", "\u2013", "\u201D", "\u2026"}) {
    EXPECT_NE(patterns(text), U"none") << text;
    EXPECT_NE(patterns(text), U"") << text;
  }
}

TEST(EnglishBraille, WithoutContractionsCapitalsAreSmallLetters) {
  EXPECT_EQ(patterns("AZaz", EnglishBraille::uncontracted), U"⠁⠵⠁⠵");
  for (const char* text : {"@", "[", "`", "{"})
    EXPECT_EQ(patterns(text, EnglishBraille::uncontracted), U"none") << text;
}

TEST(EnglishBraille, WithoutContractionsEachLetterHasItsCell) {
  EXPECT_EQ(patterns("Rest", EnglishBraille::uncontracted), U"⠗⠑⠎⠞");
  EXPECT_EQ(patterns("day off", EnglishBraille::uncontracted), U"⠙⠁⠽⠀⠕⠋⠋");
  EXPECT_EQ(patterns("(go)", EnglishBraille::uncontracted), U"none");
}

TEST(EnglishBraille, ALongTextIsTakenWholeAndALongerOneRefused) {
  const std::string longest(kLongestBrailleText, 'q');
  for (const auto how : {EnglishBraille::uncontracted, EnglishBraille::contracted}) {
    const auto made = english_braille(longest, how);
    ASSERT_TRUE(made) << base::to_line(made.error());
    EXPECT_THAT(*made, Optional(SizeIs(longest.size())));
    EXPECT_FALSE(english_braille(longest + 'q', how));
  }
}

}  // namespace
}  // namespace nazori::model
