// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "nazori/functions/plate.h"
#include "nazori/functions/points.h"
#include "nazori/functions/tablet_curves.h"

namespace nazori::functions {

/// An expression that was read, and how it is to be shown.
struct PlotRequest {
  Plot plot;
  Window window;
  PlateSettings plate;
  Language language = Language::english;  ///< of Drawing::summary
};

/// Friction of parts of a plate.
struct PlateFriction {
  std::vector<std::uint8_t> zone;  ///< of each sample, row 0 at the top; 0: that of the material
  std::vector<double> added;       ///< [friction coefficient], of zone 1 and on
};
/// Each curve has a friction of its own; of a surface, the part where it is undefined is rougher.
[[nodiscard]] PlateFriction friction_of(const Plot& plot, const Plate& plate);

/// A plot that was drawn, with all that is needed to see, feel, hear and read it. Immutable once it is shown.
struct Drawing {
  /// More grooves than anyone can feel one by one only slow the servo down; the longest are kept.
  static constexpr std::size_t kMostGrooves = 300;

  PlotRequest request;
  Picture picture;
  std::vector<TabletCurve>
      grooves;  ///< in the order of the statements, or the longest first where some are left out
  PlateFriction friction;
  std::vector<PointOfInterest> points;  ///< of a final drawing; of one statement alone only its own
  std::string summary;                  ///< of a final drawing
  bool final = false;                   ///< false: coarse, a finer one follows
};
using SharedDrawing = std::shared_ptr<const Drawing>;

/// Draws a plot coarse first, then fine, as draw_coarse_to_fine() does; `show` gets each picture with its
/// grooves, the final one with its points and summary too.
/// @param show  on this thread; false stops.
/// @return the errors of draw_coarse_to_fine.
[[nodiscard]] base::Result<void> draw_plot(const PlotRequest& request,
                                           const std::function<bool(Drawing&&)>& show,
                                           const base::Progress& progress = {});

}  // namespace nazori::functions
