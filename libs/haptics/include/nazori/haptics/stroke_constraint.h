// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/haptics/stroke_index.h"

namespace nazori::haptics {

/// Holds the stylus on a stroke: caught within the snap distance, held at the nearest point of that stroke
/// (walking along it, so joined segments are one curve and another stroke cannot take over), let go when
/// pulled further than the release distance.
///
/// The pull is a spring whose stiffness fades in over kBlend_s after the catch and out after the release,
/// where what it was at the release is the most it may be; the blend is slower where that keeps a step from
/// exceeding kMostStep_n. So neither is felt as a jolt.
///
/// @source HLAPI's constraint touch model; snap distance = pull-off force / stiffness in the 2005 program;
/// blending: own design. Thread-safe: no. Real-time-safe: yes.
class StrokeConstraint {
 public:
  static constexpr double kBlend_s = 0.1;
  static constexpr double kMostStep_n = 0.04;  ///< largest change of pull a tick of catch or release adds

  struct Settings {
    double stiffness_n_m = 100;
    double snap_distance_m = 0.01;
    double release_distance_m = 0.0105;  ///< held to at least snap_distance_m
  };

  /// @param index     empty: whatever was held is let go.
  /// @param period_s  since the last update.
  void update(const StrokeIndex& index, const Settings& settings, const Vec3& device_m,
              double period_s) noexcept;

  /// The strokes have changed: what was held is let go, and its pull fades out.
  void let_go() noexcept;
  /// Everything at once: nothing held, no pull.
  void forget() noexcept;

  /// Number of the stroke that holds, 0 none.
  [[nodiscard]] std::int32_t stroke() const noexcept { return stroke_; }
  /// Nearest point of the holding stroke.
  [[nodiscard]] const Vec3& point_m() const noexcept { return anchor_; }
  [[nodiscard]] std::int32_t segment() const noexcept { return segment_; }
  [[nodiscard]] const StrokeIndex::Hit& hit() const noexcept { return hit_; }
  /// Pull towards the stroke.
  [[nodiscard]] const Vec3& force_n() const noexcept { return force_; }

 private:
  StrokeIndex::Hit hit_;
  Vec3 anchor_{0, 0, 0};
  Vec3 force_{0, 0, 0};
  std::int32_t stroke_ = 0;
  std::int32_t segment_ = -1;
  double weight_ = 0;   // 0 no pull .. 1 the full spring
  double ceiling_ = 0;  // while fading out: largest pull [N]
};

}  // namespace nazori::haptics
