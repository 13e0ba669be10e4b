// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace nazori::writing {

/// Two forms closer than the first limit have no difference that could be graded (カ and 力); those closer
/// than the second are easily mistaken for each other (土 and 士). Units of distance_of_forms().
inline constexpr double kSameToTheEye = 3;
inline constexpr double kEasilyMistaken = 45;

/// Kanji or kana with the same number of strokes that differ from `character` only in lengths, ends or
/// proportions, so that one is easily written instead of the other; ascending. Kanji are compared with kanji,
/// kana with full-size kana.
[[nodiscard]] std::vector<char32_t> lookalikes_of(char32_t character);

}  // namespace nazori::writing
