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

TEST(Stand, ItsCornersAreThoseOfAPlateThatLeansByThirtyDegrees) {
  // The sine is a half.
  const double c = std::sqrt(0.75);
  StandSettings settings;
  settings.plate_thickness_mm = 6;
  settings.clearance_mm = 0.4;
  settings.lean_deg = 30;
  const auto expect_corners = [&](const PlateLine& wanted) {
    const PlateLine outline = stand_outline(settings).value();
    ASSERT_EQ(outline.size(), wanted.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
      EXPECT_NEAR(outline[i].x, wanted[i].x, 1e-9) << i;
      EXPECT_NEAR(outline[i].y, wanted[i].y, 1e-9) << i;
    }
  };
  // 10 mm before the slot; it carries the plate 5 mm above the table, with walls of 5 mm.
  const double rear = 10 + 6.4 * c;
  settings.plate_height_mm = 100;  // the slot is 15 mm deep, its rear wall half as high again
  expect_corners({{0, 0},
                  {rear + 35, 0},
                  {rear + 35, 5},
                  {rear + 16.25, 5 + 22.5 * c},
                  {rear + 11.25, 5 + 22.5 * c},
                  {rear, 5},
                  {10, 8.2},
                  {17.5, 8.2 + 15 * c},
                  {12.5, 8.2 + 15 * c},
                  {0, 5}});
  settings.plate_height_mm = 20;  // 8 mm at least
  expect_corners({{0, 0},
                  {rear + 19, 0},
                  {rear + 19, 5},
                  {rear + 11, 5 + 12 * c},
                  {rear + 6, 5 + 12 * c},
                  {rear, 5},
                  {10, 8.2},
                  {14, 8.2 + 8 * c},
                  {9, 8.2 + 8 * c},
                  {0, 5}});
  settings.plate_height_mm = 600;  // 25 mm at most
  expect_corners({{0, 0},
                  {rear + 160, 0},
                  {rear + 160, 5},
                  {rear + 23.75, 5 + 37.5 * c},
                  {rear + 18.75, 5 + 37.5 * c},
                  {rear, 5},
                  {10, 8.2},
                  {22.5, 8.2 + 25 * c},
                  {17.5, 8.2 + 25 * c},
                  {0, 5}});
}

TEST(Stand, TheSecondFootLiesFiveMillimetresBeyondTheFirst) {
  StandSettings settings;
  settings.width_mm = 12;
  const PlateLine outline = stand_outline(settings).value();
  const Mesh mesh = stand_mesh(settings).value();
  ASSERT_EQ(mesh.vertices.size(), 40U);
  const double beyond = outline[4].y + 5;  // the highest corner is that of the rear wall
  for (std::size_t i = 0; i < 40; ++i) {
    const PlatePoint corner = outline[i % 10];
    EXPECT_NEAR(mesh.vertices[i][0], corner.x, 1e-4) << i;
    EXPECT_NEAR(mesh.vertices[i][1], corner.y + (i < 20 ? 0 : beyond), 1e-4) << i;
    EXPECT_EQ(mesh.vertices[i][2], i / 10 % 2 == 0 ? 0.0F : 12.0F) << i;
  }
}

TEST(Stand, EachSizeHasItsBounds) {
  struct Bounds {
    double StandSettings::*size;
    double low, high;
  };
  for (const Bounds& b :
       {Bounds{&StandSettings::plate_height_mm, 20, 600},
        Bounds{&StandSettings::plate_thickness_mm, 0.4, 100}, Bounds{&StandSettings::clearance_mm, 0, 2},
        Bounds{&StandSettings::lean_deg, 5, 45}, Bounds{&StandSettings::width_mm, 3, 50}}) {
    const auto taken = [&](double value) {
      StandSettings settings;
      settings.*b.size = value;
      return stand_outline(settings).has_value();
    };
    EXPECT_TRUE(taken(b.low)) << b.low;
    EXPECT_FALSE(taken(b.low - 0.01)) << b.low;
    EXPECT_TRUE(taken(b.high)) << b.high;
    EXPECT_FALSE(taken(b.high + 0.01)) << b.high;
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
