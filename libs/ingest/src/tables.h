// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace nazori::ingest {

/// The tables of data/, as they are written there.
[[nodiscard]] std::string_view stroke_endings_table();
[[nodiscard]] std::string_view kana_endings_table();
[[nodiscard]] std::string_view alternative_orders_table();
[[nodiscard]] std::string_view radicals_table();
[[nodiscard]] std::string_view basic_words_table();

/// Parts of a text between separators; one more than there are separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// The rows of a table: lines that are neither empty nor begin with '#', cut at tabs.
[[nodiscard]] std::vector<std::vector<std::string_view>> table_rows(std::string_view table);

}  // namespace nazori::ingest
