// SPDX-License-Identifier: Apache-2.0
#include "progress/characters_card.h"

#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "nazori/practice/list_members.h"
#include "nazori/practice/strengths.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "progress/strength_grid.h"

namespace nazori::ui {

CharactersCard::CharactersCard(QWidget* parent) : CharactersCard(new QWidget, parent) {}

CharactersCard::CharactersCard(QWidget* drawing, QWidget* parent)
    : ChartCard(QStringLiteral("characters"), drawing, parent),
      list_(named(new ListChoice(drawing), "characters_list", tr("Characters to show"))),
      grid_(named(new StrengthGrid(drawing), "strength_grid")) {
  auto* here = text_label("strength_reading", drawing, "muted");
  auto* column = new QVBoxLayout(drawing);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(list_, 0, Qt::AlignLeft);
  column->addWidget(grid_, 1);
  column->addWidget(here);
  drawing->setFocusProxy(grid_);
  connect(list_, &ListChoice::currentIndexChanged, this, [this] {
    wanted_ = list_->list();
    emit list_changed();
  });
  connect(grid_, &StrengthGrid::opened, this, &CharactersCard::opened);
  connect(grid_, &StrengthGrid::walked, here, &QLabel::setText);
}

QString CharactersCard::list() const { return wanted_; }

void CharactersCard::set_list(const QString& id) { wanted_ = id; }

void CharactersCard::show_characters(const study::Statistics& statistics, study::CharacterLists* lists,
                                     const study::LearnerStore& store) {
  list_->fill(store);
  {
    const QSignalBlocker quiet(list_);
    list_->set_list(wanted_);
  }
  std::vector<study::CharacterState> states;
  QString trouble;
  if (list_->list().isEmpty())
    states = statistics.characters;
  else if (const auto members = practice::list_members(wanted_.toStdString(), lists, store); !members)
    trouble = tr("The list cannot be read: %1").arg(reason(members.error()));
  else
    states = practice::states_of(*members, statistics);
  ChartText text;
  text.id = QStringLiteral("characters");
  text.title = tr("Characters by strength");
  text.empty = trouble.isEmpty()
                   ? tr("Characters you have studied appear here, with how well you know each one.")
                   : trouble;
  text.numbers.head = {tr("Character"), tr("Strength"), tr("Chance of recall now")};
  for (const auto& state : states)
    text.numbers.rows.append({to_text(state.character), StudyCharts::strength(state.strength),
                              state.strength == study::Strength::unseen
                                  ? QStringLiteral("–")
                                  : StudyCharts::percent(state.retrievability)});
  QStringList words;
  for (const auto& [strength, count] : practice::count_by_strength(states))
    words.append(QStringLiteral("%1 %2 %3")
                     .arg(look_of(strength, current_colours()).sign, StudyCharts::strength(strength),
                          QLocale().toString(count))
                     .trimmed());
  text.summary = words.join(QStringLiteral("  ·  "));
  grid_->setAccessibleName(text.title);
  grid_->setAccessibleDescription(tr("%1. Enter: open a character.").arg(text.summary));
  grid_->show_states(std::move(states));
  show_text(text);
}

}  // namespace nazori::ui
