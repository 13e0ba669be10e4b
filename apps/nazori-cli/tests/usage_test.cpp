// SPDX-License-Identifier: Apache-2.0
// What holds for every verb: help, version, exit codes and one line for every mistake.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "program.h"
#include "text_layout.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;

TEST(Usage, HelpNamesEveryVerb) {
  const Outcome run = nazori_cli({"--help"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  for (const char* verb : {"info", "search", "carve", "render", "plot", "demo", "feel", "record", "devices",
                           "study", "database", "completion", "manual"}) {
    EXPECT_THAT(run.out, HasSubstr(verb));
  }
}

TEST(Usage, EveryVerbDocumentsItselfWithAnExample) {
  const std::vector<std::vector<std::string>> verbs{{"info"},
                                                    {"search"},
                                                    {"carve"},
                                                    {"render"},
                                                    {"plot"},
                                                    {"demo"},
                                                    {"feel"},
                                                    {"record"},
                                                    {"record", "info"},
                                                    {"record", "export"},
                                                    {"devices"},
                                                    {"database"},
                                                    {"database", "build"},
                                                    {"database", "check"},
                                                    {"database", "path"},
                                                    {"study"},
                                                    {"study", "due"},
                                                    {"study", "review"},
                                                    {"study", "export"},
                                                    {"study", "restore"},
                                                    {"study", "replay"},
                                                    {"completion"},
                                                    {"manual"}};
  for (std::vector<std::string> verb : verbs) {
    const std::string name = verb.back();
    verb.emplace_back("--help");
    const Outcome run = nazori_cli(verb);
    EXPECT_EQ(run.code, 0) << name;
    EXPECT_EQ(run.err, "") << name;
    EXPECT_THAT(run.out, HasSubstr("Example")) << name;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(display_width(line), 110) << line;
    EXPECT_THAT(run.out, HasSubstr("nazori-cli " + (verb.size() > 2 ? verb.front() + " " + name : name)));
  }
}

TEST(Usage, VersionIsOneLine) {
  const Outcome run = nazori_cli({"--version"});
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, testing::MatchesRegex("nazori-cli [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Usage, NoVerbAndUnknownVerbsAreBadUsage) {
  expect_one_line(nazori_cli({}), 2, {"info, search, carve", "--help"});
  expect_one_line(nazori_cli({"frobnicate"}), 2, {"frobnicate", "info, search, carve", "--help"});
}

TEST(Usage, AMissingArgumentIsNamedTogetherWithTheVerb) {
  expect_one_line(nazori_cli({"info"}), 2, {"nazori-cli info", "characters", "see nazori-cli info --help"});
  expect_one_line(nazori_cli({"carve", "休"}), 2, {"nazori-cli carve", "--output"});
  expect_one_line(nazori_cli({"render", "休"}), 2, {"nazori-cli render", "--output"});
}

TEST(Usage, AnUnknownOptionIsNamed) {
  expect_one_line(nazori_cli({"info", "休", "--frobnicate"}), 2, {"--frobnicate"});
}

TEST(Usage, AVerbsNameCanBeSearchedFor) {
  const Outcome run = nazori_cli({"search", "carve"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("彫"));
}

TEST(Usage, AClosedPipeIsSilent) {
  const Outcome run = shell("\"$NAZORI\" search --strokes 8 --limit 2000 | head -1");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr(" 8 strokes"));
}

TEST(Usage, AnAnswerThatCannotBeWrittenIsNotDone) {
  const Outcome run = shell("\"$NAZORI\" info 休 > /dev/full");
  expect_one_line(run, 2, {"standard output"});
}

TEST(Usage, WithoutADatabaseOneLineSaysHowToBuildIt) {
  const TemporaryFolder empty;
  expect_one_line(PlacedProgram("bin/nazori-cli").run("info 休"), 2, {"build"});
  expect_one_line(nazori_cli({"info", "休", "--database", empty / "none.db"}), 2, {"none.db"});
}

TEST(Usage, AFileThatIsNoDatabaseIsRefused) {
  const TemporaryFolder folder;
  write(folder / "kanji.db", "this is not a database, only some text that is long enough to be looked at");
  expect_one_line(nazori_cli({"info", "休", "--database", folder / "kanji.db"}), 2, {"kanji.db"});
}

}  // namespace
}  // namespace nazori::cli::test
