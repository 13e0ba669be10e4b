// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/stand.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace nazori::model {
namespace {

constexpr double kBase_mm = 5;     // between the lower end of the slot and the table
constexpr double kWall_mm = 5;     // in front of the slot and behind it
constexpr double kFront_mm = 10;   // of the foot before the slot
constexpr double kBeyond_mm = 10;  // of the foot behind the middle of the plate
constexpr double kGap_mm = 5;      // between the two feet on the bed

double twice_area(PlatePoint a, PlatePoint b, PlatePoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Triangles of a polygon without holes, counter-clockwise.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const PlateLine& outline) {
  std::vector<std::uint32_t> left(outline.size());
  for (std::uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (left.size() > 2) {
    std::size_t ear = left.size();
    for (std::size_t i = 0; i < left.size() && ear == left.size(); ++i) {
      const std::uint32_t a = left[(i + left.size() - 1) % left.size()];
      const std::uint32_t b = left[i];
      const std::uint32_t c = left[(i + 1) % left.size()];
      if (twice_area(outline[a], outline[b], outline[c]) <= 0) continue;
      const bool is_empty = std::none_of(left.begin(), left.end(), [&](std::uint32_t p) {
        return p != a && p != b && p != c && twice_area(outline[a], outline[b], outline[p]) >= 0 &&
               twice_area(outline[b], outline[c], outline[p]) >= 0 &&
               twice_area(outline[c], outline[a], outline[p]) >= 0;
      });
      if (is_empty) ear = i;
    }
    if (ear == left.size()) break;  // not a simple polygon
    triangles.push_back(
        {left[(ear + left.size() - 1) % left.size()], left[ear], left[(ear + 1) % left.size()]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

/// A solid with this outline from the bed up.
void add_solid(Mesh& mesh, const PlateLine& outline, PlatePoint shift, double height_mm) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (const double z : {0.0, height_mm})
    for (const PlatePoint p : outline)
      mesh.vertices.push_back(
          {static_cast<float>(p.x + shift.x), static_cast<float>(p.y + shift.y), static_cast<float>(z)});
  for (const auto& [a, b, c] : triangles_of(outline)) {
    mesh.triangles.push_back({first + c, first + b, first + a});
    mesh.triangles.push_back({first + count + a, first + count + b, first + count + c});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({first + i, first + next, first + count + next});
    mesh.triangles.push_back({first + i, first + count + next, first + count + i});
  }
}

}  // namespace

base::Result<PlateLine> stand_outline(const StandSettings& s) {
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!within(s.plate_height_mm, 20, 600) || !within(s.plate_thickness_mm, 0.4, 100) ||
      !within(s.clearance_mm, 0, 2) || !within(s.lean_deg, 5, 45) || !within(s.width_mm, 3, 50)) {
    return base::fail(base::Errc::bad_argument, "no stand fits this plate", "stand",
                      fmt::format("give a plate of 20 to 600 mm and a lean of 5 to 45 degrees"));
  }
  const double lean = s.lean_deg * std::numbers::pi / 180;
  const PlatePoint up{std::sin(lean), std::cos(lean)};     // along the plate
  const PlatePoint back{std::cos(lean), -std::sin(lean)};  // through it
  const double slot = s.plate_thickness_mm + s.clearance_mm;
  const double depth = std::clamp(0.15 * s.plate_height_mm, 8.0, 25.0);
  // The slot's lower edge sinks towards the back, where it must leave the base.
  const PlatePoint front{kFront_mm, kBase_mm + slot * std::sin(lean)};
  const PlatePoint rear = front + back * slot;
  const double middle = front.x + up.x * s.plate_height_mm / 2 + back.x * slot;
  const double length = std::max(middle, rear.x + up.x * depth + kWall_mm) + kBeyond_mm;
  const PlatePoint rear_top = rear + up * depth * 1.5;
  return PlateLine{{0, 0},
                   {length, 0},
                   {length, kBase_mm},
                   {rear_top.x + kWall_mm, rear_top.y},
                   rear_top,
                   rear,
                   front,
                   front + up * depth,
                   {front.x + up.x * depth - kWall_mm, front.y + up.y * depth},
                   {0, kBase_mm}};
}

base::Result<Mesh> stand_mesh(const StandSettings& settings) {
  const auto outline = stand_outline(settings);
  if (!outline) return tl::unexpected(outline.error());
  double highest = 0;
  for (const PlatePoint p : *outline) highest = std::max(highest, p.y);
  Mesh mesh;
  add_solid(mesh, *outline, {0, 0}, settings.width_mm);
  add_solid(mesh, *outline, {0, highest + kGap_mm}, settings.width_mm);
  return mesh;
}

}  // namespace nazori::model
