// SPDX-License-Identifier: Apache-2.0
#include "curve_location.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "nazori/functions/curve_kinds.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {

bool is_in_window(PlatePoint p) {
  constexpr double kHair = 1e-9;
  return p.u >= -kHair && p.u <= 1 + kHair && p.v >= -kHair && p.v <= 1 + kHair;
}

CurvePlace last_in_window(const Tracing& tracing, const CurvePlace& from, double length) {
  double inside = 0;
  double outside = length;
  for (int i = 0; i < 50; ++i) {
    const double middle = (inside + outside) / 2;
    (is_in_window(step_along(tracing, from, middle).at) ? inside : outside) = middle;
  }
  return step_along(tracing, from, inside);
}

std::optional<std::pair<double, double>> part_in_window(PlatePoint p, PlatePoint q) {
  double first = 0;
  double last = 1;
  for (const auto& [from, to] : {std::pair{p.u, q.u}, std::pair{p.v, q.v}}) {
    if (from == to) {
      if (from < 0 || from > 1) return std::nullopt;
      continue;
    }
    const double at_0 = (0 - from) / (to - from);
    const double at_1 = (1 - from) / (to - from);
    first = std::max(first, std::min(at_0, at_1));
    last = std::min(last, std::max(at_0, at_1));
  }
  if (!(first <= last)) return std::nullopt;
  return std::pair{first, last};
}

double distance(PlatePoint a, PlatePoint b) { return std::hypot(a.u - b.u, a.v - b.v); }

double parameter_at(const Branch& branch, const CurvePlace& place) {
  const auto& p = branch.points[place.piece];
  const auto& q = branch.points[(place.piece + 1) % branch.points.size()];
  const double length = std::hypot(q.u - p.u, q.v - p.v);
  const double share = length > 0 ? std::hypot(place.at.u - p.u, place.at.v - p.v) / length : 0;
  return p.parameter + (q.parameter - p.parameter) * std::clamp(share, 0.0, 1.0);
}

std::optional<CurvePosition> position_of(const Statement& s, double parameter) {
  const CurveKind& kind = curve_kind(s.kind);
  if (kind.course == nullptr || s.is_point) return std::nullopt;
  using Slope = Dual<double, 1>;
  const Course course = kind.course(s);
  const std::array<Expression, 2> outputs{course.x, course.y};
  const std::array<Variable, 1> inputs{kind.parameter};
  const Tape tape = Tape::compile(outputs, inputs);
  std::vector<Slope> registers(tape.size());
  tape.evaluate<Slope>(std::array{Slope(parameter, 0)}, registers);
  return CurvePosition{registers[tape.output(0)], registers[tape.output(1)]};
}

}  // namespace nazori::functions
