// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "distance_map.h"

namespace nazori::author {

/// Pixels whose discs touch the outline on two sides that lie far apart, as seen from the pixel: they are on
/// the middle of a line, whatever remains of the ink. Values 0 or 1.
/// @source W. H. Hesselink, J. B. T. M. Roerdink, "Euclidean skeletons of digital image and volume data in
/// linear time by the integer medial axis transform", IEEE PAMI 30, 2008; the limit is an angle here, as in
/// theta-SMA of M. Foskey et al. 2003.
[[nodiscard]] std::vector<std::uint8_t> middle_of(const DistanceMap& map);

/// Takes pixels off the outline as long as the ink stays connected and holes stay holes, the lowest first;
/// what remains are lines one pixel wide.
/// @param ink  side x side, 0 or 1. @param height  of each pixel: the lines lie on its ridges, >= 0.
/// @param kept  pixels that must remain.
/// @param keep_ends  also the last pixels of lines remain as they are met, so lines are not shortened.
/// @cost nearly in proportion to the number of pixels.
[[nodiscard]] std::vector<std::uint8_t> thinned(std::vector<std::uint8_t> ink, int side,
                                                const std::vector<float>& height,
                                                const std::vector<std::uint8_t>& kept,
                                                bool keep_ends = false);

}  // namespace nazori::author
