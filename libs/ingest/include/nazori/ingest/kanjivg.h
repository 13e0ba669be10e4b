// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"

namespace nazori::ingest {

/// A drawn form from a file of KanjiVG.
struct DrawnForm {
  char32_t code_point = 0;
  std::string variant;                 ///< suffix of the file name, empty for the main form
  std::vector<kanji::Stroke> strokes;  ///< in writing order, endings not yet known
  kanji::Component components;         ///< root of the group tree
};

/// The parts of the name of a KanjiVG file.
struct FormName {
  char32_t code_point = 0;
  std::string variant;
  friend bool operator==(const FormName&, const FormName&) = default;
};

/// "04f11.svg" or "04f11-Kaisho.svg"; nullopt for any other name.
[[nodiscard]] std::optional<FormName> parse_form_name(std::string_view file_name);

/// Reads an SVG file of KanjiVG.
/// @return Errc::parse for text that is not XML, has no strokes, more than 200 of them, groups nested deeper
/// than 50, a path that is not a stroke or that leaves the box by more than its side.
[[nodiscard]] base::Result<DrawnForm> parse_kanjivg_svg(const FormName& name, std::span<const char> svg);

}  // namespace nazori::ingest
