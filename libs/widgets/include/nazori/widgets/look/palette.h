// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPalette>

namespace nazori::ui {

/// The colours of the window: paper, ink and one accent. Each has one meaning everywhere.
struct Colours {
  QColor paper;    ///< behind everything
  QColor surface;  ///< fields and tiles
  QColor line;     ///< thin separators
  QColor
      edge;    ///< borders of what can be operated: fields, buttons, check boxes, scroll bars; 3 : 1 at least
  QColor ink;  ///< text
  QColor muted;      ///< secondary text, okurigana
  QColor vermilion;  ///< the current stroke, the one button to press next; with a cross: wrong
  QColor indigo;     ///< links, selection, the focus ring
  QColor moss;       ///< right, always with a tick
  QColor amber;      ///< advice, always with a sign
};

[[nodiscard]] const Colours& light_colours();
[[nodiscard]] const Colours& dark_colours();

/// A palette is dark when its text is lighter than its window.
[[nodiscard]] bool is_dark(const QPalette& palette);

/// The colours in force, by the application's palette. (A widget's own palette is changed by the style
/// sheet.)
[[nodiscard]] const Colours& current_colours();

/// Qt's palette made from the colours.
[[nodiscard]] QPalette make_palette(const Colours& colours);

/// `front` laid over `back` with the given share, 0..1.
[[nodiscard]] QColor blend(const QColor& back, const QColor& front, double share);

/// Contrast ratio, 1..21. @source WCAG 2.2, definition of contrast ratio.
[[nodiscard]] double contrast_ratio(const QColor& a, const QColor& b);

}  // namespace nazori::ui
