// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/tablet_workshop.h"

namespace nazori::practice {

/// A flat tablet whose strokes only attract the stylus; without strokes: just the surface.
[[nodiscard]] Tablet blank_tablet(std::vector<tablet::TabletLine> lines = {});

/// The same relief without the strokes: the grooves can be felt, but no strokes are drawn or tracked.
[[nodiscard]] Tablet without_strokes(const Tablet& tablet);

}  // namespace nazori::practice
