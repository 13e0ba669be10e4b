// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/geometry/stroke_pace.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/tablet/tablet_line.h"

namespace nazori::practice {

/// How a teacher's brush writes a character: the time of every point. The brush is slow where a stroke
/// starts, at corners, before a hook and where it stops. It is fast in between and in a sweep. It is lifted
/// on the way to the next stroke. Times are those of speed 1.
/// @source slow starts and stops, and peaks of speed between them: the two-thirds power law of handwriting,
/// F. Lacquaniti, C. Terzuolo, P. Viviani, "The law relating the kinematic and figural aspects of drawing
/// movements", Acta Psychologica 54 (1983); the figures here are round numbers near a calm hand's.
class StrokePlayer {
 public:
  static constexpr double kSpeed_m_s = 0.055;  ///< of the brush on a straight piece
  static constexpr double kLift_m = 0.008;     ///< highest point between two strokes

  /// @param paths  centre lines [m], z the bottom of the groove. @param lines  the same strokes in the same
  ///   order, for their endings.
  void set_strokes(std::span<const haptics::StrokePath> paths, std::span<const tablet::TabletLine> lines);

  /// Where the brush is.
  struct Pose {
    haptics::Vec3 tip_m{0, 0, kLift_m};
    int stroke =
        0;  ///< the one being written, or to be written next, from 1; after the last: the number of strokes
    double share = 0;      ///< of that stroke's length
    bool writing = false;  ///< the brush is down
  };
  /// @param time_s  clamped to 0..duration_s().
  [[nodiscard]] Pose at(double time_s) const;
  [[nodiscard]] double duration_s() const;
  [[nodiscard]] int stroke_count() const { return static_cast<int>(strokes_.size()); }
  /// The times at which the brush begins and ends stroke n, from 1.
  [[nodiscard]] double start_s(int stroke) const;
  [[nodiscard]] double end_s(int stroke) const;
  /// The share of a stroke's length that is written at a moment.
  [[nodiscard]] double share_at(int stroke, double time_s) const;
  /// The part of a stroke, from its start and as seen from above, that is written at a moment; empty before
  /// the brush moves.
  [[nodiscard]] geometry::Polyline<geometry::TabletFrame> written(int stroke, double time_s) const;

 private:
  struct Timed {
    double start_s = 0;
    std::vector<haptics::Vec3> points;
    std::vector<double> along_m;
    geometry::StrokePace pace;  ///< since start_s
  };
  std::vector<Timed> strokes_;
};

}  // namespace nazori::practice
