// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/kanji/query.h"

namespace nazori::kanji {

/// Finds characters by several parts: each chosen part leaves fewer characters, and fewer parts that go with
/// them. Thread-safe once made.
class PartPicker {
 public:
  /// @param parts  as KanjiDatabase::parts() gives them.
  explicit PartPicker(std::vector<PartUse> parts);

  /// All parts, in the order given.
  [[nodiscard]] const std::vector<PartUse>& parts() const { return parts_; }

  /// What a choice leaves.
  struct Choice {
    std::vector<char32_t>
        characters;              ///< that have all chosen parts, commonest first; empty without a choice
    std::vector<bool> possible;  ///< of each part: chosen, or together with the choice in a character

    friend bool operator==(const Choice&, const Choice&) = default;
  };
  /// @param chosen  elements; a part that is not in the table is in no character.
  [[nodiscard]] Choice choose(const std::vector<std::string>& chosen) const;

 private:
  std::vector<PartUse> parts_;
  std::vector<std::vector<char32_t>> sorted_;  ///< the characters of each part by code point
};

}  // namespace nazori::kanji
