// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/base/result.h"
#include "nazori/exchange/document.h"
#include "nazori/writing/written_character.h"

namespace nazori::exchange {

/// The strokes of a request: "strokes" [[[x, y], ...], ...], and where given "times" [[ms, ...], ...],
/// "pressures" [[0..1, ...], ...] and "box" [left, top, side]. Without a box, coordinates that are all within
/// 0..1 are those of a box of side 1. Other members are passed over. What the strokes mean is not looked at:
/// writing::check() does that.
/// @return Errc::parse or Errc::bad_argument with the member in Error::where ("strokes[0][2]").
[[nodiscard]] base::Result<writing::WrittenCharacter> read_handwriting(const Value& request);

/// An object that read_handwriting() reads back: "times" and "pressures" where every stroke has them.
[[nodiscard]] Value to_json(const writing::WrittenCharacter& ink);

}  // namespace nazori::exchange
