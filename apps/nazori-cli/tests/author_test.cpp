// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;

TEST(AuthorConvert, ACopyOfACharacterKeepsItsLicenceAndOpensAgainToTheSameBytes) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"author", "convert", "永", "--output", folder / "a.nazori"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("5 strokes"));
  EXPECT_THAT(run.out, HasSubstr("CC BY-SA 3.0"));
  ASSERT_EQ(nazori_cli({"author", "convert", folder / "a.nazori", "--output", folder / "b.nazori"}).code, 0);
  EXPECT_EQ(bytes_of(folder / "a.nazori"), bytes_of(folder / "b.nazori"));
  EXPECT_EQ(shell("\"$NAZORI\" author convert 永 --output - > '" + (folder / "c.nazori") + "'").code, 0);
  EXPECT_EQ(bytes_of(folder / "a.nazori"), bytes_of(folder / "c.nazori"));
  // The picture of a copy is nearly that of the character itself, so it is as large.
  ASSERT_EQ(
      nazori_cli({"author", "convert", folder / "a.nazori", "--output", folder / "a.raw", "--size", "64"})
          .code,
      0);
  EXPECT_EQ(bytes_of(folder / "a.raw").size(), 64U * 64U);
}

TEST(AuthorConvert, EveryFormatOpensAgainToTheSameBytes) {
  const TemporaryFolder folder;
  for (const std::string ending : {"svg", "str", "raw", "png"}) {
    const std::string first = folder / ("a." + ending);
    const std::string second = folder / ("b." + ending);
    EXPECT_EQ(nazori_cli({"author", "convert", "永", "--output", first, "--size", "128"}).code, 0);
    EXPECT_EQ(nazori_cli({"author", "convert", first, "--output", second, "--size", "128"}).code, 0);
    EXPECT_FALSE(bytes_of(first).empty());
    EXPECT_EQ(bytes_of(first), bytes_of(second)) << ending;
  }
}

TEST(AuthorConvert, AReliefKeepsItsSize) {
  const TemporaryFolder folder;
  ASSERT_EQ(nazori_cli({"author", "convert", "永", "--output", folder / "a.raw", "--size", "100"}).code, 0);
  const Outcome run =
      nazori_cli({"author", "convert", folder / "a.raw", "--output", folder / "b.raw", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(bytes_of(folder / "b.raw").size(), 10'000U);
  const auto answer = nlohmann::json::parse(run.out);
  EXPECT_EQ(answer.at("format"), "raw");
  EXPECT_EQ(answer.at("strokes"), 0);
  EXPECT_EQ(answer.at("has_relief"), true);
  EXPECT_EQ(answer.at("bytes"), 10'000);
}

TEST(AuthorConvert, WhatCannotBeDoneIsRefusedInOneLine) {
  const TemporaryFolder folder;
  write(folder / "a.nazori", "no document");
  write(folder / "a.txt", "text");
  ASSERT_EQ(nazori_cli({"author", "convert", "永", "--output", folder / "a.raw"}).code, 0);
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{folder / "a.nazori", "--output", folder / "b.svg"}, "a.nazori: is not a ZIP"},
      {{folder / "none.svg", "--output", folder / "b.svg"}, "none.svg"},
      {{folder / "a.raw", "--output", folder / "b.svg"}, "has no strokes"},
      {{"永", "--output", folder / "b.txt"}, "b.txt"},
      {{"永休", "--output", folder / "b.svg"}, "is more than one character"},
      {{folder / "a.raw", "--output", folder / "a.raw"}, "a.raw"},
      {{"永", "--output", "-", "--json"}, "--json"},
  };
  for (const auto& [arguments, expected] : cases) {
    std::vector<std::string> command{"author", "convert"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome run = nazori_cli(command);
    EXPECT_EQ(run.code, 2) << expected;
    EXPECT_THAT(run.err, HasSubstr(expected));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_EQ(nazori_cli({"author", "convert", "U+10FFFF", "--output", folder / "b.svg"}).code, 1);
}

TEST(AuthorCheck, ACopyIsFineAndAChangedOneIsNot) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.svg";
  ASSERT_EQ(nazori_cli({"author", "convert", "二", "--output", file}).code, 0);
  const Outcome fine = nazori_cli({"author", "check", file});
  EXPECT_EQ(fine.code, 0) << fine.out << fine.err;
  EXPECT_EQ(fine.out, file + "  2 strokes: no findings\n");
  // Another licence, another box, and a stroke less than the dictionary counts.
  EXPECT_EQ(shell("sed -i -e 's/CC-BY-SA-3.0/CC0-1.0/' -e 's/0 0 109 109/0 0 100 100/' -e '/-s2\"/d' '" +
                  file + "'")
                .code,
            0);
  const Outcome run = nazori_cli({"author", "check", file, "--json"});
  EXPECT_EQ(run.code, 1) << run.err;
  const auto answer = nlohmann::json::parse(run.out);
  std::vector<std::string> kinds;
  for (const auto& finding : answer.at(0).at("findings")) kinds.push_back(finding.at("kind"));
  EXPECT_EQ(kinds,
            (std::vector<std::string>{"count_differs", "licence_lost", "svg_view_box", "svg_number_count"}));
  EXPECT_THAT(
      nazori_cli({"author", "check", file}).out,
      HasSubstr("  error   the strokes come from KanjiVG, so CC-BY-SA-3.0 and its authors must be named\n"));
}

TEST(AuthorCheck, WorksWithoutADatabaseUnlessOneIsNamed) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.nazori";
  ASSERT_EQ(nazori_cli({"author", "convert", "二", "--output", file}).code, 0);
  const std::vector<std::string> nowhere{"NAZORI_DATA=" + (folder / "none")};
  EXPECT_EQ(nazori_cli({"author", "check", file}, nowhere).code, 0);
  EXPECT_EQ(nazori_cli({"author", "check", file, "--database", folder / "none.db"}).code, 2);
  EXPECT_EQ(nazori_cli({"author", "check", folder / "none.nazori"}).code, 2);
  EXPECT_EQ(nazori_cli({"author", "check", folder / "a.txt"}).code, 2);
}

TEST(AuthorCheck, TheTipDecidesWhichWallsAreThin) {
  const TemporaryFolder folder;
  const std::string file = folder / "a.nazori";
  ASSERT_EQ(nazori_cli({"author", "convert", "三", "--output", file}).code, 0);
  EXPECT_EQ(nazori_cli({"author", "check", file}).code, 0);
  const Outcome run = nazori_cli({"author", "check", file, "--tip-mm", "10"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("narrower than the tip"));
}

}  // namespace
}  // namespace nazori::cli::test
