// SPDX-License-Identifier: Apache-2.0
#include "../src/board_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <tuple>

#include "../src/projection.h"
#include "../src/surface_picture.h"

namespace nazori::view {
namespace {

constexpr double kWidth = 0.2;
constexpr double kDepth = 0.015;
const geometry::TabletShape kShape{kWidth, kDepth};
constexpr double kHalf = kWidth * (0.5 + 0.0625);  // the carved square and its rim
constexpr double kCorner = 0.036 * kWidth;
constexpr double kEdge = 0.012 * kWidth;

ReliefMesh flat() { return make_relief_mesh({33, std::vector<float>(33 * 33, 1.0F)}, 0.001F); }

BoardMesh board(const ReliefMesh& relief = flat()) { return make_board_mesh(relief, kShape, Hand::right); }

glm::dvec3 place(const glm::vec4& v) { return {v.x, v.y, v.z}; }

/// How far a point lies outside a rounded square, seen from above; negative within.
double outside(double x, double y, double half, double radius) {
  const double dx = std::max(std::abs(x) - (half - radius), 0.0);
  const double dy = std::max(std::abs(y) - (half - radius), 0.0);
  const double within = std::max(std::abs(x), std::abs(y)) - (half - radius);
  return (dx > 0 || dy > 0 ? std::hypot(dx, dy) : within) - radius;
}

TEST(BoardMesh, IsAsThickAsItsDeepestGrooveAndAHundredthThreeTimes) {
  EXPECT_NEAR(board_thickness_m(kShape), kDepth + 0.03 * kWidth, 1e-12);
  EXPECT_NEAR(board_corner_m(kShape), kCorner, 1e-12);
}

TEST(BoardMesh, ReachesFromUnderTheCarvedSquareToItsRoundedRimAndDown) {
  const BoardMesh mesh = board();
  double lowest = 0;
  double right = 0, left = 0, back = 0, front = 0;
  bool at_inner = false;
  for (const glm::vec4& v : mesh.vertices) {
    lowest = std::min(lowest, static_cast<double>(v.z));
    right = std::max(right, static_cast<double>(v.x));
    left = std::min(left, static_cast<double>(v.x));
    back = std::max(back, static_cast<double>(v.y));
    front = std::min(front, static_cast<double>(v.y));
    EXPECT_LE(v.z, 0);
    EXPECT_LT(outside(v.x, v.y, kHalf, kCorner), 1e-6);
    if (v.z < -kEdge - 1e-6 || std::abs(v.z + kEdge) < 1e-6) {
      EXPECT_NEAR(outside(v.x, v.y, kHalf, kCorner), 0, 1e-6) << "the sides are upright";
    }
    const double within = std::max(std::abs(v.x), std::abs(v.y));
    if (within < kWidth / 2) {
      at_inner = true;
      EXPECT_NEAR(within, kWidth * 0.498, 1e-6);
      EXPECT_NEAR(v.z, -kWidth * 0.0002, 1e-7) << "a hair under the square";
    }
  }
  EXPECT_TRUE(at_inner);
  EXPECT_NEAR(lowest, -kDepth - 0.03 * kWidth, 1e-6);
  for (const double reach : {right, -left, back, -front}) EXPECT_NEAR(reach, kHalf, 1e-6);
}

TEST(BoardMesh, TheEdgeIsAQuarterOfACircleAndItsLightThatOfItsDirection) {
  const BoardMesh mesh = board();
  int on_edge = 0;
  for (const glm::vec4& v : mesh.vertices) {
    if (v.z < -kEdge + 1e-6 || v.z > -1e-6) continue;                   // sides and top
    if (std::max(std::abs(v.x), std::abs(v.y)) < kWidth / 2) continue;  // under the square
    const double inset = -outside(v.x, v.y, kHalf, kCorner);
    EXPECT_NEAR(std::hypot(kEdge - inset, v.z + kEdge), kEdge, 1e-6);
    // The normal leans outward as much as the place lies beyond the middle of the circle.
    const double upright = (v.z + kEdge) / kEdge;
    const double outward = (kEdge - inset) / kEdge;
    const double cx = std::clamp(static_cast<double>(v.x), -(kHalf - kCorner), kHalf - kCorner);
    const double cy = std::clamp(static_cast<double>(v.y), -(kHalf - kCorner), kHalf - kCorner);
    const glm::dvec2 way = glm::normalize(glm::dvec2(v.x - cx, v.y - cy));
    EXPECT_NEAR(v.w, open_light(glm::vec3(way.x * outward, way.y * outward, upright), Hand::right), 1e-4);
    ++on_edge;
  }
  EXPECT_GT(on_edge, 50);
  for (const glm::vec4& v : mesh.vertices) {
    if (v.z == 0) {
      EXPECT_NEAR(v.w, 1, 1e-6) << "the top is as light as the plateau";
    }
  }
}

TEST(BoardMesh, IsClosedAndAllOfItFacesOutward) {
  const BoardMesh mesh = board();
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t i[3] = {mesh.indices[t], mesh.indices[t + 1], mesh.indices[t + 2]};
    const glm::dvec3 a = place(mesh.vertices[i[0]]), b = place(mesh.vertices[i[1]]),
                     c = place(mesh.vertices[i[2]]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const glm::dvec3 middle = (a + b + c) / 3.0;
    // Away from a point deep inside the board. Where corners meet the square triangles may have no area.
    if (glm::length(normal) > 1e-12) {
      EXPECT_GT(glm::dot(normal, middle - glm::dvec3(0, 0, -kDepth)), 0) << t / 3;
    }
    for (int k = 0; k < 3; ++k) ++sides[{i[k], i[(k + 1) % 3]}];
  }
  std::size_t open = 0;
  for (const auto& [side, times] : sides) {
    EXPECT_EQ(times, 1);
    open += sides.contains({side.second, side.first}) ? 0 : 1;
  }
  // Only the ring under the square and the one on the table are open, with as many points each.
  std::size_t lowest = 0;
  for (const glm::vec4& v : mesh.vertices) lowest += v.z < -kDepth - 0.03 * kWidth + 1e-6 ? 1 : 0;
  EXPECT_EQ(open, 2 * lowest);
}

/// A relief with one groove that reaches one border, and its depth there.
Relief notched(int side) {
  Relief relief{33, std::vector<float>(33 * 33, 1.0F)};
  for (int k = 10; k <= 14; ++k)
    for (int along = 0; along <= 3; ++along) {
      const int column = side == 0 ? along : side == 1 ? 32 - along : k;
      const int row = side == 2 ? along : side == 3 ? 32 - along : k;
      relief.heights[static_cast<std::size_t>(row) * 33 + static_cast<std::size_t>(column)] = 0.25F;
    }
  return relief;
}

TEST(BoardMesh, GroovesThatRunOutOfTheSquareAreClosedByWallsThatFaceThem) {
  for (int side = 0; side < 4; ++side) {
    const BoardMesh plain = board();
    const BoardMesh mesh = board(make_relief_mesh(notched(side), 0.0005F));
    ASSERT_GT(mesh.indices.size(), plain.indices.size()) << side;
    double area = 0;
    double low = 1, high = -1;
    for (std::size_t t = plain.indices.size(); t < mesh.indices.size(); t += 3) {
      const glm::vec4& first = mesh.vertices[mesh.indices[t]];
      const glm::dvec3 a = place(first), b = place(mesh.vertices[mesh.indices[t + 1]]),
                       c = place(mesh.vertices[mesh.indices[t + 2]]);
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      area += glm::length(normal) / 2;
      for (const glm::dvec3& p : {a, b, c}) {
        const double border = side == 0 ? -p.x : side == 1 ? p.x : side == 2 ? p.y : -p.y;
        EXPECT_NEAR(border, kWidth / 2, 1e-6);
        const double along = side < 2 ? (0.5 - p.y / kWidth) * 32 : (p.x / kWidth + 0.5) * 32;
        low = std::min(low, along / 32);
        high = std::max(high, along / 32);
        EXPECT_GT(p.z, -0.75 * kDepth - 1e-6);
        EXPECT_LE(p.z, 0);
      }
      if (glm::length(normal) < 1e-12) continue;
      // The wall is seen from inside the square.
      const glm::dvec3 inward(side == 0 ? 1 : side == 1 ? -1 : 0, side == 2 ? -1 : side == 3 ? 1 : 0, 0);
      EXPECT_GT(glm::dot(normal, inward), 0) << side;
    }
    // Four steps of full depth and the two slopes beside them.
    EXPECT_NEAR(area, 0.75 * kDepth * 5 * kWidth / 32, 1e-8) << side;
    EXPECT_NEAR(low, 9.0 / 32, 1e-6);
    EXPECT_NEAR(high, 15.0 / 32, 1e-6);
  }
}

TEST(BoardMesh, TheLightOnTheSidesChangesWithTheHand) {
  const BoardMesh right = make_board_mesh(flat(), kShape, Hand::right);
  const BoardMesh left = make_board_mesh(flat(), kShape, Hand::left);
  // One has on the left what the other has on the right.
  std::map<std::tuple<long, long, long>, float> light;
  const auto key = [](double x, double y, double z) {
    return std::tuple(std::lround(x * 1e7), std::lround(y * 1e7), std::lround(z * 1e7));
  };
  for (const glm::vec4& v : left.vertices) light[key(v.x, v.y, v.z)] = v.w;
  int differ = 0;
  for (std::size_t i = 0; i < right.vertices.size(); ++i) {
    const glm::vec4& v = right.vertices[i];
    differ += std::abs(v.w - left.vertices[i].w) > 0.1F ? 1 : 0;
    const auto mirrored = light.find(key(-v.x, v.y, v.z));
    if (mirrored != light.end()) {
      EXPECT_NEAR(mirrored->second, v.w, 1e-5);
    }
  }
  EXPECT_GT(differ, 20);
}

}  // namespace
}  // namespace nazori::view
