// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "nazori/exchange/document.h"
#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::exchange {

/// "stop", "hook", "taper", "either".
[[nodiscard]] std::string_view name_of(kanji::StrokeEnding ending);

/// Everything known of a character (docs/schemas/characters.json, character). Numbers of strokes are 1-based.
[[nodiscard]] Value to_json(const kanji::Character& character, const std::optional<kanji::Radical>& radical,
                            std::span<const kanji::Word> words);
/// One line of the answer to a search (docs/schemas/characters.json, search).
[[nodiscard]] Value to_json(const kanji::Summary& summary);

}  // namespace nazori::exchange
