// SPDX-License-Identifier: Apache-2.0
// What the structs of this room begin with, bounds from both sides, and a normal by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "nazori/model/braille.h"
#include "nazori/model/embosser.h"
#include "nazori/model/laser.h"
#include "nazori/model/mesh.h"
#include "nazori/model/mesh_file.h"
#include "nazori/model/mill.h"
#include "nazori/model/plate.h"
#include "nazori/model/plot_layout.h"
#include "nazori/model/raised.h"
#include "nazori/model/stand.h"
#include "nazori/model/tablet_plate.h"

namespace nazori::model {
namespace {

TEST(ModelDefaults, AreTheSizesThatFingersCanRead) {
  const BrailleSize braille;
  EXPECT_EQ(braille.dot_width_mm, 1.25);
  EXPECT_EQ(braille.dot_height_mm, 0.5);
  EXPECT_EQ(braille.dot_distance_mm, 2.5);
  EXPECT_EQ(braille.cell_distance_mm, 6.0);
  EXPECT_EQ(RaisedLine{}.height_mm, 1.0);
  EXPECT_EQ(RaisedLine{}.width_mm, 1.1);
  EXPECT_EQ(Hole{}.radius_mm, 2);
  const RaisedStrokeSettings strokes;
  EXPECT_TRUE(strokes.start_dots && strokes.numbers);
  EXPECT_EQ(strokes.dot_width_mm, 3.0);
  EXPECT_EQ(strokes.dot_rise_mm, 0.8);
  EXPECT_EQ(strokes.clear_mm, 1.2);
  const RaisedPlotSettings plot;
  EXPECT_EQ(plot.side_mm, 120);
  EXPECT_EQ(plot.thickness_mm, 3);
  EXPECT_EQ(plot.surface_height_mm, 20);
  EXPECT_EQ(plot.step_mm, 0.15);
  EXPECT_EQ(plot.axis.height_mm, 0.5);
  EXPECT_EQ(plot.axis.width_mm, 0.8);
  const TabletPlateSettings tablet;
  EXPECT_EQ(tablet.side_mm, 100);
  EXPECT_EQ(tablet.margin_mm, 6);
  EXPECT_EQ(tablet.thickness_mm, 6);
  EXPECT_EQ(tablet.depth_mm, 3);
  EXPECT_FALSE(tablet.vertical);
  EXPECT_EQ(MeshSettings{}.tolerance_mm, 0.01);
  EXPECT_EQ(MeshSettings{}.most_triangles, 99'000U);
  EXPECT_EQ(PlateMesh{}.error_mm, 0);
  EXPECT_EQ(RaisedTick{}.share, 0);
}

TEST(ModelDefaults, OfMachinesAreThoseOfTheHeaders) {
  const MillSettings mill;
  EXPECT_EQ(mill.cutter_mm, 3);
  EXPECT_EQ(mill.step_over_mm, 0.2);
  EXPECT_EQ(mill.pass_depth_mm, 1.5);
  EXPECT_EQ(mill.safe_mm, 5);
  EXPECT_EQ(mill.feed_mm_min, 800);
  EXPECT_EQ(mill.plunge_mm_min, 250);
  EXPECT_EQ(mill.spindle_rpm, 12'000);
  EXPECT_EQ(MillGuide{}.half_width_mm, 1);
  EXPECT_EQ(MillMove{}.speed, MillMove::Speed::rapid);
  for (const double value : {MillMove{}.x, MillMove{}.y, MillMove{}.z, MillPath{}.deepest_mm,
                             MillPath{}.cut_length_mm, MillPath{}.minutes})
    EXPECT_EQ(value, 0);
  EXPECT_EQ(MillPath{}.passes, 0);
  const StandSettings stand;
  EXPECT_EQ(stand.plate_height_mm, 100);
  EXPECT_EQ(stand.plate_thickness_mm, 6);
  EXPECT_EQ(stand.clearance_mm, 0.4);
  EXPECT_EQ(stand.lean_deg, 20);
  EXPECT_EQ(stand.width_mm, 10);
  EXPECT_EQ(EmbosserPaper{}.columns, 40);
  EXPECT_EQ(EmbosserPaper{}.lines, 25);
  EXPECT_TRUE(EmbossedMarks{}.numbers && EmbossedMarks{}.start_dots);
  EXPECT_EQ(PlotDistances{}.edge_mm, 5);
  EXPECT_EQ(PlotDistances{}.gap_mm, 3);
  EXPECT_EQ(PlotDistances{}.tick_mm, 4);
  const PlotLayout layout;
  for (const double value : {layout.width_mm, layout.height_mm, layout.side_mm}) EXPECT_EQ(value, 0);
  const TabletPlateSettings tablet;
  EXPECT_EQ(tablet.columns, 0);
  EXPECT_EQ(tablet.gap_mm, 0);
  EXPECT_TRUE(tablet.hanging_hole);
  EXPECT_EQ(kFewestLayers, 1);
  EXPECT_EQ(kMostLayers, 64);
}

TEST(MillBounds, AreTakenAndWhatLiesBeyondIsRefused) {
  // On a plate without grooves what is taken meets another refusal.
  const Plate flat = Plate::create(4, 4, 0.05, 3).value();
  struct Bounds {
    double MillSettings::*size;
    const char* name;
    double low, high;
  };
  for (const Bounds& b : {Bounds{&MillSettings::cutter_mm, "cutter", 0.2, 20},
                          Bounds{&MillSettings::step_over_mm, "step over", 0.02, 5},
                          Bounds{&MillSettings::pass_depth_mm, "depth of a pass", 0.05, 50},
                          Bounds{&MillSettings::safe_mm, "safe height", 1, 100},
                          Bounds{&MillSettings::feed_mm_min, "feed rate", 10, 20'000},
                          Bounds{&MillSettings::plunge_mm_min, "plunge rate", 10, 20'000},
                          Bounds{&MillSettings::spindle_rpm, "spindle speed", 0, 60'000}}) {
    const auto refusal = [&](double value) {
      MillSettings settings;
      settings.step_over_mm = 2;
      settings.*b.size = value;
      return mill_path(flat, {}, settings).error().what;
    };
    const std::string word = std::string("the ") + b.name + " cannot be";
    EXPECT_TRUE(refusal(b.low).starts_with("a ball of")) << b.name;
    EXPECT_TRUE(refusal(b.high).starts_with("a ball of")) << b.name;
    EXPECT_TRUE(refusal(b.low - 0.01).starts_with(word)) << b.name;
    EXPECT_TRUE(refusal(b.high + 1).starts_with(word)) << b.name;
  }
}

TEST(TabletPlateBounds, AreTakenAndWhatLiesBeyondIsRefused) {
  const std::array maps{surface::HeightMap::create(3).value()};
  const auto taken = [&](auto change) {
    TabletPlateSettings settings;
    settings.side_mm = 20;
    settings.hanging_hole = false;
    change(settings);
    return grooved_plate(maps, settings).has_value();
  };
  for (const double side : {9.9, 10.0, 500.0, 500.1})
    EXPECT_EQ(taken([side](auto& s) { s.side_mm = side; }), side > 9.9 && side < 500.1) << side;
  for (const double mm : {-0.1, 0.0, 100.0, 100.1}) {
    EXPECT_EQ(taken([mm](auto& s) { s.margin_mm = mm; }), mm > -0.1 && mm < 100.1) << mm;
    EXPECT_EQ(taken([mm](auto& s) { s.gap_mm = mm; }), mm > -0.1 && mm < 100.1) << mm;
  }
  EXPECT_TRUE(taken([](auto& s) { s.columns = 7; })) << "there are no more columns than tablets";
}

TEST(TabletPlate, IsAsFineAsItsGroovesNeedAndNoFinerThanAModelBears) {
  const std::array maps{surface::HeightMap::create(3).value()};
  TabletPlateSettings settings;
  settings.hanging_hole = false;
  settings.side_mm = 128;
  EXPECT_NEAR(grooved_plate(maps, settings)->step_mm(), 0.25, 1e-12);
  settings.side_mm = 20;
  const std::vector<RaisedStroke> strokes{{{{0.2, 0.5}, {0.8, 0.5}}, LineEnd::full}};
  EXPECT_NEAR(raised_plate(std::array{strokes}, settings)->plate.step_mm(), 0.125, 1e-12);
  settings.side_mm = 288;
  settings.margin_mm = 6;
  EXPECT_NEAR(raised_plate(std::array{strokes}, settings)->plate.step_mm(), 300 / std::sqrt(1.5e6), 1e-9);
}

TEST(TabletPlate, TheNumbersOfAllTabletsThatHaveNoRoomAreNamed) {
  std::vector<RaisedStroke> strokes;
  for (int i = 0; i < 14; ++i)
    strokes.push_back({{{0.02, 0.05 + 0.065 * i}, {0.98, 0.05 + 0.065 * i}}, LineEnd::full});
  TabletPlateSettings settings;
  settings.side_mm = 60;
  settings.margin_mm = 0;
  settings.vertical = true;
  const auto one = raised_plate(std::array{strokes}, settings);
  const auto two = raised_plate(std::array{strokes, strokes}, settings);
  ASSERT_TRUE(one && two);
  ASSERT_FALSE(one->without_number.empty());
  EXPECT_GT(two->without_number.size(), one->without_number.size());
}

TEST(PlateBounds, AreTakenAndWhatLiesBeyondIsRefused) {
  const auto made = [](double width, double height, double step, double thickness) {
    return Plate::create(width, height, step, thickness).has_value();
  };
  EXPECT_TRUE(made(1, 1, 0.5, 3));
  EXPECT_FALSE(made(0.99, 1, 0.5, 3));
  EXPECT_FALSE(made(1, 0.99, 0.5, 3));
  EXPECT_TRUE(made(1000, 1, 1, 3));
  EXPECT_FALSE(made(1001, 1, 1, 3));
  EXPECT_FALSE(made(1, 1001, 1, 3));
  EXPECT_TRUE(made(2, 2, 0.02, 3));
  EXPECT_FALSE(made(2, 2, 0.019, 3));
  EXPECT_TRUE(made(20, 20, 5, 3));
  EXPECT_FALSE(made(20, 20, 5.1, 3));
  EXPECT_TRUE(made(20, 20, 1, 0.4));
  EXPECT_FALSE(made(20, 20, 1, 0.39));
  EXPECT_TRUE(made(20, 20, 1, 100));
  EXPECT_FALSE(made(20, 20, 1, 101));
}

TEST(StlNormals, AreTheCrossProductOfTheSides) {
  Mesh mesh;
  mesh.vertices = {{1, 1, 1}, {2, 3, 4}, {-1, 2, 5}};  // sides (1, 2, 3) and (-2, 1, 4)
  mesh.triangles = {{0, 1, 2}};
  const auto bytes = to_stl(mesh);
  ASSERT_EQ(bytes.size(), 84U + 50U);
  std::array<float, 12> numbers{};
  std::memcpy(numbers.data(), bytes.data() + 84, sizeof numbers);
  const float unit = 1 / std::sqrt(6.0F);
  const std::array<float, 12> expected{unit, -2 * unit, unit, 1, 1, 1, 2, 3, 4, -1, 2, 5};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(numbers.at(i), expected.at(i), 1e-6) << i;
}

}  // namespace
}  // namespace nazori::model
