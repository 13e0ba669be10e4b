// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "nazori/geometry/point.h"

namespace nazori::writing {

/// Number of points by which strokes are compared.
inline constexpr std::size_t kSamples = 24;

/// Coordinates kept apart, so that comparing is a loop over plain arrays.
struct Samples {
  alignas(32) std::array<float, kSamples> x{};
  alignas(32) std::array<float, kSamples> y{};
  float length = 0;    ///< of the line that was sampled
  float centre_x = 0;  ///< mean of the samples
  float centre_y = 0;
  float inertia = 0;  ///< sum of the squared distances of the samples from their centre

  /// To be called once x and y are known.
  void find_centre();
  /// Smooths a line: each sample but the ends moves halfway to the mean of its neighbours.
  void smooth(int passes);
};

/// A stroke prepared for comparison: sampled at equal steps, as a whole and without the hook at its end.
struct Shape {
  Samples whole;
  std::optional<Samples> body;  ///< without the hook; nullopt if there is none
  bool kicked = false;          ///< it ends like a hook; a fold may do so, too
  float touch = 14;             ///< of a model stroke: much below this length it may be as short as a touch
  float freedom = 1;            ///< of a model stroke: how much more its shape may vary than is usual
  bool free_slant = false;      ///< of a model stroke: a dot above a bar may be level or upright, too
};

/// x' = a x + b y + tx, y' = c x + d y + ty.
struct Affine {
  double a = 1, b = 0, tx = 0;
  double c = 0, d = 1, ty = 0;
};

[[nodiscard]] Samples transformed(const Samples& samples, const Affine& map);
[[nodiscard]] Shape transformed(const Shape& shape, const Affine& map);

/// Samples of a line given as x, y pairs; at least one point.
[[nodiscard]] Samples sample_line(std::span<const double> xs, std::span<const double> ys);
/// A line prepared for comparison. A hook is a last part of at most 0.3 of the length, turned by more than 55
/// degrees from what comes before it.
[[nodiscard]] Shape make_shape(std::span<const double> xs, std::span<const double> ys);

template <class Frame>
[[nodiscard]] Shape make_shape(std::span<const geometry::Point2<Frame>> line) {
  std::vector<double> xs;
  std::vector<double> ys;
  xs.reserve(line.size());
  ys.reserve(line.size());
  for (const auto& p : line) {
    xs.push_back(p.x);
    ys.push_back(p.y);
  }
  return make_shape(xs, ys);
}

/// Two lines written without lifting the pen: the second follows the first, a straight link between.
[[nodiscard]] Shape joined(const Samples& first, const Samples& second);

}  // namespace nazori::writing
