// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>
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
/// The number of a radical by any of its forms: 9 for "亻"; nothing for what is no form.
using RadicalOfForm = std::function<std::optional<int>(const QString& form)>;
/// Reads a radical as it is typed: "9", "9 人", "人" or another of its forms. An empty text is none.
/// @param radical  untouched where the text is refused. @param of_form  knows forms other than the classical
/// ones; empty: there are none. @return whether it was read.
[[nodiscard]] bool read_radical(const QString& typed, std::optional<int>& radical,
                                const RadicalOfForm& of_form = {});

}  // namespace nazori::ui
