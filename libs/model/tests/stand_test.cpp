// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/stand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace nazori::model {
namespace {

double area(const PlateLine& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const PlatePoint a = line[i];
    const PlatePoint b = line[(i + 1) % line.size()];
    sum += (a.x * b.y - b.x * a.y) / 2;
  }
  return sum;
}

TEST(Stand, IsAClosedSolidOfTwoFeetThatLieFlat) {
  for (const double height : {20.0, 60.0, 120.0, 600.0}) {
    for (const double lean : {5.0, 20.0, 45.0}) {
      StandSettings settings;
      settings.plate_height_mm = height;
      settings.lean_deg = lean;
      const Mesh mesh = stand_mesh(settings).value();
      EXPECT_EQ(open_edges(mesh), 0U);
      const double expected = 2 * 10 * area(stand_outline(settings).value());
      EXPECT_GT(expected, 0);
      EXPECT_NEAR(volume_mm3(mesh), expected, expected * 1e-4) << height << ' ' << lean;
      // Every corner is on the bed or on the level upper face: nothing overhangs.
      for (const auto& corner : mesh.vertices) EXPECT_TRUE(corner[2] == 0 || corner[2] == 10);
    }
  }
}

TEST(Stand, TheSlotTakesThePlateAtItsLean) {
  StandSettings settings;
  settings.plate_thickness_mm = 4;
  settings.clearance_mm = 0.5;
  settings.lean_deg = 15;
  const PlateLine outline = stand_outline(settings).value();
  const PlatePoint rear = outline[5];
  const PlatePoint front = outline[6];
  EXPECT_NEAR(geometry::distance(rear, front), 4.5, 1e-9);
  EXPECT_NEAR(std::atan2(front.y - rear.y, rear.x - front.x) * 180 / 3.14159265358979, 15, 1e-6);
  const PlatePoint wall = outline[7] - front;
  EXPECT_NEAR(std::atan2(wall.x, wall.y) * 180 / 3.14159265358979, 15, 1e-6);
  EXPECT_GE(rear.y, 5 - 1e-9);  // what carries the plate
}

TEST(Stand, TheMiddleOfThePlateLiesOverTheFoot) {
  for (const double height : {20.0, 120.0, 600.0}) {
    StandSettings settings;
    settings.plate_height_mm = height;
    const PlateLine outline = stand_outline(settings).value();
    double length = 0;
    for (const PlatePoint p : outline) length = std::max(length, p.x);
    const double lean = 20 * 3.14159265358979 / 180;
    const double middle = outline[6].x + std::sin(lean) * height / 2 + std::cos(lean) * 6;
    EXPECT_GE(length, middle + 5);
    EXPECT_GT(outline[6].x, 5);
  }
}

TEST(Stand, WhatCannotStandIsRefused) {
  StandSettings settings;
  settings.lean_deg = 60;
  EXPECT_FALSE(stand_mesh(settings));
  settings = {};
  settings.plate_height_mm = 10;
  EXPECT_FALSE(stand_mesh(settings));
  settings = {};
  settings.plate_thickness_mm = std::nan("");
  EXPECT_FALSE(stand_mesh(settings));
  settings = {};
  settings.width_mm = 0;
  EXPECT_FALSE(stand_mesh(settings));
}

}  // namespace
}  // namespace nazori::model
