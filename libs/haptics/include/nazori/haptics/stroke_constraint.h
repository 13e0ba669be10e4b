// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/haptics/stroke_index.h"

namespace nazori::haptics {

/// Keeps the stylus on a stroke. The stroke captures it within the snap distance and pulls it to the nearest
/// point of that stroke. This point is found by walking along the stroke, so joined segments are one curve
/// and another stroke cannot take over. The stroke releases the stylus when it is pulled further than the
/// release distance.
///
/// The pull is a spring whose stiffness fades in over kBlend_s after the capture and out after the release.
/// After the release the pull is never larger than it was at that moment. The blend is slower where needed to
/// keep a step below kMostStep_n. So neither is felt as a jolt.
///
/// @source HLAPI's constraint touch model; snap distance = pull-off force / stiffness in the 2005 program;
/// blending: own design. Thread-safe: no. Real-time-safe: yes.
class StrokeConstraint {
 public:
  static constexpr double kBlend_s = 0.1;
  static constexpr double kMostStep_n = 0.04;  ///< largest change of the pull per tick at capture and release

  struct Settings {
    double stiffness_n_m = 100;
    double snap_distance_m = 0.01;
    double release_distance_m = 0.0105;  ///< at least snap_distance_m
  };

  /// @param index     empty: releases the stylus.
  /// @param period_s  since the last update.
  void update(const StrokeIndex& index, const Settings& settings, const Vec3& device_m,
              double period_s) noexcept;

  /// The strokes have changed: releases the stylus, and the pull fades out.
  void let_go() noexcept;
  /// Releases the stylus at once, without fading.
  void forget() noexcept;

  /// Number of the stroke that attracts the stylus, 0 none.
  [[nodiscard]] std::int32_t stroke() const noexcept { return stroke_; }
  /// Nearest point of that stroke.
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
