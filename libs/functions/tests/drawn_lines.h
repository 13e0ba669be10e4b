// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "nazori/functions/tracing.h"

namespace nazori::functions::test {

inline Branch line(std::vector<CurvePoint> points, int statement = 0, bool closed = false) {
  Branch made;
  made.statement = statement;
  made.closed = closed;
  made.points = std::move(points);
  return made;
}

/// In the window from 0 to 1 both ways.
inline Tracing tracing_of(std::vector<Branch> branches) {
  Tracing made;
  made.window = {0, 1, 0, 1};
  made.branches = std::move(branches);
  return made;
}

}  // namespace nazori::functions::test
