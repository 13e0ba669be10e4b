// SPDX-License-Identifier: Apache-2.0
#include "nazori/speech/spoken_kana.h"

#include <gtest/gtest.h>

#include <string>

namespace nazori::speech {
namespace {

std::string said(std::string_view text) {
  const auto spoken = spoken_kana(text);
  return spoken ? spoken->said : "refused: " + spoken.error().what;
}

TEST(SpokenKana, IsHiraganaWhateverTheSyllabary) {
  EXPECT_EQ(said("か"), "か");
  EXPECT_EQ(said("コーヒー"), "こーひー");
  EXPECT_EQ(said("ｶﾞｯｺｳ"), "がっこう");
  EXPECT_EQ(said("ヷ"), "ゔぁ");
  EXPECT_EQ(said("ヺ"), "ゔぉ");
}

TEST(SpokenKana, TakesSoundMarksThatStandAlone) {
  EXPECT_EQ(said("か\u3099"), "が");
  EXPECT_EQ(said("ハ\u309Aン"), "ぱん");
  EXPECT_EQ(said("\u3099"), "refused: only kana can be spoken");
  EXPECT_EQ(said("な\u3099"), "refused: only kana can be spoken");
}

TEST(SpokenKana, LeavesOutTheMarksOfDictionariesAndKeepsPauses) {
  EXPECT_EQ(said("やす.む"), "やすむ");
  EXPECT_EQ(said("-やす・み～"), "やすみ");
  EXPECT_EQ(said("きゅう、 やすむ"), "きゅう、やすむ");
  EXPECT_EQ(said(" か　"), "か");
  EXPECT_EQ(said("か,き"), "か、き");
}

TEST(SpokenKana, ASmallKanaAloneIsSaidByItsName) {
  const auto tsu = spoken_kana("ッ");
  ASSERT_TRUE(tsu);
  EXPECT_EQ(*tsu, (SpokenKana{"っ", "ちいさい、つ"}));
  EXPECT_EQ(said("ょ"), "ちいさい、よ");
  EXPECT_EQ(said("ー"), "のばすおん");
  EXPECT_EQ(said("きゃ"), "きゃ") << "only alone";
  EXPECT_EQ(said("つ"), "つ");
}

TEST(SpokenKana, RefusesAllElse) {
  EXPECT_EQ(said(""), "refused: there is nothing to speak");
  EXPECT_EQ(said("、 ・"), "refused: there is nothing to speak");
  EXPECT_EQ(said("か休"), "refused: only kana can be spoken");
  EXPECT_EQ(said("ka"), "refused: only kana can be spoken");
  EXPECT_EQ(said("\xE3\x81"), "refused: is not UTF-8");
  std::string most;
  EXPECT_EQ(kMostSpokenKana, 60U);
  for (std::size_t i = 0; i < kMostSpokenKana; ++i) most += "か";
  EXPECT_EQ(said(most), most);
  EXPECT_EQ(said(most + "か"), "refused: is too long to be spoken");
}

TEST(SpokenKana, CountsAKatakanaThatBecomesTwoHiraganaAsTwo) {
  std::string pairs;
  std::string spoken;
  for (std::size_t i = 0; i < kMostSpokenKana / 2; ++i) {
    pairs += "ヷ";
    spoken += "ゔぁ";
  }
  EXPECT_EQ(said(pairs), spoken);
  EXPECT_EQ(said(pairs + "ヷ"), "refused: is too long to be spoken");
}

}  // namespace
}  // namespace nazori::speech
