// SPDX-License-Identifier: Apache-2.0
#include "basic_words.h"

#include <set>
#include <utility>

#include "tables.h"

namespace nazori::ingest {

bool is_basic(const EdictEntry& word) {
  using Key = std::pair<std::string_view, std::string_view>;
  static const auto words = [] {
    std::set<Key> all;
    for (const auto& row : table_rows(basic_words_table())) all.emplace(row.at(0), row.at(1));
    return all;
  }();
  return words.contains(Key(word.text, word.reading));
}

}  // namespace nazori::ingest
