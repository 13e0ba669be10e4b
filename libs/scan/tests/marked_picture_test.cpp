// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/marked_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace nazori::scan {
namespace {

using Colour = std::array<int, 3>;
constexpr Colour kPaper{200, 200, 200};

Photo photograph() {
  Photo photo{200, 160, {}};
  photo.grey.assign(std::size_t{200} * 160, 200);
  return photo;
}

Colour colour_at(const surface::ColourPicture& picture, int x, int y) {
  const auto at = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

/// A cell of 100 pixels a side.
CellReading cell_with(CellState state) {
  CellReading cell;
  cell.corners = {PhotoPoint{20, 30}, {120, 30}, {120, 130}, {20, 130}};
  cell.state = state;
  return cell;
}

surface::ColourPicture marked(CellReading cell) {
  std::vector<SheetReading> sheets(1);
  sheets[0].cells.push_back(std::move(cell));
  return marked_picture(photograph(), sheets);
}

TEST(MarkedPicture, WithoutCellsIsThePhotograph) {
  Photo photo = photograph();
  photo.grey[200 * 7 + 3] = 17;
  const auto picture = marked_picture(photo, {});
  EXPECT_EQ(picture.width, 200);
  EXPECT_EQ(picture.height, 160);
  ASSERT_EQ(picture.rgb.size(), photo.grey.size() * 3);
  EXPECT_EQ(colour_at(picture, 3, 7), (Colour{17, 17, 17}));
  EXPECT_EQ(colour_at(picture, 4, 7), kPaper);
  EXPECT_EQ(colour_at(picture, 199, 159), kPaper);
}

TEST(MarkedPicture, TheColourSaysWhatWasFound) {
  CellReading remarked = cell_with(CellState::legible);
  remarked.remarks.push_back({CellFlaw::small, 0});
  const std::vector<std::pair<CellReading, Colour>> cases{{cell_with(CellState::empty), {150, 150, 150}},
                                                          {cell_with(CellState::traced), {70, 110, 230}},
                                                          {cell_with(CellState::illegible), {220, 30, 30}},
                                                          {cell_with(CellState::legible), {20, 150, 60}},
                                                          {remarked, {240, 140, 0}}};
  for (const auto& [cell, colour] : cases) EXPECT_EQ(colour_at(marked(cell), 70, 33), colour);
}

TEST(MarkedPicture, AnOutlineLiesJustInsideTheCell) {
  // 3 pixels inside, a thirtieth of the side wide.
  const auto picture = marked(cell_with(CellState::legible));
  const Colour green{20, 150, 60};
  for (int off = -4; off <= 4; ++off) {
    const bool on_line = off >= -1 && off <= 1;
    EXPECT_EQ(colour_at(picture, 70, 33 + off), on_line ? green : kPaper) << off;
    EXPECT_EQ(colour_at(picture, 70, 127 + off), on_line ? green : kPaper) << off;
    EXPECT_EQ(colour_at(picture, 23 + off, 80), on_line ? green : kPaper) << off;
    EXPECT_EQ(colour_at(picture, 117 + off, 80), on_line ? green : kPaper) << off;
  }
  for (int along = 22; along <= 118; ++along) EXPECT_EQ(colour_at(picture, along, 33), green) << along;
  for (const int beyond : {21, 119}) EXPECT_EQ(colour_at(picture, beyond, 33), kPaper) << beyond;
}

TEST(MarkedPicture, OnlyWhatIsIllegibleIsCrossedOut) {
  const auto crossed = marked(cell_with(CellState::illegible));
  const Colour red{220, 30, 30};
  for (const int d : {-30, -10, 0, 10, 30}) {
    EXPECT_EQ(colour_at(crossed, 70 + d, 80 + d), red) << d;
    EXPECT_EQ(colour_at(crossed, 70 + d, 80 - d), red) << d;
  }
  EXPECT_EQ(colour_at(crossed, 73, 80), kPaper);
  for (const CellState state : {CellState::empty, CellState::traced, CellState::legible})
    EXPECT_EQ(colour_at(marked(cell_with(state)), 70, 80), kPaper);
}

TEST(MarkedPicture, TheLineOfALargeCellIsWider) {
  CellReading cell = cell_with(CellState::legible);
  cell.corners = {PhotoPoint{0, 10}, {180, 10}, {180, 190}, {0, 190}};
  const auto picture = marked(cell);
  // 180 / 30 = 6 pixels: three to each side of the line at 5.4 inside.
  for (int y = 10; y <= 22; ++y) EXPECT_EQ(colour_at(picture, 90, y) != kPaper, y >= 12 && y <= 18) << y;
}

TEST(MarkedPicture, CellsMayReachBeyondThePhotograph) {
  CellReading cell = cell_with(CellState::legible);
  cell.corners = {PhotoPoint{-100, 20}, {400, 20}, {400, 520}, {-100, 520}};
  const auto wide = marked(cell);
  // 15 inside; 500 / 30 is 16 pixels.
  for (const int x : {0, 100, 199}) {
    EXPECT_EQ(colour_at(wide, x, 35), (Colour{20, 150, 60})) << x;
    EXPECT_EQ(colour_at(wide, x, 26), kPaper) << x;
    EXPECT_EQ(colour_at(wide, x, 27), (Colour{20, 150, 60})) << x;
    EXPECT_EQ(colour_at(wide, x, 43), (Colour{20, 150, 60})) << x;
    EXPECT_EQ(colour_at(wide, x, 44), kPaper) << x;
  }
}

}  // namespace
}  // namespace nazori::scan
