// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace nazori::kanji {

/// An English meaning as it is searched: lower case, each run of anything but letters, digits and apostrophes
/// one space, none at the ends. Letters beyond ASCII stay as they are. "Day off (work)" gives "day off work".
[[nodiscard]] std::string fold_meaning(std::string_view meaning);

}  // namespace nazori::kanji
