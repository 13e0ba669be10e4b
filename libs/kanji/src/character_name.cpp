// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/character_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/own_characters.h"

namespace nazori::kanji {
namespace {

constexpr std::string_view kHowToName = "name characters as 休, 休-Kaisho or U+4F11";

bool is_suffix_letter(char32_t c) {
  return (c >= U'0' && c <= U'9') || (c >= U'A' && c <= U'Z') || (c >= U'a' && c <= U'z');
}

/// "U+4F11", perhaps with the suffix of a variant form.
bool names_code_point(std::string_view text) {
  return text.size() >= 3 && (text[0] == 'U' || text[0] == 'u') && text[1] == '+';
}
std::optional<CharacterName> parse_code_point(std::string_view text) {
  const std::string_view digits = text.substr(2, text.find('-') - 2);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size() || value > 0x10FFFF ||
      (value >= 0xD800 && value <= 0xDFFF))
    return std::nullopt;
  const std::size_t dash = text.find('-');
  if (dash == std::string_view::npos) return CharacterName{static_cast<char32_t>(value), ""};
  const std::string_view suffix = text.substr(dash + 1);
  if (suffix.empty() || !std::all_of(suffix.begin(), suffix.end(), is_suffix_letter)) return std::nullopt;
  return CharacterName{static_cast<char32_t>(value), std::string(suffix)};
}

bool is_passed_over(char32_t c) {
  return c == U' ' || c == U'\u3000' || (c >= 0xFE00 && c <= 0xFE0F) || (c >= 0xE0100 && c <= 0xE01EF);
}

/// A character followed by a hyphen and the suffix of a variant form.
bool names_variant(std::u32string_view text) { return text.size() >= 2 && text[1] == U'-'; }
std::optional<CharacterName> parse_variant(std::u32string_view text) {
  if (text.size() < 3) return std::nullopt;
  const std::u32string_view suffix = text.substr(2);
  if (!std::all_of(suffix.begin(), suffix.end(), is_suffix_letter)) return std::nullopt;
  return CharacterName{text[0], base::encode_utf8(suffix)};
}

}  // namespace

std::string CharacterName::text() const {
  // No font of a terminal has own characters.
  const bool has_letter = code_point > 0x20 && code_point != 0x7F && !is_own(code_point);
  std::string name = has_letter ? base::encode_utf8(code_point) : code_point_text(code_point);
  if (!variant.empty()) name += "-" + variant;
  return name;
}

std::string CharacterName::file_name() const {
  if (code_point != U'/' && code_point != U'.') return text();
  return code_point_text(code_point) + (variant.empty() ? "" : "-" + variant);
}

std::string code_point_text(char32_t code_point) {
  return fmt::format("U+{:04X}", static_cast<std::uint32_t>(code_point));
}

base::Result<std::vector<CharacterName>> parse_characters(std::span<const std::string> arguments) {
  std::vector<CharacterName> names;
  const auto add = [&names](CharacterName name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  };
  for (const std::string& argument : arguments) {
    const auto text = base::decode_utf8(argument);
    if (!text) {
      return base::fail(base::Errc::bad_argument, "is not valid UTF-8", "'" + argument + "'",
                        std::string(kHowToName));
    }
    if (names_code_point(argument) || names_variant(*text)) {
      auto name = names_code_point(argument) ? parse_code_point(argument) : parse_variant(*text);
      if (!name) {
        return base::fail(base::Errc::bad_argument, "is not the name of a character", "'" + argument + "'",
                          std::string(kHowToName));
      }
      add(std::move(*name));
      continue;
    }
    const std::size_t before = names.size();
    bool any = false;
    for (std::size_t i = 0; i < text->size(); ++i) {
      char32_t c = (*text)[i];
      if (is_passed_over(c)) continue;
      any = true;
      if (i + 1 < text->size()) {
        if (const char32_t whole = with_sound_mark(c, (*text)[i + 1]); whole != 0) {
          c = whole;
          ++i;
        }
      }
      add({c, ""});
    }
    if (!any && names.size() == before) {
      return base::fail(base::Errc::bad_argument, "contains no character", "'" + argument + "'",
                        std::string(kHowToName));
    }
  }
  return names;
}

CharacterName name_of(const Character& character) { return {character.code_point, character.variant}; }

}  // namespace nazori::kanji
