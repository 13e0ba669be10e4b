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

TEST(Mesh, ASettingOutOfRangeIsRefused) {
  const Plate plate = Plate::create(30, 20, 0.5, 4).value();
  EXPECT_EQ(mesh_of(plate, {0, 99'000}).error().code, base::Errc::bad_argument);
  EXPECT_FALSE(mesh_of(plate, {std::nan(""), 99'000}));
  EXPECT_FALSE(mesh_of(plate, {0.01, 999}));
  EXPECT_TRUE(mesh_of(plate, {0.01, 1000}));
}

}  // namespace
}  // namespace nazori::model
