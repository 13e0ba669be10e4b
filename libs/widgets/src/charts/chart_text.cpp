// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/charts/chart_text.h"

#include <QCoreApplication>

namespace nazori::ui {

QString Numbers::as_text() const {
  QString text = head.join(QLatin1Char('\t'));
  for (const QStringList& row : rows) text += QLatin1Char('\n') + row.join(QLatin1Char('\t'));
  return text + QLatin1Char('\n');
}

QString Numbers::row_text(int row) const {
  if (row < 0 || row >= rows.size() || rows[row].isEmpty()) return {};
  const QStringList& cells = rows[row];
  QStringList parts;
  for (qsizetype i = 1; i < cells.size() && i < head.size(); ++i)
    parts.append(QCoreApplication::translate("nazori::ui::Numbers", "%1 %2", "head of a column, its number")
                     .arg(head[i], cells[i]));
  return QCoreApplication::translate("nazori::ui::Numbers", "%1: %2", "a row of a table, its numbers")
      .arg(cells[0], parts.join(QStringLiteral(", ")));
}

}  // namespace nazori::ui
