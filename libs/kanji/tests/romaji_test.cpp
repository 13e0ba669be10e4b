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
  EXPECT_EQ(first("ya su"), "やす");
  EXPECT_EQ(first("ZAza"), "ざざ");
  EXPECT_EQ(first("AZA"), "あざ");
  EXPECT_EQ(first("tta"), "った");
  EXPECT_EQ(first("-"), "ー");
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
  EXPECT_EQ(first("onna"), "おんな");
  EXPECT_EQ(first("kannya"), "かんにゃ");
  EXPECT_EQ(first("hannbun"), "はんぶん");
  EXPECT_EQ(first("kan’i"), "かんい");
  EXPECT_EQ(first("n"), "ん");
  EXPECT_EQ(first("nn"), "ん");
  EXPECT_EQ(first("nk"), "(none)");
  EXPECT_EQ(first("km"), "(none)");
  EXPECT_EQ(first("mka"), "(none)");
}

TEST(Romaji, ALongVowelMarkGivesEverySpellingItCanStandFor) {
  EXPECT_THAT(romaji_to_hiragana("kyū"), ElementsAre("きゅう", "きゅー"));
  EXPECT_THAT(romaji_to_hiragana("kyû"), ElementsAre("きゅう", "きゅー"));
  EXPECT_THAT(romaji_to_hiragana("ōkii"), Contains("おおきい"));
  EXPECT_THAT(romaji_to_hiragana("Tōkyō"), Contains("とうきょう"));
  EXPECT_THAT(romaji_to_hiragana("nēsan"), Contains("ねえさん"));
  EXPECT_THAT(romaji_to_hiragana("sensê"), Contains("せんせい"));
  // Which kana can lengthen which vowel, in upper and lower case, with macron and circumflex.
  EXPECT_THAT(romaji_to_hiragana("kā"), ElementsAre("かあ", "かー"));
  EXPECT_THAT(romaji_to_hiragana("kî"), ElementsAre("きい", "きー"));
  EXPECT_THAT(romaji_to_hiragana("kū"), ElementsAre("くう", "くー"));
  EXPECT_THAT(romaji_to_hiragana("kê"), ElementsAre("けい", "けえ", "けー"));
  EXPECT_THAT(romaji_to_hiragana("kō"), ElementsAre("こう", "こお", "こー"));
  for (const auto& [marked, plain] : std::vector<std::pair<std::string, std::string>>{
           {"āâĀÂ", "ああ"}, {"īîĪÎ", "いい"}, {"ūûŪÛ", "うう"}, {"ēêĒÊ", "えい"}, {"ōôŌÔ", "おう"}}) {
    for (std::size_t i = 0; i < marked.size(); i += 2) EXPECT_EQ(first(marked.substr(i, 2)), plain) << marked;
  }
  EXPECT_THAT(romaji_to_hiragana("āāāāāā"), testing::SizeIs(64)) << "as many as are tried";
  EXPECT_THAT(romaji_to_hiragana("āāāōō"), testing::SizeIs(0)) << "72";
}

TEST(Romaji, TextThatIsNoRomajiSpellsNothing) {
  for (const std::string_view text :
       {"",   "rest", "休", "3",  "yas", "qa", "\xFF", "a\xE4", "ā:", ":",  "@a",
        "[a", "`a",   "{a", "a,", "k￡", "t",  "tc",   "tca",   "''", "k'a"}) {
    EXPECT_THAT(romaji_to_hiragana(text), IsEmpty()) << text;
  }
  EXPECT_THAT(romaji_to_hiragana(std::string(64, 'a')), testing::SizeIs(1));
  EXPECT_THAT(romaji_to_hiragana(std::string(65, 'a')), IsEmpty()) << "longer than any word";
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
  EXPECT_THAT(romaji_beginnings(""), IsEmpty());
  EXPECT_THAT(romaji_beginnings("yask1"), IsEmpty());
  EXPECT_THAT(romaji_beginnings("qa"), IsEmpty());
  EXPECT_THAT(romaji_beginnings("kan-"), ElementsAre("かんー"));
  EXPECT_THAT(romaji_beginnings("as"), testing::UnorderedElementsAre("あさ", "あし", "あす", "あせ", "あそ",
                                                                     "あしゃ", "あしゅ", "あしょ", "あしぇ"))
      << "each once, however it is spelled";
  EXPECT_THAT(romaji_beginnings("an"), testing::UnorderedElementsAre("あん", "あな", "あに", "あぬ", "あね",
                                                                     "あの", "あにゃ", "あにゅ", "あにょ"));
}

TEST(Kana, KatakanaOfEitherWidthBecomesHiragana) {
  EXPECT_EQ(to_hiragana("キュウ"), "きゅう");
  EXPECT_EQ(to_hiragana("ｷｭｳ"), "きゅう");
  EXPECT_EQ(to_hiragana("ｶﾞｯｺｳﾊﾟ"), "がっこうぱ");
  EXPECT_EQ(to_hiragana("ヴァ"), "ゔぁ");
  EXPECT_EQ(to_hiragana("ァヶ"), "ぁゖ") << "the first and the last that have a hiragana";
  EXPECT_EQ(to_hiragana("゠ヷ休ーa"), "゠ヷ休ーa");
  EXPECT_EQ(to_hiragana("\xFF"), "\xFF");
  EXPECT_EQ(to_hiragana("ｦｧｨｩｪｫｬｭｮｯｰｱｲｳｴｵｶｷｸｹｺｻｼｽｾｿﾀﾁﾂﾃﾄﾅﾆﾇﾈﾉﾊﾋﾌﾍﾎﾏﾐﾑﾒﾓﾔﾕﾖﾗﾘﾙﾚﾛﾜﾝ"),
            "をぁぃぅぇぉゃゅょっーあいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめもやゆ"
            "よらりるれろわん");
  EXPECT_EQ(to_hiragana("･"), "･") << "the sign before the letters";
}

TEST(Kana, AVoicingMarkOfHalfWidthJoinsOnlyALetterThatCanBeVoiced) {
  EXPECT_EQ(to_hiragana("ｶﾞｷﾞｸﾞｹﾞｺﾞｻﾞｼﾞｽﾞｾﾞｿﾞﾀﾞﾁﾞﾂﾞﾃﾞﾄﾞﾊﾞﾋﾞﾌﾞﾍﾞﾎﾞ"),
            "がぎぐげござじずぜぞだぢづでどばびぶべぼ");
  EXPECT_EQ(to_hiragana("ﾊﾟﾋﾟﾌﾟﾍﾟﾎﾟ"), "ぱぴぷぺぽ");
  EXPECT_EQ(to_hiragana("ﾞ"), "ﾞ");
  EXPECT_EQ(to_hiragana("ﾟ"), "ﾟ");
  EXPECT_EQ(to_hiragana("ﾅﾞ"), "なﾞ");
  EXPECT_EQ(to_hiragana("ﾄﾟ"), "とﾟ");
  EXPECT_EQ(to_hiragana("ﾏﾟ"), "まﾟ");
  EXPECT_EQ(to_hiragana("ﾊﾞﾟ"), "ばﾟ");
  EXPECT_EQ(to_hiragana("ﾊﾞﾞ"), "ばﾞ");
}

TEST(Kana, AReadingIsSearchedWithoutItsMarks) {
  EXPECT_EQ(fold_reading("やす.む"), "やすむ");
  EXPECT_EQ(fold_reading("-うえ"), "うえ");
  EXPECT_EQ(fold_reading("うわ-"), "うわ");
  EXPECT_EQ(fold_reading("キュウ"), "きゅう");
  for (const std::string mark : {".", "．", "-", "・", "･", " ", "　"})
    EXPECT_EQ(fold_reading(mark + "やす" + mark + "む" + mark), "やすむ") << mark;
  EXPECT_EQ(fold_reading("やー、！"), "やー、！") << "all else stays";
  EXPECT_EQ(fold_reading("\xFF"), "");
}

TEST(MeaningText, IsLowerCaseWordsWithSingleSpaces) {
  EXPECT_EQ(fold_meaning("Day off (work), e.g."), "day off work e g");
  EXPECT_EQ(fold_meaning("  one's   own"), "one's own");
  EXPECT_EQ(fold_meaning("café"), "café");
  EXPECT_EQ(fold_meaning("--"), "");
  EXPECT_EQ(fold_meaning("AZaz09"), "azaz09");
  EXPECT_EQ(fold_meaning("a@b[c`d{e/f:g"), "a b c d e f g") << "the signs beside letters and digits";
  EXPECT_EQ(fold_meaning("x\xC2\x80y"), "x\xC2\x80y");
}

}  // namespace
}  // namespace nazori::kanji
