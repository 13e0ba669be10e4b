// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/style_sheet.h"

#include <QHash>
#include <QRegularExpression>

#include "nazori/widgets/look/resources.h"

namespace nazori::ui {

QString style_sheet(const Colours& c) {
  const QHash<QString, QString> values{
      {QStringLiteral("paper"), c.paper.name()},
      {QStringLiteral("surface"), c.surface.name()},
      {QStringLiteral("line"), c.line.name()},
      {QStringLiteral("edge"), c.edge.name()},
      {QStringLiteral("ink"), c.ink.name()},
      {QStringLiteral("muted"), c.muted.name()},
      {QStringLiteral("indigo"), c.indigo.name()},
      {QStringLiteral("vermilion"), c.vermilion.name()},
      {QStringLiteral("indigo_hover"), blend(c.indigo, c.ink, 0.15).name()},
      {QStringLiteral("hover"), blend(c.paper, c.line, 0.45).name()},
      {QStringLiteral("press"), blend(c.paper, c.line, 0.9).name()},
      {QStringLiteral("tint"), blend(c.surface, c.indigo, 0.13).name()},
      {QStringLiteral("faint"), blend(c.muted, c.paper, 0.35).name()},
      {QStringLiteral("mode"), c.ink.lightnessF() > 0.5 ? QStringLiteral("dark") : QStringLiteral("light")},
      {QStringLiteral("ring"), QStringLiteral("2px")},
      {QStringLiteral("thin"), QStringLiteral("1px")},
      {QStringLiteral("corner"), QStringLiteral("8px")},
      {QStringLiteral("card_corner"), QStringLiteral("10px")},
      {QStringLiteral("arrow_width"), QStringLiteral("10px")},
      {QStringLiteral("arrow_height"), QStringLiteral("6px")},
  };
  const QString sheet = QString::fromUtf8(read_resource(QStringLiteral("window.qss")));
  static const QRegularExpression placeholder(QStringLiteral("@([a-z_]+)"));
  QString filled;
  qsizetype end = 0;
  for (auto at = placeholder.globalMatch(sheet); at.hasNext();) {
    const auto match = at.next();
    // A name without a value stays in the text, so that a test can find it.
    filled += sheet.mid(end, match.capturedStart() - end) + values.value(match.captured(1), match.captured());
    end = match.capturedEnd();
  }
  return filled + sheet.mid(end);
}

}  // namespace nazori::ui
