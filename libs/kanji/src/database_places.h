// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::kanji {

/// Where a program looks for kanji.db, in the order of KanjiDatabase::locate().
/// @param program its file; empty where that is not known.
[[nodiscard]] std::vector<std::filesystem::path> database_places(const std::filesystem::path& program);

/// What KanjiDatabase::locate() answers to that program.
[[nodiscard]] base::Result<std::filesystem::path> locate_for(const std::filesystem::path& program);

/// What KanjiDatabase::place_to_build() answers to that program.
[[nodiscard]] base::Result<std::filesystem::path> place_to_build_for(const std::filesystem::path& program);

}  // namespace nazori::kanji
