// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "nazori/ingest/kanjivg.h"

namespace nazori::ingest {

/// The orders of data/alternative_orders.tsv by character.
[[nodiscard]] std::map<char32_t, std::vector<kanji::AlternativeOrder>> listed_orders();

/// The order in which a variant writes the strokes of the main form, as stroke numbers of the main form;
/// nullopt if the variant has other strokes. Strokes are matched by their ends so that the sum of the
/// distances is smallest; none may be farther apart than 20 glyph units.
[[nodiscard]] std::optional<std::vector<int>> order_of_variant(const DrawnForm& main,
                                                               const DrawnForm& variant);

/// Whether a suffix of KanjiVG means another order of strokes, and not (only) for another form: "HzFst",
/// "KaishoVtLst", but not "Kaisho" or "Insatsu".
[[nodiscard]] bool names_an_order(std::string_view suffix);

}  // namespace nazori::ingest
