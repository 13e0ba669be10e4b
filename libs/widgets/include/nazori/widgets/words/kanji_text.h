// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QFont>
#include <QString>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/kanji/kun_reading.h"

namespace nazori::ui {

[[nodiscard]] QString to_text(char32_t code_point);
[[nodiscard]] QString to_text(std::string_view utf8);

/// Texts with something between them. @param most  of them, from the first.
[[nodiscard]] QString joined(const std::vector<std::string>& texts, const QString& between,
                             std::size_t most = SIZE_MAX);

/// A kun reading as shown to the learner: "やす・む".
[[nodiscard]] QString kun_plain(const kanji::KunReading& reading);

/// The same as rich text, okurigana in `muted`.
[[nodiscard]] QString kun_rich(const kanji::KunReading& reading, const QColor& muted);

/// Klee One, the school-book hand, in points; the font's own fallback where it is not installed.
[[nodiscard]] QFont textbook_font(double point_size, int weight = QFont::Normal);

/// Characters whose form somebody made instead of the published one, and the font that has these forms.
/// Thread: interface.
void set_own_forms(const QString& family, const std::set<char32_t>& characters);
/// As textbook_font(), for one character: the font of own forms where somebody made its form.
[[nodiscard]] QFont character_font(const QString& text, double point_size, int weight = QFont::Normal);

/// Whether the textbook font itself has the character; what it lacks is drawn from its strokes.
[[nodiscard]] bool textbook_font_has(char32_t code_point);

}  // namespace nazori::ui
