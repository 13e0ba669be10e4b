// SPDX-License-Identifier: Apache-2.0
// The outline of a stroke: the line at distance 0 in the field of its distances.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "nazori/calligraphy/brush_stroke.h"
#include "nazori/geometry/needed_points.h"
#include "nazori/geometry/polyline.h"
#include "stroke_field.h"

namespace nazori::calligraphy {
namespace {

using Line = geometry::Polyline<geometry::PaperFrame>;

constexpr double kStep_m = 0.0001;
constexpr double kTolerance_m = 0.00001;

/// Each half apart: the ends of a loop are one point.
Line simplified(const Line& loop) {
  if (loop.size() < 4) return loop;
  const std::size_t middle = loop.size() / 2;
  const std::span<const Line::value_type> all(loop);
  Line out;
  for (const std::size_t i : geometry::needed_points(all.first(middle + 1), kTolerance_m))
    out.push_back(loop[i]);
  out.pop_back();  // the second half begins with it
  for (const std::size_t i : geometry::needed_points(all.subspan(middle), kTolerance_m))
    out.push_back(loop[middle + i]);
  return out;
}

/// The edges of the lattice that the outline crosses, each with the next one along it.
class Crossings {
 public:
  explicit Crossings(const StrokeField& field)
      : field_(field),
        next_(2 * static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows), kNone) {
    for (int row = 0; row + 1 < field.rows; ++row)
      for (int column = 0; column + 1 < field.columns; ++column) link(column, row);
  }

  std::vector<Line> loops() {
    std::vector<Line> all;
    for (std::size_t begin = 0; begin < next_.size(); ++begin) {
      Line loop;
      for (std::size_t at = begin; next_[at] != kNone; at = std::exchange(next_[at], kNone))
        loop.push_back(point_on(at));
      if (loop.size() >= 3) all.push_back(simplified(loop));
    }
    return all;
  }

 private:
  static constexpr auto kNone = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t edge(int column, int row, bool upwards) const {
    return 2 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(field_.columns) +
                static_cast<std::size_t>(column)) +
           (upwards ? 1 : 0);
  }
  [[nodiscard]] geometry::PaperPoint point_on(std::size_t edge) const {
    const auto columns = static_cast<std::size_t>(field_.columns);
    const int column = static_cast<int>(edge / 2 % columns), row = static_cast<int>(edge / 2 / columns);
    const bool upwards = edge % 2 == 1;
    const int to_column = upwards ? column : column + 1, to_row = upwards ? row + 1 : row;
    const double a = static_cast<double>(field_.at(column, row));
    const double b = static_cast<double>(field_.at(to_column, to_row));
    const auto from = field_.place(column, row);
    return from + (field_.place(to_column, to_row) - from) * (a / (a - b));
  }
  /// The parts of the outline in one square of the lattice, with the ink to their left.
  void link(int column, int row) {
    const std::array corners{field_.at(column, row), field_.at(column + 1, row),
                             field_.at(column + 1, row + 1), field_.at(column, row + 1)};
    const std::array edges{edge(column, row, false), edge(column + 1, row, true),
                           edge(column, row + 1, false), edge(column, row, true)};
    const auto inside = [&corners](std::size_t i) { return corners[i % 4] < 0; };
    // Each way out of the ink, counterclockwise around the square, begins a part of the outline.
    for (std::size_t i = 0; i < 4; ++i) {
      if (!inside(i) || inside(i + 1)) continue;
      std::size_t end = (i + 3) % 4;  // back along the square to where the ink was entered
      const float middle = corners[0] + corners[1] + corners[2] + corners[3];
      const bool is_saddle = inside(i + 2) && !inside(i + 3);
      if (is_saddle && middle < 0)
        end = (i + 1) % 4;
      else
        while (inside(end)) end = (end + 3) % 4;
      next_[edges[i]] = edges[end];
    }
  }

  const StrokeField& field_;
  std::vector<std::size_t> next_;
};

}  // namespace

std::vector<Line> outline_of(const ModelStroke& stroke) {
  if (stroke.points.empty()) return {};
  const StrokeField field = field_of(stroke, kStep_m);
  return Crossings(field).loops();
}

}  // namespace nazori::calligraphy
