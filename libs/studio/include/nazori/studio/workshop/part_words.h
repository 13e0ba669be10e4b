// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>

#include "nazori/author/own_character.h"
#include "nazori/base/result.h"

namespace nazori::ui {

/// "亻: strokes 1, 2".
[[nodiscard]] QString part_words(const author::OwnPart& part);
/// The strokes of a part as they are typed: "1, 2" or "1-3", also with Japanese commas and full-width digits.
/// @return the errors of author::parse_stroke_numbers().
[[nodiscard]] base::Result<std::vector<int>> read_strokes(const QString& typed, std::size_t count);

/// The classical form of a radical: "人" for 9.
/// @param radical  1..214. @source the block Kangxi Radicals of Unicode, whose characters are in the order of
/// the numbers and name the ideograph that each stands for.
[[nodiscard]] QString radical_form(int radical);
/// "9 人"; empty for none.
[[nodiscard]] QString radical_words(std::optional<int> radical);
/// Reads a radical as it is typed: "9", "9 人" or "人". An empty text is none.
/// @param radical  untouched where the text is refused. @return whether it was read.
[[nodiscard]] bool read_radical(const QString& typed, std::optional<int>& radical);

}  // namespace nazori::ui
