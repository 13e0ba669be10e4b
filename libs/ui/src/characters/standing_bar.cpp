// SPDX-License-Identifier: Apache-2.0
#include "characters/standing_bar.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "nazori/practice/strengths.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"

namespace nazori::ui {

StandingBar::StandingBar(const QList<QAction*>& actions, QWidget* parent)
    : QWidget(parent), standing_(new QLabel(this)) {
  setObjectName(QStringLiteral("standing_bar"));
  standing_->setObjectName(QStringLiteral("standing"));
  standing_->setWordWrap(true);
  standing_->setTextFormat(Qt::PlainText);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(standing_);
  auto* row = new FlowLayout(6, 6);
  for (auto* action : actions) {
    auto* button = new QPushButton(action->iconText(), this);
    button->setObjectName(QStringLiteral("button_") + action->objectName());
    button->setProperty("role", QStringLiteral("compact"));
    button->setToolTip(action->toolTip());
    button->setEnabled(action->isEnabled());
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    connect(action, &QAction::changed, button, [button, action] { button->setEnabled(action->isEnabled()); });
    row->addWidget(button);
  }
  column->addLayout(row);
}

QString StandingBar::words(const practice::CharacterStanding& standing) {
  QStringList all{StudyCharts::strength(standing.strength)};
  if (const auto sign = practice::look_of(standing.strength).sign; sign != 0)
    all[0] = to_text(sign) + QLatin1Char(' ') + all[0];
  if (standing.comes_again)
    all.append(
        standing.is_due
            ? tr("due today")
            : tr("comes again %1").arg(StudyWords::comes_again(standing.card, standing.now, standing.today)));
  if (standing.recall > 0)
    all.append(tr("%1 likely to be remembered").arg(StudyCharts::percent(standing.recall)));
  const auto& brush = standing.card.brush;
  if (brush.due_day && standing.comes_again)
    all.append(*brush.due_day <= standing.today
                   ? tr("due with the brush")
                   : tr("with the brush %1")
                         .arg(StudyWords::comes_again(study::review_delay(brush, standing.today))));
  return all.join(QStringLiteral(" · "));
}

void StandingBar::show_standing(const practice::CharacterStanding& standing) {
  standing_->setText(words(standing));
}

}  // namespace nazori::ui
