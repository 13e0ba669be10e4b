// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QFont>
#include <QString>
#include <string>
#include <string_view>

namespace nazori::ui {

[[nodiscard]] QString to_text(char32_t code_point);
[[nodiscard]] QString to_text(std::string_view utf8);

/// A kun reading as KANJIDIC2 writes it, taken apart: "やす.む" is the stem やす, which the kanji stands for,
/// and the okurigana む, which follows it in kana. A hyphen marks a reading used only as the end or the
/// beginning of a word.
struct KunReading {
  QString stem;
  QString okurigana;
  bool as_suffix = false;
  bool as_prefix = false;
};
[[nodiscard]] KunReading split_kun(std::string_view reading);

/// "やす・む", with a wave dash where the hyphen stood.
[[nodiscard]] QString kun_plain(const KunReading& reading);

/// The same as rich text, okurigana in `muted`.
[[nodiscard]] QString kun_rich(const KunReading& reading, const QColor& muted);

/// Klee One, the school-book hand, in points; the font's own fallback where it is not installed.
[[nodiscard]] QFont textbook_font(double point_size, int weight = QFont::Normal);

/// Whether the textbook font itself has the character; what it lacks is drawn from its strokes.
[[nodiscard]] bool textbook_font_has(char32_t code_point);

}  // namespace nazori::ui
