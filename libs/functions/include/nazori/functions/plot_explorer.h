// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/plot_event.h"
#include "nazori/functions/sound.h"

namespace nazori::functions {

/// What is heard and announced at a place that a hand touches.
struct Touch {
  Cue cue;
  bool trembles = false;  ///< a dense band
  /// A point of interest that the hand has just come to, of the drawing; else null.
  const PointOfInterest* reached = nullptr;
};

/// A drawing explored by key and by hand. Each key is answered with what is to be announced. Thread: one.
class PlotExplorer {
 public:
  using Way = CurveFollower::Way;

  /// Another picture. A coarse one has no points and is not followed yet.
  void show(SharedDrawing drawing);
  /// No finer picture follows: what is shown is followed, even if it is coarse.
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
  /// Of the groove with this number; 0: all. @param count  of the grooves.
  [[nodiscard]] PlotEvent groove(int number, int count) const;

  /// The tone of a location: as loud as one that is touched where it lies on a curve, silent elsewhere.
  [[nodiscard]] Cue cue_of(const PlotLocation& location) const;
  /// What a hand on the plate hears. Of a surface the pitch is its height, of curves that of the nearest one,
  /// the louder the nearer. Only while something is shown.
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

/// The tone of y = 0, to compare with; nothing where it lies outside the window.
[[nodiscard]] std::optional<Cue> reference_cue(const Window& window);

}  // namespace nazori::functions
