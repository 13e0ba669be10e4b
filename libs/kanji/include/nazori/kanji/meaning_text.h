// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace nazori::kanji {

/// Normalises an English meaning for searching: lower case, each run of anything but letters, digits and
/// apostrophes becomes one space, none at the ends. Letters beyond ASCII are unchanged. "Day off (work)"
/// gives "day off work".
[[nodiscard]] std::string fold_meaning(std::string_view meaning);

}  // namespace nazori::kanji
