// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string printed_text(const std::string& pdf) { return shell("pdftotext '" + pdf + "' -").out; }

TEST(Worksheet, CharactersAreOnIt) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"worksheet", "休永", "--output", folder / "a.pdf", "--title", "Week 3"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("2 characters"));
  const std::string text = printed_text(folder / "a.pdf");
  for (const char* part : {"休", "永", "キュウ", "Week 3"}) EXPECT_THAT(text, HasSubstr(part));
}

TEST(Worksheet, JsonTellsWhatWasWritten) {
  const TemporaryFolder folder;
  const Outcome run =
      nazori_cli({"worksheet", "休永", "--layout", "cards", "--json", "--output", folder / "a.pdf"});
  EXPECT_EQ(run.code, 0) << run.err;
  const auto bytes = std::filesystem::file_size(folder / "a.pdf");
  for (const std::string& part : {std::string(R"("layout": "cards")"), std::string(R"("characters": 2)"),
                                  R"("bytes": )" + std::to_string(bytes), std::string("a.pdf")})
    EXPECT_THAT(run.out, HasSubstr(part));
}

TEST(Worksheet, EveryKanjiOfATextIsOnItOnce) {
  const TemporaryFolder folder;
  write(folder / "a.txt", "木の下で休む。木と人。");
  const Outcome run =
      nazori_cli({"worksheet", "人", "--text", folder / "a.txt", "--no-facts", "--output", folder / "a.pdf"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("4 characters"));
  EXPECT_THAT(printed_text(folder / "a.pdf"), Not(HasSubstr("の")));
}

TEST(Worksheet, AGradeHasItsEightyKanji) {
  const TemporaryFolder folder;
  EXPECT_THAT(nazori_cli({"worksheet", "--grade", "1", "--booklet", "-o", folder / "a.pdf"}).out,
              HasSubstr("80 characters"));
}

TEST(Worksheet, ManuscriptPaperHoldsTheWholeText) {
  const TemporaryFolder folder;
  write(folder / "a.txt", "春はあけぼの。");
  EXPECT_EQ(
      nazori_cli({"worksheet", "--layout", "manuscript", "--text", folder / "a.txt", "-o", folder / "a.pdf"})
          .code,
      0);
  const std::string text = printed_text(folder / "a.pdf");
  for (const char* part : {"春", "ぼ", "。"}) EXPECT_THAT(text, HasSubstr(part));
}

TEST(Worksheet, BrushSheetsHaveTheSizeOfHanshiAndFewCharacters) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"worksheet", "永和心", "--layout", "brush", "--paper", "hanshi",
                                  "--per-sheet", "2", "--rows", "1", "-o", folder / "a.pdf"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string about = shell("pdfinfo '" + folder / "a.pdf" + "'").out;
  EXPECT_THAT(about, HasSubstr("688.82 x 946.77 pts"));  // 243 x 334 mm
  EXPECT_THAT(about, testing::ContainsRegex("Pages: +2\n"));
  expect_one_line(
      nazori_cli({"worksheet", "永", "--layout", "brush", "--per-sheet", "3", "-o", folder / "b.pdf"}), 2,
      {"--per-sheet"});
}

TEST(Worksheet, AListOfStudyCanBePrinted) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"worksheet", "--list", "hiragana", "--no-facts", "--learners",
                                  folder.path().string(), "-o", folder / "a.pdf"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(printed_text(folder / "a.pdf"), HasSubstr("あ"));
}

TEST(Worksheet, WhatCannotBePrintedIsRefusedInOneLine) {
  const TemporaryFolder folder;
  write(folder / "bad.txt", "\xFF\xFE");
  const std::string pdf = folder / "a.pdf";
  expect_one_line(nazori_cli({"worksheet", "-o", pdf}), 2, {"no character to print", "--grade"});
  expect_one_line(nazori_cli({"worksheet", "休", "-o", folder / "a.png"}), 2, {"a.png", ".pdf"});
  expect_one_line(nazori_cli({"worksheet", "休", "-o", pdf, "--cell-mm", "7"}), 2, {"--cell-mm", "8..60"});
  expect_one_line(nazori_cli({"worksheet", "休", "-o", pdf, "--rows", "39"}), 2, {"do not fit"});
  expect_one_line(nazori_cli({"worksheet", "--text", folder / "bad.txt", "-o", pdf}), 2,
                  {"bad.txt", "UTF-8"});
  expect_one_line(nazori_cli({"worksheet", "--text", folder / "none.txt", "-o", pdf}), 2, {"none.txt"});
  expect_one_line(nazori_cli({"worksheet", "U+10FFFF", "-o", pdf}), 1, {"not in the database"});
}

}  // namespace
}  // namespace nazori::cli::test
