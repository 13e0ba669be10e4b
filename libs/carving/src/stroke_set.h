// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/kanji/stroke.h"

namespace nazori::carving {

/// The strokes in an order of their own, each of them once: what is computed from it does not depend, to the
/// last bit, on the order in which strokes were given.
[[nodiscard]] std::vector<const kanji::StrokeLine*> stroke_set(std::span<const kanji::StrokeLine> strokes);

}  // namespace nazori::carving
