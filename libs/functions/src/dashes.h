// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "distance_grid.h"

namespace nazori::functions {

/// Adds a branch in strokes and gaps. @param lengths  of dash and gap alternately, in plate units.
void add_dashes(DistanceGrid& grid, const Branch& branch, std::span<const double> lengths);

/// Per sample, row 0 at the top: 1 + the statement of the region its middle lies in, 0 outside; empty where
/// there is no region.
[[nodiscard]] std::vector<std::uint8_t> regions_of(const Tracing& tracing, int size);

}  // namespace nazori::functions
