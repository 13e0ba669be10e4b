// SPDX-License-Identifier: Apache-2.0
// A tile as bytes, for undo and for files: only what is not zero.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "inside.h"

namespace nazori::paint {

/// The fields of a tile without those of the paper. Empty for a tile that was never touched.
[[nodiscard]] std::vector<std::uint8_t> pack(const Tile& tile);
/// Fills a tile with what pack() made. The caller settles it.
/// @return whether the bytes are such a tile, with every value in its range; else the tile is unusable.
[[nodiscard]] bool unpack(std::span<const std::uint8_t> bytes, const Bands& paper_inside, Tile& tile);

}  // namespace nazori::paint
