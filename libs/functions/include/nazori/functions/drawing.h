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

/// A parsed expression and the settings of its picture.
struct PlotRequest {
  Plot plot;
  Window window;
  PlateSettings plate;
  Language language = Language::english;  ///< of Drawing::summary
  SpeechStyle speech = SpeechStyle::verbose;
};

/// Friction of parts of a plate.
struct PlateFriction {
  std::vector<std::uint8_t> zone;  ///< for each sample, row 0 at the top; 0: the material's friction
  std::vector<double> added;       ///< [friction coefficient], of zones 1 and up
};
/// Each curve has its own friction; where a surface is undefined, the plate is rougher.
[[nodiscard]] PlateFriction friction_of(const Plot& plot, const Plate& plate);

/// A drawn plot, with all data needed to see, feel, hear and read it. Immutable once it is shown.
struct Drawing {
  /// Maximum number of grooves: more could not be felt one by one and would slow down the servo; the longest
  /// are kept.
  static constexpr std::size_t kMostGrooves = 300;

  PlotRequest request;
  Picture picture;
  std::vector<TabletCurve>
      grooves;  ///< in the order of the statements, or the longest first where some are left out
  PlateFriction friction;
  std::vector<PointOfInterest> points;  ///< of a final drawing; if one statement is shown alone, only its own
  std::string summary;                  ///< of a final drawing
  bool final = false;                   ///< false: coarse, a finer one follows
};
using SharedDrawing = std::shared_ptr<const Drawing>;

/// Draws a plot coarse first, then fine, as draw_coarse_to_fine() does; `show` receives each picture with its
/// grooves, and the final one also with its points and summary.
/// @param show  called on this thread; returning false stops.
/// @return the errors of draw_coarse_to_fine.
[[nodiscard]] base::Result<void> draw_plot(const PlotRequest& request,
                                           const std::function<bool(Drawing&&)>& show,
                                           const base::Progress& progress = {});

}  // namespace nazori::functions
