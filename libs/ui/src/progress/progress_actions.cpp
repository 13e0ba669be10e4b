// SPDX-License-Identifier: Apache-2.0
#include "progress/progress_actions.h"

#include "nazori/practice/study_charts.h"
#include "progress/study_charts.h"

namespace nazori::ui {

ProgressActions::ProgressActions(QWidget* window) : ActionSet(window) {
  const auto key = [](const char* text) { return QStringList{QString::fromLatin1(text)}; };
  const auto go_to = [this](const QString& id, const QString& text, const QString& tip) {
    const auto name = QStringLiteral("progress_") + id;
    places.append({id, make(name.toLatin1().constData(), text, tip, {QString::number(places.size() + 1)})});
  };
  for (const practice::ChartKind& kind : practice::chart_kinds())
    go_to(StudyCharts::id(kind.id), StudyCharts::menu_text(kind.id), StudyCharts::menu_tip(kind.id));
  go_to(QStringLiteral("characters"), tr("&Every character"), tr("Go to the grid of characters"));
  go_to(QStringLiteral("hard_strokes"), tr("&Hardest strokes"), tr("Go to the strokes that go wrong"));
  numbers = make("progress_numbers", tr("&Numbers or drawing"),
                 tr("Show the chart at hand as a table, or as a drawing again"), key("N"));
  copy = make("progress_copy", tr("Co&py the numbers"), tr("Copy the numbers of the chart at hand"),
              key("Ctrl+C"));
  longer = make("progress_longer", tr("&Longer time"), tr("Show a longer time"), key("L"));
  shorter = make("progress_shorter", tr("Shorter &time"), tr("Show a shorter time"), key("K"));
  draw(numbers, Icon::numbers);
  draw(copy, Icon::copy);
  QList<QAction*> group;
  for (const Place& place : places) group.append(place.action);
  group += {nullptr, numbers, copy, nullptr, longer, shorter};
  add_group(tr("&Progress"), group);
}

}  // namespace nazori::ui
