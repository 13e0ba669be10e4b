// SPDX-License-Identifier: Apache-2.0
#include "nazori/ingest/edict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

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

TEST(EdictLine, EveryMarkOfTheDocumentationIsAPartOfSpeech) {
  for (const std::string mark : {"adj-f", "adj-i", "adv", "conj", "ctr", "exp", "int", "n", "n-t", "num",
                                 "pn", "v1", "v5u", "v5uru", "vi", "vs", "vt", "vz"})
    EXPECT_EQ(read("休 /(" + mark + ") rest/").parts_of_speech, mark);
  EXPECT_EQ(read("休 /(n,vs,n) rest/(vs) stop/").parts_of_speech, "n,vs") << "each once";
  EXPECT_THAT(read("休 /(n,uk) rest/").senses, ElementsAre(ElementsAre("(n,uk) rest")))
      << "one of them is none";
}

TEST(EdictLine, ASenseHasAtMostThreeFigures) {
  EXPECT_THAT(read("休 /(1) a/(999) b/").senses, ElementsAre(ElementsAre("a"), ElementsAre("b")));
  EXPECT_THAT(read("休 /(1) a/(1000) b/").senses, ElementsAre(ElementsAre("a", "(1000) b")));
  EXPECT_THAT(read("休 /(1a) a/() b/").senses, ElementsAre(ElementsAre("(1a) a", "() b")));
  EXPECT_THAT(read("休 /a/(2) b/c/").senses, ElementsAre(ElementsAre("a"), ElementsAre("b", "c")));
  EXPECT_THAT(read("休 /(1)/(2) b/").senses, ElementsAre(ElementsAre("b"))) << "no sense is empty";
  EXPECT_THAT(read("休 /a/(2)/").senses, ElementsAre(ElementsAre("a")));
}

TEST(EdictLine, BlanksAroundItsPartsDoNotCount) {
  EXPECT_EQ(read("  休日  [ きゅうじつ ]  /  (n)  holiday  / day off /(P)/"),
            (EdictEntry{"休日", "きゅうじつ", {{"holiday", "day off"}}, "n", true}));
  EXPECT_EQ(read("a b /c  d/"), (EdictEntry{"a b", "", {{"c  d"}}, "", false}));
}

TEST(EdictLine, SaysWhatIsWrong) {
  const auto wrong = [](std::string_view line) {
    const auto entry = parse_edict_line(line);
    return entry ? std::string() : entry.error().what;
  };
  EXPECT_EQ(wrong("休日"), "no '/' before the glosses");
  EXPECT_EQ(wrong("休日 /"), "no '/' after the last gloss");
  EXPECT_EQ(wrong("休日 /a"), "no '/' after the last gloss");
  EXPECT_EQ(wrong("休日 /a/"), "");
  EXPECT_EQ(wrong("/a/"), "no word");
  EXPECT_EQ(wrong("[a] /a/"), "no word");
  EXPECT_EQ(wrong("休日 [a /a/"), "the reading has no closing bracket");
  EXPECT_EQ(wrong("休日 [] /a/"), "the reading is empty");
  EXPECT_EQ(wrong("休日 [ ] /a/"), "the reading is empty");
  EXPECT_EQ(wrong("休日 //"), "no gloss");
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
