// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/tablet_workshop.h"

namespace nazori::practice {

/// A tablet with nothing carved, on which strokes lie that only hold the stylus; none: just a face.
[[nodiscard]] Tablet blank_tablet(std::vector<kanji::StrokeLine> lines = {});

/// The same relief without the strokes: it is felt, but neither drawn nor followed.
[[nodiscard]] Tablet without_strokes(const Tablet& tablet);

}  // namespace nazori::practice
