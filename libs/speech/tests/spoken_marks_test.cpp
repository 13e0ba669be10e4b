// SPDX-License-Identifier: Apache-2.0
// Every sign that is not an ordinary kana, one by one.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "nazori/speech/spoken_kana.h"

namespace nazori::speech {
namespace {

std::string spoken_as(const std::string& text) {
  const auto spoken = spoken_kana(text);
  return spoken ? spoken->said : "refused";
}

TEST(SpokenMarks, EachMarkOfDictionariesIsLeftOut) {
  for (const char* mark : {".", "．", "・", "･", "-", "~", "～", "〜"})
    EXPECT_EQ(spoken_as("か" + std::string(mark) + "き"), "かき") << mark;
}

TEST(SpokenMarks, EachSpaceOrCommaIsOnePauseButNotAtAnEnd) {
  for (const char* mark : {" ", "　", "、", "､", ","}) {
    const std::string pause = mark;
    EXPECT_EQ(spoken_as("か" + pause + "き"), "か、き") << mark;
    EXPECT_EQ(spoken_as("か" + pause + pause + "き"), "か、き") << mark;
    EXPECT_EQ(spoken_as(pause + "か" + pause), "か") << mark;
  }
}

TEST(SpokenMarks, EachSmallKanaAloneIsSaidWithItsFullSize) {
  const std::vector<std::pair<const char*, const char*>> kana{
      {"ぁ", "あ"}, {"ぃ", "い"}, {"ぅ", "う"}, {"ぇ", "え"}, {"ぉ", "お"}, {"っ", "つ"},
      {"ゃ", "や"}, {"ゅ", "ゆ"}, {"ょ", "よ"}, {"ゎ", "わ"}, {"ゕ", "か"}, {"ゖ", "け"}};
  for (const auto& [small, full] : kana) EXPECT_EQ(spoken_as(small), "ちいさい、" + std::string(full));
}

TEST(SpokenMarks, KatakanaWithoutHiraganaAreSaidAsTwo) {
  const std::vector<std::pair<const char*, const char*>> kana{
      {"ヷ", "ゔぁ"}, {"ヸ", "ゔぃ"}, {"ヹ", "ゔぇ"}, {"ヺ", "ゔぉ"}};
  for (const auto& [one, two] : kana) EXPECT_EQ(spoken_as(one), two);
}

TEST(SpokenMarks, TheFirstAndTheLastHiraganaAreKanaAndTheirNeighboursAreNot) {
  EXPECT_EQ(spoken_as("あぁ"), "あぁ") << "U+3041";
  EXPECT_EQ(spoken_as("あゖ"), "あゖ") << "U+3096";
  EXPECT_EQ(spoken_as("あ\u3040"), "refused");
  EXPECT_EQ(spoken_as("あ\u3097"), "refused");
}

}  // namespace
}  // namespace nazori::speech
