// SPDX-License-Identifier: Apache-2.0
// Strokes and components as the database stores them.
#pragma once

#include <utility>
#include <vector>

#include "kanji_database_inside.h"

namespace nazori::kanji {

/// @throws SQLite::Exception  for a row that no builder writes.
[[nodiscard]] Stroke read_stroke(Rewound& row);
[[nodiscard]] Component read_component(Rewound& row);

/// The tree of rows that each name their parent; a parent comes before its children.
[[nodiscard]] Component assemble(std::vector<std::pair<int, Component>> rows);

}  // namespace nazori::kanji
