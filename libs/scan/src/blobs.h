// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/scan/sheet.h"

namespace nazori::scan {

/// A dark spot that may be a disc of a mark.
struct Blob {
  PhotoPoint centre;
  double radius = 0;  ///< pixels; of an ellipse the geometric mean
  double unlike = 0;  ///< how far from an ellipse: 0 for a perfect one
};

/// The spots that are most like discs seen from above or at a slant, best first; some dozens at most.
[[nodiscard]] std::vector<Blob> find_discs(const Photo& photo);

}  // namespace nazori::scan
