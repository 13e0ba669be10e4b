// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/geometry/point.h"
#include "nazori/print/page_drawing.h"
#include "nazori/print/sheet_mark.h"
#include "nazori/scan/picture.h"

namespace nazori::scan {

/// Pixels of a photograph: x right, y down, whole numbers at the centres of pixels.
struct PhotoFrame {};
using PhotoPoint = geometry::Point2<PhotoFrame>;

/// How a flat page lies in a photograph: the projective map from millimetres of the page to pixels.
struct PageMap {
  std::array<double, 9> matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};

  /// The map that takes four points of the page, no three of them on a line, to those of the photograph.
  [[nodiscard]] static PageMap through(const std::array<print::PaperPoint, 4>& page,
                                       const std::array<PhotoPoint, 4>& photo);
  [[nodiscard]] PhotoPoint at(print::PaperPoint p) const;
};

/// A printed page that was found in a photograph.
struct FoundSheet {
  print::SheetMark mark;
  PageMap map;
};

/// Every sheet with a readable mark. Sheets may lie turned in any direction and in perspective.
/// @return Errc::not_found where there is none, Errc::schema where the only mark is of another version.
[[nodiscard]] base::Result<std::vector<FoundSheet>> find_sheets(const Photo& photo);

}  // namespace nazori::scan
