// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace nazori::view {

/// The preferred position of a number: next to its start, on a side. Pixels, y down.
struct NumberWish {
  glm::dvec2 start;
  glm::dvec2 side;  ///< unit vector, or zero where no side is better
};

/// Middles of discs that do not overlap: each beside its start where there is room, otherwise moved around
/// and away from it as little as needed. Changes smoothly while the starts move, so that numbers do not
/// jump when the tablet is turned.
/// @param radius  of a disc.  @param gap  between a start and its disc, and between discs.
[[nodiscard]] std::vector<glm::dvec2> lay_out_numbers(std::span<const NumberWish> wishes, double radius,
                                                      double gap);

}  // namespace nazori::view
