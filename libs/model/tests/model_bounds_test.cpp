// SPDX-License-Identifier: Apache-2.0
// What the structs of this room begin with, bounds from both sides, and a normal by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "nazori/model/braille.h"
#include "nazori/model/mesh.h"
#include "nazori/model/mesh_file.h"
#include "nazori/model/plate.h"
#include "nazori/model/raised.h"
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
