// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "nazori/functions/points.h"

namespace nazori::functions {

/// Collects points of interest: only those in the window, each once, a limited number of each statement.
class PointList {
 public:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  PointList(const Plot& plot, const Tracing& tracing, std::size_t most)
      : plot_(plot),
        tracing_(tracing),
        window_(tracing.window),
        most_(most),
        counts_(plot.statements.size()),
        events_(tracing.events) {}

  [[nodiscard]] const Plot& plot() const { return plot_; }
  [[nodiscard]] const Tracing& tracing() const { return tracing_; }
  [[nodiscard]] const Window& window() const { return window_; }
  [[nodiscard]] const Statement& statement(int i) const {
    return plot_.statements[static_cast<std::size_t>(i)];
  }

  /// What tracing found, in places that are solved for exactly.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  void set_events(std::vector<Event> events) { events_ = std::move(events); }

  /// @return the point, or null where it was not added.
  PointOfInterest* add(int statement, PointKind kind, double x, double y, double parameter = 0,
                       int other = -1);
  /// A slanted asymptote, which has no place of its own.
  PointOfInterest& add_slanted(int statement, double slope, double intercept, int side);
  /// Whether a point of this kind is at most `share` of the window away.
  [[nodiscard]] bool has_near(int statement, PointKind kind, double x, double y, double share) const;
  /// Whether tracing found a break (pole, hole, jump) of the statement at this parameter.
  [[nodiscard]] bool has_break(int statement, double parameter, double reach) const;
  [[nodiscard]] bool has_event(int statement, EventKind kind, double parameter, double reach) const;
  /// Sorted by statement, then from left to right, with exact names.
  [[nodiscard]] std::vector<PointOfInterest> take();

 private:
  [[nodiscard]] bool in_window(double x, double y) const;

  const Plot& plot_;
  const Tracing& tracing_;
  Window window_;
  std::size_t most_;
  std::vector<std::size_t> counts_;
  std::vector<PointOfInterest> found_;
  std::vector<Event> events_;
};

}  // namespace nazori::functions
