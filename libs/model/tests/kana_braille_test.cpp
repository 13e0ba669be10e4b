// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/kana_braille.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace nazori::model {
namespace {

std::u32string patterns(const std::optional<std::vector<BrailleCell>>& cells) {
  std::u32string out;
  if (!cells) return U"none";
  for (const BrailleCell cell : *cells) out += static_cast<char32_t>(0x2800 + cell);
  return out;
}

/// @source ja-kantenji.utb of liblouis 3.24 (LGPL 2.1 or later). Its dots 2 3 7 5 6 8 are 1 to 6 here:
/// braille of eight dots keeps the six of kana in its lower rows.
const std::pair<const char*, const char32_t*> kPublished[] = {
    {"あ", U"⠁"},    {"い", U"⠃"},    {"う", U"⠉"},    {"え", U"⠋"},    {"お", U"⠊"},    {"か", U"⠡"},
    {"き", U"⠣"},    {"く", U"⠩"},    {"け", U"⠫"},    {"こ", U"⠪"},    {"が", U"⠐⠡"},   {"ぎ", U"⠐⠣"},
    {"ぐ", U"⠐⠩"},   {"げ", U"⠐⠫"},   {"ご", U"⠐⠪"},   {"さ", U"⠱"},    {"し", U"⠳"},    {"す", U"⠹"},
    {"せ", U"⠻"},    {"そ", U"⠺"},    {"ざ", U"⠐⠱"},   {"じ", U"⠐⠳"},   {"ず", U"⠐⠹"},   {"ぜ", U"⠐⠻"},
    {"ぞ", U"⠐⠺"},   {"た", U"⠕"},    {"ち", U"⠗"},    {"つ", U"⠝"},    {"て", U"⠟"},    {"と", U"⠞"},
    {"だ", U"⠐⠕"},   {"ぢ", U"⠐⠗"},   {"づ", U"⠐⠝"},   {"で", U"⠐⠟"},   {"ど", U"⠐⠞"},   {"な", U"⠅"},
    {"に", U"⠇"},    {"ぬ", U"⠍"},    {"ね", U"⠏"},    {"の", U"⠎"},    {"は", U"⠥"},    {"ひ", U"⠧"},
    {"ふ", U"⠭"},    {"へ", U"⠯"},    {"ほ", U"⠮"},    {"ば", U"⠐⠥"},   {"び", U"⠐⠧"},   {"ぶ", U"⠐⠭"},
    {"べ", U"⠐⠯"},   {"ぼ", U"⠐⠮"},   {"ぱ", U"⠠⠥"},   {"ぴ", U"⠠⠧"},   {"ぷ", U"⠠⠭"},   {"ぺ", U"⠠⠯"},
    {"ぽ", U"⠠⠮"},   {"ま", U"⠵"},    {"み", U"⠷"},    {"む", U"⠽"},    {"め", U"⠿"},    {"も", U"⠾"},
    {"や", U"⠌"},    {"ゆ", U"⠬"},    {"よ", U"⠜"},    {"ら", U"⠑"},    {"り", U"⠓"},    {"る", U"⠙"},
    {"れ", U"⠛"},    {"ろ", U"⠚"},    {"わ", U"⠄"},    {"を", U"⠔"},    {"ん", U"⠴"},    {"っ", U"⠂"},
    {"きゃ", U"⠈⠡"}, {"きゅ", U"⠈⠩"}, {"きょ", U"⠈⠪"}, {"ぎゃ", U"⠘⠡"}, {"ぎゅ", U"⠘⠩"}, {"ぎょ", U"⠘⠪"},
    {"しゃ", U"⠈⠱"}, {"しゅ", U"⠈⠹"}, {"しょ", U"⠈⠺"}, {"じゃ", U"⠘⠱"}, {"じゅ", U"⠘⠹"}, {"じょ", U"⠘⠺"},
    {"ちゃ", U"⠈⠕"}, {"ちゅ", U"⠈⠝"}, {"ちょ", U"⠈⠞"}, {"ぢゃ", U"⠘⠕"}, {"ぢゅ", U"⠘⠝"}, {"ぢょ", U"⠘⠞"},
    {"にゃ", U"⠈⠅"}, {"にゅ", U"⠈⠍"}, {"にょ", U"⠈⠎"}, {"ひゃ", U"⠈⠥"}, {"ひゅ", U"⠈⠭"}, {"ひょ", U"⠈⠮"},
    {"びゃ", U"⠘⠥"}, {"びゅ", U"⠘⠭"}, {"びょ", U"⠘⠮"}, {"ぴゃ", U"⠨⠥"}, {"ぴゅ", U"⠨⠭"}, {"ぴょ", U"⠨⠮"},
    {"みゃ", U"⠈⠵"}, {"みゅ", U"⠈⠽"}, {"みょ", U"⠈⠾"}, {"りゃ", U"⠈⠑"}, {"りゅ", U"⠈⠙"}, {"りょ", U"⠈⠚"},
    {"ー", U"⠒"}};

TEST(KanaBraille, EveryKanaIsThatOfThePublishedTable) {
  for (const auto& [kana, cells] : kPublished) EXPECT_EQ(patterns(kana_braille(kana)), cells) << kana;
  // The old kana are other ones in braille for kanji. @source Wikipedia, Japanese Braille.
  EXPECT_EQ(patterns(kana_braille("ゐゑ")), U"⠆⠖");
}

TEST(KanaBraille, KatakanaHasTheCellsOfHiragana) {
  EXPECT_EQ(patterns(kana_braille("キュウジツ")), patterns(kana_braille("きゅうじつ")));
  EXPECT_EQ(patterns(kana_braille("ノート")), U"⠎⠒⠞");
  EXPECT_EQ(patterns(kana_braille("ヴ")), U"⠐⠉");
}

TEST(KanaBraille, ADigitIsNotContinuedByAKanaWithTheCellOfADigit) {
  EXPECT_EQ(patterns(kana_braille("6かく")), U"⠼⠋⠡⠩");
  EXPECT_EQ(patterns(kana_braille("12かく")), U"⠼⠁⠃⠡⠩");
  EXPECT_EQ(patterns(kana_braille("6え")), U"⠼⠋⠤⠋");
  EXPECT_EQ(patterns(kana_braille("6り")), U"⠼⠋⠤⠓");
  EXPECT_EQ(patterns(kana_braille("6りょ")), U"⠼⠋⠈⠚");
  EXPECT_EQ(patterns(kana_braille("6 え")), U"⠼⠋⠀⠋");
}

TEST(KanaBraille, ALongVowelOfAReadingIsALineAndAnEndingIsNot) {
  EXPECT_EQ(patterns(reading_braille("キュウ")), U"⠈⠩⠒");
  EXPECT_EQ(patterns(reading_braille("コウ")), U"⠪⠒");
  EXPECT_EQ(patterns(reading_braille("ショウ")), U"⠈⠺⠒");
  EXPECT_EQ(patterns(reading_braille("ウ")), U"⠉");
  EXPECT_EQ(patterns(reading_braille("スイ")), U"⠹⠃");
  EXPECT_EQ(patterns(reading_braille("く.う")), U"⠩⠉");
  EXPECT_EQ(patterns(reading_braille("-ど")), U"⠐⠞");
  EXPECT_EQ(patterns(reading_braille("あ.う")), U"⠁⠉");
  EXPECT_EQ(patterns(reading_braille("アウ")), U"⠁⠉");
  EXPECT_EQ(patterns(reading_braille("やす.む")), U"⠌⠹⠽");
}

TEST(KanaBraille, WhatHasNoCellIsRefused) {
  for (const char* text : {"休", "ファ", "a", "き\xff"}) EXPECT_FALSE(kana_braille(text)) << text;
  EXPECT_FALSE(reading_braille("休"));
  EXPECT_TRUE(kana_braille("")->empty());
}

}  // namespace
}  // namespace nazori::model
