// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nazori/geometry/point.h"

namespace nazori::geometry {

/// A short text beside a point of the tablet, such as a number of an axis. It is seen, not felt.
struct Label {
  std::string text;  ///< UTF-8: digits, "-", "+", ".", "e"
  TabletPoint at;    ///< [m]
  /// The side of the point on which the text stands: a unit vector, x to the right, y up.
  double right = 0;
  double up = 0;

  friend bool operator==(const Label&, const Label&) = default;
};

}  // namespace nazori::geometry
