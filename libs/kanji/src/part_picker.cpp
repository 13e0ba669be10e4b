// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/part_picker.h"

#include <algorithm>
#include <utility>

namespace nazori::kanji {

PartPicker::PartPicker(std::vector<PartUse> parts) : parts_(std::move(parts)) {
  for (const PartUse& part : parts_) {
    sorted_.push_back(part.characters);
    std::sort(sorted_.back().begin(), sorted_.back().end());
  }
}

PartPicker::Choice PartPicker::choose(const std::vector<std::string>& chosen) const {
  Choice choice;
  if (chosen.empty()) {
    choice.possible.assign(parts_.size(), true);
    return choice;
  }
  std::vector<std::size_t> rows;
  for (const std::string& element : chosen) {
    const auto row = std::find_if(parts_.begin(), parts_.end(),
                                  [&element](const PartUse& part) { return part.element == element; });
    if (row == parts_.end()) {
      choice.possible.assign(parts_.size(), false);
      return choice;
    }
    rows.push_back(static_cast<std::size_t>(row - parts_.begin()));
  }
  for (const char32_t character : parts_[rows.front()].characters) {
    if (std::all_of(rows.begin(), rows.end(), [&](std::size_t row) {
          return std::binary_search(sorted_[row].begin(), sorted_[row].end(), character);
        }))
      choice.characters.push_back(character);
  }
  for (std::size_t row = 0; row < parts_.size(); ++row) {
    const auto& with = sorted_[row];
    const bool is_chosen = std::find(rows.begin(), rows.end(), row) != rows.end();
    choice.possible.push_back(is_chosen || std::any_of(choice.characters.begin(), choice.characters.end(),
                                                       [&with](char32_t character) {
                                                         return std::binary_search(with.begin(), with.end(),
                                                                                   character);
                                                       }));
  }
  return choice;
}

}  // namespace nazori::kanji
