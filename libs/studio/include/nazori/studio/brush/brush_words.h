// SPDX-License-Identifier: Apache-2.0
// Names and sentences about brush, ink and paper.
#pragma once

#include <QString>
#include <span>
#include <string_view>

#include "nazori/author/font_model.h"
#include "nazori/calligraphy/sheet_editor.h"
#include "nazori/practice/brush_session.h"
#include "nazori/studio/brush/paper_view.h"

namespace nazori::ui {

/// Names of what can be chosen, with what it is for: "Hanshi (practice paper)".
[[nodiscard]] QString paper_name(std::string_view paper);
[[nodiscard]] QString ink_name(std::string_view ink);
[[nodiscard]] QString hair_name(brush::Hair hair);
[[nodiscard]] QString brush_size_name(calligraphy::BrushSize size);
/// "4 characters".
[[nodiscard]] QString ruling_name(int characters);
/// The font of a model; an empty family is printed lines.
[[nodiscard]] QString font_name(std::string_view family);
/// How to get the brush fonts that are not installed; empty where all of them are.
[[nodiscard]] QString font_packages_words(std::span<const author::BrushFont> installed);

/// What is in the brush: "Brush: 80% full, ink 100%."
[[nodiscard]] QString brush_words(const calligraphy::SheetState& state);
/// What is on the paper: "3 strokes, wet."
[[nodiscard]] QString paper_words(const calligraphy::SheetState& state);
/// The model of a review, by its place.
[[nodiscard]] practice::BrushModel brush_model_of(ModelPlace place);
/// The sentence after undo and redo.
[[nodiscard]] QString undo_words(calligraphy::Edit edit, int strokes);
[[nodiscard]] QString redo_words(calligraphy::Edit edit, int strokes);

}  // namespace nazori::ui
