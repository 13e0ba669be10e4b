// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "ink_map.h"
#include "nazori/author/trace.h"

namespace nazori::author {

/// @return Errc::bad_argument for strokes that trace_as() refuses.
[[nodiscard]] base::Result<void> check_known(std::span<const kanji::StrokeLine> character);

/// The strokes of a known character in ink.
/// @pre strokes with points, all finite.
[[nodiscard]] std::vector<FittedStroke> fitted(const InkMap& map,
                                               std::span<const kanji::StrokeLine> character);

}  // namespace nazori::author
