// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/base/result.h"

namespace nazori::author {

/// One character of a font.
struct FontGlyph {
  char32_t code_point = 0;         ///< up to U+10FFFF, not a surrogate; U+F0000..U+FFFFD is for private use
  std::vector<OwnStroke> strokes;  ///< within the limits of validate(); without strokes the glyph is blank
  std::string name = {};           ///< named in errors; the font has no names of glyphs
};

/// Units of the font per em. The box of 109 x 109 glyph units fills the em.
inline constexpr int kFontEm = 1000;
/// The top of the box over the base line; the bottom is 120 units under it, as in CJK fonts.
inline constexpr int kFontAscent = 880;
/// Half the width of the thinnest line [glyph units]: where a groove is narrower, the font is not, so that it
/// can be seen.
inline constexpr double kThinnestInFont = 0.5;
/// The same at both ends of a line, so that sweeps end in a tip: it sinks to this over the last kTipRun glyph
/// units, or over a quarter of a shorter line. A stroke of one point has none.
inline constexpr double kTipInFont = 0.1;
inline constexpr double kTipRun = 2;
/// How far the edge of a glyph may be from that of the groove [glyph units], while the glyph has room for it.
inline constexpr double kFontTolerance = 0.15;
/// Most characters of a font. @source OpenType counts glyphs with 16 bits; one is the glyph for what is
/// missing.
inline constexpr std::size_t kMostFontGlyphs = 65'534;

/// A TrueType font of one family whose glyphs are the grooves of strokes, filled. Every glyph is one em wide.
/// Depth does not count. The same glyphs and family give the same bytes, in whatever order the glyphs are.
/// The font may be embedded and installed (fsType 0) and holds no licence.
///
/// A glyph of more than 20,000 points, or with an edge longer than 2,200 em, is drawn more coarsely than
/// kFontTolerance until it has no more, so that programs can draw it. Only characters with thousands of bends
/// need it.
/// @param family  UTF-8 without control characters, 1 to 200 bytes. FreeType and Qt show only ASCII of it.
/// @return Errc::bad_argument naming the glyph, where there are too many of them, a code point is none or
/// comes twice, strokes are not valid, the outlines together exceed 2 GiB, or the family is not as above.
/// @cost about a millisecond for a kanji. Thread-safe: yes.
/// @source OpenType specification 1.9.1; overlapping contours as its flag OVERLAP_SIMPLE allows.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> character_font(std::span<const FontGlyph> glyphs,
                                                                     std::string_view family);

}  // namespace nazori::author
