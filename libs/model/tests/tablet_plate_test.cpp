// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/tablet_plate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "nazori/model/mesh.h"
#include "test_plates.h"

namespace nazori::model {
namespace {

using testing::HasSubstr;

double rise(const Plate& plate, double x, double y) {
  return plate.at(static_cast<int>(std::lround(x / plate.step_mm())),
                  static_cast<int>(std::lround(y / plate.step_mm()))) -
         plate.thickness_mm();
}

/// A map whose one deep sample is the middle.
surface::HeightMap pit() {
  auto map = surface::HeightMap::create(65).value();
  for (int row = 31; row <= 33; ++row)
    for (int column = 31; column <= 33; ++column) map.set(column, row, 0.0F);
  return map;
}

TEST(TabletPlate, AGrooveHasItsDepthInTheMiddleOfTheTablet) {
  const Plate plate = grooved_plate(std::array{pit()}).value();
  EXPECT_NEAR(plate.width_mm(), 112, 0.2);
  EXPECT_NEAR(plate.height_mm(), 120, 0.2);
  EXPECT_NEAR(rise(plate, 56, 56), -3, 1e-3);
  EXPECT_EQ(rise(plate, 40, 56), 0);
  ASSERT_EQ(plate.holes().size(), 1U);
  EXPECT_NEAR(plate.holes()[0].centre.x, 56, 0.2);
  EXPECT_NEAR(plate.holes()[0].centre.y, 115, 0.2);
}

TEST(TabletPlate, TabletsStandInRowsWithGaps) {
  TabletPlateSettings settings;
  settings.side_mm = 40;
  settings.gap_mm = 10;
  settings.columns = 2;
  settings.hanging_hole = false;
  // 2 above, 1 below: only the third is deep.
  const auto flat = surface::HeightMap::create(65).value();
  const std::array maps{flat, flat, pit()};
  const Plate plate = grooved_plate(maps, settings).value();
  EXPECT_NEAR(plate.width_mm(), 12 + 90, 0.2);
  EXPECT_NEAR(plate.height_mm(), 12 + 90, 0.2);
  EXPECT_NEAR(rise(plate, 26, 26), -3, 1e-3);
  const auto corners = tablet_corners(3, settings);
  EXPECT_EQ(corners[0], (PlatePoint{6, 56}));
  EXPECT_EQ(corners[1], (PlatePoint{56, 56}));
  EXPECT_EQ(corners[2], (PlatePoint{6, 6}));
  settings.gap_mm = -1;
  EXPECT_FALSE(grooved_plate(maps, settings));
  settings.gap_mm = 0;
  settings.columns = -1;
  EXPECT_FALSE(grooved_plate(maps, settings));
}

TEST(TabletPlate, AWordStandsSideBySideOrBelowOneAnother) {
  TabletPlateSettings settings;
  settings.side_mm = 40;
  settings.hanging_hole = false;
  const std::array maps{pit(), surface::HeightMap::create(65).value(), pit()};
  const Plate beside = grooved_plate(maps, settings).value();
  EXPECT_NEAR(beside.width_mm(), 132, 0.2);
  EXPECT_NEAR(beside.height_mm(), 52, 0.2);
  EXPECT_NEAR(rise(beside, 6 + 20, 26), -3, 1e-3);
  EXPECT_EQ(rise(beside, 6 + 60, 26), 0);
  EXPECT_NEAR(rise(beside, 6 + 100, 26), -3, 1e-3);
  settings.vertical = true;
  const std::array first_deep{pit(), surface::HeightMap::create(65).value()};
  const Plate below = grooved_plate(first_deep, settings).value();
  EXPECT_NEAR(below.height_mm(), 92, 0.2);
  EXPECT_NEAR(rise(below, 26, 6 + 60), -3, 1e-3);
  EXPECT_EQ(rise(below, 26, 6 + 20), 0);
}

TEST(TabletPlate, RaisedStrokesAreScaledToTheTablet) {
  const std::vector<RaisedStroke> strokes{{{{0.25, 0.5}, {0.75, 0.5}}, LineEnd::full}};
  TabletPlateSettings settings;
  settings.side_mm = 60;
  const auto made = raised_plate(std::array{strokes}, settings).value();
  EXPECT_TRUE(made.without_number.empty());
  EXPECT_NEAR(rise(made.plate, 6 + 30, 6 + 30), 1, 0.02);
  EXPECT_NEAR(rise(made.plate, 6 + 15, 6 + 30), 1.8, 0.02);
  EXPECT_EQ(rise(made.plate, 6 + 30, 6 + 34), 0);
}

TEST(TabletPlate, WhatCannotBeMadeIsRefused) {
  EXPECT_THAT(grooved_plate({}).error().what, HasSubstr("no tablet"));
  EXPECT_FALSE(raised_plate({}));
  TabletPlateSettings settings;
  settings.depth_mm = 5.1;
  EXPECT_THAT(grooved_plate(std::array{pit()}, settings).error().what, HasSubstr("5.1 mm"));
  settings.depth_mm = 5;
  EXPECT_TRUE(grooved_plate(std::array{pit()}, settings));
  settings.depth_mm = 0;
  EXPECT_FALSE(grooved_plate(std::array{pit()}, settings));
  settings = {};
  settings.side_mm = 9;
  EXPECT_FALSE(grooved_plate(std::array{pit()}, settings));
}

TEST(TabletPlate, AMouldHoldsWhatIsPouredIn) {
  TabletPlateSettings settings;
  settings.side_mm = 40;
  const Plate plate = grooved_plate(std::array{pit()}, settings).value();
  const Plate mould = mould_of(plate);
  const float lowest = *std::min_element(mould.heights().begin(), mould.heights().end());
  EXPECT_GE(lowest, 3 - 1e-3);
  // The groove has become a knob of its depth, 5 mm below the rim.
  const double knob = rise(mould, plate.width_mm() - 26, 26);
  EXPECT_NEAR(knob + 6 - lowest, 3, 1e-3);
  EXPECT_NEAR(rise(mould, 0, 0) - knob, 5, 1e-3);
  EXPECT_NEAR(rise(mould, mould.width_mm(), mould.height_mm()), rise(mould, 0, 0), 3.01);
  EXPECT_EQ(open_edges(mesh_of(mould).value().mesh), 0U);
}

}  // namespace
}  // namespace nazori::model
