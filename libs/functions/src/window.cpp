// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "nazori/functions/tracing.h"

namespace nazori::functions {

Window Window::zoomed(PlatePoint at, double times) const {
  const double cx = x(at.u);
  const double cy = y(at.v);
  return {cx - (cx - x0) / times, cx + (x1 - cx) / times, cy - (cy - y0) / times, cy + (y1 - cy) / times};
}

Window Window::moved(double du, double dv) const {
  const double dx = (x1 - x0) * du;
  const double dy = (y1 - y0) * dv;
  return {x0 + dx, x1 + dx, y0 + dy, y1 + dy};
}

base::Result<void> Window::check() const {
  const auto narrow = [](double a, double b) {
    return !std::isfinite(a) || !std::isfinite(b) || !(b > a) ||
           b - a < 1e-10 * std::max(std::abs(a), std::abs(b)) || b - a < 1e-290 || !std::isfinite(b - a);
  };
  if (narrow(x0, x1) || narrow(y0, y1)) {
    return base::fail(base::Errc::bad_argument, "the window is empty or too narrow to compute in", "window",
                      "give x0 < x1 and y0 < y1, at least 1e-10 of their size apart");
  }
  return {};
}

}  // namespace nazori::functions
