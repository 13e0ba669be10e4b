// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "nazori/functions/tracing.h"
#include "nazori/surface/height_map.h"

namespace nazori::functions {

/// The elements besides the curves, each with its own switch; all are interrupted where a curve passes.
struct Layers {
  bool axes = true;   ///< ridges along x = 0 and y = 0
  bool ticks = true;  ///< short ridges across the axes, or along the frame where an axis is out of the window
  bool grid = false;  ///< fine low ridges at every tick
  bool rim = true;    ///< a raised frame that keeps the tip on the plate
  [[nodiscard]] bool any() const { return axes || ticks || grid || rim; }
  [[nodiscard]] static Layers none() { return {false, false, false, false}; }
};

struct HeightRange {
  double low = -1;
  double high = 1;
};

struct PlateSettings {
  int size = 512;              ///< samples a side, 32 to 4096
  double half_width = 0.0125;  ///< of a groove, as a share of the plate's side: 0.001 to 0.2
  Layers layers;
  std::optional<HeightRange> heights;  ///< of a surface; if not set, the range of its values
  /// Index of the one statement that is shown, so that a curve can be felt and heard alone; -1: all.
  int alone = -1;
};

/// A plot carved into a square plate.
struct Plate {
  /// Curves: 1 the plateau (0.9 where layers are shown, so that ridges and rim can stand out), 0 the bottom
  /// of a groove. A surface: from the low end of its range (0) to the high end (1).
  surface::HeightMap heights;
  /// Per sample, row 0 at the top: 255 carved or, of a surface, defined; 0 not.
  std::vector<std::uint8_t> mask;
  /// Per sample: 0 none, else 1 + the index of the statement nearest to it within a groove. This lets each
  /// curve have its own friction or texture.
  std::vector<std::uint8_t> statement;
  HeightRange range;  ///< of a surface
};

/// Distance between ticks for a range: 1, 2 or 5 times a power of ten, four to ten of them.
[[nodiscard]] double tick_step(double low, double high);

/// Carves a tracing: grooves have the same perpendicular width everywhere, computed from the exact distance
/// of each sample to the nearest piece of a curve. Where curves meet the lower height counts, so a curve
/// typed twice is not deeper. Regions get a fine ripple; a border that does not belong to its region is
/// dashed.
[[nodiscard]] base::Result<Plate> carve(const Tracing& tracing, const PlateSettings& settings = {});

/// Carves z = f(x, y). Values are cut to the range; samples where f is undefined or has a pole lie outside
/// the mask, single gaps with consistent surroundings are closed.
[[nodiscard]] base::Result<Plate> carve_surface(const Statement& surface, const Window& window,
                                                const PlateSettings& settings = {},
                                                const base::Progress& progress = {});

/// A plate and the data it was made from.
struct Picture {
  Tracing tracing;
  Plate plate;
};

/// Traces and carves in one go, curves or a surface.
/// @param most_milliseconds  as in TraceSettings; surfaces have no limit.
[[nodiscard]] base::Result<Picture> draw(const Plot& plot, const Window& window,
                                         const PlateSettings& settings = {},
                                         const base::Progress& progress = {}, double most_milliseconds = 0);

/// The same, coarse first: calls `show` with a picture of at most 128 samples within 100 ms, then with the
/// final one. If 100 ms are too short, the first picture contains what is proven by then, and
/// Tracing::complete is false. `show` runs on this thread; returning false stops.
[[nodiscard]] base::Result<void> draw_coarse_to_fine(const Plot& plot, const Window& window,
                                                     const PlateSettings& settings,
                                                     const std::function<bool(Picture&&, bool final)>& show,
                                                     const base::Progress& progress = {});

}  // namespace nazori::functions
