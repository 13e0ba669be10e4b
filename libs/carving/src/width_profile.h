// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/carving/carve.h"

namespace nazori::carving {

/// The groove at an arc length.
struct WidthKnot {
  double s;  ///< [glyph units]
  double half_width;
  double depth;
};

/// Width and depth along a line, given at some arc lengths: smooth curves through them that never overshoot.
/// @source monotone piecewise cubic interpolation, F. N. Fritsch and R. E. Carlson, 1980, with the slopes of
/// F. N. Fritsch and J. Butland, 1984.
class WidthProfile {
 public:
  /// @param knots  at least one, `s` ascending.
  explicit WidthProfile(std::vector<WidthKnot> knots);

  /// Before the first and behind the last knot the groove is that of the knot.
  [[nodiscard]] BrushMark at(double s) const;
  [[nodiscard]] std::span<const WidthKnot> knots() const { return knots_; }
  /// The half width that half of the line exceeds.
  [[nodiscard]] double usual_half_width() const;

 private:
  std::vector<WidthKnot> knots_;
  std::vector<BrushMark> slopes_;
};

}  // namespace nazori::carving
