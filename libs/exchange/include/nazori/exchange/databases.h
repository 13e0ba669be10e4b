// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/exchange/document.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::exchange {

/// How many of what a kanji database holds, by the names of docs/schemas/database.json.
using DatabaseCounts = std::span<const std::pair<std::string_view, std::int64_t>>;

/// The place of a database (docs/schemas/database.json, path).
[[nodiscard]] Value database_path(const std::string& path);

/// A database that was built.
struct BuiltDatabase {
  std::uintmax_t bytes = 0;
  double took_s = 0;
  DatabaseCounts counts;
  std::vector<std::string> left_out;  ///< lines of the sources that cannot be read: "edict:24"
};
/// docs/schemas/database.json, build. @param built  nothing where it was up to date.
[[nodiscard]] Value to_json(const std::string& path, const std::optional<BuiltDatabase>& built);

/// A database that was checked (docs/schemas/database.json, check).
[[nodiscard]] Value checked_database(const std::string& path, std::uintmax_t bytes, DatabaseCounts counts,
                                     std::span<const kanji::Source> sources);

}  // namespace nazori::exchange
