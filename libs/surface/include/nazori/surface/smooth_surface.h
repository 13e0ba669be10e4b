// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "nazori/base/result.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {

/// Height and slope at a place.
struct SurfacePoint {
  double height;    ///< [0, 1] as HeightMap
  double d_column;  ///< change of height per sample to the right
  double d_row;     ///< change of height per sample downwards
};

/// Height, slope and bend at a place.
struct CurvedPoint {
  double height;           ///< [0, 1] as HeightMap
  double d_column;         ///< change of height per sample to the right
  double d_row;            ///< change of height per sample downwards
  double d_column_column;  ///< change of d_column per sample to the right
  double d_column_row;     ///< change of d_column per sample downwards
  double d_row_row;        ///< change of d_row per sample downwards
};

/// A surface without steps in height or slope close to the samples of a height map, made to be asked a
/// million times a second: the uniform biquadratic B-spline whose control heights are the samples.
///
/// At a sample the height is that of the 3 x 3 neighbourhood weighted (1 6 1)/8 each way: straight slopes are
/// met exactly, a bend is rounded by 1/8 of its second difference. The heights are a weighted mean of samples
/// with weights >= 0, so the surface never rings above the highest or below the lowest of them. The slope has
/// no steps, the bend is constant within the square around a sample.
///
/// Immutable. Thread-safe: yes. Real-time-safe: at(), curved_at() yes. Memory: 4 (size + 2)^2 bytes.
/// @source C. de Boor, A Practical Guide to Splines, 1978: quadratic B-splines on integer knots.
class SmoothSurface {
 public:
  /// Copies the samples, with a border of one that repeats the edge.
  /// @return Errc::bad_argument for an empty map.
  [[nodiscard]] static base::Result<std::shared_ptr<const SmoothSurface>> create(const HeightMap& map);

  [[nodiscard]] int size() const noexcept { return size_; }
  /// Outside the grid the nearest edge goes on level, from half a sample beyond it; there, too, without a
  /// step in slope. @param column,row  finite; infinities and NaN count as far outside.
  [[nodiscard]] SurfacePoint at(double column, double row) const noexcept {
    const Cell c = cell(column, row);
    const Weights x(c.u), y(c.v);
    SurfacePoint p{0, 0, 0};
    for (std::size_t j = 0; j < 3; ++j) {
      const float* s = c.corner + j * stride_;
      const double s0 = s[0], s1 = s[1], s2 = s[2];
      const double along = x.value[0] * s0 + x.value[1] * s1 + x.value[2] * s2;
      p.height += y.value[j] * along;
      p.d_row += y.slope[j] * along;
      p.d_column += y.value[j] * (x.slope[0] * s0 + x.slope[1] * s1 + x.slope[2] * s2);
    }
    return p;
  }
  /// As at(), with the second derivatives.
  [[nodiscard]] CurvedPoint curved_at(double column, double row) const noexcept {
    const Cell c = cell(column, row);
    const Weights x(c.u), y(c.v);
    constexpr double kBend[3] = {1, -2, 1};
    CurvedPoint p{0, 0, 0, 0, 0, 0};
    for (std::size_t j = 0; j < 3; ++j) {
      const float* s = c.corner + j * stride_;
      const double s0 = s[0], s1 = s[1], s2 = s[2];
      const double along = x.value[0] * s0 + x.value[1] * s1 + x.value[2] * s2;
      const double slope = x.slope[0] * s0 + x.slope[1] * s1 + x.slope[2] * s2;
      p.height += y.value[j] * along;
      p.d_row += y.slope[j] * along;
      p.d_row_row += kBend[j] * along;
      p.d_column += y.value[j] * slope;
      p.d_column_row += y.slope[j] * slope;
      p.d_column_column += y.value[j] * (s0 - 2 * s1 + s2);
    }
    // Beyond the rim it is level: the bend of the last square ends there.
    if (c.column_outside) p.d_column_column = 0;
    if (c.row_outside) p.d_row_row = 0;
    return p;
  }

 private:
  /// The three B-splines that are not zero at `u` in [-0.5, 0.5] from the middle sample.
  struct Weights {
    explicit Weights(double u)
        : value{0.5 * (0.5 - u) * (0.5 - u), 0.75 - u * u, 0.5 * (0.5 + u) * (0.5 + u)},
          slope{u - 0.5, -2 * u, u + 0.5} {}
    double value[3];
    double slope[3];
  };
  struct Cell {
    const float* corner;  // sample above and left of the middle one
    double u, v;
    bool column_outside, row_outside;
  };

  explicit SmoothSurface(const HeightMap& map);

  [[nodiscard]] Cell cell(double column, double row) const noexcept {
    // The comparisons are written so that NaN ends on the border, not outside the memory.
    const double last = size_ - 0.5;
    const double x = column > -0.5 ? (column < last ? column : last) : -0.5;
    const double y = row > -0.5 ? (row < last ? row : last) : -0.5;
    const int i0 = static_cast<int>(x + 0.5);
    const int j0 = static_cast<int>(y + 0.5);
    const int i = i0 < size_ ? i0 : size_ - 1;
    const int j = j0 < size_ ? j0 : size_ - 1;
    return {samples_.get() + static_cast<std::size_t>(j) * stride_ + static_cast<std::size_t>(i), x - i,
            y - j, x != column, y != row};
  }

  int size_;
  std::size_t stride_;
  std::unique_ptr<float[]> samples_;  // (size + 2) x (size + 2)
};

}  // namespace nazori::surface
