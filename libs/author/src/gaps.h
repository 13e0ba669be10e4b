// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ink_graph.h"

namespace nazori::author {

/// Divides branches where two strokes only touch: a groove is less deep between their ends, ink is narrower.
/// What remains beside a node of the other stroke goes.
[[nodiscard]] InkGraph divided_at_gaps(const InkGraph& graph, const InkMap& map);

}  // namespace nazori::author
