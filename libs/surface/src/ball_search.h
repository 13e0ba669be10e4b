// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nazori/surface/height_map.h"
#include "nazori/surface/smooth_surface.h"

namespace nazori::surface {

/// For each sample of a surface, how high a ball above that sample is when it rests on the surface.
///
/// Lengths are in cells, the distance between two samples. A ball whose middle is above x touches the surface
/// at the point q where z(q) + c(x - q) is largest, with c(d) = sqrt(r^2 - d^2) - r; its lowest point is then
/// at that height. The contact is searched among points that lie close enough to each other, and moved from
/// there to where ball and surface have the same slope. Immutable; rows() may be called by several threads at
/// once.
class BallSearch {
 public:
  /// @param map  the samples of `surface`; both outlive this. @param radius  above 0 [cells].
  /// @param steep  height 1 of the surface [cells], above 0. @param tolerance  what a contact between the
  /// samples must be higher by to be searched for [cells].
  BallSearch(const HeightMap& map, const SmoothSurface& surface, double radius, double steep,
             double tolerance);

  /// Writes the heights [0..1] of the rows first to last - 1 to `out`.
  void rows(int first, int last, std::span<float> out) const;

  /// From a sample to its neighbours on each side, along the axes: changes of height to the right and down.
  struct Slopes {
    float left, right, up, down;
  };
  /// Where balls are relative to a sample [cells].
  struct Region {
    float left = 0, right = 0, top = 0, bottom = 0;
    bool is_sure = true;  // all balls are in it
    [[nodiscard]] bool is_empty() const { return left > right || top > bottom; }
  };
  /// A box around the balls of radius `r` for which a sample is higher than its four neighbours: right to the
  /// first order in the cells per height of the ball's middle, and with what the second adds at most.
  [[nodiscard]] static Region region_of(const Slopes& s, float r);

 private:
  /// The best contact so far for each sample of a band of rows.
  struct Band {
    int first, last;
    int z_first;                        // first row of z
    std::vector<float> z;               // the surface at the samples [cells]
    std::vector<float> height;          // [cells]
    std::vector<std::int32_t> contact;  // how far the sample that is touched is; empty if it is not needed

    [[nodiscard]] const float* row(int number, int size) const {
      return z.data() + static_cast<std::ptrdiff_t>(number - z_first) * size;
    }
  };
  void prepare_samples();
  void prepare_points();
  void rows_from_samples(int first, int last, std::span<float> out) const;
  void row_from_points(int row, std::span<float> out) const;
  void measure(Band& band) const;
  void spread(Band& band) const;
  void spread_rows(Band& band, int column, int row, const Slopes& s) const;
  void offer(Band& band, int column, int row, int top, int bottom, int left, int right) const;
  void offer_row(Band& band, int column, int row, int y, int left, int right) const;
  void offer_turned(Band& band, int column, int row, const Region& at) const;
  [[nodiscard]] double refined(int column, int row, double x, double y) const;
  [[nodiscard]] bool is_level(int from, int to, int row) const;
  [[nodiscard]] double loss(double left) const;
  [[nodiscard]] double gain(const Band& band, int x, int y, int dx, int dy) const;
  [[nodiscard]] float to_height(double cells) const;

  const HeightMap& map_;
  const SmoothSurface& surface_;
  int size_;
  double radius_, steep_, tolerance_;

  // A ball that covers many samples: the samples are the points that are tried.
  int reach_ = 0;             // whole samples that the ball covers to each side
  float steepest_fast_ = 0;   // slopes of the way that is not row by row
  bool refines_ = true;       // contacts between samples make a difference
  double refined_below_ = 0;  // squares of the height of the ball's middle above a contact
  std::vector<float> cap_;    // c at whole samples: rows 0..reach_, columns -reach_..reach_

  // A ball that covers few samples: points closer than the samples are tried.
  struct Point {
    int first;                // of three samples, relative to the one below the ball
    std::array<float, 3> of;  // their weights
  };
  int steps_ = 0;              // points to each side
  double step_ = 0;            // between two points [cells]
  std::vector<Point> points_;  // along an axis, 2 steps_ + 1
};

}  // namespace nazori::surface
