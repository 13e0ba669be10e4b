// SPDX-License-Identifier: Apache-2.0
#include "nazori/ingest/edict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace nazori::ingest {
namespace {

using testing::ElementsAre;

EdictEntry read(std::string_view line) {
  const auto entry = parse_edict_line(line);
  EXPECT_TRUE(entry) << line << ": " << (entry ? "" : entry.error().what);
  return entry.value_or(EdictEntry{});
}

TEST(EdictLine, HasWordReadingGlossesAndMarks) {
  EXPECT_EQ(read("休日 [きゅうじつ] /(n) holiday/day off/(P)/"),
            (EdictEntry{"休日", "きゅうじつ", {{"holiday", "day off"}}, "n", true}));
}

TEST(EdictLine, KeepsSensesApart) {
  const EdictEntry rest = read(
      "休む [やすむ] /(v5m,vi) (1) to be absent/to take a day off/(v5m,vi) (2) to rest/to have a break/(P)/");
  EXPECT_THAT(rest.senses, ElementsAre(ElementsAre("to be absent", "to take a day off"),
                                       ElementsAre("to rest", "to have a break")));
  EXPECT_EQ(rest.parts_of_speech, "v5m,vi");
  EXPECT_TRUE(rest.common);
}

TEST(EdictLine, LeavesMarksThatAreNoPartOfSpeechInTheGloss) {
  const EdictEntry night = read(
      "お休み [おやすみ] /(n) (1) (pol) holiday/absence/(n) (2) (hon) sleep/(exp) (3) (abbr) (uk) Good "
      "night/(P)/");
  EXPECT_THAT(night.senses, ElementsAre(ElementsAre("(pol) holiday", "absence"), ElementsAre("(hon) sleep"),
                                        ElementsAre("(abbr) (uk) Good night")));
  EXPECT_EQ(night.parts_of_speech, "n,exp");
}

TEST(EdictLine, LeavesBracketsOfTheEnglish) {
  EXPECT_THAT(read("休め [やすめ] /(int) (stand) at ease!/").senses,
              ElementsAre(ElementsAre("(stand) at ease!")));
  EXPECT_THAT(read("鳴る [なる] /(v5r) (of a bell) to ring/").senses,
              ElementsAre(ElementsAre("(of a bell) to ring")));
  EXPECT_THAT(read("あ /(int) Ah! (expressing surprise)/").senses,
              ElementsAre(ElementsAre("Ah! (expressing surprise)")));
  EXPECT_THAT(read("あ /(unclosed bracket/").senses, ElementsAre(ElementsAre("(unclosed bracket")));
}

TEST(EdictLine, MayLackAReading) {
  const EdictEntry yes = read("ああ /(adv) like that/so/(P)/");
  EXPECT_EQ(yes.text, "ああ");
  EXPECT_EQ(yes.reading, "");
  EXPECT_EQ(yes.senses.front().size(), 2U);
}

TEST(EdictLine, IsCommonOnlyWithItsMark) {
  EXPECT_FALSE(read("休肝日 [きゅうかんび] /(n) (joc) teetotal day/").common);
  EXPECT_TRUE(read("休日 /(P) holiday/").common);
  EXPECT_FALSE(read("Ｐ /(Paper) size/").common);
}

TEST(EdictLine, RefusesWhatDoesNotFollowTheFormat) {
  for (const char* line :
       {"", "/", "休日", "休日 [きゅうじつ]", "休日 [きゅうじつ] /", "休日 [きゅうじつ] //",
        "休日 [] /holiday/", "休日 [きゅうじつ /holiday/", "休日 [きゅうじつ] /holiday",
        " [きゅうじつ] /holiday/", "/holiday/", "４° [しど] /", "休日 /(n) (P)/", "休日 [/a/"}) {
    const auto entry = parse_edict_line(line);
    ASSERT_FALSE(entry) << line;
    EXPECT_EQ(entry.error().code, base::Errc::parse);
    EXPECT_FALSE(entry.error().what.empty());
  }
}

}  // namespace
}  // namespace nazori::ingest
