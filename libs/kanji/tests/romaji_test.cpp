// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/romaji.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "nazori/kanji/meaning_text.h"

namespace nazori::kanji {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

std::string first(std::string_view romaji) {
  const auto all = romaji_to_hiragana(romaji);
  return all.empty() ? std::string("(none)") : all.front();
}

TEST(Romaji, HepburnAndKunreiSpellTheSameSyllables) {
  // The syllables in which the two systems of the Cabinet notification of 1954 differ.
  const std::vector<std::pair<std::string, std::string>> pairs = {
      {"shi", "si"},  {"chi", "ti"},  {"tsu", "tu"},  {"fu", "hu"},   {"ji", "zi"},
      {"sha", "sya"}, {"shu", "syu"}, {"sho", "syo"}, {"cha", "tya"}, {"chu", "tyu"},
      {"cho", "tyo"}, {"ja", "zya"},  {"ju", "zyu"},  {"jo", "zyo"}};
  for (const auto& [hepburn, kunrei] : pairs) EXPECT_EQ(first(hepburn), first(kunrei)) << hepburn;
  EXPECT_EQ(first("shi"), "し");
  EXPECT_EQ(first("tsu"), "つ");
  EXPECT_EQ(first("sho"), "しょ");
  EXPECT_EQ(first("zyu"), "じゅ");
}

TEST(Romaji, SpellsWholeWords) {
  EXPECT_EQ(first("yasumu"), "やすむ");
  EXPECT_EQ(first("kyuujitsu"), "きゅうじつ");
  EXPECT_EQ(first("KYUU"), "きゅう");
  EXPECT_EQ(first("nihongo"), "にほんご");
  EXPECT_EQ(first("gakkou"), "がっこう");
  EXPECT_EQ(first("matcha"), "まっちゃ");
  EXPECT_EQ(first("mattya"), "まっちゃ");
  EXPECT_EQ(first("zasshi"), "ざっし");
  EXPECT_EQ(first("ra-men"), "らーめん");
  EXPECT_EQ(first("ｙａｓｕ"), "やす");
  EXPECT_EQ(first("yasu.mu"), "やすむ");
}

TEST(Romaji, TellsTheTwoKindsOfNApart) {
  EXPECT_EQ(first("kan"), "かん");
  EXPECT_EQ(first("kana"), "かな");
  EXPECT_EQ(first("kan'i"), "かんい");
  EXPECT_EQ(first("kani"), "かに");
  EXPECT_EQ(first("kanni"), "かんに");
  EXPECT_EQ(first("konnichiha"), "こんにちは");
  EXPECT_EQ(first("hann"), "はん");
  EXPECT_EQ(first("shin'yuu"), "しんゆう");
  EXPECT_EQ(first("shinyuu"), "しにゅう");
  EXPECT_EQ(first("shimbun"), "しんぶん");
  EXPECT_EQ(first("sampo"), "さんぽ");
  EXPECT_EQ(first("samma"), "さんま");
}

TEST(Romaji, ALongVowelMarkGivesEverySpellingItCanStandFor) {
  EXPECT_THAT(romaji_to_hiragana("kyū"), ElementsAre("きゅう", "きゅー"));
  EXPECT_THAT(romaji_to_hiragana("kyû"), ElementsAre("きゅう", "きゅー"));
  EXPECT_THAT(romaji_to_hiragana("ōkii"), Contains("おおきい"));
  EXPECT_THAT(romaji_to_hiragana("Tōkyō"), Contains("とうきょう"));
  EXPECT_THAT(romaji_to_hiragana("nēsan"), Contains("ねえさん"));
  EXPECT_THAT(romaji_to_hiragana("sensê"), Contains("せんせい"));
}

TEST(Romaji, TextThatIsNoRomajiSpellsNothing) {
  for (const std::string_view text : {"", "rest", "休", "3", "yas", "qa", "\xFF", "a\xE4", "ā:", ":"}) {
    EXPECT_THAT(romaji_to_hiragana(text), IsEmpty()) << text;
  }
  EXPECT_THAT(romaji_to_hiragana(std::string(1000, 'a')), IsEmpty());
  EXPECT_THAT(romaji_to_hiragana("āāāāāāāāāāāāāāāāāāāā"), IsEmpty());
}

TEST(Romaji, ASyllableStillBeingTypedCanBecomeEachThatBeginsSo) {
  EXPECT_THAT(romaji_beginnings("yas"),
              testing::AllOf(Contains("やす"), Contains("やし"), Contains("やしょ"), Not(Contains("やた"))));
  EXPECT_THAT(romaji_beginnings("ky"), testing::UnorderedElementsAre("きゃ", "きゅ", "きょ"));
  EXPECT_THAT(romaji_beginnings("kan"),
              testing::AllOf(Contains("かん"), Contains("かに"), Contains("かにょ")));
  EXPECT_THAT(romaji_beginnings("yasu"), ElementsAre("やす"));
  EXPECT_THAT(romaji_beginnings("kann"), ElementsAre("かん"));
  EXPECT_THAT(romaji_beginnings("休"), IsEmpty());
}

TEST(Kana, KatakanaOfEitherWidthBecomesHiragana) {
  EXPECT_EQ(to_hiragana("キュウ"), "きゅう");
  EXPECT_EQ(to_hiragana("ｷｭｳ"), "きゅう");
  EXPECT_EQ(to_hiragana("ｶﾞｯｺｳﾊﾟ"), "がっこうぱ");
  EXPECT_EQ(to_hiragana("ヴァ"), "ゔぁ");
  EXPECT_EQ(to_hiragana("休ーa"), "休ーa");
  EXPECT_EQ(to_hiragana("\xFF"), "\xFF");
}

TEST(Kana, AReadingIsSearchedWithoutItsMarks) {
  EXPECT_EQ(fold_reading("やす.む"), "やすむ");
  EXPECT_EQ(fold_reading("-うえ"), "うえ");
  EXPECT_EQ(fold_reading("うわ-"), "うわ");
  EXPECT_EQ(fold_reading("キュウ"), "きゅう");
  EXPECT_EQ(fold_reading("やす・む"), "やすむ");
}

TEST(MeaningText, IsLowerCaseWordsWithSingleSpaces) {
  EXPECT_EQ(fold_meaning("Day off (work), e.g."), "day off work e g");
  EXPECT_EQ(fold_meaning("  one's   own"), "one's own");
  EXPECT_EQ(fold_meaning("café"), "café");
  EXPECT_EQ(fold_meaning("--"), "");
}

}  // namespace
}  // namespace nazori::kanji
