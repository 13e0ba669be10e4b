// SPDX-License-Identifier: Apache-2.0
// The real kanji.db, built from the published sources.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::kanji {

/// Where NAZORI_DATA, or the current folder, has it.
inline std::filesystem::path published_database_file() {
  const char* const folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe)
  return std::filesystem::path(folder == nullptr ? "." : folder) / "kanji.db";
}

/// Opened once for each program.
inline const KanjiDatabase& database() {
  static const auto opened_once = [] {
    auto opened = KanjiDatabase::open(published_database_file());
    if (!opened) {
      ADD_FAILURE() << base::to_line(opened.error());
      std::abort();
    }
    return std::move(*opened);
  }();
  return opened_once;
}

/// A character that must be there.
inline Character find(char32_t c) {
  auto found = database().find(c);
  EXPECT_TRUE(found) << base::encode_utf8(c);
  return found.value_or(Character{});
}

/// The characters of a list, in its order.
inline std::u32string characters(const std::vector<Summary>& summaries) {
  std::u32string out;
  for (const Summary& s : summaries) out += s.code_point;
  return out;
}

}  // namespace nazori::kanji
