// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/functions/plot.h"

namespace nazori::functions {

/// A point of the plate: the window is u and v from 0 to 1, u right, v up.
struct PlatePoint {
  double u = 0;
  double v = 0;
  friend bool operator==(const PlatePoint&, const PlatePoint&) = default;
};

/// The part of the plane that is shown, stretched to the square plate.
struct Window {
  double x0 = -10;
  double x1 = 10;
  double y0 = -10;
  double y1 = 10;
  friend bool operator==(const Window&, const Window&) = default;

  [[nodiscard]] double u(double x) const { return (x - x0) / (x1 - x0); }
  [[nodiscard]] double v(double y) const { return (y - y0) / (y1 - y0); }
  [[nodiscard]] double x(double u) const { return x0 + u * (x1 - x0); }
  [[nodiscard]] double y(double v) const { return y0 + v * (y1 - y0); }
  /// The window zoomed so that curves are `times` larger (below 1: smaller), with the point `at` fixed.
  [[nodiscard]] Window zoomed(PlatePoint at, double times) const;
  /// The window moved by shares of its sides, right and up.
  [[nodiscard]] Window moved(double du, double dv) const;
  /// Errc::bad_argument where a side is empty, not finite, or too narrow for doubles.
  [[nodiscard]] base::Result<void> check() const;
};

/// A point of a curve. `parameter` is x of y = f(x), y of x = g(y), t or theta; not used for implicit curves.
struct CurvePoint {
  double u = 0;
  double v = 0;
  double parameter = 0;
};

/// A connected piece of a curve as a polyline; its segments are closer to the true curve than the tolerance.
struct Branch {
  int statement = 0;  ///< index into Plot::statements
  bool closed = false;
  bool boundary = false;  ///< edge of a region
  bool strict = false;    ///< a border that does not belong to its region
  bool has_parameter = false;
  std::vector<CurvePoint> points;
};

/// A straight piece that the curve covers from end to end although its course inside is finer than a cell:
/// part of a dense band.
struct Bar {
  int statement = 0;
  PlatePoint from;
  PlatePoint to;
};

/// A single point of the graph.
struct Dot {
  int statement = 0;
  PlatePoint at;
};

/// A rectangle of which every point satisfies the statement.
struct Fill {
  int statement = 0;
  PlatePoint low;
  PlatePoint high;
};

enum class EventKind : std::uint8_t {
  pole,      ///< the curve goes to infinity on at least one side
  hole,      ///< a single missing point, bridged by the tracing
  jump,      ///< both sides end at different points
  end,       ///< the curve begins or ends
  singular,  ///< the gradient vanishes on the curve: crossing with itself, cusp
  isolated,  ///< a single point
  limit      ///< from here on the dense band is undecidable
};

/// A feature of a curve that was found during tracing; positions in the units of the window.
struct Event {
  EventKind kind = EventKind::hole;
  int statement = 0;
  double parameter = 0;  ///< as CurvePoint::parameter
  double x = 0;
  double y = 0;        ///< NaN where there is none
  double x_after = 0;  ///< of a jump: the far end; NaN otherwise
  double y_after = 0;
};

/// The result of tracing one plot in one window.
struct Tracing {
  Window window;
  std::vector<Branch> branches;
  std::vector<Bar> bars;
  std::vector<Dot> dots;
  std::vector<Fill> fills;
  std::vector<Event> events;
  /// Cells of the tracing's own grid that no proof could decide; they are not drawn.
  std::int64_t undecided_cells = 0;
  std::int64_t cells = 1;                    ///< of that grid
  std::vector<PlatePoint> undecided_places;  ///< centres of some of them, at most 1000
  bool complete = true;                      ///< false if the time ran out before everything was examined
  bool dense = false;                        ///< a band is drawn where the curve is finer than a cell
  [[nodiscard]] double undecided_share() const {
    return static_cast<double>(undecided_cells) / static_cast<double>(cells);
  }
};

struct TraceSettings {
  static constexpr int kFewestCells = 32;
  static constexpr int kMostCells = 8192;
  /// Cells per side of the picture: determines tolerances, the grid of implicit curves and what counts as
  /// dense. kFewestCells to kMostCells.
  int resolution = 512;
  /// How far outside the window curves are followed, in plate units, so that grooves are whole at the edge.
  double margin = 0.02;
  /// After this time tracing ends with an incomplete result, Tracing::complete false; 0: no limit.
  double most_milliseconds = 0;
};

/// Finds the curves, dots and regions of every statement but surfaces. Deterministic; thread-safe.
/// @return Errc::bad_argument for a bad window or setting, Errc::cancelled.
/// @source Tupper 2001 (interval proofs of continuity and zeros); docs/functions.md.
[[nodiscard]] base::Result<Tracing> trace(const Plot& plot, const Window& window,
                                          const TraceSettings& settings = {},
                                          const base::Progress& progress = {});

}  // namespace nazori::functions
