// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/page_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "nazori/kanji/kanji_database.h"
#include "nazori/print/sheet_mark.h"
#include "nazori/print/worksheet.h"
#include "page_parts.h"

namespace nazori::print {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<SheetCharacter> characters(std::u32string_view text) {
  static const auto database =
      kanji::KanjiDatabase::open(std::filesystem::path(std::getenv("NAZORI_DATA")) / "kanji.db");
  std::vector<SheetCharacter> all;
  for (const char32_t c : text) all.push_back({database->find(c).value(), database->words(c, 3)});
  return all;
}

Worksheet sheet(std::u32string_view text, const SheetSettings& settings = {}) {
  auto made = Worksheet::lay_out(characters(text), settings);
  EXPECT_TRUE(made) << (made ? "" : base::to_line(made.error()));
  return *std::move(made);
}

std::ptrdiff_t closed_squares(const PageDrawing& page, double side_mm) {
  return std::count_if(page.marks.begin(), page.marks.end(), [side_mm](const PageMark& mark) {
    const Box box = box_of(mark);
    return !mark.filled && mark.path.size() == 5 && std::abs(box.right - box.left - side_mm) < 0.02 &&
           std::abs(box.bottom - box.top - side_mm) < 0.02;
  });
}

TEST(PageDrawing, HasTheSizeOfThePaper) {
  SheetSettings settings;
  const PageDrawing a4 = sheet(U"休", settings).page(0);
  EXPECT_DOUBLE_EQ(a4.width_mm, 210);
  EXPECT_DOUBLE_EQ(a4.height_mm, 297);
  settings.paper = Paper::b5;
  settings.booklet = true;
  const PageDrawing folded = sheet(U"休", settings).page(0);
  EXPECT_DOUBLE_EQ(folded.width_mm, 257);
  EXPECT_DOUBLE_EQ(folded.height_mm, 182);
}

/// Whether a filled rectangle of the page covers a place.
bool is_dark(const PageDrawing& page, PaperPoint at) {
  for (const PageMark& mark : page.marks) {
    if (!mark.filled || mark.grey > 0.1) continue;
    PageMark rectangle;
    const auto covers = [&rectangle, at] {
      const Box box = box_of(rectangle);
      return box.left < at.x && at.x < box.right && box.top < at.y && at.y < box.bottom;
    };
    for (const PathStep& step : mark.path) {
      if (step.kind == PathStep::Kind::move) {
        if (covers()) return true;
        rectangle.path.clear();
      }
      rectangle.path.push_back(step);
    }
    if (covers()) return true;
  }
  return false;
}

// By this row a reader finds the columns of the mark.
TEST(PageDrawing, TheFirstRowOfTheMarkAlternatesDarkFirst) {
  const PageDrawing page = sheet(U"休").page(0);
  const int columns = mark_columns(kFewestMarkBytes);
  for (int column = 0; column < columns; ++column)
    EXPECT_EQ(is_dark(page, module_centre(page.height_mm, column, 0)), column % 2 == 0) << column;
}

TEST(PageDrawing, SaysWhatIsWrittenOnThePage) {
  const std::string text = sheet(U"休").page(0).text;
  for (const char* part : {"休\n", "キュウ", "rest", "Name\n", "Date\n"}) EXPECT_THAT(text, HasSubstr(part));
}

TEST(PageDrawing, TheLineForNameClassAndDateCanBeLeftOut) {
  SheetSettings settings;
  settings.title = "Week 3";
  settings.name_line = false;
  const std::string text = sheet(U"休", settings).page(0).text;
  for (const char* part : {"Name", "Class", "Date"}) EXPECT_THAT(text, Not(HasSubstr(part)));
  EXPECT_THAT(text, HasSubstr("Week 3\n"));
}

TEST(PageDrawing, CellsLieWhereTheyArePrinted) {
  SheetSettings settings;
  settings.cell_mm = 20;
  settings.rows = 2;
  settings.steps = false;
  settings.facts = false;
  const PageDrawing page = sheet(U"一", settings).page(0);
  // Nine cells of 20 mm fit between margins of 12 mm, in two rows.
  EXPECT_EQ(closed_squares(page, 20), 18);
  EXPECT_EQ(closed_squares(page, 32), 1);  // the model
  double left = 1e9;
  double top = 1e9;
  for (const PageMark& mark : page.marks) {
    const Box box = box_of(mark);
    if (!mark.filled && mark.path.size() == 5) {
      left = std::min(left, box.left);
      top = std::min(top, box.top);
    }
  }
  EXPECT_NEAR(left, kMargin_mm, 0.01);
  EXPECT_NEAR(top, kMargin_mm + 9, 0.01);  // under the line for the name
}

TEST(PageDrawing, StrokesOfTheModelAreDrawnInItsCell) {
  SheetSettings settings;
  settings.rows = 0;
  settings.steps = false;
  settings.facts = false;
  settings.arrows = false;
  settings.numbers = false;
  settings.guide = Guide::none;
  settings.cell_mm = 20;
  const PageDrawing page = sheet(U"一", settings).page(0);
  std::vector<PageMark> strokes;
  std::copy_if(page.marks.begin(), page.marks.end(), std::back_inserter(strokes),
               [](const PageMark& mark) { return mark.round; });
  ASSERT_EQ(strokes.size(), 1U);
  // KanjiVG draws 一 from the left edge of its box to the right one, in the middle.
  const Box box = box_of(strokes.front());
  EXPECT_GT(box.left, 12);
  EXPECT_LT(box.right, 12 + 32);
  EXPECT_GT(box.right - box.left, 25);
  EXPECT_NEAR((box.top + box.bottom) / 2, 21 + 16, 2);
  EXPECT_DOUBLE_EQ(strokes.front().grey, 0);
  EXPECT_NEAR(strokes.front().width_mm, 3.6 / 109 * 32, 0.01);
}

TEST(PageDrawing, CopiesFadeFromCellToCell) {
  SheetSettings settings;
  settings.rows = 1;
  settings.copies = 3;
  settings.steps = false;
  const PageDrawing page = sheet(U"一", settings).page(0);
  std::vector<double> greys;
  for (const PageMark& mark : page.marks)
    if (mark.round) greys.push_back(mark.grey);
  ASSERT_EQ(greys.size(), 4U);
  EXPECT_DOUBLE_EQ(greys[0], 0);
  EXPECT_LT(greys[1], greys[2]);
  EXPECT_LT(greys[2], greys[3]);
  EXPECT_LT(greys[3], 1);
}

TEST(PageDrawing, OnlyGuidesAreDashed) {
  SheetSettings settings;
  const auto dashed = [&settings] {
    const PageDrawing page = sheet(U"一", settings).page(0);
    return std::count_if(page.marks.begin(), page.marks.end(),
                         [](const PageMark& mark) { return mark.dash_mm > 0; });
  };
  const auto with_cross = dashed();
  EXPECT_GT(with_cross, 20);
  settings.guide = Guide::diagonals;
  EXPECT_EQ(dashed(), 2 * with_cross);
  settings.guide = Guide::none;
  EXPECT_EQ(dashed(), 0);
}

TEST(PageDrawing, AHiddenTextIsSearchedForButNotPainted) {
  SheetSettings settings;
  settings.layout = Layout::cards;
  settings.numbers = false;
  const PageDrawing front = sheet(U"一", settings).page(0);
  EXPECT_THAT(front.text, HasSubstr("一\n"));
  // The stroke is the only thing in the card: the letter in the font would be a filled shape as wide as the
  // card.
  EXPECT_TRUE(std::none_of(front.marks.begin(), front.marks.end(), [](const PageMark& mark) {
    const Box box = box_of(mark);
    return mark.filled && box.right - box.left > 20 && box.top < 200;
  }));
}

TEST(PageDrawing, ABookletShowsTwoPagesOnEachSide) {
  SheetSettings settings;
  settings.booklet = true;
  settings.whole_page = true;
  Worksheet four = sheet(U"一二三休", settings);
  ASSERT_EQ(four.page_count(), 2U);
  // Folded: 4 and 1 outside, 2 and 3 inside.
  const PageDrawing outside = four.page(0);
  EXPECT_THAT(outside.text, HasSubstr("休\n"));
  EXPECT_THAT(outside.text, HasSubstr("一\n"));
  EXPECT_THAT(outside.text, Not(HasSubstr("三\n")));
  EXPECT_LT(outside.text.find("休\n"), outside.text.find("一\n"));
  // The model of the page on the right lies right of the fold.
  EXPECT_TRUE(std::any_of(outside.marks.begin(), outside.marks.end(),
                          [](const PageMark& mark) { return mark.round && box_of(mark).left > 148.5 + 12; }));
  const PageDrawing inside = four.page(1);
  EXPECT_THAT(inside.text, HasSubstr("二\n"));
  EXPECT_THAT(inside.text, HasSubstr("三\n"));
}

TEST(PageDrawing, LettersAreOutlinesOfTheirSize) {
  SheetSettings settings;
  settings.layout = Layout::manuscript;
  settings.text = "国";
  auto paper = Worksheet::lay_out({}, settings);
  ASSERT_TRUE(paper);
  const PageDrawing page = paper->page(0);
  EXPECT_THAT(page.text, HasSubstr("国\n"));
  std::vector<PageMark> letters;
  std::copy_if(page.marks.begin(), page.marks.end(), std::back_inserter(letters), [](const PageMark& mark) {
    return mark.filled && mark.grey == 0.5 && box_of(mark).top < 100;
  });
  ASSERT_EQ(letters.size(), 1U);
  // The first cell: at the right of the sheet, at its top. 国 fills most of its em box of 0.84 cells.
  double cell = 1e9;
  Box first;
  for (const PageMark& mark : page.marks) {
    const Box box = box_of(mark);
    if (mark.filled || mark.path.size() != 5) continue;
    cell = std::min(cell, box.right - box.left);
    if (first.right < box.right || (first.right == box.right && box.top < first.top)) first = box;
  }
  const Box letter = box_of(letters.front());
  EXPECT_GT(letter.left, first.left);
  EXPECT_LT(letter.right, first.right);
  EXPECT_GT(letter.top, first.top);
  EXPECT_LT(letter.bottom, first.bottom);
  EXPECT_GT(letter.right - letter.left, 0.5 * cell);
  EXPECT_GT(letter.bottom - letter.top, 0.5 * cell);
}

/// The box of one letter on manuscript paper, whose cells are 9.1 mm wide.
Box letter_box(const std::string& letter) {
  SheetSettings settings;
  settings.layout = Layout::manuscript;
  settings.text = letter;
  auto paper = Worksheet::lay_out({}, settings);
  EXPECT_TRUE(paper);
  const PageDrawing page = paper->page(0);
  for (const PageMark& mark : page.marks)
    if (mark.filled && mark.grey == 0.5 && box_of(mark).top < 100) return box_of(mark);
  ADD_FAILURE() << letter << " is not drawn";
  return {};
}

TEST(PageDrawing, CurvesOfLettersBendAlongThem) {
  // Also the control points of a level stroke lie in its narrow band.
  const Box level = letter_box("一");
  EXPECT_GT(level.right - level.left, 5);
  EXPECT_LT(level.bottom - level.top, 2);
}

TEST(PageDrawing, WritingTheFileStopsWhenAsked) {
  Worksheet paper = sheet(U"休");
  const auto stopped = paper.pdf([](double, std::string_view) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
  const auto whole = paper.pdf();
  ASSERT_TRUE(whole);
  EXPECT_EQ(*whole, worksheet_pdf(characters(U"休"), {}).value());
}

}  // namespace
}  // namespace nazori::print
