// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "nazori/kanji/kanji_database.h"
#include "nazori/view/offscreen.h"
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

/// Draws strokes of a character as a pen of 1 mm does, into the middle of a cell of a page at 120 dpi.
void draw(view::Picture& page, const nlohmann::json& cell, char32_t character, std::size_t strokes) {
  const auto database = kanji::KanjiDatabase::open(data_folder() / "kanji.db");
  ASSERT_TRUE(database);
  const auto found = database->find(character);
  ASSERT_TRUE(found);
  double left = 1e9, top = 1e9, right = 0;
  for (const auto& corner : cell.at("corners")) {
    left = std::min(left, corner[0].get<double>());
    right = std::max(right, corner[0].get<double>());
    top = std::min(top, corner[1].get<double>());
  }
  const double unit = (right - left) / 109;
  const auto dot = [&](double x, double y) {
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        if (dx * dx + dy * dy > 5) continue;
        const auto column = static_cast<std::size_t>(std::lround(x) + dx);
        const auto row = static_cast<std::size_t>(std::lround(y) + dy);
        const std::size_t at = (row * static_cast<std::size_t>(page.width) + column) * 4;
        for (std::size_t k = 0; k < 3; ++k) page.rgba[at + k] = 20;
      }
  };
  for (std::size_t s = 0; s < std::min(strokes, found->strokes.size()); ++s) {
    const auto& points = found->strokes[s].line.points;
    for (std::size_t i = 1; i < points.size(); ++i)
      for (int k = 0; k <= 40; ++k) {
        const auto at = points[i - 1] + (points[i] - points[i - 1]) * (k / 40.0);
        dot(left + at.x * unit, top + at.y * unit);
      }
  }
}

TEST(GradeSheet, WhatIsWrittenIsToldCellByCell) {
  const TemporaryFolder folder;
  const std::string photo = printed(folder, {"--rows", "1", "--copies", "0"});
  const auto cells =
      nlohmann::json::parse(nazori_cli({"grade-sheet", photo, "--json"}).out)[0]["sheets"][0]["cells"];
  auto page = view::load_picture_png(photo);
  ASSERT_TRUE(page);
  draw(*page, cells.at(1), U'休', 6);
  draw(*page, cells.at(3), U'休', 5);
  draw(*page, cells.at(5), U'永', 5);
  ASSERT_TRUE(view::save_png(*page, folder / "written.png"));
  const Outcome run = nazori_cli({"grade-sheet", folder / "written.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out,
              testing::StartsWith(folder / "written.png" +
                                  "  practice sheet, page 1: 24 cells to write in, 2 legible, 1 not legible, "
                                  "21 empty\n"));
  EXPECT_THAT(run.out, HasSubstr("\n    2  休  legible\n"));
  EXPECT_THAT(run.out, HasSubstr("\n    4  休  legible: "));
  EXPECT_THAT(run.out, HasSubstr("\n    6  休  not legible as this character, looks like 永\n"));
  EXPECT_THAT(run.out, Not(HasSubstr("\n    1  ")));
}

TEST(GradeSheet, AQuizIsNamedAsOne) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"grade-sheet", printed(folder, {"--layout", "quiz"})});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("photo-1.png  quiz, page 1: "));
  EXPECT_THAT(run.out, Not(HasSubstr("to trace")));
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
