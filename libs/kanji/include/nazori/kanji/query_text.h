// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nazori/kanji/query.h"

namespace nazori::kanji {

/// A search as it is typed into one line.
struct TypedQuery {
  Query query;
  /// Lists and tags of the learner, as study::CharacterLists::members() reads them: "list:NAME", "tag:NAME".
  std::vector<std::string> lists;

  friend bool operator==(const TypedQuery&, const TypedQuery&) = default;
};

/// Reads conditions out of a typed line; what is no condition is the text to search for. Words are apart by
/// blanks; full-width letters and signs count as plain ones, and letters in either case.
///
///     6画  6-8画  strokes:6  画数:6-8        number of strokes, from 1 to 200
///     radical:9  radical:亻  部首:亻         radical
///     parts:木日  パーツ:木日                parts
///     skip:1-2-4  1-2-4  skip:1-2            SKIP code or its beginning
///     corner:2429.0  24290  2429  四角:2429  four-corner code or its beginning
///     grade:3  学年:3                        school grade 1..10
///     jlpt:4                                 JLPT level of before 2010, 4..1
///     freq:500  頻度:500                     one of the 500 most frequent
///     list:NAME  tag:"MY TAG"                a list or tag of the learner
///
/// A condition with a value that cannot be is text; one without a value is left out.
[[nodiscard]] TypedQuery read_query(std::string_view typed);

/// A typed line with another value of one condition: "rest parts:木" with "parts", "木日" gives "rest
/// parts:木日".
/// @param key  as read_query() reads it, in English. @param value  empty: without the condition.
[[nodiscard]] std::string with_condition(std::string_view typed, std::string_view key,
                                         std::string_view value);

/// Whether a text has the form of a SKIP code or of its beginning: "1-2-4", "1-2", "4-". The kind is 1..4.
[[nodiscard]] bool is_skip(std::string_view text);
/// Whether a text has the form of a four-corner code or of its beginning with at least one digit: "2429.0",
/// "24290", "2429".
[[nodiscard]] bool is_four_corner(std::string_view text);

}  // namespace nazori::kanji
