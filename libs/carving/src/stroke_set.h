// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/carving/groove.h"
#include "nazori/kanji/stroke.h"

namespace nazori::carving {

/// The strokes in a canonical order, each of them once. What is computed from them does not depend, to the
/// last bit, on the order in which they were given.
[[nodiscard]] std::vector<const kanji::StrokeLine*> stroke_set(std::span<const kanji::StrokeLine> strokes);

/// Likewise for grooves.
[[nodiscard]] std::vector<const Groove*> groove_set(std::span<const Groove> grooves);

}  // namespace nazori::carving
