// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#include "nazori/base/result.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {

/// Height and slope at a point.
struct SurfacePoint {
  double height;    ///< [0, 1] as HeightMap
  double d_column;  ///< change of height per sample to the right
  double d_row;     ///< change of height per sample downwards
};

/// Height, slope and second derivatives at a point.
struct CurvedPoint {
  double height;           ///< [0, 1] as HeightMap
  double d_column;         ///< change of height per sample to the right
  double d_row;            ///< change of height per sample downwards
  double d_column_column;  ///< change of d_column per sample to the right
  double d_column_row;     ///< change of d_column per sample downwards
  double d_row_row;        ///< change of d_row per sample downwards
};

/// The square around a sample, in which a surface is one polynomial: at u columns to the right of the sample
/// and v rows below it the height is the sum of of[a][b] u^a v^b.
struct SurfacePatch {
  double column = 0, row = 0;  ///< of the sample
  double of[3][3] = {};
  /// The point that was asked for lies beyond the edge of the map. There the surface goes on level, and the
  /// polynomial does not hold in the square around the sample.
  bool is_outside = false;
};

/// A surface close to the samples of a height map, without steps in height or slope, that can be evaluated a
/// million times a second: the uniform biquadratic B-spline whose control heights are the samples.
///
/// At a sample the height is that of the 3 x 3 neighbourhood weighted (1 6 1)/8 in each direction: constant
/// slopes are reproduced exactly, a bend is rounded by 1/8 of its second difference. The heights are a
/// weighted mean of samples with weights >= 0, so the surface never overshoots the highest or lowest of them.
/// The slope has no steps; the second derivatives are constant within the square around a sample.
///
/// Immutable. Thread-safe: yes. Real-time-safe: at(), curved_at() yes. Memory: 4 (size + 2)^2 bytes, the side
/// rounded up to a multiple of 4.
/// @source C. de Boor, A Practical Guide to Splines, 1978: quadratic B-splines on integer knots.
class SmoothSurface {
 public:
  /// Copies the samples, with a border of one that repeats the edge. Uses up to four threads for large maps.
  /// @return Errc::bad_argument for an empty map.
  [[nodiscard]] static base::Result<std::shared_ptr<const SmoothSurface>> create(const HeightMap& map);

  [[nodiscard]] int size() const noexcept { return size_; }
  /// Outside the grid the nearest edge continues level, from half a sample beyond it, also without a step in
  /// slope. @param column,row  finite; infinities and NaN count as far outside.
  [[nodiscard]] SurfacePoint at(double column, double row) const noexcept {
    const CurvedPoint p = curved_at(column, row);  // the compiler removes the unused parts once it is inlined
    return {p.height, p.d_column, p.d_row};
  }
  /// As at(), with the second derivatives.
  [[nodiscard]] CurvedPoint curved_at(double column, double row) const noexcept {
    const Cell c = cell(column, row);
    // Memory offsets of the three columns and the three rows of samples.
    const float* west = samples_.get() + column_at(c.i);
    const float* mid = samples_.get() + column_at(c.i + 1);
    const float* east = samples_.get() + column_at(c.i + 2);
    const std::size_t top = row_at(c.j), middle = row_at(c.j + 1), bottom = row_at(c.j + 2);
    const Piece left(c.v, west[top], west[middle], west[bottom]);
    const Piece centre(c.v, mid[top], mid[middle], mid[bottom]);
    const Piece right(c.v, east[top], east[middle], east[bottom]);
    const Piece along(c.u, left.value, centre.value, right.value);
    const Piece down(c.u, left.slope, centre.slope, right.slope);
    const Piece bend(c.u, left.bend, centre.bend, right.bend);
    // Beyond the rim it is level: the curvature of the last square ends there.
    return {along.value, along.slope,
            down.value,  c.column_outside ? 0 : along.bend,
            down.slope,  c.row_outside ? 0 : bend.value};
  }
  /// The square in which a point lies. @param column,row  as at().
  [[nodiscard]] SurfacePatch patch_at(double column, double row) const noexcept {
    const Cell c = cell(column, row);
    const Powers left = powers_at(c.i, c.j), middle = powers_at(c.i + 1, c.j),
                 right = powers_at(c.i + 2, c.j);
    SurfacePatch patch{static_cast<double>(c.i), static_cast<double>(c.j), {}, false};
    for (int b = 0; b < 3; ++b) {
      const Powers along(left.of[b], middle.of[b], right.of[b]);
      for (int a = 0; a < 3; ++a) patch.of[a][b] = along.of[a];
    }
    if (c.column_outside || c.row_outside) go_on_level(c, patch);
    return patch;
  }
  /// Identifies a surface, also among surfaces that had the same address.
  [[nodiscard]] std::uint64_t serial() const noexcept { return serial_; }

 private:
  /// The quadratic B-spline with three control values, at `u` in [-0.5, 0.5] from the middle one.
  struct Piece {
    Piece(double u, double before, double middle, double after)
        : value(0), slope(0), bend(before - 2 * middle + after) {
      const double lean = 0.5 * (after - before);
      value = middle + u * lean + (0.125 + 0.5 * u * u) * bend;
      slope = lean + u * bend;
    }
    double value, slope, bend;
  };
  /// The same spline as a polynomial of u.
  struct Powers {
    Powers(double before, double middle, double after) {
      const double bend = before - 2 * middle + after;
      of[0] = middle + 0.125 * bend;
      of[1] = 0.5 * (after - before);
      of[2] = 0.5 * bend;
    }
    double of[3];
  };
  struct Cell {
    std::size_t i, j;  // of the sample above and left of the middle one, in the map with its border
    double u, v;
    bool column_outside, row_outside;
  };

  explicit SmoothSurface(const HeightMap& map);

  [[nodiscard]] Cell cell(double column, double row) const noexcept {
    // The comparisons are written so that NaN is clamped to the border and cannot lead outside the memory.
    const double last = size_ - 0.5;
    const double x = column > -0.5 ? (column < last ? column : last) : -0.5;
    const double y = row > -0.5 ? (row < last ? row : last) : -0.5;
    const double from_left = x + 0.5, from_top = y + 0.5;  // >= 0: the cast rounds down
    const int i0 = static_cast<int>(from_left);
    const int j0 = static_cast<int>(from_top);
    const int i = i0 < size_ ? i0 : size_ - 1;
    const int j = j0 < size_ ? j0 : size_ - 1;
    return {static_cast<std::size_t>(i), static_cast<std::size_t>(j), x - i, y - j, x != column, y != row};
  }

  /// Of three samples of a column of the map with its border, of which (i, j) is the first.
  [[nodiscard]] Powers powers_at(std::size_t i, std::size_t j) const noexcept {
    const float* column = samples_.get() + column_at(i);
    return {column[row_at(j)], column[row_at(j + 1)], column[row_at(j + 2)]};
  }
  static void go_on_level(const Cell& c, SurfacePatch& patch) noexcept {
    patch.is_outside = true;
    for (int k = 0; k < 3; ++k) {
      if (c.column_outside) {
        patch.of[0][k] += c.u * (patch.of[1][k] + c.u * patch.of[2][k]);
        patch.of[1][k] = patch.of[2][k] = 0;
      }
    }
    for (int k = 0; k < 3; ++k) {
      if (c.row_outside) {
        patch.of[k][0] += c.v * (patch.of[k][1] + c.v * patch.of[k][2]);
        patch.of[k][1] = patch.of[k][2] = 0;
      }
    }
  }

  // The samples are stored in squares of 4 x 4, one cache line each, so that neighbours on the tablet are
  // close in memory in both directions.
  static constexpr std::size_t kSide = 4, kLine = 64;
  static_assert(kSide * kSide * sizeof(float) == kLine);
  [[nodiscard]] static std::size_t column_at(std::size_t i) noexcept {
    return i / kSide * (kSide * kSide) + i % kSide;
  }
  [[nodiscard]] std::size_t row_at(std::size_t j) const noexcept {
    return j / kSide * (squares_ * kSide * kSide) + j % kSide * kSide;
  }
  struct Aligned {
    void operator()(float* p) const noexcept { ::operator delete[](p, std::align_val_t{kLine}); }
  };

  std::uint64_t serial_;
  int size_;
  std::size_t squares_;  // a side, with the border
  std::unique_ptr<float[], Aligned> samples_;
};

}  // namespace nazori::surface
