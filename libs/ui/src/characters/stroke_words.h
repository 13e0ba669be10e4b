// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>

#include "nazori/kanji/stroke.h"

namespace nazori::ui {

/// The names and endings of strokes, in the language of the interface.
class StrokeWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::StrokeWords)
 public:
  /// By the type that KanjiVG gives ("㇔/㇏", "㇕b"); empty where it gives none.
  /// @source names after the Unicode chart of CJK strokes (U+31C0..U+31E3) and school usage.
  [[nodiscard]] static QString name(const std::string& type);
  /// "It ends with a stop."
  [[nodiscard]] static QString ending(kanji::StrokeEnding ending);
};

}  // namespace nazori::ui
