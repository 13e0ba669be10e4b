// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "character_json.h"
#include "console.h"
#include "nazori/base/result.h"
#include "nazori/writing/written_character.h"

namespace nazori::cli {

/// Answers each line of standard input, a JSON object, with one line of JSON, sent at once. Empty lines are
/// passed over. A line that `answer` refuses, or that is no object, gets `refusal` with "line" and "error"
/// added. An "id" is handed back.
/// @return kDone, or kWrong where a line was refused.
[[nodiscard]] int answer_lines(Console& console, const Json& refusal,
                               const std::function<base::Result<Json>(const Json& request)>& answer);

/// The strokes of a request: "strokes" [[[x, y], ...], ...], and where given "times" [[ms, ...], ...],
/// "pressures" [[0..1, ...], ...] and "box" [left, top, side]. Without a box, coordinates that are all within
/// 0..1 are those of a box of side 1.
[[nodiscard]] base::Result<writing::WrittenCharacter> read_ink(const Json& request);

}  // namespace nazori::cli
