// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ink.h"
#include "nazori/writing/written_character.h"

namespace nazori::scan {

/// The middle lines of the ink as strokes, in pixels of the cell: where lines cross, each goes on as straight
/// as it can. Their order and direction mean nothing. No strokes without ink.
/// @source T. Y. Zhang, C. Y. Suen, "A fast parallel algorithm for thinning digital patterns", 1984.
[[nodiscard]] writing::WrittenCharacter lines_of(InkCell ink);

}  // namespace nazori::scan
