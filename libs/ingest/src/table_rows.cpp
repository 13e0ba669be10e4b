// SPDX-License-Identifier: Apache-2.0
#include "tables.h"

namespace nazori::ingest {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> out;
  while (true) {
    const std::size_t at = text.find(separator);
    out.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return out;
    text.remove_prefix(at + 1);
  }
}

std::vector<std::vector<std::string_view>> table_rows(std::string_view table) {
  std::vector<std::vector<std::string_view>> out;
  for (const std::string_view line : split(table, '\n')) {
    if (!line.empty() && line.front() != '#') out.push_back(split(line, '\t'));
  }
  return out;
}

}  // namespace nazori::ingest
