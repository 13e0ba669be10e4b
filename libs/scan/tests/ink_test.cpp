// SPDX-License-Identifier: Apache-2.0
#include "../src/ink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace nazori::scan {
namespace {

using testing::Each;
using testing::SizeIs;

std::size_t index(int x, int y) { return static_cast<std::size_t>(y * kCellSide + x); }

DarkCell white_cell() { return DarkCell(static_cast<std::size_t>(kCellSide * kCellSide)); }

void fill(DarkCell& cell, int left, int top, int right, int bottom, float darkness) {
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) cell[index(x, y)] = darkness;
}

/// A photograph of so many pixels, of one brightness.
Photo paper(int width, int height, std::uint8_t brightness) {
  Photo photo{width, height, {}};
  photo.grey.assign(static_cast<std::size_t>(width * height), brightness);
  return photo;
}

void draw(Photo& photo, int left, int top, int right, int bottom, std::uint8_t brightness) {
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x)
      photo.grey[static_cast<std::size_t>(y * photo.width + x)] = brightness;
}

/// A page seen from above, its corner in the corner of the photograph.
PageMap seen_from_above(double pixels_per_mm) {
  return {{pixels_per_mm, 0, 0, 0, pixels_per_mm, 0, 0, 0, 1}};
}

/// A cell of which a pixel is 0.1 mm: its outline takes six pixels, beside a guide are four, a speck has
/// fewer than twenty.
const print::MarkedBox kBox{U'一', {0, 0}, 12.8, false};

std::size_t count_of(const InkCell& ink) {
  return static_cast<std::size_t>(std::count(ink.begin(), ink.end(), 1));
}

TEST(CutOut, ACellIsSeenAtItsPlace) {
  Photo photo = paper(200, 220, 200);
  draw(photo, 60, 90, 79, 99, 0);
  const print::MarkedBox box{U'一', {20, 30}, kCellSide, false};
  for (const auto& [x_mm, y_mm] : {std::pair{0, 0}, {3, -2}}) {
    const DarkCell cell =
        cut_out(photo, seen_from_above(1), {box, static_cast<double>(x_mm), static_cast<double>(y_mm)});
    ASSERT_THAT(cell, SizeIs(static_cast<std::size_t>(kCellSide * kCellSide)));
    // Each pixel of the cell lies between four of the photograph.
    const int left = 60 - 20 - x_mm;
    const int top = 90 - 30 - y_mm;
    for (int y = 0; y < kCellSide; ++y)
      for (int x = 0; x < kCellSide; ++x) {
        const bool beside = x < left - 1 || x > left + 19 || y < top - 1 || y > top + 9;
        const bool inside = x >= left && x < left + 19 && y >= top && y < top + 9;
        if (beside) {
          ASSERT_EQ(cell[index(x, y)], 0) << x << " " << y;
        } else if (inside) {
          ASSERT_EQ(cell[index(x, y)], 1) << x << " " << y;
        }
      }
    EXPECT_NEAR(cell[index(left - 1, top + 4)], 0.5, 1e-6);
    EXPECT_NEAR(cell[index(left + 19, top + 4)], 0.5, 1e-6);
    EXPECT_NEAR(cell[index(left + 5, top - 1)], 0.5, 1e-6);
    EXPECT_NEAR(cell[index(left - 1, top - 1)], 0.25, 1e-6);
  }
}

TEST(CutOut, AHalfAsBrightPixelIsHalfDark) {
  Photo photo = paper(140, 140, 160);
  draw(photo, 40, 40, 50, 50, 80);
  const DarkCell cell = cut_out(photo, seen_from_above(1), {{U'一', {0, 0}, kCellSide, false}, 0, 0});
  EXPECT_NEAR(cell[index(45, 45)], 0.5, 1e-6);
  EXPECT_EQ(cell[index(90, 45)], 0);
}

TEST(CutOut, UnevenLightIsPaper) {
  Photo photo = paper(128, 128, 0);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x)
      photo.grey[static_cast<std::size_t>(y * 128 + x)] = static_cast<std::uint8_t>(110 + x / 2 + y / 2);
  const DarkCell plain = cut_out(photo, seen_from_above(1), {{U'一', {0, 0}, kCellSide, false}, 0, 0});
  for (int y = 16; y < 112; ++y)
    for (int x = 16; x < 112; ++x) ASSERT_LT(plain[index(x, y)], 0.08) << x << " " << y;
  // Half of a square of paper may be ink.
  draw(photo, 32, 32, 63, 47, 20);
  const DarkCell written = cut_out(photo, seen_from_above(1), {{U'一', {0, 0}, kCellSide, false}, 0, 0});
  EXPECT_GT(written[index(48, 40)], 0.8);
  EXPECT_LT(written[index(48, 56)], 0.08);
}

TEST(CutOut, LightThatFallsFromOneSideIsPaper) {
  for (const bool from_left : {false, true}) {
    Photo photo = paper(128, 128, 0);
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x)
        photo.grey[static_cast<std::size_t>(y * 128 + x)] =
            static_cast<std::uint8_t>(110 + (from_left ? x : y));
    const DarkCell cell = cut_out(photo, seen_from_above(1), {{U'一', {0, 0}, kCellSide, false}, 0, 0});
    for (int y = 16; y < 112; ++y)
      for (int x = 16; x < 112; ++x) ASSERT_LT(cell[index(x, y)], 0.08) << x << " " << y;
  }
}

TEST(CutOut, BlackPaperIsNotDivided) {
  const DarkCell cell =
      cut_out(paper(128, 128, 0), seen_from_above(1), {{U'一', {0, 0}, kCellSide, false}, 0, 0});
  EXPECT_THAT(cell, Each(1.0F));
}

/// A cell with an upright and a level guide line of such darkness.
DarkCell with_guides(float darkness) {
  DarkCell cell = white_cell();
  fill(cell, 64, 0, 64, 127, darkness);
  fill(cell, 0, 64, 127, 64, darkness);
  return cell;
}

TEST(GuideDarkness, IsThatOfTheLines) {
  EXPECT_EQ(guide_darkness({with_guides(0.3F)}, print::Guide::cross), 0.3F);
  EXPECT_EQ(guide_darkness({with_guides(0.3F)}, print::Guide::field), 0.3F);
  EXPECT_EQ(guide_darkness({with_guides(0.3F)}, print::Guide::none), 0);
  EXPECT_EQ(guide_darkness({}, print::Guide::cross), 0);
}

TEST(GuideDarkness, OneLineOfTheTwoIsEnough) {
  DarkCell upright = white_cell();
  fill(upright, 64, 0, 64, 127, 0.3F);
  EXPECT_EQ(guide_darkness({upright}, print::Guide::cross), 0.3F);
  DarkCell level = white_cell();
  fill(level, 0, 64, 127, 64, 0.3F);
  EXPECT_EQ(guide_darkness({level}, print::Guide::cross), 0.3F);
}

TEST(GuideDarkness, LinesMayLieTwoPixelsBesideTheMiddle) {
  for (int x = 60; x <= 68; ++x) {
    DarkCell cell = white_cell();
    fill(cell, x, 0, x, 127, 0.3F);
    EXPECT_EQ(guide_darkness({cell}, print::Guide::cross), x >= 62 && x <= 66 ? 0.3F : 0) << x;
    DarkCell level = white_cell();
    fill(level, 0, x, 127, x, 0.3F);
    EXPECT_EQ(guide_darkness({level}, print::Guide::cross), x >= 62 && x <= 66 ? 0.3F : 0) << x;
  }
}

TEST(GuideDarkness, DiagonalsCountWhereTheyArePrinted) {
  for (const bool falling : {false, true}) {
    DarkCell cell = white_cell();
    for (int k = 0; k < kCellSide; ++k) cell[index(falling ? k : kCellSide - 1 - k, k)] = 0.3F;
    EXPECT_EQ(guide_darkness({cell}, print::Guide::diagonals), 0.3F) << falling;
    EXPECT_EQ(guide_darkness({cell}, print::Guide::cross), 0) << falling;
  }
}

TEST(GuideDarkness, IsThatOfTheLighterCells) {
  const std::vector<DarkCell> cells{with_guides(0.5F), with_guides(0.9F), with_guides(0.1F),
                                    with_guides(0.3F)};
  EXPECT_EQ(guide_darkness(cells, print::Guide::cross), 0.3F);
}

TEST(GuideDarkness, InkOnTheWholeLinesIsLimitedByTheirEnds) {
  DarkCell cell = with_guides(0.2F);
  fill(cell, 64, 12, 64, 115, 0.9F);
  fill(cell, 12, 64, 115, 64, 0.9F);
  EXPECT_FLOAT_EQ(guide_darkness({cell}, print::Guide::cross), 1.6F * 0.2F);
  // The ends reach from the 5th to the 11th pixel of both sides.
  DarkCell ends = with_guides(0.9F);
  for (const int from : {5, 116}) {
    fill(ends, 64, from, 64, from + 6, 0.2F);
    fill(ends, from, 64, from + 6, 64, 0.2F);
  }
  EXPECT_FLOAT_EQ(guide_darkness({ends}, print::Guide::cross), 1.6F * 0.2F);
}

TEST(Ink, IsWhatIsDark) {
  DarkCell cell = white_cell();
  fill(cell, 20, 30, 29, 37, 0.8F);
  const InkCell ink = ink_of(cell, kBox, print::Guide::none, 0);
  for (int y = 0; y < kCellSide; ++y)
    for (int x = 0; x < kCellSide; ++x)
      ASSERT_EQ(ink[index(x, y)], x >= 20 && x <= 29 && y >= 30 && y <= 37 ? 1 : 0) << x << " " << y;
  EXPECT_THAT(ink_of(white_cell(), kBox, print::Guide::none, 0), Each(0));
}

TEST(Ink, TheNoiseOfPaperIsNone) {
  DarkCell cell = white_cell();
  fill(cell, 20, 30, 29, 37, 0.2F);
  EXPECT_THAT(ink_of(cell, kBox, print::Guide::none, 0), Each(0));
  fill(cell, 20, 30, 29, 37, 0.21F);
  EXPECT_EQ(count_of(ink_of(cell, kBox, print::Guide::none, 0)), 80U);
}

TEST(Ink, TheOutlineIsNone) {
  DarkCell cell = white_cell();
  fill(cell, 0, 40, 127, 50, 0.8F);
  InkCell ink = ink_of(cell, kBox, print::Guide::none, 0);
  for (const auto& [x, expected] : {std::pair{5, 0}, {6, 1}, {121, 1}, {122, 0}})
    EXPECT_EQ(ink[index(x, 45)], expected) << x;
  cell = white_cell();
  fill(cell, 40, 0, 50, 127, 0.8F);
  ink = ink_of(cell, kBox, print::Guide::none, 0);
  for (const auto& [y, expected] : {std::pair{5, 0}, {6, 1}, {121, 1}, {122, 0}})
    EXPECT_EQ(ink[index(45, y)], expected) << y;
}

TEST(Ink, OfADarkPenWhatIsMuchLighterIsNone) {
  DarkCell cell = white_cell();
  fill(cell, 20, 20, 39, 39, 1);
  fill(cell, 60, 20, 69, 29, 0.44F);
  fill(cell, 80, 20, 89, 29, 0.46F);
  const InkCell ink = ink_of(cell, kBox, print::Guide::none, 0);
  EXPECT_EQ(ink[index(30, 30)], 1);
  EXPECT_EQ(ink[index(65, 25)], 0);
  EXPECT_EQ(ink[index(85, 25)], 1);
}

TEST(Ink, ThreeTenthsOfTheInkSayHowDarkThePenIs) {
  for (const auto& [dark, kept] : {std::pair{29, true}, {31, false}}) {
    DarkCell cell = white_cell();
    fill(cell, 20, 20, 29, 20 + 100 - dark - 1, 0.4F);
    fill(cell, 60, 20, 69, 20 + dark - 1, 1);
    const InkCell ink = ink_of(cell, kBox, print::Guide::none, 0);
    EXPECT_EQ(ink[index(25, 25)] != 0, kept) << dark;
    EXPECT_EQ(ink[index(65, 25)], 1) << dark;
  }
}

TEST(Ink, SpecksAreNone) {
  DarkCell cell = white_cell();
  fill(cell, 20, 20, 24, 23, 0.8F);
  EXPECT_EQ(count_of(ink_of(cell, kBox, print::Guide::none, 0)), 20U);
  cell[index(22, 21)] = cell[index(22, 22)] = 0;
  EXPECT_EQ(count_of(ink_of(cell, kBox, print::Guide::none, 0)), 0U);
  // Pixels that touch at a corner are one spot.
  cell[index(25, 24)] = cell[index(26, 25)] = 0.8F;
  EXPECT_EQ(count_of(ink_of(cell, kBox, print::Guide::none, 0)), 20U);
  // In a large cell a speck has fewer than six pixels.
  const print::MarkedBox large{U'一', {0, 0}, 50, false};
  cell = white_cell();
  fill(cell, 20, 20, 25, 20, 0.8F);
  EXPECT_EQ(count_of(ink_of(cell, large, print::Guide::none, 0)), 6U);
  cell[index(25, 20)] = 0;
  EXPECT_EQ(count_of(ink_of(cell, large, print::Guide::none, 0)), 0U);
}

TEST(Ink, OnAGuideLineOnlyWhatIsDarkerThanItCounts) {
  // What is darker than 1.5 times the guides and a little more.
  for (const auto& [darkness, counts] : {std::pair{0.64F, false}, {0.68F, true}}) {
    DarkCell cell = white_cell();
    fill(cell, 20, 50, 110, 77, darkness);
    const InkCell ink = ink_of(cell, kBox, print::Guide::cross, 0.4F);
    for (const auto& [x, on_guide] : {std::pair{59, false}, {60, true}, {67, true}, {68, false}})
      EXPECT_EQ(ink[index(x, 52)] != 0, counts || !on_guide) << x << " " << darkness;
    for (const auto& [y, on_guide] : {std::pair{59, false}, {60, true}, {67, true}, {68, false}})
      EXPECT_EQ(ink[index(30, y)] != 0, counts || !on_guide) << y << " " << darkness;
  }
}

TEST(Ink, DiagonalsAreGuideLinesToo) {
  DarkCell cell = white_cell();
  fill(cell, 10, 10, 117, 117, 0.5F);
  const InkCell cross = ink_of(cell, kBox, print::Guide::cross, 0.4F);
  const InkCell ink = ink_of(cell, kBox, print::Guide::diagonals, 0.4F);
  for (int off = -7; off <= 7; ++off) {
    // Nearer than four pixels to the line.
    const bool on_guide = std::abs(off) <= 5;
    EXPECT_EQ(ink[index(30 + off, 30)], on_guide ? 0 : 1) << off;
    EXPECT_EQ(ink[index(97 + off, 30)], on_guide ? 0 : 1) << off;
    EXPECT_EQ(ink[index(30 + off, 97)], on_guide ? 0 : 1) << off;
    EXPECT_EQ(cross[index(30 + off, 30)], 1) << off;
  }
  EXPECT_EQ(ink[index(63, 20)], 0);
}

TEST(Ink, AFaintGuideIsStillNoInk) {
  DarkCell cell = white_cell();
  fill(cell, 62, 10, 65, 117, 0.19F);
  fill(cell, 20, 20, 29, 29, 0.6F);
  const InkCell ink = ink_of(cell, kBox, print::Guide::cross, 0.01F);
  EXPECT_EQ(ink[index(63, 30)], 0);
  EXPECT_EQ(ink[index(25, 25)], 1);
}

/// A page of 10 pixels a millimetre with the outlines of cells.
class Outlines {
 public:
  Outlines() : photo_(paper(1200, 700, 220)) {}
  /// The outline of a box moved by so much.
  void draw_box(const print::MarkedBox& box, double x_mm, double y_mm, std::uint8_t brightness = 90) {
    const int left = pixel(box.corner.x + x_mm);
    const int top = pixel(box.corner.y + y_mm);
    const int side = pixel(box.side_mm);
    for (const int edge : {0, side}) {
      draw(photo_, left + edge - 1, top, left + edge + 1, top + side, brightness);
      draw(photo_, left, top + edge - 1, left + side, top + edge + 1, brightness);
    }
  }
  [[nodiscard]] std::vector<PlacedBox> placed(const std::vector<print::MarkedBox>& boxes) const {
    return place_boxes(photo_, {{}, seen_from_above(10)}, boxes);
  }

 private:
  static int pixel(double mm) { return static_cast<int>(std::lround(mm * 10)); }
  Photo photo_;
};

void expect_moved(const PlacedBox& placed, double x_mm, double y_mm) {
  EXPECT_NEAR(placed.x_mm, x_mm, 0.101);
  EXPECT_NEAR(placed.y_mm, y_mm, 0.101);
}

TEST(PlacedBoxes, LieWhereTheirOutlineIsSeen) {
  const print::MarkedBox box{U'一', {20, 20}, 15, false};
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.8, -0.6}, {-1.5, 1.1}, {0.3, 0.0}}) {
    Outlines page;
    page.draw_box(box, x, y);
    const auto placed = page.placed({box});
    ASSERT_THAT(placed, SizeIs(1));
    EXPECT_EQ(placed[0].box, box);
    expect_moved(placed[0], x, y);
  }
}

TEST(PlacedBoxes, WithoutAnOutlineLieAsTheirNeighbour) {
  const print::MarkedBox first{U'一', {20, 20}, 15, false};
  Outlines page;
  EXPECT_EQ(page.placed({first})[0].x_mm, 0);
  EXPECT_EQ(page.placed({first})[0].y_mm, 0);
  page.draw_box(first, 0.8, -0.6);
  const print::MarkedBox apart{U'三', {80, 40}, 15, false};
  const auto placed = page.placed({first, apart});
  ASSERT_THAT(placed, SizeIs(2));
  expect_moved(placed[1], 0.8, -0.6);
}

TEST(PlacedBoxes, AreLookedForNearTheirNeighbour) {
  const print::MarkedBox first{U'一', {20, 20}, 15, false};
  const print::MarkedBox second{U'二', {35, 20}, 15, false};
  Outlines page;
  page.draw_box(first, 1.4, 0.8);
  page.draw_box(second, 1.8, 1.2);
  const auto placed = page.placed({first, second});
  ASSERT_THAT(placed, SizeIs(2));
  expect_moved(placed[0], 1.4, 0.8);
  expect_moved(placed[1], 1.8, 1.2);
}

TEST(PlacedBoxes, FarFromTheOthersAreLookedForFarther) {
  const print::MarkedBox first{U'一', {20, 20}, 15, false};
  const print::MarkedBox near{U'二', {42, 20}, 15, false};
  const print::MarkedBox far{U'三', {43, 20}, 15, false};
  for (const print::MarkedBox& other : {near, far}) {
    Outlines page;
    page.draw_box(first, 0, 0);
    page.draw_box(other, 1.4, 0);
    const auto placed = page.placed({first, other});
    ASSERT_THAT(placed, SizeIs(2));
    if (other == far)
      expect_moved(placed[1], 1.4, 0);
    else
      EXPECT_LT(placed[1].x_mm, 1);
  }
}

TEST(PlacedBoxes, TheNearestNeighbourSaysWhereToBegin) {
  const print::MarkedBox left{U'一', {10, 20}, 15, false};
  const print::MarkedBox right{U'二', {80, 20}, 15, false};
  const print::MarkedBox beside_right{U'三', {80, 35}, 15, false};
  const print::MarkedBox beside_left{U'四', {10, 35}, 15, false};
  Outlines page;
  page.draw_box(left, -1.2, 0);
  page.draw_box(right, 1.2, 0.2);
  const auto placed = page.placed({left, right, beside_right, beside_left});
  ASSERT_THAT(placed, SizeIs(4));
  EXPECT_NEAR(placed[2].x_mm, 1.2, 0.7);
  EXPECT_NEAR(placed[3].x_mm, -1.2, 0.7);
}

}  // namespace
}  // namespace nazori::scan
