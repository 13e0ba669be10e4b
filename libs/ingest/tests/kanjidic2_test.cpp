// SPDX-License-Identifier: Apache-2.0
#include "kanjidic2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace nazori::ingest {
namespace {

using testing::ElementsAre;

std::string xml(const std::string& characters) {
  return "<kanjidic2><header><date_of_creation>2022-08-23</date_of_creation></header>" + characters +
         "</kanjidic2>";
}
std::string trouble(const std::string& text) {
  const auto read = parse_kanjidic2(text);
  return read ? "" : read.error().what;
}

TEST(Kanjidic2, EveryElementComesWhereItBelongs) {
  const auto read = parse_kanjidic2(xml(
      "<character><literal>休</literal>"
      "<codepoint><cp_value cp_type='ucs'>4f11</cp_value><cp_value "
      "cp_type='jis208'>1-21-57</cp_value></codepoint>"
      "<radical><rad_value rad_type='classical'>9</rad_value><rad_value "
      "rad_type='nelson_c'>75</rad_value></radical>"
      "<misc><grade>1</grade><stroke_count>6</stroke_count><stroke_count>7</stroke_count><freq>642</"
      "freq><jlpt>4</jlpt></misc>"
      "<dic_number><dic_ref dr_type='moro' m_vol='1' m_page='0663'>440</dic_ref><dic_ref "
      "dr_type='heisig'>965</dic_ref></dic_number>"
      "<query_code><q_code qc_type='skip'>1-2-4</q_code><q_code qc_type='skip' "
      "skip_misclass='posn'>2-2-4</q_code></query_code>"
      "<reading_meaning><rmgroup><reading r_type='pinyin'>xiu1</reading><reading "
      "r_type='ja_on'>キュウ</reading>"
      "<reading r_type='ja_kun'>やす.む</reading><meaning m_lang='fr'>repos</meaning><meaning>rest</meaning>"
      "<meaning m_lang='en'>day off</meaning></rmgroup><nanori>やす</nanori></reading_meaning></character>"
      "<character><literal>日</literal></character>"));
  ASSERT_TRUE(read) << base::to_line(read.error());
  EXPECT_EQ(read->version, "2022-08-23");
  ASSERT_EQ(read->entries.size(), 2U);
  kanji::DictionaryEntry rest;
  rest.on_readings = {"キュウ"};
  rest.kun_readings = {"やす.む"};
  rest.nanori = {"やす"};
  rest.meanings = {{"en", "rest"}, {"en", "day off"}, {"fr", "repos"}};
  rest.grade = 1;
  rest.frequency = 642;
  rest.old_jlpt_level = 4;
  rest.stroke_counts = {6, 7};
  rest.radical = 9;
  rest.codes = {{"radical_nelson_c", "75"},
                {"jis208", "1-21-57"},
                {"skip", "1-2-4"},
                {"skip_misclass_posn", "2-2-4"},
                {"moro", "440 (vol. 1, p. 0663)"},
                {"heisig", "965"}};
  EXPECT_EQ(read->entries.at(U'休'), rest);
  EXPECT_EQ(read->entries.at(U'日'), kanji::DictionaryEntry{});
}

TEST(Kanjidic2, SaysWhatIsWrong) {
  EXPECT_EQ(trouble(xml("")), "has no characters");
  EXPECT_EQ(trouble("<other/>"), "has no characters");
  const std::string one = "<character><literal>休</literal></character>";
  EXPECT_EQ(trouble(xml(one)), "");
  EXPECT_EQ(trouble(xml(one + one)), "describes 休 twice");
  EXPECT_EQ(trouble(xml("<character/>")), "a literal is not one character: \"\"");
  EXPECT_EQ(trouble(xml("<character><literal>休日</literal></character>")),
            "a literal is not one character: \"休日\"");
  EXPECT_THAT(trouble("<kanjidic2><character>"), testing::HasSubstr("is not XML: "));
  EXPECT_THAT(trouble("<kanjidic2><character>"), testing::HasSubstr(" at byte "));
}

}  // namespace
}  // namespace nazori::ingest
