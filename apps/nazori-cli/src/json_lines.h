// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "console.h"
#include "json_answers.h"
#include "nazori/base/result.h"

namespace nazori::cli {

/// Answers each line of standard input, as exchange::reply_to() does, with one line that is sent at once.
/// Empty lines are passed over.
/// @return kDone, or kWrong where a line was refused.
[[nodiscard]] int answer_lines(Console& console, const Json& refusal,
                               const std::function<base::Result<Json>(const Json& request)>& answer);

}  // namespace nazori::cli
