// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/calligraphy/tools.h"
#include "nazori/carving/groove.h"
#include "nazori/geometry/bristle_segment.h"
#include "nazori/kanji/stroke.h"

namespace nazori::calligraphy {

/// How many characters a sheet is ruled for.
inline constexpr std::array kRulings{0, 1, 2, 4, 6};

/// A square for one character.
struct RuledSquare {
  geometry::PaperPoint middle;
  double side_m = 0;
};

/// The squares of a sheet, in the order in which they are written: down each column, the right column first.
/// @param characters  of kRulings; others, and 0, give none.
[[nodiscard]] std::vector<RuledSquare> ruled_squares(int characters);
/// The square for a model where nothing is ruled: as for one character.
[[nodiscard]] RuledSquare only_square();
/// The brush that fits characters of this size.
[[nodiscard]] BrushSize size_for(int characters);

/// A stroke of a model as a brush leaves it: pressed at the start, thin in a sweep or hook, pressed again at
/// a stop.
struct ModelStroke {
  geometry::Polyline<geometry::PaperFrame> points;
  std::vector<double> half_width_m;  ///< one for each point
};
/// The strokes of a character in a square.
[[nodiscard]] std::vector<ModelStroke> model_strokes(std::span<const kanji::StrokeLine> lines,
                                                     const RuledSquare& square);
/// The same of strokes that have their own widths, such as those of a font.
[[nodiscard]] std::vector<ModelStroke> model_strokes(std::span<const carving::Groove> strokes,
                                                     const RuledSquare& square);

/// The characters that stand as models in the squares of a sheet. A short text is repeated, of a long one
/// each sheet shows the next part.
/// @param text  the characters; spaces are not written. @param squares  their number. @param sheet  counted
/// from 0; it may be any number.
/// @return one for each square; empty where there is no text.
[[nodiscard]] std::vector<char32_t> models_on_sheet(std::u32string_view text, int squares, int sheet);
/// How many sheets the text needs, at least 1.
[[nodiscard]] int sheets_of(std::u32string_view text, int squares);

}  // namespace nazori::calligraphy
