// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/sheets.h"

#include <gtest/gtest.h>

#include <numbers>

#include "nazori/exchange/document.h"
#include "nazori/scan/sheet_reader.h"

namespace nazori::exchange {
namespace {

TEST(SheetDocument, TellsPlacesAndShapesToAThousandth) {
  scan::CellReading cell;
  cell.box.character = U'休';
  cell.corners = {{{1.2346, 2}, {30.0004, 2.5}, {30, 31.9996}, {1, 32}}};
  cell.shape = writing::InkShape{.covered = {1, 0.12345},
                                 .missing = 0.25,
                                 .extra = 0.0014,
                                 .size = 0.98765,
                                 .offset_x = -0.0125,
                                 .offset_y = 0.5,
                                 .lean_rad = std::numbers::pi / 6};
  scan::SheetReading sheet;
  sheet.mark.page = 3;
  sheet.cells = {cell};
  const Value json = to_json("a.jpg", std::vector{sheet});
  EXPECT_EQ(json["photo"], "a.jpg");
  EXPECT_EQ(json["stroke_order_seen"], false);
  ASSERT_EQ(json["sheets"].size(), 1U);
  EXPECT_EQ(json["sheets"][0]["page"], 3);
  const Value& told = json["sheets"][0]["cells"][0];
  EXPECT_EQ(told["character"], "休");
  EXPECT_EQ(json::to_line(told["corners"]), "[[1.235,2.0],[30.0,2.5],[30.0,32.0],[1.0,32.0]]");
  const Value& shape = told["shape"];
  EXPECT_EQ(json::to_line(shape["covered"]), "[1.0,0.123]");
  EXPECT_DOUBLE_EQ(shape["size"].get<double>(), 0.988);
  EXPECT_DOUBLE_EQ(shape["right"].get<double>(), -0.013);
  EXPECT_DOUBLE_EQ(shape["down"].get<double>(), 0.5);
  EXPECT_DOUBLE_EQ(shape["lean_deg"].get<double>(), 30);
  EXPECT_DOUBLE_EQ(shape["missing"].get<double>(), 0.25);
  EXPECT_DOUBLE_EQ(shape["extra"].get<double>(), 0.001);
  EXPECT_TRUE(told["looks_like"].is_null());
}

}  // namespace
}  // namespace nazori::exchange
