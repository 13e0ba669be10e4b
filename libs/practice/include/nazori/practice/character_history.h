// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nazori/practice/learner.h"
#include "nazori/study/card.h"
#include "nazori/study/handwriting.h"

namespace nazori::practice {

/// A stroke that went wrong more than once.
struct HardStroke {
  int stroke = 0;  ///< from 0
  int times = 0;

  friend bool operator==(const HardStroke&, const HardStroke&) = default;
};

/// Strokes of a character that went wrong more than once, the most frequent first; endings do not count. If
/// the history cannot be read, announces it and returns nothing.
/// @param most  maximum number of strokes.
[[nodiscard]] std::vector<HardStroke> hard_strokes(Learner& learner, char32_t character, std::size_t most);

/// A character as the learner wrote it from memory once.
struct EarlierWriting {
  study::Handwriting ink;
  study::Day day{};
  study::Rating rating = study::Rating::good;
};

/// The newest writings of a character from memory that were saved with their handwriting, the newest first. A
/// writing that cannot be read is announced and left out.
/// @param most  maximum number of writings.
/// @return nothing where the history cannot be read.
[[nodiscard]] std::optional<std::vector<EarlierWriting>> earlier_writings(Learner& learner,
                                                                          char32_t character,
                                                                          std::size_t most);

}  // namespace nazori::practice
