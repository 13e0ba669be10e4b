// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/kana_sound.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/romaji.h"

namespace nazori::kanji {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(KanaSound, IsHepburnInEitherSyllabary) {
  for (const auto& [kana, romaji] : std::vector<std::pair<char32_t, const char*>>{{U'あ', "a"},
                                                                                  {U'シ', "shi"},
                                                                                  {U'ち', "chi"},
                                                                                  {U'ツ', "tsu"},
                                                                                  {U'ふ', "fu"},
                                                                                  {U'ん', "n"},
                                                                                  {U'ジ', "ji"},
                                                                                  {U'ぽ', "po"}}) {
    ASSERT_TRUE(kana_sound(kana));
    EXPECT_EQ(*kana_sound(kana), (KanaSound{romaji, "", false}));
  }
}

TEST(KanaSound, SaysHowKanaThatSoundTheSameAreTyped) {
  EXPECT_EQ(*kana_sound(U'ぢ'), (KanaSound{"ji", "di", false}));
  EXPECT_EQ(*kana_sound(U'ヅ'), (KanaSound{"zu", "du", false}));
  EXPECT_EQ(*kana_sound(U'を'), (KanaSound{"o", "wo", false}));
  EXPECT_EQ(*kana_sound(U'ゃ'), (KanaSound{"ya", "", true}));
  EXPECT_EQ(*kana_sound(U'ッ'), (KanaSound{"tsu", "", true}));
  EXPECT_EQ(*kana_sound(U'ー'), (KanaSound{"-", "", false}));
  EXPECT_EQ(*kana_sound(U'ヹ'), (KanaSound{"ve", "", false}));
  for (const char32_t other : {U'休', U'a', U'ゝ', U'。', char32_t{0}}) EXPECT_FALSE(kana_sound(other));
}

TEST(KanaSound, NoTwoFullSizeKanaAreAskedForInTheSameWay) {
  std::vector<std::string> asked;
  for (char32_t kana = U'ぁ'; kana <= U'ゔ'; ++kana) {
    const auto sound = kana_sound(kana);
    ASSERT_TRUE(sound) << static_cast<std::uint32_t>(kana);
    const std::string question = sound->romaji + "/" + sound->typed + (sound->is_small ? "/small" : "");
    EXPECT_THAT(asked, testing::Not(Contains(question)));
    asked.push_back(question);
    EXPECT_EQ(kana_sound(in_other_syllabary(kana)), sound);
  }
}

TEST(KanaSound, CanBeTypedBack) {
  for (char32_t kana = U'あ'; kana <= U'ん'; ++kana) {
    const auto sound = kana_sound(kana);
    if (sound->is_small) continue;
    const auto typed = romaji_to_hiragana(sound->typed.empty() ? sound->romaji : sound->typed);
    EXPECT_THAT(typed, Contains(base::encode_utf8(kana))) << sound->romaji;
  }
}

TEST(RomajiOf, IsHepburnThatTellsTheSpelling) {
  for (const auto& [kana, romaji] : std::vector<std::pair<const char*, const char*>>{{"いぬ", "inu"},
                                                                                     {"がっこう", "gakkou"},
                                                                                     {"きゃ", "kya"},
                                                                                     {"じゅう", "juu"},
                                                                                     {"まっちゃ", "matcha"},
                                                                                     {"こんや", "kon'ya"},
                                                                                     {"こんにち", "konnichi"},
                                                                                     {"しんあい", "shin'ai"},
                                                                                     {"コーヒー", "kōhī"},
                                                                                     {"ファン", "fan"},
                                                                                     {"パーティー", "pātī"},
                                                                                     {"シェフ", "shefu"},
                                                                                     {"ウィ", "wi"},
                                                                                     {"あっ", "a'"},
                                                                                     {"きや", "kiya"},
                                                                                     {"", ""},
                                                                                     {"休み", "休mi"}})
    EXPECT_EQ(romaji_of(kana), romaji) << kana;
}

TEST(TeachingRank, FollowsTheTableThenTheSmallKanaThenTheVoicedOnes) {
  constexpr std::u32string_view kTable =
      U"あいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめもやゆよらりるれろわをん";
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    EXPECT_EQ(teaching_rank(kTable[i]), static_cast<int>(i));
    EXPECT_EQ(teaching_rank(in_other_syllabary(kTable[i])), static_cast<int>(i));
  }
  EXPECT_GT(teaching_rank(U'ゃ'), teaching_rank(U'ん'));
  EXPECT_GT(teaching_rank(U'が'), teaching_rank(U'ょ'));
  EXPECT_GT(teaching_rank(U'ぱ'), teaching_rank(U'ぼ'));
  EXPECT_GT(teaching_rank(U'ぁ'), teaching_rank(U'ぽ'));
  EXPECT_GT(teaching_rank(U'ゐ'), teaching_rank(U'ぉ'));
  EXPECT_GT(teaching_rank(U'ヺ'), teaching_rank(U'ヷ'));
  EXPECT_GT(teaching_rank(U'ヷ'), teaching_rank(U'ヴ'));
  EXPECT_EQ(teaching_rank(U'休'), std::nullopt);
}

TEST(SimilarKana, AreThoseThatBeginnersMistake) {
  EXPECT_THAT(similar_kana(U'ぬ'), ElementsAre(U'め'));
  EXPECT_THAT(similar_kana(U'シ'), ElementsAre(U'ツ', U'ン'));
  EXPECT_THAT(similar_kana(U'れ'), ElementsAre(U'ね', U'わ'));
  EXPECT_THAT(similar_kana(U'ば'), ElementsAre(U'は', U'ぱ'));
  EXPECT_THAT(similar_kana(U'ガ'), ElementsAre(U'カ'));
  EXPECT_THAT(similar_kana(U'休'), IsEmpty());
  EXPECT_THAT(similar_kana(U'ん'), ElementsAre(U'え'));
  for (char32_t kana = U'ぁ'; kana <= U'ヺ'; ++kana)
    for (const char32_t other : similar_kana(kana)) {
      EXPECT_EQ(script_of(other), script_of(kana));
      EXPECT_NE(other, kana);
    }
}

TEST(Combinations, ArePairsOfAKanaAndASmallOne) {
  EXPECT_THAT(combinations_with(U'き'), ElementsAre("きゃ", "きゅ", "きょ"));
  EXPECT_THAT(combinations_with(U'ジ'), ElementsAre("ジャ", "ジュ", "ジョ"));
  EXPECT_THAT(combinations_with(U'ょ'), ElementsAre("きょ", "しょ", "ちょ", "にょ", "ひょ", "みょ", "りょ",
                                                    "ぎょ", "じょ", "びょ", "ぴょ"));
  EXPECT_THAT(combinations_with(U'か'), IsEmpty());
  EXPECT_THAT(combinations_with(U'や'), IsEmpty());
  for (const char32_t kana : {U'き', U'し', U'ち', U'じ', U'ぴ'})
    for (const auto& one : combinations_with(kana))
      EXPECT_THAT(romaji_to_hiragana(romaji_of(one)), Contains(one));
}

}  // namespace
}  // namespace nazori::kanji
