// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "nazori/haptics/haptic_scene.h"

namespace nazori::haptics {

/// Centre lines prepared for the query "what is nearest?", which runs in every tick. Immutable. Thread-safe:
/// yes. Real-time-safe: all but the constructor.
class StrokeIndex {
 public:
  /// A location on a stroke.
  struct Hit {
    Vec3 point{0, 0, 0};
    double squared_m2 = std::numeric_limits<double>::infinity();  ///< squared distance to the query point
    std::int32_t segment = -1;                                    ///< -1: none within reach
    double along = 0;                                             ///< 0..1 on the segment
  };

  StrokeIndex() = default;
  /// @param only  0 = all strokes, n = only stroke n. Points that are not finite are left out.
  StrokeIndex(std::span<const StrokePath> strokes, int only);

  [[nodiscard]] bool empty() const noexcept { return segments_.empty(); }
  /// Nearest location on any stroke within `reach_m` of `p`. O(segments / 8) in the worst case.
  [[nodiscard]] Hit nearest(const Vec3& p, double reach_m) const noexcept;
  /// Nearest location on the stroke that `segment` belongs to, found by walking along it from there.
  [[nodiscard]] Hit follow(const Vec3& p, std::int32_t segment) const noexcept;
  /// Number of the stroke, from 1, that contains `segment`.
  [[nodiscard]] std::int32_t stroke(std::int32_t segment) const noexcept {
    return segments_[static_cast<std::size_t>(segment)].stroke;
  }
  /// Metres along the stroke from its start.
  [[nodiscard]] double arc_length_m(const Hit& hit) const noexcept;
  /// Metres from start to end of the stroke that contains `segment`.
  [[nodiscard]] double stroke_length_m(std::int32_t segment) const noexcept;
  /// The location `arc_m` along the stroke numbered `stroke`, limited to its ends; segment -1 when there is
  /// no such stroke. O(log segments).
  [[nodiscard]] Hit at_length(std::int32_t stroke, double arc_m) const noexcept;
  /// Unit direction of writing at `segment`; zero for a stroke of one point.
  [[nodiscard]] Vec3 direction(std::int32_t segment) const noexcept;

 private:
  struct Segment {
    Vec3 from, along;
    double per_squared;  // 1 / |along|^2, 0 for a single point
    double before_m;     // arc length at `from`
    double length_m;     // |along|
    std::int32_t stroke;
    std::int32_t first, last;  // segments of the same stroke
  };
  struct Cluster {
    Vec3 low, high;
    std::size_t begin, end;
  };
  static constexpr std::size_t kCluster = 8;

  void test(const Vec3& p, std::size_t i, Hit& best) const noexcept;

  std::vector<Segment> segments_;
  std::vector<Cluster> clusters_;
  std::vector<std::int32_t> first_;  // by stroke: its first segment, -1 none
};

}  // namespace nazori::haptics
