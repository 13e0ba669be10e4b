// SPDX-License-Identifier: Apache-2.0
#include "board_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "projection.h"
#include "surface_picture.h"

namespace nazori::view {
namespace {

constexpr double kCornerFraction = 0.036;
constexpr double kEdgeFraction = 0.012;  ///< radius of the rounded edge
constexpr int kCornerSteps = 8;
constexpr int kEdgeSteps = 4;
/// The rim reaches this far under the carved square and is slightly lower, so that no gap is visible between
/// them.
constexpr double kOverlapFraction = 0.002;
constexpr double kHairFraction = 0.0002;
constexpr float kGrooveEndLight = 0.6F;

struct OutlinePoint {
  glm::dvec2 place;
  glm::dvec2 normal;
};

std::vector<OutlinePoint> rounded_square(double half, double radius) {
  std::vector<OutlinePoint> outline;
  constexpr std::array<glm::dvec2, 4> kCorners{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  for (std::size_t corner = 0; corner < kCorners.size(); ++corner) {
    for (int k = 0; k <= kCornerSteps; ++k) {
      const double angle =
          std::numbers::pi / 2 * (static_cast<double>(corner) + static_cast<double>(k) / kCornerSteps);
      const glm::dvec2 normal(std::cos(angle), std::sin(angle));
      outline.push_back({kCorners[corner] * (half - radius) + normal * radius, normal});
    }
  }
  return outline;
}

/// Joins the last two rings of `count` vertices into a closed band.
void close_band(BoardMesh& mesh, std::uint32_t count) {
  const auto outer = static_cast<std::uint32_t>(mesh.vertices.size()) - count;
  const std::uint32_t inner = outer - count;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.indices.insert(mesh.indices.end(),
                        {inner + i, outer + i, outer + next, inner + i, outer + next, inner + next});
  }
}

/// One side of the carved square: vertical ends of the grooves that reach it.
void append_groove_ends(BoardMesh& mesh, std::vector<MeshVertex> side, bool along_columns, bool flipped,
                        int grid, const geometry::TabletShape& shape) {
  std::sort(side.begin(), side.end(), [&](const MeshVertex& a, const MeshVertex& b) {
    return along_columns ? a.column < b.column : a.row < b.row;
  });
  const auto place = [&](const MeshVertex& v, bool at_lip) {
    const double x = (static_cast<double>(v.column) / grid - 0.5) * shape.width_m;
    const double y = (0.5 - static_cast<double>(v.row) / grid) * shape.width_m;
    const double z = at_lip ? 0 : (v.height / 65535.0 - 1) * shape.depth_m;
    return glm::vec4(x, y, z, kGrooveEndLight);
  };
  for (std::size_t i = 0; i + 1 < side.size(); ++i) {
    if (side[i].height == 65535 && side[i + 1].height == 65535) continue;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {place(side[i], false), place(side[i + 1], false),
                                               place(side[i + 1], true), place(side[i], true)});
    if (flipped)
      mesh.indices.insert(mesh.indices.end(), {first, first + 2, first + 1, first, first + 3, first + 2});
    else
      mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }
}

}  // namespace

double board_thickness_m(const geometry::TabletShape& shape) {
  return shape.depth_m + kBaseFraction * shape.width_m;
}

double board_corner_m(const geometry::TabletShape& shape) { return kCornerFraction * shape.width_m; }

BoardMesh make_board_mesh(const ReliefMesh& relief, const geometry::TabletShape& shape, Hand hand) {
  BoardMesh mesh;
  const double half = shape.width_m * (0.5 + kRimFraction);
  const double edge = kEdgeFraction * shape.width_m;
  const double inner = shape.width_m * (0.5 - kOverlapFraction);
  const auto outline = rounded_square(half, board_corner_m(shape));
  const auto count = static_cast<std::uint32_t>(outline.size());
  const auto ring = [&](double inset, double z, double upright) {
    for (const OutlinePoint& point : outline) {
      const glm::dvec2 place = point.place - point.normal * inset;
      const double outward = std::sqrt(std::max(0.0, 1 - upright * upright));
      const glm::vec3 normal(point.normal * outward, upright);
      mesh.vertices.emplace_back(place.x, place.y, z, open_light(normal, hand));
    }
  };
  for (const OutlinePoint& point : outline) {
    const glm::dvec2 place = glm::clamp(point.place, -inner, inner);
    mesh.vertices.emplace_back(place.x, place.y, -kHairFraction * shape.width_m, 1.0F);
  }
  ring(edge, 0, 1);
  close_band(mesh, count);
  for (int k = 1; k <= kEdgeSteps; ++k) {
    const double angle = std::numbers::pi / 2 * k / kEdgeSteps;
    ring(edge * (1 - std::sin(angle)), -edge * (1 - std::cos(angle)), std::cos(angle));
    close_band(mesh, count);
  }
  ring(0, -board_thickness_m(shape), 0);
  close_band(mesh, count);

  const int grid = relief.grid;
  const auto side = [&](auto&& lies_on) {
    std::vector<MeshVertex> vertices;
    std::copy_if(relief.vertices.begin(), relief.vertices.end(), std::back_inserter(vertices), lies_on);
    return vertices;
  };
  append_groove_ends(mesh, side([](const MeshVertex& v) { return v.row == 0; }), true, false, grid, shape);
  append_groove_ends(mesh, side([=](const MeshVertex& v) { return v.row == grid; }), true, true, grid, shape);
  append_groove_ends(mesh, side([](const MeshVertex& v) { return v.column == 0; }), false, true, grid, shape);
  append_groove_ends(mesh, side([=](const MeshVertex& v) { return v.column == grid; }), false, false, grid,
                     shape);
  return mesh;
}

}  // namespace nazori::view
