// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/plot_event.h"
#include "nazori/functions/sound.h"

namespace nazori::functions {

/// The sound and the announcement at a point that a hand touches.
struct Touch {
  Cue cue;
  bool trembles = false;  ///< a dense band
  /// The point of interest of the drawing that the hand has just reached; else null.
  const PointOfInterest* reached = nullptr;
};

/// A drawing explored by key and by hand. Each key returns the event to announce. Thread: one.
class PlotExplorer {
 public:
  using Way = CurveFollower::Way;

  /// Sets another picture. A coarse one has no points and cannot be followed yet.
  void show(SharedDrawing drawing);
  /// No finer picture follows: the present one can be followed, even if it is coarse.
  void settle();
  /// Null before the first picture.
  [[nodiscard]] const SharedDrawing& drawing() const { return drawing_; }
  [[nodiscard]] bool has_curve() const { return drawing_ && !drawing_->picture.tracing.branches.empty(); }
  [[nodiscard]] const std::optional<PlotLocation>& location() const { return follower_.location(); }

  PlotEvent step(Way way);
  PlotEvent step_to_tick(Way way);
  PlotEvent go_to_end(Way way);
  PlotEvent change_branch(Way way);
  PlotEvent next_point(Way way);
  /// @param index  into Drawing::points.
  PlotEvent go_to_point(std::size_t index);
  PlotEvent drop_beacon();
  PlotEvent go_to_next_beacon();
  /// Where the hand is.
  [[nodiscard]] PlotEvent where() const;
  [[nodiscard]] PlotEvent slope() const;
  /// The event for choosing the groove with this number; 0: all. @param count  number of grooves.
  [[nodiscard]] PlotEvent groove(int number, int count) const;

  /// The tone of a location: as loud as a touched one if it lies on a curve, silent elsewhere.
  [[nodiscard]] Cue cue_of(const PlotLocation& location) const;
  /// The sound for a hand on the plate. For a surface the pitch shows its height, for curves the height of
  /// the nearest one, louder when nearer. Call it only while something is shown.
  Touch touch(PlatePoint hand);

 private:
  [[nodiscard]] PlotEvent at_location(PlotEventKind kind) const;
  [[nodiscard]] PlotEvent stepped(CurveFollower::Step step) const;
  [[nodiscard]] PlotEvent at_point(const PointOfInterest* point);
  [[nodiscard]] Touch touch_surface(PlatePoint hand) const;
  [[nodiscard]] Touch touch_curves(PlatePoint hand) const;

  SharedDrawing drawing_;
  CurveFollower follower_;
  const PointOfInterest* touched_ = nullptr;  ///< of the drawing
};

/// The tone of y = 0, for comparison; nothing where it lies outside the window.
[[nodiscard]] std::optional<Cue> reference_cue(const Window& window);

}  // namespace nazori::functions
