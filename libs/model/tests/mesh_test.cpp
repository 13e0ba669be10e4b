// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "test_plates.h"

namespace nazori::model {
namespace {

Plate sunk(const surface::HeightMap& map, double side_mm, double step_mm) {
  Plate plate = Plate::create(side_mm, side_mm, step_mm, 5).value();
  plate.sink(map, {0, 0}, side_mm, 3);
  return plate;
}

TEST(Mesh, ABoxHasTwelveTriangles) {
  const Plate plate = Plate::create(30, 20, 0.5, 4).value();
  const auto made = mesh_of(plate);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->mesh.triangles.size(), 12U);
  EXPECT_EQ(made->mesh.vertices.size(), 8U);
  EXPECT_EQ(open_edges(made->mesh), 0U);
  EXPECT_NEAR(volume_mm3(made->mesh), 30 * 20 * 4, 1e-6);
  EXPECT_EQ(made->error_mm, 0);
}

TEST(Mesh, AReliefIsClosedAndHasTheVolumeOfItsSamples) {
  const Plate plate = sunk(hills(257), 64, 0.25);
  const auto made = mesh_of(plate);
  ASSERT_TRUE(made);
  EXPECT_EQ(open_edges(made->mesh), 0U);
  EXPECT_LE(made->error_mm, 0.01);
  const double volume = volume_of_samples(plate);
  EXPECT_NEAR(volume_mm3(made->mesh), volume, volume * 0.001);
  EXPECT_LT(volume, 64.0 * 64 * 4.9);  // the relief is there
}

TEST(Mesh, EvenNoiseUpToTheRimIsClosed) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Plate plate = sunk(noise(65, seed), 32, 0.5);
    const auto made = mesh_of(plate);
    ASSERT_TRUE(made);
    EXPECT_EQ(open_edges(made->mesh), 0U);
    EXPECT_NEAR(volume_mm3(made->mesh), volume_of_samples(plate), volume_of_samples(plate) * 0.01);
  }
}

TEST(Mesh, TheTrianglesHaveALimitWithWallsAndLowerFace) {
  const Plate plate = sunk(noise(129, 4), 64, 0.5);
  const auto made = mesh_of(plate, {1e-4, 5000});
  ASSERT_TRUE(made);
  EXPECT_LE(made->mesh.triangles.size(), 5000U);
  EXPECT_GT(made->mesh.triangles.size(), 3500U);
  EXPECT_GT(made->error_mm, 1e-4);
  EXPECT_EQ(open_edges(made->mesh), 0U);
}

TEST(Mesh, AHoleGoesThroughAndIsClosed) {
  Plate plate = Plate::create(40, 40, 0.25, 5).value();
  plate.sink(hills(129), {4, 4}, 26, 3);
  ASSERT_TRUE(plate.add_hole({{20, 35}, 2}));
  const auto made = mesh_of(plate);
  ASSERT_TRUE(made);
  EXPECT_EQ(open_edges(made->mesh), 0U);
  // A prism on 24 corners of a circle.
  const double hole = 24 / 2.0 * 4 * std::sin(2 * std::numbers::pi / 24) * 5;
  const double volume = volume_of_samples(plate) - hole;
  EXPECT_NEAR(volume_mm3(made->mesh), volume, volume * 0.001);
  for (const auto& t : made->mesh.triangles) {
    double x = 0;
    double y = 0;
    for (const auto corner : t) {
      x += made->mesh.vertices[corner][0] / 3.0;
      y += made->mesh.vertices[corner][1] / 3.0;
    }
    EXPECT_GT(std::hypot(x - 20, y - 35), 1.7) << "a triangle closes the hole";
  }
}

TEST(Mesh, SeveralHolesAreAllOpen) {
  Plate plate = Plate::create(60, 40, 0.25, 3).value();
  ASSERT_TRUE(plate.add_hole({{10, 35}, 2}));
  ASSERT_TRUE(plate.add_hole({{50, 35}, 2.5}));
  const auto made = mesh_of(plate);
  ASSERT_TRUE(made);
  EXPECT_EQ(open_edges(made->mesh), 0U);
  // Euler: a body with two holes through it has V - E + F = -2; each triangle has 1.5 edges.
  const auto v = static_cast<long>(made->mesh.vertices.size());
  const auto f = static_cast<long>(made->mesh.triangles.size());
  std::set<std::uint32_t> used;
  for (const auto& t : made->mesh.triangles) used.insert(t.begin(), t.end());
  EXPECT_EQ(static_cast<long>(used.size()) - f * 3 / 2 + f, -2);
  EXPECT_EQ(static_cast<long>(used.size()), v) << "a corner that no triangle uses";
}

TEST(Mesh, ThatAnEdgeIsOpenIsNoticed) {
  auto mesh = mesh_of(Plate::create(30, 20, 0.5, 4).value()).value().mesh;
  mesh.triangles.pop_back();
  EXPECT_EQ(open_edges(mesh), 3U);
  mesh = mesh_of(Plate::create(30, 20, 0.5, 4).value()).value().mesh;
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_GT(open_edges(mesh), 0U);
}

TEST(Mesh, TheSamePlateGivesTheSameMesh) {
  const Plate plate = sunk(noise(65, 9), 32, 0.5);
  const auto first = mesh_of(plate).value();
  const auto second = mesh_of(plate).value();
  EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
}

TEST(Mesh, ItsCornersLieOnTheSamplesOfThePlateAndOnTheBed) {
  Plate plate = Plate::create(30, 20, 0.25, 4).value();
  plate.sink(hills(65), {2, 2}, 16, 2);
  ASSERT_TRUE(plate.add_hole({{25, 10}, 2}));
  const Mesh mesh = mesh_of(plate)->mesh;
  for (const auto& [x, y, z] : mesh.vertices) {
    const int column = static_cast<int>(std::lround(x / 0.25));
    const int row = static_cast<int>(std::lround(y / 0.25));
    EXPECT_FLOAT_EQ(x, static_cast<float>(column * 0.25));
    EXPECT_FLOAT_EQ(y, static_cast<float>(row * 0.25));
    EXPECT_TRUE(z == 0 || z == plate.at(column, row)) << x << " " << y;
  }
}

TEST(Mesh, TheWallOfAHoleHasTwentyFourCornersOnItsCircle) {
  Plate plate = Plate::create(30, 20, 0.25, 4).value();
  ASSERT_TRUE(plate.add_hole({{20, 9}, 3}));
  const Mesh mesh = mesh_of(plate)->mesh;
  std::set<std::pair<float, float>> lower, wanted;
  for (const auto& t : mesh.triangles) {
    // Triangles of walls stand upright: two of their corners are above one another.
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& a = mesh.vertices[t[i]];
      const auto& b = mesh.vertices[t[(i + 1) % 3]];
      if (a[0] == b[0] && a[1] == b[1] && std::hypot(a[0] - 20, a[1] - 9) < 4) lower.emplace(a[0], a[1]);
    }
  }
  for (int i = 0; i < 24; ++i) {
    const double angle = i * std::numbers::pi / 12;
    wanted.emplace(static_cast<float>(std::lround((20 + 3 * std::cos(angle)) * 4)) / 4,
                   static_cast<float>(std::lround((9 + 3 * std::sin(angle)) * 4)) / 4);
  }
  EXPECT_EQ(lower, wanted);
}

TEST(Mesh, AWideHoleIsClosedThoughTheGroundIsRoughAMillimetreFromIt) {
  for (const double radius : {6.0, 11.0}) {
    const PlatePoint centre{20, 20};
    auto map = noise(161, 12);
    for (int row = 0; row < 161; ++row)
      for (int column = 0; column < 161; ++column)
        if (std::hypot(column * 0.25 - centre.x, 40 - row * 0.25 - centre.y) <= radius + 1.3)
          map.set(column, row, 1.0F);
    Plate plate = Plate::create(40, 40, 0.25, 5).value();
    plate.sink(map, {0, 0}, 40, 3);
    ASSERT_TRUE(plate.add_hole({centre, radius})) << radius;
    EXPECT_EQ(open_edges(mesh_of(plate, {1e-3, 12'000})->mesh), 0U) << radius;
  }
}

TEST(Mesh, HasNearlyAsManyTrianglesAsItMayWhereTheyDoNotSuffice) {
  Plate plate = sunk(noise(129, 6), 64, 0.5);
  Plate holed = Plate::create(64, 64, 0.25, 5).value();
  holed.sink(noise(129, 7), {0, 0}, 50, 3);
  ASSERT_TRUE(holed.add_hole({{57, 57}, 3}));
  for (const std::size_t most : {std::size_t{1000}, std::size_t{3000}})
    for (const Plate* p : {&plate, &holed}) {
      const auto made = mesh_of(*p, {1e-4, most});
      ASSERT_TRUE(made);
      EXPECT_LE(made->mesh.triangles.size(), most);
      EXPECT_GE(made->mesh.triangles.size(), most * 85 / 100);
      EXPECT_EQ(open_edges(made->mesh), 0U);
    }
}

TEST(Mesh, TheGreatestDistanceIsTold) {
  // A mesh that may have few triangles: the farthest sample from it, by the height of its triangles there.
  const Plate plate = sunk(noise(33, 8), 16, 0.5);
  const auto made = mesh_of(plate, {1e-4, 1000});
  ASSERT_TRUE(made);
  double worst = 0;
  for (int row = 0; row < plate.rows(); ++row)
    for (int column = 0; column < plate.columns(); ++column) {
      const double x = column * 0.5, y = row * 0.5;
      for (const auto& t : made->mesh.triangles) {
        const auto &a = made->mesh.vertices[t[0]], &b = made->mesh.vertices[t[1]],
                   &c = made->mesh.vertices[t[2]];
        const double whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if (whole <= 1e-9) continue;  // of the lower face or a wall
        const double u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / whole;
        const double v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / whole;
        if (u < -1e-9 || v < -1e-9 || u + v > 1 + 1e-9) continue;
        worst =
            std::max(worst, std::abs(a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]) - plate.at(column, row)));
      }
    }
  EXPECT_GT(worst, 0.01);
  EXPECT_NEAR(made->error_mm, worst, 1e-4);
}

TEST(Mesh, ASettingOutOfRangeIsRefused) {
  const Plate plate = Plate::create(30, 20, 0.5, 4).value();
  EXPECT_EQ(mesh_of(plate, {0, 99'000}).error().code, base::Errc::bad_argument);
  EXPECT_FALSE(mesh_of(plate, {std::nan(""), 99'000}));
  EXPECT_FALSE(mesh_of(plate, {0.01, 999}));
  EXPECT_TRUE(mesh_of(plate, {0.01, 1000}));
}

}  // namespace
}  // namespace nazori::model
