// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::cli {

/// JSON whose members keep the order they were added in, so that output is the same every time.
using Json = nlohmann::ordered_json;

/// "stop", "hook", "taper", "either".
[[nodiscard]] std::string_view ending_name(kanji::StrokeEnding ending);

/// Everything known of a character; its form is documented in docs/command-line.md. Numbers of strokes are
/// 1-based.
[[nodiscard]] Json to_json(const kanji::Character& character, const std::optional<kanji::Radical>& radical,
                           std::span<const kanji::Word> words);
[[nodiscard]] Json to_json(const kanji::Summary& summary);

/// Text of a document, two spaces a level, with a line break at the end.
[[nodiscard]] std::string to_text(const Json& document);

}  // namespace nazori::cli
