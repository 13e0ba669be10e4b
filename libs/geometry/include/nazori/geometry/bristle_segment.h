// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/geometry/point.h"

namespace nazori::geometry {

/// The plane of a sheet of paper, in metres: x right, y up, origin at the centre of the sheet.
struct PaperFrame {};
using PaperPoint = Point2<PaperFrame>;

/// What one bristle of a brush swept over the paper between two positions of the pen. The bristle touched the
/// band of `width_m` along the straight line from `from` to `to`. A brush lists such segments, and paper
/// takes ink along them. So neither needs to know the other, and the result does not depend on how often the
/// pen is reported.
struct BristleSegment {
  PaperPoint from;
  PaperPoint to;         ///< equal to `from` where the bristle rests
  double pressure = 0;   ///< 0..1, of the bristle on the paper; 0: it only just touches
  double width_m = 0;    ///< of the band, > 0
  double length_m = 0;   ///< of the part of the bristle that lies on the paper, >= 0
  double speed_m_s = 0;  ///< of the bristle over the paper, >= 0
  double wetness = 1;    ///< 0..1, water that the bristle offers, relative to a full load
  double pigment = 1;    ///< 0..1, pigment that the bristle offers, relative to undiluted ink
};

}  // namespace nazori::geometry
