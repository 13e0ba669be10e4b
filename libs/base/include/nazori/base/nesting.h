// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace nazori::base {

/// Whether the brackets and braces of a JSON text are nested deeper than `most`; those inside strings do not
/// count. Asked before parsing what a stranger wrote: the depth of the parser's recursion, and of freeing the
/// result, is the text's. Time linear in the text; any bytes.
[[nodiscard]] bool is_nested_deeper(std::string_view json, int most);

}  // namespace nazori::base
