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

/// Strokes of a character that went wrong more than once, the worst first; endings do not count. Empty where
/// the history cannot be read, which is announced.
/// @param most  of them.
[[nodiscard]] std::vector<HardStroke> hard_strokes(Learner& learner, char32_t character, std::size_t most);

/// A character as the learner wrote it from memory once.
struct EarlierWriting {
  study::Handwriting ink;
  study::Day day{};
  study::Rating rating = study::Rating::good;
};

/// The newest writings of a character from memory that were saved with their handwriting, the newest first.
/// What cannot be read is announced: a writing is left out then.
/// @param most  of them.
/// @return nothing where the history cannot be read.
[[nodiscard]] std::optional<std::vector<EarlierWriting>> earlier_writings(Learner& learner,
                                                                          char32_t character,
                                                                          std::size_t most);

}  // namespace nazori::practice
