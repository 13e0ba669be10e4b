// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "nazori/author/check.h"
#include "nazori/author/workbench.h"

namespace nazori::ui {

/// "Draw strokes".
[[nodiscard]] QString tool_name(author::Tool tool);
[[nodiscard]] QString stamp_name(author::StampShape shape);
/// Stop, hook or sweep.
[[nodiscard]] QString ending_name(kanji::StrokeEnding ending);
/// What was done, undone or redone: "Stroke drawn.", "Undone: stroke drawn."
[[nodiscard]] QString edit_words(author::EditKind kind, author::EditWay way);
/// "Stroke 2 of 5, sweep, 4 points. Point 1: start." Empty where nothing is chosen.
[[nodiscard]] QString selection_words(const author::OwnCharacter& character,
                                      const author::Selection& selection);
/// "永: 5 strokes. The relief was changed by hand."
[[nodiscard]] QString character_words(const author::OwnCharacter& character);
/// One finding of a check: "Stroke 2: too shallow to feel."
[[nodiscard]] QString finding_words(const author::Finding& finding);
/// An entry of the list of strokes: "2  sweep".
[[nodiscard]] QString stroke_words(std::size_t number, const author::OwnStroke& stroke);

}  // namespace nazori::ui
