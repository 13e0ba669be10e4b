// SPDX-License-Identifier: Apache-2.0
#include "newton.h"

#include <array>
#include <cmath>
#include <vector>

#include "nazori/functions/tape.h"

namespace nazori::functions {

PlatePoint refined(const Expression& f, const Expression& g, PlatePoint start) {
  const Tape tape = Tape::compile(std::array{f, g}, std::array{Variable::x, Variable::y});
  using D = Dual<double, 2>;
  std::vector<D> registers(tape.size());
  PlatePoint p = start;
  for (int i = 0; i < 30; ++i) {
    tape.evaluate<D>(std::array{D(p.u, 0), D(p.v, 1)}, registers);
    const D& a = registers[tape.output(0)];
    const D& b = registers[tape.output(1)];
    const double det = a.slopes[0] * b.slopes[1] - a.slopes[1] * b.slopes[0];
    const double du = (a.value * b.slopes[1] - b.value * a.slopes[1]) / det;
    const double dv = (b.value * a.slopes[0] - a.value * b.slopes[0]) / det;
    if (!std::isfinite(du + dv)) return start;
    p.u -= du;
    p.v -= dv;
    if (std::hypot(du, dv) < 1e-15 * (1 + std::hypot(p.u, p.v))) break;
  }
  return std::hypot(p.u - start.u, p.v - start.v) < 0.05 * (1 + std::hypot(start.u, start.v)) ? p : start;
}

double same_place(ArcProbe& probe, double s, double t) {
  for (int k = 0; k < 30; ++k) {
    const auto a = probe.at(s);
    const auto b = probe.at(t);
    const double det = b.slope_x * a.slope_y - a.slope_x * b.slope_y;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double ds = (b.slope_x * dy - b.slope_y * dx) / det;
    const double dt = (a.slope_x * dy - a.slope_y * dx) / det;
    if (!std::isfinite(ds + dt)) break;
    s += ds;
    t += dt;
    if (std::abs(ds) + std::abs(dt) < 1e-15 * (1 + std::abs(s) + std::abs(t))) break;
  }
  return s;
}

}  // namespace nazori::functions
