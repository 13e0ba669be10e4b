// SPDX-License-Identifier: Apache-2.0
// What the program says of a command line that it does not understand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The error message of one line.
std::string trouble(const std::vector<std::string>& arguments) {
  const Outcome run = nazori_cli(arguments);
  expect_one_line(run, 2, {});
  return run.err;
}

TEST(Messages, AMissingArgumentOrOptionIsNamedWithItsValue) {
  EXPECT_EQ(trouble({"info"}),
            "nazori-cli info: the argument 'characters' is missing (see nazori-cli info --help)\n");
  EXPECT_EQ(trouble({"carve", "休"}),
            "nazori-cli carve: --output FILE is missing (see nazori-cli carve --help)\n");
  EXPECT_EQ(trouble({"carve", "休", "--output"}),
            "nazori-cli carve: --output FILE has no value (see nazori-cli carve --help)\n");
}

TEST(Messages, AMisspeltVerbOrOptionIsAnsweredWithTheOneThatWasMeant) {
  EXPECT_EQ(trouble({"carv", "休"}), "nazori-cli: unknown command 'carv' (did you mean carve?)\n");
  EXPECT_EQ(trouble({"due"}), "nazori-cli: unknown command 'due' (did you mean study due?)\n");
  EXPECT_EQ(trouble({"study", "stat"}), "nazori-cli study: unknown command 'stat' (did you mean stats?)\n");
  EXPECT_EQ(trouble({"carve", "休", "--outptu", "a.png"}),
            "nazori-cli carve: there is no option '--outptu' (did you mean --output?)\n");
  EXPECT_EQ(trouble({"carve", "休", "--outptu=a.png"}),
            "nazori-cli carve: there is no option '--outptu' (did you mean --output?)\n");
  EXPECT_THAT(trouble({"study", "frobnicate"}), HasSubstr("the verbs are due, next, review"));
  EXPECT_THAT(trouble({"study"}), HasSubstr("a command is missing (the verbs are due, next, review"));
  EXPECT_EQ(trouble({"info", "休", "-x"}),
            "nazori-cli info: there is no option '-x' (see nazori-cli info --help)\n");
  EXPECT_THAT(trouble({"--bogus", "info", "休"}), HasSubstr("there is no option '--bogus'"));
}

TEST(Messages, AnArgumentTooManyIsNamed) {
  EXPECT_EQ(
      trouble({"database", "path", "here"}),
      "nazori-cli database path: 'here' is one argument too many (see nazori-cli database path --help)\n");
  EXPECT_THAT(trouble({"database", "path", "-1,2"}), HasSubstr("follows an equals sign: --name=-1,2"));
}

TEST(Messages, ANumberThatIsNoneOrOutOfRangeIsSaid) {
  EXPECT_EQ(trouble({"info", "休", "--words", "1.5"}),
            "nazori-cli info: --words: '1.5' is not a whole number (see nazori-cli info --help)\n");
  EXPECT_EQ(trouble({"info", "休", "--words", "abc"}),
            "nazori-cli info: --words: 'abc' is not a number (see nazori-cli info --help)\n");
  EXPECT_EQ(trouble({"info", "休", "--words", "200000"}),
            "nazori-cli info: --words: 200000 is not in the range 0..100000 (see nazori-cli info --help)\n");
  EXPECT_THAT(trouble({"carve", "休", "-o", "a.png", "--size", "nan"}),
              HasSubstr("--size: nan is not in the range"));
  EXPECT_THAT(trouble({"plot", "y=x", "--window=1,2,x,4"}), HasSubstr("--window: 'x' is not a number"));
}

TEST(Messages, ANumberOfValuesThatIsWrongIsCounted) {
  EXPECT_EQ(trouble({"plot", "y=x", "--window=1,2,3,4,5,6"}),
            "nazori-cli plot: --window: has 6 values, not 4 (write --window=X0,X1,Y0,Y1)\n");
  EXPECT_EQ(trouble({"plot", "y=x", "--window=1"}),
            "nazori-cli plot: --window: has 1 value, not 4 (write --window=X0,X1,Y0,Y1)\n");
  EXPECT_EQ(trouble({"plot", "y=x", "--size", "64", "--size", "128"}),
            "nazori-cli plot: --size: is given 2 times (give it once)\n");
  EXPECT_EQ(trouble({"study", "profiles", "--rename", "a"}),
            "nazori-cli study profiles: --rename: has 1 value, not 2 (write --rename NAME NAME)\n");
  EXPECT_EQ(trouble({"info", "休", "--json=maybe"}),
            "nazori-cli info: --json: takes no value (leave out what follows the equals sign)\n");
}

TEST(Messages, AWordThatIsNoChoiceIsAnsweredWithTheChoices) {
  EXPECT_EQ(trouble({"plot", "y=x", "--axes", "of"}),
            "nazori-cli plot: --axes: 'of' is none of on, off (did you mean off?)\n");
  EXPECT_EQ(trouble({"plot", "y=x", "--axes", "maybe"}),
            "nazori-cli plot: --axes: 'maybe' is none of on, off (see nazori-cli plot --help)\n");
  EXPECT_THAT(trouble({"completion", "bsh"}),
              HasSubstr("shell: 'bsh' is none of bash, zsh, fish (did you mean bash?)"));
}

TEST(Messages, AnEmptyValueIsRefusedWhereverOneIsGiven) {
  EXPECT_EQ(trouble({"info", "休", "--database", ""}),
            "nazori-cli info: --database: is empty (give FILE, or leave the option out)\n");
  EXPECT_EQ(trouble({"study", "due", "--profile", ""}),
            "nazori-cli study due: --profile: is empty (give NAME, or leave the option out)\n");
  EXPECT_THAT(trouble({"study", "due", "--learners", ""}), HasSubstr("--learners: is empty"));
  EXPECT_THAT(trouble({"study", "tag", "休", "--with", "a", "--with", ""}), HasSubstr("--with: is empty"));
}

TEST(Messages, AnArgumentOf50kBIsNotRepeatedWhole) {
  const std::string long_text(50'000, 'a');
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{long_text},
                                             {"info", "休", "--" + long_text},
                                             {"info", "休", "--words", long_text},
                                             {"info", "U+" + long_text},
                                             {"info", "休", "--database", long_text},
                                             {"plot", "y=x", "--axes", long_text},
                                             {"search", "--radical", long_text},
                                             {"database", "path", long_text}}) {
    const std::string line = trouble(arguments);
    EXPECT_LT(line.size(), 1'000U);
    EXPECT_THAT(line, HasSubstr("…"));
  }
  // Short text is not cut.
  EXPECT_THAT(trouble({"info", "休", "--database", std::string(150, 'b')}), Not(HasSubstr("…")));
}

TEST(Messages, HelpOfAVerbIsTheSameByBothWays) {
  for (const std::vector<std::string>& verb :
       std::vector<std::vector<std::string>>{{}, {"carve"}, {"study"}, {"study", "due"}, {"help"}}) {
    std::vector<std::string> by_option = verb;
    by_option.emplace_back("--help");
    std::vector<std::string> by_verb{"help"};
    by_verb.insert(by_verb.end(), verb.begin(), verb.end());
    const Outcome one = nazori_cli(by_option);
    const Outcome other = nazori_cli(by_verb);
    EXPECT_EQ(other.code, 0) << other.err;
    EXPECT_EQ(other.out, one.out);
  }
  EXPECT_EQ(trouble({"help", "carv"}), "nazori-cli help: unknown command 'carv' (did you mean carve?)\n");
  EXPECT_THAT(trouble({"help", "carve", "due"}), HasSubstr("'carve' has no verbs of its own"));
}

TEST(Messages, HelpListsAllVerbsUnderOneHeading) {
  const std::string help = nazori_cli({"--help"}).out;
  const std::size_t verbs = help.find("\nCommands:\n");
  ASSERT_NE(verbs, std::string::npos);
  EXPECT_THAT(help, Not(HasSubstr("SUBCOMMAND")));
  EXPECT_THAT(help, Not(HasSubstr("Subcommands")));
  for (const char* verb :
       {"info",  "search",    "carve",       "render",   "model",      "plot",      "demo",     "feel",
        "paint", "record",    "devices",     "database", "grade",      "recognise", "practise", "speak",
        "study", "worksheet", "grade-sheet", "author",   "completion", "manual",    "help"})
    EXPECT_NE(help.find(std::string("\n  ") + verb + " ", verbs), std::string::npos) << verb;
}

TEST(Messages, QuietLeavesTheExitCodeAndTrouble) {
  const Outcome found = nazori_cli({"info", "休", "--quiet"});
  EXPECT_EQ(found.code, 0);
  EXPECT_EQ(found.out + found.err, "");
  const Outcome json = nazori_cli({"search", "rest", "-q", "--json"});
  EXPECT_EQ(json.code, 0);
  EXPECT_EQ(json.out + json.err, "");
  expect_one_line(nazori_cli({"info", "U+10FFFF", "-q"}), 1, {"not in the database"});
  expect_one_line(nazori_cli({"info", "-q"}), 2, {"is missing"});
}

TEST(Messages, QuietIsTakenByEveryVerb) {
  for (const std::vector<std::string>& verb : std::vector<std::vector<std::string>>{{"info"},
                                                                                    {"search"},
                                                                                    {"carve"},
                                                                                    {"render"},
                                                                                    {"model"},
                                                                                    {"worksheet"},
                                                                                    {"grade-sheet"},
                                                                                    {"author", "check"},
                                                                                    {"author", "convert"},
                                                                                    {"author", "trace"},
                                                                                    {"plot"},
                                                                                    {"demo"},
                                                                                    {"feel"},
                                                                                    {"paint"},
                                                                                    {"record", "info"},
                                                                                    {"record", "export"},
                                                                                    {"devices"},
                                                                                    {"database", "build"},
                                                                                    {"database", "check"},
                                                                                    {"database", "path"},
                                                                                    {"grade"},
                                                                                    {"recognise"},
                                                                                    {"practise"},
                                                                                    {"speak"},
                                                                                    {"study", "due"},
                                                                                    {"study", "review"},
                                                                                    {"study", "export"},
                                                                                    {"completion"},
                                                                                    {"manual"},
                                                                                    {"help"}}) {
    std::vector<std::string> arguments = verb;
    arguments.emplace_back("--help");
    EXPECT_THAT(nazori_cli(arguments).out, HasSubstr("-q, --quiet")) << verb.back();
  }
}

}  // namespace
}  // namespace nazori::cli::test
