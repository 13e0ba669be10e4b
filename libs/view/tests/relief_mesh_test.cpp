// SPDX-License-Identifier: Apache-2.0
#include "../src/relief_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace nazori::view {
namespace {

/// Smooth hills, a steep groove and some noise: everything that can occur in a relief.
Relief hills(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> noise(0, 0.02F);
  Relief relief{size, {}};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = static_cast<double>(column) / size;
      const double y = static_cast<double>(row) / size;
      const double groove = std::abs(x - 0.3 - 0.4 * y) < 0.04 ? 0.35 : 0;
      const double bumpy = x > 0.7 ? static_cast<double>(noise(random)) : 0.0;
      relief.heights.push_back(
          static_cast<float>(0.55 + 0.2 * std::sin(5 * x) * std::cos(4 * y) - groove + bumpy));
    }
  return relief;
}

struct Corner {
  double x, y, z;
};
Corner corner(const ReliefMesh& mesh, std::uint32_t index) {
  const MeshVertex& v = mesh.vertices[index];
  return {static_cast<double>(v.column), static_cast<double>(v.row), v.height / 65535.0};
}

TEST(ReliefMesh, CoversAllAndMissesNoSampleByMuch) {
  for (const float tolerance : {0.002F, 0.01F, 0.05F}) {
    const Relief relief = hills(129, 3);
    const ReliefMesh mesh = make_relief_mesh(relief, tolerance);
    std::vector<int> covered(relief.heights.size(), 0);
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      const Corner a = corner(mesh, mesh.indices[t]), b = corner(mesh, mesh.indices[t + 1]),
                   c = corner(mesh, mesh.indices[t + 2]);
      const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      ASSERT_NE(area, 0);
      for (int row = static_cast<int>(std::min({a.y, b.y, c.y})); row <= std::max({a.y, b.y, c.y}); ++row)
        for (int column = static_cast<int>(std::min({a.x, b.x, c.x})); column <= std::max({a.x, b.x, c.x});
             ++column) {
          const double u = ((b.x - column) * (c.y - row) - (c.x - column) * (b.y - row)) / area;
          const double v = ((c.x - column) * (a.y - row) - (a.x - column) * (c.y - row)) / area;
          const double w = 1 - u - v;
          if (std::min({u, v, w}) < -1e-9) continue;
          covered[static_cast<std::size_t>(row) * 129 + static_cast<std::size_t>(column)] = 1;
          // At the middle of each hypotenuse the error is within the tolerance; errors of several levels may
          // add up.
          const double off = std::abs(u * a.z + v * b.z + w * c.z - relief.at(column, row));
          ASSERT_LE(off, 2 * tolerance + 1.0 / 65535) << column << ", " << row << " at " << tolerance;
        }
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 0), 0);
  }
}

TEST(ReliefMesh, MeetsTheMiddleOfEachHypotenuseWithinItsTolerance) {
  for (const float tolerance : {0.002F, 0.01F, 0.05F}) {
    const Relief relief = hills(129, 3);
    const ReliefMesh mesh = make_relief_mesh(relief, tolerance);
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      // The longest side joins the first two corners.
      const Corner a = corner(mesh, mesh.indices[t]), b = corner(mesh, mesh.indices[t + 1]),
                   c = corner(mesh, mesh.indices[t + 2]);
      ASSERT_EQ(std::hypot(a.x - c.x, a.y - c.y), std::hypot(b.x - c.x, b.y - c.y));
      const int column = static_cast<int>(a.x + b.x) / 2;
      const int row = static_cast<int>(a.y + b.y) / 2;
      if (std::abs(a.x - b.x) + std::abs(a.y - b.y) < 2 || 2 * column != static_cast<int>(a.x + b.x) ||
          2 * row != static_cast<int>(a.y + b.y))
        continue;  // no sample lies there
      ASSERT_NEAR((a.z + b.z) / 2, relief.at(column, row), tolerance + 1.0 / 65535) << tolerance;
    }
  }
}

TEST(ReliefMesh, ASingleSpikeIsMetWhereverItStands) {
  constexpr int kSide = 65;
  for (int row = 0; row < kSide; ++row) {
    for (int column = (row * 3) % 4; column < kSide; column += 4) {
      Relief relief{kSide, std::vector<float>(static_cast<std::size_t>(kSide) * kSide, 0.25F)};
      relief.heights[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)] = 0.75F;
      const ReliefMesh mesh = make_relief_mesh(relief, 0.1F);
      const bool met = std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const MeshVertex& v) {
        return v.column == column && v.row == row && v.height == 49151;
      });
      ASSERT_TRUE(met) << column << ", " << row;
      // Cut up around the spike only: less than an eighth of what all samples would take.
      ASSERT_LT(mesh.indices.size(), 3U * 64 * 64 * 2 / 8) << column << ", " << row;
    }
  }
}

TEST(ReliefMesh, HeightsAreTheNearestOf65536) {
  Relief relief{33, std::vector<float>(33 * 33, 1.0F)};
  relief.heights[0] = 0;
  relief.heights[32] = 0.50001F;
  const ReliefMesh mesh = make_relief_mesh(relief, 0.001F);
  EXPECT_EQ(mesh.grid, 32);
  for (const MeshVertex& v : mesh.vertices) {
    if (v.row != 0 || (v.column != 0 && v.column != 32)) continue;
    EXPECT_EQ(v.height, v.column == 0 ? 0 : 32768);
  }
}

TEST(ReliefMesh, HasNoCracksAndAllItsTrianglesLieTheSameWayUp) {
  const ReliefMesh mesh = make_relief_mesh(hills(65, 4), 0.004F);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  double area = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const Corner a = corner(mesh, mesh.indices[t]), b = corner(mesh, mesh.indices[t + 1]),
                 c = corner(mesh, mesh.indices[t + 2]);
    const double twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    EXPECT_LT(twice, 0) << "counter-clockwise seen from above, rows downwards";
    area -= twice / 2;
    for (int k = 0; k < 3; ++k)
      ++sides[{mesh.indices[t + static_cast<std::size_t>(k)],
               mesh.indices[t + static_cast<std::size_t>((k + 1) % 3)]}];
  }
  EXPECT_EQ(area, 64 * 64);
  for (const auto& [side, times] : sides) {
    EXPECT_EQ(times, 1);
    if (sides.contains({side.second, side.first})) continue;
    const Corner a = corner(mesh, side.first), b = corner(mesh, side.second);
    EXPECT_TRUE((a.x == b.x && (a.x == 0 || a.x == 64)) || (a.y == b.y && (a.y == 0 || a.y == 64)))
        << "a side that no other triangle has lies on the rim";
  }
}

TEST(ReliefMesh, AFlatReliefNeedsFewTrianglesAndAFinerToleranceMore) {
  const Relief flat{129, std::vector<float>(129 * 129, 0.5F)};
  const std::size_t of_flat = make_relief_mesh(flat, 0.001F).indices.size();
  const std::size_t coarse = make_relief_mesh(hills(129, 5), 0.05F).indices.size();
  const std::size_t fine = make_relief_mesh(hills(129, 5), 0.002F).indices.size();
  EXPECT_LT(of_flat, coarse);
  EXPECT_LT(2 * coarse, fine);
  EXPECT_LT(fine, 3U * 2 * 128 * 128) << "a flat part is not cut up";
}

TEST(ReliefMesh, EachTriangleIsInOneTileWithinItsBounds) {
  const ReliefMesh mesh = make_relief_mesh(hills(129, 6), 0.01F);
  std::vector<int> times(mesh.indices.size(), 0);
  for (const MeshTile& tile : mesh.tiles) {
    for (std::uint32_t i = tile.first_index; i < tile.first_index + tile.index_count; ++i) {
      ++times[i];
      const MeshVertex& v = mesh.vertices[mesh.indices[i]];
      EXPECT_GE(v.column, tile.bounds[0]);
      EXPECT_GE(v.row, tile.bounds[1]);
      EXPECT_LE(v.column, tile.bounds[2]);
      EXPECT_LE(v.row, tile.bounds[3]);
    }
  }
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
  // Sixteen tiles a side, each of them no larger than its share; the bounds are the narrowest.
  EXPECT_EQ(mesh.tiles.size(), 256U);
  std::map<std::pair<int, int>, int> places;
  for (const MeshTile& tile : mesh.tiles) {
    EXPECT_EQ(tile.bounds[2] - tile.bounds[0], 8);
    EXPECT_EQ(tile.bounds[3] - tile.bounds[1], 8);
    ++places[{tile.bounds[0] / 8, tile.bounds[1] / 8}];
  }
  EXPECT_EQ(places.size(), 256U);
}

}  // namespace
}  // namespace nazori::view
