// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/base/result.h"
#include "nazori/kanji/stroke.h"

namespace nazori::author {

/// A font that is written with a brush.
struct BrushFont {
  std::string_view family;   ///< as fontconfig names it
  std::string_view package;  ///< of Debian
};

/// The brush fonts that are known by name, all of them free: packages and licences are in docs/brush.md.
[[nodiscard]] std::span<const BrushFont> brush_fonts();
/// Those of them that are installed, in the same order. @cost as font_families(). Thread-safe: yes.
[[nodiscard]] std::vector<BrushFont> installed_brush_fonts();

/// How well strokes fit a character of a font.
struct FontFit {
  double covered = 0;  ///< share of the font's ink that lies in the strokes
  double outside = 0;  ///< share of the strokes' area that has no ink of the font
  double on_ink = 0;   ///< of the strokes the smallest share of a middle line that lies in ink
  double alone = 0;    ///< of the strokes the smallest share of an area that no other stroke covers
  double moved = 0;    ///< of the strokes the largest mean distance from their place in the known character,
                       ///< after it was laid over the ink as a whole [glyph units]
};

/// Whether strokes with this fit are those of the font. The limits are in docs/brush.md.
[[nodiscard]] bool is_good_fit(const FontFit& fit);

/// A character as a font writes it, stroke by stroke.
struct FontStrokes {
  std::vector<OwnStroke> strokes;  ///< where they stand in the font's square; all depths are 1
  FontFit fit;
};

/// The strokes of a known character in a font, however poor the fit: number, order, directions and endings
/// are those of the known character, lines and widths those of the font.
/// @param known  as for trace_as(). @return the errors of font_picture() and trace_as(); Errc::not_found also
/// for a font whose glyph is empty. @cost 20 to 100 ms. Thread-safe: yes.
[[nodiscard]] base::Result<FontStrokes> font_strokes(char32_t character,
                                                     std::span<const kanji::StrokeLine> known,
                                                     const std::string& family);

/// The same as a model to write after. @return also Errc::not_found where the fit is poor, as of cursive
/// forms, which join and leave out strokes.
[[nodiscard]] base::Result<FontStrokes> font_model(char32_t character,
                                                   std::span<const kanji::StrokeLine> known,
                                                   const std::string& family);

}  // namespace nazori::author
