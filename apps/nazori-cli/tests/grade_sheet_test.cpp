// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A printed page as a picture, photo-1.png, in the folder.
std::string printed(const TemporaryFolder& folder, const std::vector<std::string>& options) {
  std::vector<std::string> command{"worksheet", "休永", "--output", folder / "a.pdf"};
  command.insert(command.end(), options.begin(), options.end());
  EXPECT_EQ(nazori_cli(command).code, 0);
  EXPECT_EQ(shell("pdftoppm -r 120 -png '" + (folder / "a.pdf") + "' '" + (folder / "photo") + "'").code, 0);
  return folder / "photo-1.png";
}

TEST(GradeSheet, AnEmptySheetIsToldAsEmpty) {
  const TemporaryFolder folder;
  const std::string photo = printed(folder, {"--rows", "1"});
  const Outcome run = nazori_cli({"grade-sheet", photo});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(
      run.out,
      HasSubstr("practice sheet, page 1: 16 cells to write in, 0 legible, 0 not legible, 16 empty, 8 to "
                "trace (not judged)"));
  EXPECT_THAT(run.out, HasSubstr("Stroke order and direction cannot be seen"));
}

TEST(GradeSheet, JsonHasEveryCellAndThePictureShowsThem) {
  const TemporaryFolder folder;
  const std::string photo = printed(folder, {"--rows", "1", "--copies", "0"});
  const Outcome run = nazori_cli({"grade-sheet", photo, "--json", "--output", folder / "m.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  const auto answer = nlohmann::json::parse(run.out);
  const auto& cells = answer.at(0).at("sheets").at(0).at("cells");
  ASSERT_EQ(cells.size(), 24U);
  EXPECT_EQ(cells[0].at("character"), "休");
  EXPECT_EQ(cells[23].at("character"), "永");
  EXPECT_EQ(cells[23].at("state"), "empty");
  EXPECT_GT(std::filesystem::file_size(folder / "m.png"), 10'000U);
}

TEST(GradeSheet, WhatCannotBeReadIsRefusedInOneLine) {
  const TemporaryFolder folder;
  write(folder / "text.png", "no picture");
  const std::string photo = printed(folder, {"--layout", "cards"});
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{folder / "none.png"}, "none.png"},
      {{folder / "text.png"}, "neither a PNG nor a JPEG"},
      {{photo}, "no sheet with a mark of Nazori was found"},
      {{photo, photo, "--output", folder / "m.png"}, "is for one photograph"},
      {{photo, "--output", folder / "m.gif"}, "m.gif"},
      {{photo, "--output", photo}, "photo-1.png"},
      {{}, "the argument 'photos' is missing"}};
  for (const auto& [arguments, part] : cases) {
    std::vector<std::string> command{"grade-sheet"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome run = nazori_cli(command);
    EXPECT_EQ(run.code, 2) << part;
    EXPECT_THAT(run.err, HasSubstr(part));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace nazori::cli::test
