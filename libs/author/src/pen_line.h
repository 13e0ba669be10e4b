// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/carving/groove.h"
#include "nazori/geometry/written_stroke.h"

namespace nazori::author {

/// The points of a groove that are needed so that its line and its half width stay within `tolerance` glyph
/// units, and its depth within a tenth of that, of what all the points give.
[[nodiscard]] carving::Groove simplified(const carving::Groove& groove, double tolerance);

/// The pressure of a pen, 0..1; 1 where it reports none.
[[nodiscard]] double pressure_of(const geometry::WrittenPoint<geometry::GlyphFrame>& point);

}  // namespace nazori::author
