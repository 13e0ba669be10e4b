// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace nazori::writing {

/// Two forms closer than the first have no difference to judge by (カ and 力); those closer than the second
/// are easily written for each other (土 and 士). Units of distance_of_forms().
inline constexpr double kSameToTheEye = 3;
inline constexpr double kEasilyMistaken = 45;

/// Kanji or kana of as many strokes that differ from `character` only in lengths, ends or proportions, so
/// that one is easily written for the other; ascending. Kanji are compared with kanji, kana with kana that
/// are not the small ones.
[[nodiscard]] std::vector<char32_t> lookalikes_of(char32_t character);

}  // namespace nazori::writing
