// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/author/own_character.h"
#include "nazori/kanji/character.h"

namespace nazori::author {

/// What a check can find. @source svg_* and number_*: the checks of kanjivg-tools; the others: how a groove
/// is read by touch.
enum class FindingKind : std::uint8_t {
  no_strokes,          ///< there is nothing to write; a note where there is a relief
  no_name,             ///< the character has no name
  number_far,          ///< the number of a stroke is far from its start: `amount` glyph units
  numbers_overlap,     ///< two numbers cover one another: `stroke`, `second`
  number_hides_start,  ///< the number of `stroke` covers the start of `second`
  part_empty,          ///< a part has no strokes: `text` its name
  stroke_in_no_part,   ///< there are parts, but none has this stroke
  outside,             ///< a point is not in the picture; the first of each stroke
  no_length,           ///< the stroke is shorter than 1 glyph unit: `amount`
  doubled,             ///< `second` lies on `stroke` along its whole length
  ending_differs,      ///< it is to stop but narrows over its last 15 %, or is a hook or sweep and does not
  point_off_line,      ///< the line turns back at a point: `amount` degrees, more than 160
  too_shallow,         ///< the body of a groove is less than kReadableDepth deep: `amount`
  too_narrow,          ///< the body of a groove is narrower than the tip: `amount` glyph units
  thin_wall,           ///< the wall between two strokes is thinner than the tip: `amount` glyph units
  count_differs,       ///< the dictionary counts other strokes: `amount` many
  licence_lost,        ///< it comes from KanjiVG, and its licence or authors are not named
  no_licence,          ///< an own drawing whose licence is not said
  svg_view_box,        ///< viewBox is not "0 0 109 109"
  svg_size,            ///< width or height is not 109
  svg_root_id,         ///< the groups of paths and numbers are not named after one character
  svg_style,           ///< one of these groups has no style
  svg_group_id,        ///< a group is not named after the character, -g and its number: `text`
  svg_stroke_id,       ///< a stroke is not named after the character, -s and its number: `text`
  svg_number_count,    ///< there are other numbers than strokes: `amount` many
  svg_number_order,    ///< the numbers are not 1, 2, 3 and so on: `text`
};

/// How much a finding matters.
enum class Severity : std::uint8_t {
  note,     ///< may be meant so
  warning,  ///< harder to read or to write
  error,    ///< wrong, or not allowed to be passed on
};

/// What a check found, as data.
struct Finding {
  FindingKind kind = FindingKind::no_strokes;
  Severity severity = Severity::warning;
  std::optional<std::size_t> stroke = {};  ///< 0-based
  std::optional<std::size_t> point = {};   ///< 0-based, of that stroke
  std::optional<std::size_t> second = {};  ///< another stroke
  std::optional<geometry::GlyphPoint> at = {};
  double amount = 0;
  std::string text = {};
  friend bool operator==(const Finding&, const Finding&) = default;
};

/// A groove that is less deep is hard to follow, as a share of the tablet's depth. @source 1 mm of 10 mm: the
/// height of a line that fingers follow with certainty (guidelines for tactile graphics, docs/tactile.md).
inline constexpr double kReadableDepth = 0.1;

/// What is asked of a character.
struct CheckSettings {
  double tip = 1.1;  ///< diameter of the stylus' tip [glyph units]; 1 mm on a tablet of 100 mm
  const kanji::DictionaryEntry* dictionary = nullptr;  ///< of the character; null: not known
};

/// Looks a character over. The findings are in a fixed order: by kind, then by stroke.
[[nodiscard]] std::vector<Finding> check(const OwnCharacter& character, const CheckSettings& settings = {});

/// Looks the text of an SVG file over, as KanjiVG's tools do: ids, styles, size and numbers. Empty for what
/// is no SVG of this kind: parse_strokes_svg() says why.
[[nodiscard]] std::vector<Finding> check_svg(std::string_view svg);

/// A stable name for scripts: "thin_wall".
[[nodiscard]] std::string_view name_of(FindingKind kind);
[[nodiscard]] std::string_view name_of(Severity severity);

}  // namespace nazori::author
