// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/functions/plot.h"
#include "region_tracer.h"

namespace nazori::functions {

/// A region in r and theta, r < 1 + cos(theta), expressed in x and y; any other statement is unchanged. r is
/// not negative, and theta is the angle from 0 to 2 pi, or from -pi to pi where the range given begins below
/// zero.
[[nodiscard]] Statement in_the_plane(const Statement& s);

/// The conditions, in x and y, for the angle to lie in the range given with the region.
[[nodiscard]] std::vector<Condition> angle_bounds(const Statement& s);

}  // namespace nazori::functions
