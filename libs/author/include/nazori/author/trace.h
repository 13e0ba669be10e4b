// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/base/result.h"
#include "nazori/kanji/stroke.h"
#include "nazori/scan/picture.h"
#include "nazori/surface/height_map.h"

namespace nazori::author {

/// A picture with more separate lines than this is not one character.
inline constexpr int kMostTracedStrokes = 160;

/// The strokes of a carved tablet, where nothing is known about the character: centre lines with the width
/// and the depth of the groove. Where lines meet, those go on in each other that bend least; corners divide
/// strokes as in printed characters (口 is three). Directions, endings and order are guesses from the
/// shape: left to right, top to bottom, a line that thins out ends there.
/// @param map  1 or white is the plateau; its edges are the edges of the glyph box.
/// @return Errc::bad_argument for a map without a groove, one that is nearly all groove, and one with more
/// than kMostTracedStrokes lines.
/// @cost under a tenth of a second at 512 x 512. Thread-safe.
[[nodiscard]] base::Result<std::vector<OwnStroke>> trace(const surface::HeightMap& map);

/// The same for a photograph, a scan or a picture of dark writing on light paper. Light may be uneven, and
/// the paper may lie on a darker table (see scan::paper_alone). The ink, without specks, is placed in the
/// middle of the glyph box, its larger side as large as that of a printed character. All depths are 1.
[[nodiscard]] base::Result<std::vector<OwnStroke>> trace(const scan::Photo& photo);

/// A stroke of a known character as it was found in a picture.
struct FittedStroke {
  OwnStroke stroke;  ///< centre line and width from the ink; direction and ending of the character
  kanji::StrokeEnding ending_of_ink = kanji::StrokeEnding::stop;  ///< what the width says
  double covered = 0;  ///< share of the stroke that lies in the middle of ink, 0..1
  double moved = 0;    ///< mean distance of the stroke from that of the character, after the character as a
                       ///< whole was laid over the ink [glyph units]
};

/// The strokes of a known character, in its order: each is where the ink is most like it. Strokes may share
/// ink where they touch or cross. Where a stroke has no ink, it is where its neighbours say, and `covered`
/// is low.
/// @param character  at least one stroke, each with at least one point, all finite.
/// @return also Errc::bad_argument for a character that is not so.
[[nodiscard]] base::Result<std::vector<FittedStroke>> trace_as(const surface::HeightMap& map,
                                                               std::span<const kanji::StrokeLine> character);
[[nodiscard]] base::Result<std::vector<FittedStroke>> trace_as(const scan::Photo& photo,
                                                               std::span<const kanji::StrokeLine> character);

}  // namespace nazori::author
