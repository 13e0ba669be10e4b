// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "laid_over.h"
#include "ridge.h"

namespace nazori::author {

/// A line that was laid over ink, moved onto the middle of it.
struct Snapped {
  GlyphLine line;
  std::vector<bool> is_on_ink;  ///< for each of its points
};

/// Moves each line onto the middle line beside it that goes on longest with it. An end goes to a free end of
/// the ink near it; one that touches another line stays at the same place of it.
/// @param lines  points about a unit apart, at least two each.
/// @param thins_out  for each line whether its last end thins out.
/// @param gate  how far beside a line the middle of its ink may be [glyph units].
[[nodiscard]] std::vector<Snapped> snapped(const std::vector<GlyphLine>& lines,
                                           const std::vector<bool>& thins_out, const Ridge& ridge,
                                           double gate);

}  // namespace nazori::author
