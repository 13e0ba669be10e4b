// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nazori/practice/pen_recorder.h"
#include "nazori/practice/stroke_player.h"
#include "nazori/practice/tablet_workshop.h"

namespace nazori::practice {

/// A learner's writing and the model, both written again at once: the learner's at its true speed, the model
/// at a teacher's. Times are seconds since the start; below 0 everything is written.
class WritingReplay {
 public:
  void set(std::vector<HandStroke> strokes, const Tablet& model);

  [[nodiscard]] const std::vector<HandStroke>& strokes() const { return strokes_; }
  /// When the longer of the two ends.
  [[nodiscard]] double duration_s() const;
  /// The part of a stroke of the learner, from 0, that is written at a moment.
  [[nodiscard]] std::span<const HandPoint> written(std::size_t stroke, double time_s) const;
  /// The number of points in all such parts.
  [[nodiscard]] std::size_t points_written(double time_s) const;
  [[nodiscard]] int model_strokes() const { return player_.stroke_count(); }
  /// The part of a stroke of the model, from 1, that is written at a moment.
  [[nodiscard]] geometry::Polyline<geometry::TabletFrame> model_written(int stroke, double time_s) const;

 private:
  std::vector<HandStroke> strokes_;
  Tablet model_;
  StrokePlayer player_;
};

}  // namespace nazori::practice
