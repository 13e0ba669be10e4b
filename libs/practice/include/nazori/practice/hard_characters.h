// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/mistake_kind.h"
#include "nazori/study/learner_store.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {

/// The most frequent mistake in one stroke of a character.
struct StrokeTrouble {
  int stroke = 0;  ///< from 0
  kanji::MistakeKind kind = kanji::MistakeKind::wrong;
  int times = 0;     ///< writings with this mistake in this stroke
  int writings = 0;  ///< of the character in the same time

  friend bool operator==(const StrokeTrouble&, const StrokeTrouble&) = default;
};

/// A character that often fails.
struct HardCharacter {
  char32_t character = 0;
  int failed_days = 0;                  ///< days on which its first review failed
  std::optional<StrokeTrouble> stroke;  ///< its hardest stroke, where one goes wrong more than once

  friend bool operator==(const HardCharacter&, const HardCharacter&) = default;
};

/// The last days that make a character hard, today included, and the number of days on which it must fail.
inline constexpr int kHardDays = 28;
inline constexpr int kHardFailures = 2;

/// Characters whose first review failed on kHardFailures or more of the last kHardDays study days: the most
/// often failed first, equally often failed ones by code point. Suspended characters are left out.
/// @param most  maximum number. @return the errors of the store.
[[nodiscard]] base::Result<std::vector<HardCharacter>> hard_characters(const study::LearnerStore& store,
                                                                       std::size_t most);

/// The mistake that is made most often in one stroke of a character, from a day on; of equals the earlier
/// stroke, then the kind that comes first in kanji::MistakeKind. Endings and mistakes that were made once do
/// not count, and neither does what was only watched.
/// @return the errors of the store.
[[nodiscard]] base::Result<std::optional<StrokeTrouble>> stroke_trouble(const study::LearnerStore& store,
                                                                        char32_t character, study::Day first);

/// The same of a stroke of the statistics: the kind that is most frequent in it.
[[nodiscard]] StrokeTrouble trouble_of(const study::HardStroke& stroke);

}  // namespace nazori::practice
