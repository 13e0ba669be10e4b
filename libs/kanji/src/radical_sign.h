// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace nazori::kanji {

/// The character that a sign of Unicode's block "CJK Radicals Supplement" stands for: 亻 for ⺅. Any other
/// character itself.
[[nodiscard]] char32_t ideograph_of(char32_t sign);

/// The number of a sign of the block "Kangxi Radicals", which has them in order.
[[nodiscard]] std::optional<int> radical_of_sign(char32_t sign);

}  // namespace nazori::kanji
