// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

std::vector<std::string> found(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "search");
  arguments.emplace_back("--json");
  const Outcome run = nazori_cli(arguments);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  std::vector<std::string> characters;
  for (const Json& one : Json::parse(run.out)) characters.push_back(one["character"]);
  return characters;
}

TEST(Search, FindsByMeaningReadingRomajiAndCharacter) {
  EXPECT_THAT(found({"rest"}), Contains("休"));
  EXPECT_THAT(found({"day", "off"}), Contains("休"));
  EXPECT_THAT(found({"やすむ"}), Contains("休"));
  EXPECT_THAT(found({"やす.む"}), Contains("休"));
  EXPECT_THAT(found({"キュウ"}), Contains("休"));
  EXPECT_THAT(found({"kyuu"}), Contains("休"));
  EXPECT_EQ(found({"休"}).at(0), "休");
}

TEST(Search, ConditionsAllHold) {
  // Six strokes under radical 9 in first grade: 休 alone.
  EXPECT_THAT(found({"--grade", "1", "--strokes", "6", "--radical", "9"}), testing::ElementsAre("休"));
  EXPECT_THAT(found({"--grade", "1", "--strokes", "6", "--radical", "亻"}), testing::ElementsAre("休"));
}

TEST(Search, FindsByPartsAndCodes) {
  // KANJIDIC2 (EDRDG, CC BY-SA 4.0): 休 has SKIP 1-2-4 and the four-corner code 2429.0.
  EXPECT_THAT(found({"--parts", "木亻"}), Contains("休"));
  EXPECT_THAT(found({"--skip", "1-2-4"}), Contains("休"));
  EXPECT_THAT(found({"--four-corner", "2429.0"}), Contains("休"));
  EXPECT_THAT(found({"--jlpt", "4", "--grade", "1"}), Contains("休"));
  EXPECT_EQ(found({"--frequency", "50"}).size(), 50U);
  expect_one_line(nazori_cli({"search", "--skip", "9-9-9"}), 2, {"SKIP", "1-2-4"});
  expect_one_line(nazori_cli({"search", "--four-corner", "x"}), 2, {"four-corner", "2429.0"});
}

TEST(Search, NamesWordsWithTheirMeaning) {
  for (const char* text : {"きゅうじつ", "kyuujitsu", "holiday"}) {
    const Outcome run = nazori_cli({"search", text});
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.out, HasSubstr("休日")) << text;
    EXPECT_THAT(run.out, HasSubstr("day off")) << text;
  }
  EXPECT_THAT(nazori_cli({"search", "off"}).out, HasSubstr("(day off)")) << "why 休 is found";
}

TEST(Search, TheFirstGradeHasEightyCharacters) {
  const auto characters = found({"--grade", "1"});
  EXPECT_EQ(std::set<std::string>(characters.begin(), characters.end()).size(), 80U);
}

TEST(Search, TheLimitIsKept) { EXPECT_EQ(found({"--grade", "6", "--limit", "7"}).size(), 7U); }

TEST(Search, ForPeopleOneLineEach) {
  const Outcome run = nazori_cli({"search", "休"});
  EXPECT_EQ(run.code, 0);
  const std::string line = run.out.substr(0, run.out.find('\n'));
  for (const char* part : {"休", "6 strokes", "grade 1", "rest"}) EXPECT_THAT(line, HasSubstr(part));
}

TEST(Search, ARadicalIsNumberedTo214OrGivenInAnyForm) {
  EXPECT_THAT(found({"--radical", "1", "--grade", "1"}), Contains("一"));
  EXPECT_THAT(found({"--radical", "214"}), Contains("龠"));
  expect_one_line(nazori_cli({"search", "--radical", "0"}), 2, {"'0' is not a radical"});
  expect_one_line(nazori_cli({"search", "--radical", "9a"}), 2, {"'9a' is not a radical"});
}

TEST(Search, EachConditionIsTaken) {
  EXPECT_EQ(found({"--skip", "1-2-4", "--grade", "1"}),
            found({"--skip", "1-2-4", "--grade", "1", "--strokes", "6"}));
  EXPECT_THAT(found({"--four-corner", "2429.0", "--grade", "1"}), testing::ElementsAre("休"));
  EXPECT_THAT(found({"--parts", "木亻", "--grade", "1"}), testing::ElementsAre("休"));
  EXPECT_THAT(found({"--frequency", "1"}), testing::ElementsAre("日"));
  const auto levels = found({"--jlpt", "4"});
  EXPECT_THAT(levels, Contains("休"));
  EXPECT_LT(levels.size(), 200U);
}

TEST(Search, WordsStandAloneWhereNoCharacterFitsAndNotWithConditions) {
  const Outcome run = nazori_cli({"search", "kyuujitsu"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "休日  きゅうじつ  holiday; day off\n");
  EXPECT_THAT(nazori_cli({"search", "rest", "--grade", "1"}).out, testing::Not(HasSubstr("休憩")));
  EXPECT_THAT(nazori_cli({"search", "rest"}).out, HasSubstr("休憩"));
}

TEST(Search, NothingFoundIsANo) {
  expect_one_line(nazori_cli({"search", "xyzzyplugh"}), 1, {"no matching character", "xyzzyplugh"});
  const Outcome run = nazori_cli({"search", "xyzzyplugh", "--json"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(Json::parse(run.out), Json::array());
}

TEST(Search, BadQuestionsAreRefused) {
  expect_one_line(nazori_cli({"search"}), 2, {"nothing to search"});
  expect_one_line(nazori_cli({"search", "  "}), 2, {"nothing to search"});
  expect_one_line(nazori_cli({"search", "\xFF"}), 2, {"UTF-8"});
  expect_one_line(nazori_cli({"search", "--radical", "215"}), 2, {"--radical", "1..214"});
  expect_one_line(nazori_cli({"search", "--radical", "休"}), 2, {"--radical", "1..214"});
  expect_one_line(nazori_cli({"search", "--grade", "11"}), 2, {"--grade", "1..10"});
  expect_one_line(nazori_cli({"search", "--grade", "first"}), 2, {"--grade", "first"});
  expect_one_line(nazori_cli({"search", "rest", "--limit", "0"}), 2, {"--limit"});
  expect_one_line(nazori_cli({"search", "rest", "--strokes", "-1"}), 2, {"--strokes"});
}

}  // namespace
}  // namespace nazori::cli::test
