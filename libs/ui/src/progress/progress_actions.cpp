// SPDX-License-Identifier: Apache-2.0
#include "progress/progress_actions.h"

#include "nazori/practice/study_charts.h"
#include "nazori/widgets/charts/study_charts.h"

namespace nazori::ui {

ProgressActions::ProgressActions(QWidget* window) : ActionSet(window) {
  const auto go_to = [this](const QString& id, const QString& text, const QString& tip) {
    const auto name = QStringLiteral("progress_") + id;
    card_entries.append({id, make(name.toLatin1().constData(), text, tip,
                                  QByteArray::number(card_entries.size() + 1).constData())});
  };
  go_to(QStringLiteral("calendar"), tr("C&alendar"), tr("Go to the calendar of the year"));
  go_to(QStringLiteral("characters"), tr("Characters by str&ength"), tr("Go to the grid of characters"));
  go_to(QStringLiteral("hard_strokes"), tr("&Hardest strokes"),
        tr("Go to the strokes you get wrong most often"));
  for (const practice::ChartKind& kind : practice::chart_kinds())
    go_to(StudyCharts::id(kind.id), StudyCharts::menu_text(kind.id), StudyCharts::menu_tip(kind.id));
  more = make("progress_more", tr("M&ore charts and figures"), tr("Show or hide the charts"), "M", true);
  practise = make("progress_practise", tr("Practise the hardest &strokes"),
                  tr("Write the characters of the hardest strokes from memory once"), "P");
  numbers = make("progress_numbers", tr("&Numbers or chart"),
                 tr("Switch the current chart between numbers and drawing"), "N", Icon::numbers);
  copy = make("progress_copy", tr("Co&py numbers"), tr("Copy the numbers of the current chart"), "Ctrl+C",
              Icon::copy);
  longer = make("progress_longer", tr("&Longer period"), tr("Show a longer period"), "L");
  shorter = make("progress_shorter", tr("Shor&ter period"), tr("Show a shorter period"), "K");
  QList<QAction*> group;
  for (const CardEntry& entry : card_entries) group.append(entry.action);
  group += {nullptr, more, practise, nullptr, numbers, copy, nullptr, longer, shorter};
  add_group(tr("&Progress"), group);
}

}  // namespace nazori::ui
