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

/// What a check can find. @source kinds from `number_missing` to `number_far`: the checks of kanjivg-tools
/// that have a meaning for a document that is not text (the others hold for every file that is written here,
/// and check_svg() looks for them in a file); the rest: how a groove is read by touch.
enum class FindingKind : std::uint8_t {
  no_strokes,          ///< there is nothing to write
  no_name,             ///< the character has no name
  number_far,          ///< the number of a stroke is far from its start: `amount` glyph units
  numbers_overlap,     ///< two numbers cover one another: `stroke`, `second`
  number_hides_start,  ///< the number of `stroke` covers the start of `second`
  part_empty,          ///< a part has no strokes: `text` its name
  stroke_in_no_part,   ///< there are parts, but none has this stroke
  outside,             ///< a point is not in the picture
  no_length,           ///< the stroke is shorter than it is broad at its start, or a dot of no length
  doubled,             ///< `second` lies on `stroke` along its whole length
  ending_differs,      ///< the ending is not the one that the last 15 % of the groove have
  point_off_line,      ///< a point is a spike: the line turns back there by more than 150 degrees
  too_shallow,         ///< the body of a groove is less than kReadableDepth deep: `amount`
  too_narrow,          ///< the body of a groove is narrower than the tip: `amount` in glyph units
  thin_wall,           ///< the wall between two strokes is thinner than the tip: `amount` in glyph units
  count_differs,       ///< the dictionary counts other strokes: `amount` many
  licence_lost,        ///< it comes from KanjiVG, and licence or authors are not named
  no_licence,          ///< an own drawing whose licence is not said
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

/// A groove that is less deep is hard to follow. @source the shallowest groove that a stylus stays in at the
/// default forces, 0.15 of 10 mm; see docs/workshop.md.
inline constexpr double kReadableDepth = 0.15;

/// What is asked of a character.
struct CheckSettings {
  double tip = 2.2;                                    ///< diameter of the stylus' tip [glyph units]
  const kanji::DictionaryEntry* dictionary = nullptr;  ///< of the character; null: not known
};

/// Looks a character over. The findings are in a fixed order: by kind, then by stroke.
[[nodiscard]] std::vector<Finding> check(const OwnCharacter& character, const CheckSettings& settings = {});

/// A stable name for scripts: "thin_wall".
[[nodiscard]] std::string_view name_of(FindingKind kind);
[[nodiscard]] std::string_view name_of(Severity severity);

}  // namespace nazori::author
