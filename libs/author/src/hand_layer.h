// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/author/own_character.h"
#include "nazori/carving/groove.h"

namespace nazori::author {

/// The layer at `size` samples a side, interpolated bilinearly; an untouched one stays untouched.
[[nodiscard]] HandLayer resampled(const HandLayer& hand, int size);

/// The heights of a box, row by row. @param box  within the layer.
[[nodiscard]] std::vector<float> cut_out(const HandLayer& hand, const carving::GridBox& box);

/// Index of a sample of a square of `size`.
[[nodiscard]] inline std::size_t sample_index(int size, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
}

}  // namespace nazori::author
