// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "groove_line.h"

namespace nazori::author {

/// Lines of a skeleton as strokes of a printed character: divided at corners where a brush would be lifted,
/// each from its start to its end.
/// @param lines  from any end. @return in no order.
[[nodiscard]] std::vector<GridLine> divided(const std::vector<GridLine>& lines, const InkMap& map);

/// The ending that the ink shows: a sweep thins out over a long part, a hook turns back and thins out within
/// a short one.
[[nodiscard]] kanji::StrokeEnding ending_of_ink(const OwnStroke& stroke);

/// The stroke from its other end.
[[nodiscard]] OwnStroke turned_round(OwnStroke stroke);

/// Turns a stroke round where its shape or its width says that it is written the other way.
void direct(OwnStroke& stroke);

/// Puts strokes into an order of writing: from the top to the bottom, from the left to the right.
void put_in_order(std::vector<OwnStroke>& strokes);

}  // namespace nazori::author
