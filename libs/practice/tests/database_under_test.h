// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "nazori/geometry/point.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::practice::test {

/// kanji.db as made by `nazori-cli database build`.
inline std::filesystem::path database() {
  const char* const folder = std::getenv("NAZORI_DATA");
  return std::filesystem::path(folder != nullptr ? folder : ".") / "kanji.db";
}

/// The strokes of a character as KanjiVG draws them.
inline std::vector<std::vector<geometry::GlyphPoint>> model(char32_t character) {
  std::vector<std::vector<geometry::GlyphPoint>> strokes;
  for (const auto& line : kanji::KanjiDatabase::open(database())->find(character)->lines())
    strokes.push_back(line.points);
  return strokes;
}

}  // namespace nazori::practice::test
