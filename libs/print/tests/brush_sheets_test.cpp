// SPDX-License-Identifier: Apache-2.0
// Sheets for the brush: where characters, folds and the column of the name lie, worked out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "nazori/print/worksheet.h"
#include "page_parts.h"

namespace nazori::print {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// One level stroke through the middle of the box, from 10 to 100 glyph units.
SheetCharacter level(char32_t code_point, kanji::StrokeEnding ending = kanji::StrokeEnding::stop) {
  SheetCharacter one;
  one.character.code_point = code_point;
  kanji::Stroke stroke;
  stroke.path = "M10,54.5L100,54.5";
  stroke.line.points = {{10, 54.5}, {100, 54.5}};
  stroke.line.ending = ending;
  one.character.strokes = {stroke};
  return one;
}

SheetSettings brush(int per_sheet) {
  SheetSettings settings;
  settings.layout = Layout::brush;
  settings.paper = Paper::hanshi;
  settings.guide = Guide::none;
  settings.numbers = settings.arrows = settings.name_line = false;
  settings.per_sheet = per_sheet;
  settings.rows = 1;
  settings.copies = 1;
  return settings;
}

std::vector<PageDrawing> pages(const std::vector<SheetCharacter>& characters, const SheetSettings& settings) {
  auto sheet = Worksheet::lay_out(characters, settings);
  EXPECT_TRUE(sheet) << sheet.error().what;
  std::vector<PageDrawing> all;
  for (std::size_t i = 0; sheet && i < sheet->page_count(); ++i) all.push_back(sheet->page(i));
  return all;
}

/// The broad, round marks: pieces of brush strokes.
std::vector<PageMark> ink(const PageDrawing& page) {
  std::vector<PageMark> all;
  for (const PageMark& mark : page.marks)
    if (mark.round && !mark.filled && mark.dash_mm == 0) all.push_back(mark);
  return all;
}

/// A stroke on the page: where it begins and ends.
struct Written {
  PaperPoint from, to;
};
std::vector<Written> strokes(const PageDrawing& page) {
  std::vector<Written> all;
  for (const PageMark& mark : ink(page)) {
    const PaperPoint from = mark.path.front().points[0];
    const PaperPoint to = mark.path.back().points[0];
    if (all.empty() || std::hypot(all.back().to.x - from.x, all.back().to.y - from.y) > 0.05)
      all.push_back({from, to});
    else
      all.back().to = to;
  }
  return all;
}

// The frame of a page of hanshi lies from 12 to 231 mm and from 12 to 318 mm.
constexpr double kWidth = 219;
constexpr double kHeight = 306;

TEST(BrushSheets, OneCharacterFillsTheSheet) {
  const auto all = pages({level(U'一')}, brush(1));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_DOUBLE_EQ(all[0].width_mm, 243);
  EXPECT_DOUBLE_EQ(all[0].height_mm, 334);
  const auto written = strokes(all[0]);
  ASSERT_EQ(written.size(), 1U);
  const double side = 0.9 * kWidth;
  EXPECT_NEAR(written[0].from.x, 121.5 - side / 2 + 10 / 109.0 * side, 0.05);
  EXPECT_NEAR(written[0].to.x, 121.5 - side / 2 + 100 / 109.0 * side, 0.05);
  EXPECT_NEAR(written[0].from.y, 12 + kHeight / 2, 0.05);
  EXPECT_NEAR(ink(all[0])[0].width_mm, 8 / 109.0 * side, 0.05);
}

TEST(BrushSheets, CharactersGoDownAndThenToTheLeft) {
  std::vector<SheetCharacter> seven;
  for (const char32_t c : std::u32string(U"一二三四五六七")) seven.push_back(level(c));
  const auto middles = [](const PageDrawing& page) {
    std::vector<std::pair<double, double>> all;
    for (const Written& one : strokes(page)) all.emplace_back((one.from.x + one.to.x) / 2, one.from.y);
    return all;
  };
  const auto near = [](double x, double y) {
    // The stroke's middle is 0.5 units right of the middle of the box.
    return testing::Pair(DoubleNear(x, 0.7), DoubleNear(y, 0.06));
  };
  const double right = 12 + 0.75 * kWidth;
  const double left = 12 + 0.25 * kWidth;
  const auto at = [](double share) { return 12 + share * kHeight; };
  auto all = pages(seven, brush(6));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_THAT(middles(all[0]),
              ElementsAre(near(right, at(1 / 6.0)), near(right, at(0.5)), near(right, at(5 / 6.0)),
                          near(left, at(1 / 6.0)), near(left, at(0.5)), near(left, at(5 / 6.0))));
  EXPECT_THAT(middles(all[1]), ElementsAre(near(right, at(1 / 6.0))));
  all = pages(seven, brush(4));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_THAT(middles(all[0]), ElementsAre(near(right, at(0.25)), near(right, at(0.75)), near(left, at(0.25)),
                                           near(left, at(0.75))));
  all = pages(seven, brush(2));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_THAT(middles(all[0]), ElementsAre(near(121.5, at(0.25)), near(121.5, at(0.75))));
}

TEST(BrushSheets, FoldsLieBetweenTheCharactersAndBesideTheName) {
  const auto folds = [](const PageDrawing& page) {
    std::vector<std::vector<double>> all;
    for (const PageMark& mark : page.marks)
      if (mark.dash_mm > 0)
        all.push_back({mark.path[0].points[0].x, mark.path[0].points[0].y, mark.path[1].points[0].x,
                       mark.path[1].points[0].y});
    return all;
  };
  const auto line = [](double x0, double y0, double x1, double y1) {
    return ElementsAre(DoubleNear(x0, 0.02), DoubleNear(y0, 0.02), DoubleNear(x1, 0.02),
                       DoubleNear(y1, 0.02));
  };
  SheetSettings settings = brush(4);
  EXPECT_THAT(folds(pages({level(U'一')}, settings)[0]),
              ElementsAre(line(121.5, 12, 121.5, 318), line(12, 165, 231, 165)));
  settings.name_line = true;
  const double name = 12 + 0.13 * kWidth;
  EXPECT_THAT(folds(pages({level(U'一')}, settings)[0]),
              ElementsAre(line(name, 12, name, 318), line((name + 231) / 2, 12, (name + 231) / 2, 318),
                          line(name, 165, 231, 165)));
  settings.per_sheet = 1;
  EXPECT_THAT(folds(pages({level(U'一')}, settings)[0]), ElementsAre(line(name, 12, name, 318)));
}

TEST(BrushSheets, FoldsAreThinGreyDashesAndTheFrameIsSolid) {
  const auto page = pages({level(U'一')}, brush(4))[0];
  int folds = 0;
  for (const PageMark& mark : page.marks) {
    if (mark.dash_mm == 0) continue;
    ++folds;
    EXPECT_NEAR(mark.grey, 0.6, 0.001);
    EXPECT_NEAR(mark.width_mm, 0.15, 0.003);
    EXPECT_NEAR(mark.dash_mm, 3, 0.003);
  }
  EXPECT_EQ(folds, 2);
  const auto frame = std::find_if(page.marks.begin(), page.marks.end(), [](const PageMark& mark) {
    return !mark.filled && mark.path.back().kind == PathStep::Kind::close;
  });
  ASSERT_NE(frame, page.marks.end());
  EXPECT_NEAR(frame->grey, 0.45, 0.001);
  EXPECT_NEAR(frame->width_mm, 0.25, 0.003);
  EXPECT_EQ(frame->dash_mm, 0);
  const Box box = box_of(*frame);
  EXPECT_NEAR(box.left, 12, 0.02);
  EXPECT_NEAR(box.top, 12, 0.02);
  EXPECT_NEAR(box.right, 231, 0.02);
  EXPECT_NEAR(box.bottom, 318, 0.02);
}

TEST(BrushSheets, TheLabelOfTheNameStandsInTheMiddleOfItsColumnAtTheTop) {
  SheetSettings settings = brush(1);
  settings.name_line = true;
  settings.language = Language::japanese;
  std::vector<Box> letters;
  const auto sheet = pages({level(U'一')}, settings);
  for (const PageMark& mark : sheet[0].marks)
    if (const Box box = box_of(mark); mark.filled && box.bottom < 100) letters.push_back(box);
  ASSERT_EQ(letters.size(), 2U) << "名前";
  // Each fills most of its square of 4 mm; the first square begins 2 mm below the frame.
  const double middle = 12 + 0.13 * kWidth / 2;
  for (std::size_t i = 0; i < 2; ++i) {
    const double top = 12 + 2 + 4 * static_cast<double>(i);
    EXPECT_NEAR((letters[i].left + letters[i].right) / 2, middle, 0.3) << i;
    EXPECT_NEAR((letters[i].top + letters[i].bottom) / 2, top + 2, 0.4) << i;
    EXPECT_GT(letters[i].right - letters[i].left, 2.5) << i;
    EXPECT_LT(letters[i].right - letters[i].left, 4) << i;
  }
}

TEST(BrushSheets, ALatinLabelRunsDownItsColumnFromTheTop) {
  SheetSettings settings = brush(1);
  settings.name_line = true;
  std::vector<Box> letters;
  const auto sheet = pages({level(U'一')}, settings);
  for (const PageMark& mark : sheet[0].marks)
    if (const Box box = box_of(mark); mark.filled && box.bottom < 100) letters.push_back(box);
  ASSERT_EQ(letters.size(), 1U) << "a piece of text is one area";
  // Four letters of 4 mm, the first at the top, lying on their side.
  EXPECT_GT(letters[0].top, 12 + 2);
  EXPECT_LT(letters[0].bottom, 12 + 2 + 4 * 4);
  EXPECT_GT(letters[0].bottom - letters[0].top, 6);
  const double middle = 12 + 0.13 * kWidth / 2;
  EXPECT_GT(letters[0].left, middle - 2.5);
  EXPECT_LT(letters[0].right, middle + 2.5);
}

TEST(BrushSheets, CopiesFadeAndTheOtherSheetsAreEmpty) {
  SheetSettings settings = brush(2);
  settings.rows = 4;
  settings.copies = 3;
  const auto all = pages({level(U'一'), level(U'二'), level(U'三')}, settings);
  ASSERT_EQ(all.size(), 8U);
  std::vector<double> greys;
  for (std::size_t i = 0; i < 3; ++i) greys.push_back(ink(all[i])[0].grey);
  EXPECT_THAT(greys, ElementsAre(DoubleNear(0.62, 0.01), DoubleNear(0.76, 0.01), DoubleNear(0.9, 0.01)));
  EXPECT_TRUE(ink(all[3]).empty());
  EXPECT_EQ(strokes(all[4]).size(), 1U) << "the third character";
  EXPECT_TRUE(ink(all[7]).empty());
  settings.rows = 0;
  EXPECT_EQ(pages({level(U'一')}, settings).size(), 1U);
  settings.copies = 0;
  EXPECT_TRUE(ink(pages({level(U'一')}, settings)[0]).empty());
}

TEST(BrushSheets, SweepsThinOutOverThirtyUnitsAndFlicksOverNine) {
  const auto widths = [](kanji::StrokeEnding ending) {
    std::vector<double> all;
    const auto page = pages({level(U'一', ending)}, brush(1))[0];
    for (const PageMark& mark : ink(page)) all.push_back(mark.width_mm * 109 / (0.9 * kWidth));
    return all;
  };
  const auto thinner_than_8 = [](const std::vector<double>& all) {
    return std::count_if(all.begin(), all.end(), [](double width) { return width < 7.95; });
  };
  const auto stop = widths(kanji::StrokeEnding::stop);
  const auto taper = widths(kanji::StrokeEnding::taper);
  const auto hook = widths(kanji::StrokeEnding::hook);
  // 90 units in 61 pieces.
  EXPECT_EQ(stop.size(), 61U);
  EXPECT_EQ(thinner_than_8(stop), 0);
  EXPECT_NEAR(static_cast<double>(thinner_than_8(taper)) * 90 / 61, 30, 2);
  EXPECT_NEAR(static_cast<double>(thinner_than_8(hook)) * 90 / 61, 9, 2);
  EXPECT_NEAR(taper.back(), 0.12 * 8, 0.1);
  EXPECT_TRUE(std::is_sorted(taper.rbegin(), taper.rend()));
}

TEST(BrushSheets, SayTheCharacterAndTheNameColumnInTheChosenLanguage) {
  SheetSettings settings = brush(1);
  settings.guide = Guide::field;
  EXPECT_THAT(pages({level(U'永')}, settings)[0].text, HasSubstr("永\n"));
  EXPECT_THAT(pages({level(U'永')}, settings)[0].text, Not(HasSubstr("Name")));
  settings.name_line = true;
  EXPECT_THAT(pages({level(U'永')}, settings)[0].text, HasSubstr("Name"));
  settings.language = Language::japanese;
  const std::string text = pages({level(U'永')}, settings)[0].text;
  EXPECT_THAT(text, HasSubstr("名"));
  EXPECT_THAT(text, HasSubstr("前"));
}

TEST(BrushSheets, NumbersArrowsAndGuidesAreThereWhereTheyAreAskedFor) {
  const auto marks = [](bool SheetSettings::*option) {
    SheetSettings settings = brush(1);
    const auto before = pages({level(U'一')}, settings)[0].marks.size();
    settings.*option = true;
    return pages({level(U'一')}, settings)[0].marks.size() - before;
  };
  EXPECT_GT(marks(&SheetSettings::numbers), 0U);
  EXPECT_GT(marks(&SheetSettings::arrows), 0U);
  SheetSettings settings = brush(1);
  const auto before = pages({level(U'一')}, settings)[0].marks.size();
  settings.guide = Guide::diagonals;
  EXPECT_EQ(pages({level(U'一')}, settings)[0].marks.size(), before + 5) << "a square and four lines";
}

TEST(BrushSheets, ThreeOrNoCharactersOnASheetAreRefused) {
  for (const int count : {0, 3, 5, 7}) {
    const auto refused = Worksheet::lay_out({level(U'一')}, brush(count));
    ASSERT_FALSE(refused) << count;
    EXPECT_EQ(refused.error().code, base::Errc::bad_argument);
  }
}

}  // namespace
}  // namespace nazori::print
