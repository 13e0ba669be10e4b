// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "triangulation.h"

namespace nazori::model {
namespace {

constexpr int kRingCorners = 24;
constexpr double kOuterRing_mm = 0.6;
constexpr std::size_t kFewestTriangles = 1000;

/// The corners of a hole on the grid, counter-clockwise.
std::vector<GridSample> ring_of(const Plate& plate, const Hole& hole, double wider_mm) {
  std::vector<GridSample> ring;
  for (int i = 0; i < kRingCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRingCorners;
    const double radius = hole.radius_mm + wider_mm;
    ring.push_back(
        {static_cast<int>(std::lround((hole.centre.x + radius * std::cos(angle)) / plate.step_mm())),
         static_cast<int>(std::lround((hole.centre.y + radius * std::sin(angle)) / plate.step_mm()))});
  }
  return ring;
}

bool is_inside(const std::vector<GridSample>& ring, double column, double row) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridSample a = ring[i];
    const GridSample b = ring[(i + 1) % ring.size()];
    if ((a.row > row) != (b.row > row) &&
        column < a.column + (row - a.row) * (b.column - a.column) / static_cast<double>(b.row - a.row))
      inside = !inside;
  }
  return inside;
}

/// The samples on the edge of the grid, counter-clockwise from (0, 0).
std::vector<GridSample> rim_of(const Triangulation& face, int columns, int rows) {
  std::vector<GridSample> rim;
  const auto place = [&](GridSample s) {
    if (s.row == 0) return s.column;
    if (s.column == columns - 1) return columns + s.row;
    if (s.row == rows - 1) return columns + rows + (columns - 1 - s.column);
    return 2 * columns + rows + (rows - 1 - s.row);
  };
  for (const GridSample& s : face.samples()) {
    if (s.row == 0 || s.column == 0 || s.row == rows - 1 || s.column == columns - 1) rim.push_back(s);
  }
  std::sort(rim.begin(), rim.end(), [&](GridSample a, GridSample b) { return place(a) < place(b); });
  return rim;
}

class Builder {
 public:
  explicit Builder(const Plate& plate) : plate_(plate) {
    for (const Hole& hole : plate.holes()) rings_.push_back(ring_of(plate, hole, 0));
  }

  void add_upper(const Triangulation& face) { upper_ = add_face(face, true); }
  void add_lower(const Triangulation& face) { lower_ = add_face(face, false); }

  /// @param loop  counter-clockwise seen from above. @param outwards  the wall is seen from outside the loop.
  void add_wall(const std::vector<GridSample>& loop, bool outwards) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const GridSample from = outwards ? loop[i] : loop[(i + 1) % loop.size()];
      const GridSample to = outwards ? loop[(i + 1) % loop.size()] : loop[i];
      const std::uint32_t b0 = lower_.at(key(from));
      const std::uint32_t b1 = lower_.at(key(to));
      const std::uint32_t t0 = upper_.at(key(from));
      const std::uint32_t t1 = upper_.at(key(to));
      mesh_.triangles.push_back({b0, b1, t1});
      mesh_.triangles.push_back({b0, t1, t0});
    }
  }

  [[nodiscard]] Mesh take() { return std::move(mesh_); }
  [[nodiscard]] const std::vector<std::vector<GridSample>>& rings() const { return rings_; }

 private:
  using Places = std::unordered_map<int, std::uint32_t>;

  [[nodiscard]] int key(GridSample s) const { return s.row * plate_.columns() + s.column; }

  Places add_face(const Triangulation& face, bool upper) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    Places places;
    for (const GridSample& s : face.samples()) {
      places.emplace(key(s), static_cast<std::uint32_t>(mesh_.vertices.size()));
      mesh_.vertices.push_back({static_cast<float>(s.column * plate_.step_mm()),
                                static_cast<float>(s.row * plate_.step_mm()),
                                upper ? plate_.at(s.column, s.row) : 0.0F});
    }
    for (const auto& triangle : face.triangles()) {
      if (is_in_hole(face, triangle)) continue;
      const auto at = [&](std::size_t i) { return first + static_cast<std::uint32_t>(triangle.corner[i]); };
      if (upper) {
        mesh_.triangles.push_back({at(0), at(1), at(2)});
      } else {
        mesh_.triangles.push_back({at(0), at(2), at(1)});
      }
    }
    return places;
  }

  [[nodiscard]] bool is_in_hole(const Triangulation& face, const Triangulation::Triangle& triangle) const {
    if (rings_.empty()) return false;
    double column = 0;
    double row = 0;
    for (const std::int32_t corner : triangle.corner) {
      const GridSample s = face.samples()[static_cast<std::size_t>(corner)];
      column += s.column / 3.0;
      row += s.row / 3.0;
    }
    return std::any_of(rings_.begin(), rings_.end(),
                       [&](const auto& ring) { return is_inside(ring, column, row); });
  }

  const Plate& plate_;
  Mesh mesh_;
  std::vector<std::vector<GridSample>> rings_;
  Places upper_;
  Places lower_;
};

}  // namespace

base::Result<PlateMesh> mesh_of(const Plate& plate, const MeshSettings& settings) {
  if (!(settings.tolerance_mm > 0) || settings.most_triangles < kFewestTriangles) {
    return base::fail(base::Errc::bad_argument, "the tolerance or the number of triangles is out of range",
                      "mesh", fmt::format("give more than 0 mm, and {} triangles or more", kFewestTriangles));
  }
  Builder builder(plate);
  Triangulation upper(plate.columns(), plate.rows(), plate.heights());
  Triangulation lower(plate.columns(), plate.rows(), {});
  for (std::size_t i = 0; i < builder.rings().size(); ++i) {
    for (const GridSample& s : builder.rings()[i]) {
      upper.insert(s);
      lower.insert(s);
    }
    // A second ring keeps the samples that follow away from the edges of the first.
    for (const GridSample& s : ring_of(plate, plate.holes()[i], kOuterRing_mm)) upper.insert(s);
  }
  // Each sample of the rim costs two triangles of the upper face, the lower face and the wall together; the
  // rim rarely has more than a tenth of all.
  PlateMesh result;
  std::size_t most = settings.most_triangles * 3 / 4;
  result.error_mm = upper.refine(settings.tolerance_mm, most);
  const std::vector<GridSample> rim = rim_of(upper, plate.columns(), plate.rows());
  const std::size_t others = 4 * rim.size() + std::size_t{6} * kRingCorners * builder.rings().size();
  if (settings.most_triangles > others + most) {
    most = settings.most_triangles - others;
    // A finer face may have more samples on its rim, two triangles of the lower face and the wall for each.
    result.error_mm = upper.refine(settings.tolerance_mm, most - most / 50);
  }
  const std::vector<GridSample> whole_rim = rim_of(upper, plate.columns(), plate.rows());
  for (const GridSample& s : whole_rim) lower.insert(s);
  builder.add_upper(upper);
  builder.add_lower(lower);
  builder.add_wall(whole_rim, true);
  for (const auto& ring : builder.rings()) builder.add_wall(ring, false);
  result.mesh = builder.take();
  assert(open_edges(result.mesh) == 0);
  return result;
}

std::size_t open_edges(const Mesh& mesh) {
  std::unordered_map<std::uint64_t, int> edges;
  edges.reserve(mesh.triangles.size() * 2);
  std::size_t bad = 0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t from = t[i];
      const std::uint64_t to = t[(i + 1) % 3];
      if (++edges[from << 32U | to] > 1) ++bad;
    }
  }
  for (const auto& [edge, count] : edges) {
    if (!edges.contains(edge << 32U | edge >> 32U)) ++bad;
  }
  return bad;
}

double volume_mm3(const Mesh& mesh) {
  double six_times = 0;
  for (const auto& t : mesh.triangles) {
    const auto& a = mesh.vertices[t[0]];
    const auto& b = mesh.vertices[t[1]];
    const auto& c = mesh.vertices[t[2]];
    const auto product = [](const auto& p, const auto& q, std::size_t i, std::size_t j) {
      return static_cast<double>(p[i]) * q[j] - static_cast<double>(p[j]) * q[i];
    };
    six_times += a[0] * product(b, c, 1, 2) + a[1] * product(b, c, 2, 0) + a[2] * product(b, c, 0, 1);
  }
  return six_times / 6;
}

}  // namespace nazori::model
