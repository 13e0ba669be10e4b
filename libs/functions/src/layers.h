// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "nazori/functions/plate.h"

namespace nazori::functions {

/// The height of the plateau if ridges and a rim must rise above it.
inline constexpr double kPlateauUnderLayers = 0.9;
/// Ridges stay this many half widths away from the edge of a groove.
inline constexpr double kClearance = 1.5;

/// Distance of each of n sample centres to the nearest tick, in plate units.
/// @param downwards  the first sample has the largest value, as in rows.
[[nodiscard]] std::vector<double> tick_distances(double low, double high, int n, bool downwards);

/// Raises axes, ticks, grid and rim on a carved plate, nowhere nearer to a curve than the clearance.
/// @param distance  of a sample to the nearest curve, infinite where none is near.
void add_layers(Plate& plate, const Window& window, const PlateSettings& settings,
                const std::function<float(std::size_t)>& distance);

}  // namespace nazori::functions
