// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/functions/plate.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/label.h"

namespace nazori::functions {

/// The numbers of the ticks, on the tablet: those of x below their axis, those of y to the left of it. An
/// axis at the edge of the window has them on its other side. 0 stands once, where the axes cross. None where
/// the ticks are not shown, and none on the frame.
[[nodiscard]] std::vector<geometry::Label> axis_labels(const Window& window, const Layers& layers,
                                                       const geometry::TabletShape& shape = {});

/// A multiple of a tick's distance as it is written: "-1.5", "2000"; "3e7" and "2e-5" where that is shorter.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace nazori::functions
