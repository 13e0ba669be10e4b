// SPDX-License-Identifier: Apache-2.0
#include "pen_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "nazori/geometry/needed_points.h"

namespace nazori::author {
namespace {

/// Line, half width and depth as one point in space.
struct GrooveVector {
  std::array<double, 4> v{};
  friend GrooveVector operator+(const GrooveVector& a, const GrooveVector& b) {
    return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
  }
  friend GrooveVector operator-(const GrooveVector& a, const GrooveVector& b) { return a + b * -1.0; }
  friend GrooveVector operator*(const GrooveVector& a, double s) {
    return {{a.v[0] * s, a.v[1] * s, a.v[2] * s, a.v[3] * s}};
  }
  friend double dot(const GrooveVector& a, const GrooveVector& b) {
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2] + a.v[3] * b.v[3];
  }
  friend double distance(const GrooveVector& a, const GrooveVector& b) {
    return std::sqrt(dot(a - b, a - b));
  }
};

}  // namespace

carving::Groove simplified(const carving::Groove& groove, double tolerance) {
  constexpr double kUnitsPerDepth = 10;
  std::vector<GrooveVector> points;
  points.reserve(groove.size());
  for (const carving::GroovePoint& p : groove)
    points.push_back({{p.at.x, p.at.y, p.half_width, p.depth * kUnitsPerDepth}});
  carving::Groove out;
  for (const std::size_t i : geometry::needed_points<GrooveVector>(points, tolerance))
    if (out.empty() || out.back().at != groove[i].at) out.push_back(groove[i]);
  return out;
}

double pressure_of(const geometry::WrittenPoint<geometry::GlyphFrame>& point) {
  const double pressure = point.pressure.value_or(1.0);
  return std::isfinite(pressure) ? std::clamp(pressure, 0.0, 1.0) : 1.0;
}

}  // namespace nazori::author
