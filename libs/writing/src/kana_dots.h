// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "shape.h"

namespace nazori::writing {

/// Other ways to write one stroke of a kana by hand, beside the one that KanjiVG draws. KanjiVG's dots of う,
/// え, む and ふ end in a turn to the next stroke, as quick writing has it; careful hands leave it off.
/// @param shape  the model stroke as make_shape() makes it, with what it takes for a hook set apart
[[nodiscard]] std::vector<Shape> other_ways(char32_t character, std::size_t stroke, const Shape& shape);

}  // namespace nazori::writing
