// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/character_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/kanji/kana.h"
#include "nazori/kanji/own_characters.h"

namespace nazori::kanji {
namespace {

using testing::ElementsAre;

std::vector<CharacterName> parsed(std::vector<std::string> arguments) {
  auto names = parse_characters(arguments);
  EXPECT_TRUE(names) << base::to_line(names.error());
  return names ? *names : std::vector<CharacterName>{};
}

std::string refused(const std::string& argument) {
  const std::vector arguments{argument};
  const auto names = parse_characters(arguments);
  return names ? "" : names.error().what;
}

TEST(CharacterName, IsACharacterAVariantOrACodePoint) {
  EXPECT_THAT(
      parsed({"休", "休-Kaisho", "U+4F11", "u+6728-Hz1"}),
      ElementsAre(CharacterName{U'休', ""}, CharacterName{U'休', "Kaisho"}, CharacterName{U'木', "Hz1"}));
}

TEST(CharacterName, OneArgumentMayNameSeveralAndEachCountsOnce) {
  EXPECT_THAT(parsed({"休日 休", "日\uFE00本　"}),
              ElementsAre(CharacterName{U'休', ""}, CharacterName{U'日', ""}, CharacterName{U'本', ""}));
}

TEST(CharacterName, AKanaAndItsSoundMarkAreOneCharacter) {
  EXPECT_THAT(parsed({"か\u3099は\u309Aう\u3099"}),
              ElementsAre(CharacterName{U'が', ""}, CharacterName{U'ぱ', ""}, CharacterName{U'ゔ', ""}));
}

TEST(CharacterName, WhatNamesNoneIsRefused) {
  EXPECT_EQ(refused("\xFF"), "is not valid UTF-8");
  EXPECT_EQ(refused("  "), "contains no character");
  for (const char* wrong : {"U+110000", "U+D800", "U+4F11x", "U+4F11-", "休-", "休-かい"})
    EXPECT_EQ(refused(wrong), "is not the name of a character") << wrong;
}

TEST(CharacterName, ReadsAsItIsNamedAndNamesAFile) {
  EXPECT_EQ((CharacterName{U'休', ""}.text()), "休");
  EXPECT_EQ((CharacterName{U'休', "Kaisho"}.text()), "休-Kaisho");
  EXPECT_EQ((CharacterName{U' ', ""}.text()), "U+0020");
  EXPECT_EQ((CharacterName{U'/', ""}.text()), "/");
  EXPECT_EQ((CharacterName{U'/', ""}.file_name()), "U+002F");
  EXPECT_EQ((CharacterName{U'.', "A"}.file_name()), "U+002E-A");
  EXPECT_EQ((CharacterName{U'休', "Kaisho"}.file_name()), "休-Kaisho");
}

/// @source The Unicode Standard, UnicodeData.txt, canonical decompositions.
TEST(Kana, TakeTheirSoundMarkWhereOneIsWritten) {
  EXPECT_EQ(with_sound_mark(U'か', 0x3099), U'が');
  EXPECT_EQ(with_sound_mark(U'ハ', 0x3099), U'バ');
  EXPECT_EQ(with_sound_mark(U'ハ', 0x309A), U'パ');
  EXPECT_EQ(with_sound_mark(U'ウ', 0x3099), U'ヴ');
  EXPECT_EQ(with_sound_mark(U'ゝ', 0x3099), U'ゞ');
  EXPECT_EQ(with_sound_mark(U'か', 0x309A), 0U);
  EXPECT_EQ(with_sound_mark(U'あ', 0x3099), 0U);
  EXPECT_EQ(with_sound_mark(U'か', U'か'), 0U);
}

TEST(Kana, OneSyllabaryAnswersTheOther) {
  EXPECT_EQ(in_other_syllabary(U'あ'), U'ア');
  EXPECT_EQ(in_other_syllabary(U'ン'), U'ん');
  EXPECT_EQ(in_other_syllabary(U'ゖ'), U'ヶ');
  for (const char32_t none : {U'ー', U'ゝ', U'ヽ', U'ヷ', U'休', U'a'})
    EXPECT_EQ(in_other_syllabary(none), 0U);
}

TEST(Kana, AScriptIsTheBlockOfItsCharacters) {
  EXPECT_EQ(script_of(U'ぁ'), Script::hiragana);
  EXPECT_EQ(script_of(U'ゟ'), Script::hiragana);
  EXPECT_EQ(script_of(U'゠'), Script::katakana);
  EXPECT_EQ(script_of(U'ヿ'), Script::katakana);
  EXPECT_EQ(script_of(U'7'), Script::latin);
  EXPECT_EQ(script_of(U'ａ'), Script::latin);
  EXPECT_EQ(script_of(U'休'), Script::other);
  EXPECT_EQ(script_of(0x250), Script::other);
}

TEST(Names, OfOwnCharactersAreTheirCodePoints) {
  EXPECT_EQ((CharacterName{kFirstOwn, ""}).text(), "U+F0000");
  EXPECT_EQ((CharacterName{kLastOwn, ""}).text(), "U+FFFFD");
  EXPECT_EQ((CharacterName{kFirstOwn - 1, ""}).text(), "\xF3\xAF\xBF\xBF");
  const std::string named[] = {"U+F0000"};
  EXPECT_EQ(parse_characters(named).value().front().code_point, kFirstOwn);
}

}  // namespace
}  // namespace nazori::kanji
