// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/plotter.h"
#include "nazori/practice/tablet_workshop.h"

namespace nazori::practice {

/// A drawn plot and the tablet into which it is carved.
struct TabletPlot {
  functions::SharedDrawing drawing;
  Tablet tablet;
};

/// Makes a tablet from a drawing: its plate is the relief, its curves are the strokes. Any thread.
/// @return the errors of CarvedTablet::from_height_map.
[[nodiscard]] base::Result<TabletPlot> on_tablet(functions::Drawing&& drawing);

}  // namespace nazori::practice
