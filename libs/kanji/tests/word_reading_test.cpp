// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/word_reading.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace nazori::kanji {
namespace {

/// Readings as KANJIDIC2 (EDRDG, CC BY-SA 4.0) gives them.
std::vector<std::string> readings_of(char32_t c) {
  static const std::map<char32_t, std::vector<std::string>> known{
      {U'人', {"ジン", "ニン", "ひと", "-り", "-と"}},
      {U'三', {"サン", "ゾウ", "み", "み.つ", "みっ.つ"}},
      {U'村', {"ソン", "むら"}},
      {U'学', {"ガク", "まな.ぶ"}},
      {U'校', {"コウ", "キョウ"}},
      {U'休', {"キュウ", "やす.む", "やす.まる", "やす.める"}},
      {U'日', {"ニチ", "ジツ", "ひ", "-び", "-か"}},
      {U'今', {"コン", "キン", "いま"}},
      {U'受', {"ジュ", "う.ける", "-う.け", "う.かる"}},
      {U'付', {"フ", "つ.ける", "-つ.ける", "つ.く", "-づ.く"}},
      {U'話', {"ワ", "はな.す", "はなし"}},
      {U'出', {"シュツ", "スイ", "で.る", "だ.す"}},
      {U'発', {"ハツ", "ホツ", "た.つ"}},
      {U'一', {"イチ", "イツ", "ひと-", "ひと.つ"}},
      {U'匹', {"ヒツ", "ひき"}},
      {U'折', {"セツ", "お.る", "おり"}},
      {U'紙', {"シ", "かみ"}},
      {U'酒', {"シュ", "さけ", "さか-"}},
  };
  const auto found = known.find(c);
  return found == known.end() ? std::vector<std::string>() : found->second;
}

/// "さん|にん" with the dictionary's readings behind: "さん=サン|にん=ニン"; "-" where it cannot be divided.
std::string divided(const std::string& word, const std::string& reading) {
  const auto pieces = divide_reading(word, reading, readings_of);
  if (!pieces) return "-";
  std::string out;
  for (const auto& piece : *pieces) {
    if (!out.empty()) out += '|';
    out += piece.reading;
    if (!piece.from.empty()) out += '=' + piece.from;
  }
  return out;
}

TEST(WordReading, IsDividedAmongItsCharacters) {
  EXPECT_EQ(divided("三人", "さんにん"), "さん=サン|にん=ニン");
  EXPECT_EQ(divided("休日", "きゅうじつ"), "きゅう=キュウ|じつ=ジツ");
  EXPECT_EQ(divided("休む", "やすむ"), "やす=やす.む|む");
  EXPECT_EQ(divided("人", "ひと"), "ひと=ひと");
}

TEST(WordReading, FollowsTheChangesOfSoundWithinWords) {
  EXPECT_EQ(divided("村人", "むらびと"), "むら=むら|びと=ひと") << "voiced";
  EXPECT_EQ(divided("人々", "ひとびと"), "ひと=ひと|びと=ひと") << "repeated";
  EXPECT_EQ(divided("学校", "がっこう"), "がっ=ガク|こう=コウ") << "shortened";
  EXPECT_EQ(divided("出発", "しゅっぱつ"), "しゅっ=シュツ|ぱつ=ハツ") << "both";
  EXPECT_EQ(divided("一匹", "いっぴき"), "いっ=イチ|ぴき=ひき");
}

TEST(WordReading, KnowsVerbsWithoutTheirOkurigana) {
  EXPECT_EQ(divided("受付", "うけつけ"), "うけ=う.ける|つけ=つ.ける");
  EXPECT_EQ(divided("折紙", "おりがみ"), "おり=おり|がみ=かみ");
  EXPECT_EQ(divided("話", "はなし"), "はなし=はなし") << "the dictionary has it as it is";
}

TEST(WordReading, IsNotDividedWhereTheReadingsDoNotMakeIt) {
  EXPECT_EQ(divided("今日", "きょう"), "-");
  EXPECT_EQ(divided("休む", "やすみ"), "-") << "the kana differ";
  EXPECT_EQ(divided("休日", "きゅう"), "-") << "a character is left over";
  EXPECT_EQ(divided("休", "きゅうう"), "-") << "a sound is left over";
  EXPECT_EQ(divided("鬱", "うつ"), "-") << "no readings are known";
  EXPECT_EQ(divided("", ""), "-");
  EXPECT_EQ(divided("ひと", "びと"), "-");
  EXPECT_EQ(divided("人村", "びとむら"), "-") << "the first character is not voiced";
  EXPECT_EQ(divided("校学", "こうがっ"), "-") << "the last character is not shortened";
}

TEST(WordReading, ReadsKatakanaAsHiragana) { EXPECT_EQ(divided("ビル人", "びるじん"), "ビ|ル|じん=ジン"); }

TEST(WordReading, OfLongWordsIsFoundAtOnce) {
  std::string word;
  std::string reading;
  for (int i = 0; i < 30; ++i) {
    word += "一";
    reading += "いち";
  }
  EXPECT_NE(divided(word, reading), "-");
  EXPECT_EQ(divided(word, reading + "い"), "-");
}

}  // namespace
}  // namespace nazori::kanji
