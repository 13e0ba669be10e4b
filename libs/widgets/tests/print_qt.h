// SPDX-License-Identifier: Apache-2.0
// What a failed comparison prints of Qt's strings and widgets.
#pragma once

#include <QString>
#include <QWidget>
#include <ostream>
#include <string>

/// As text, not as a list of 2-byte objects.
inline void PrintTo(const QString& text, std::ostream* out) { *out << '"' << text.toStdString() << '"'; }

/// The parts of a widget that need more than `width`, each with what it needs.
inline std::string widest_parts(const QWidget* whole, int width) {
  std::string parts;
  for (const auto* part : whole->findChildren<QWidget*>())
    if (part->isVisibleTo(whole) && part->minimumSizeHint().width() > width - 16)
      parts += std::string("\n  ") + part->metaObject()->className() + ' ' +
               part->objectName().toStdString() + " \"" + part->property("text").toString().toStdString() +
               "\" " + std::to_string(part->minimumSizeHint().width());
  return parts;
}
