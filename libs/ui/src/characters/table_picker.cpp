// SPDX-License-Identifier: Apache-2.0
#include "characters/table_picker.h"

#include <QEvent>
#include <QFontInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

TablePicker::TablePicker(QWidget* parent)
    : QWidget(parent),
      stack_(new QStackedWidget(this)),
      parts_(make_table("parts_table", tr("Parts by number of strokes"))),
      radicals_(make_table("radicals_table", tr("Radicals by number of strokes"))) {
  setObjectName(QStringLiteral("table_picker"));
  stack_->addWidget(parts_);
  stack_->addWidget(radicals_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 6, 0);
  column->addWidget(stack_);
}

QScrollArea* TablePicker::make_table(const char* name, const QString& title) {
  auto* area = new QScrollArea(stack_);
  area->setObjectName(QString::fromLatin1(name));
  area->setAccessibleName(title);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget(area);
  content->setObjectName(QStringLiteral("information_content"));
  auto* flow = new FlowLayout(2, 2, content);
  flow->setContentsMargins(2, 2, 2, 2);
  area->setWidget(content);
  area->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
  return area;
}

QPushButton* TablePicker::add_button(QWidget* table, const QString& text, int strokes, int& before) {
  if (strokes != before) {
    auto* number = new QLabel(QString::number(strokes), table);
    number->setProperty("role", QStringLiteral("heading"));
    number->setAccessibleName(tr("%n strokes", nullptr, strokes));
    table->layout()->addWidget(number);
    before = strokes;
  }
  auto* button = new QPushButton(text, table);
  button->setProperty("role", QStringLiteral("table"));
  button->setCheckable(true);
  table->layout()->addWidget(button);
  return button;
}

void TablePicker::show_tables(const std::shared_ptr<const practice::CharacterTables>& tables) {
  if (tables_) return;
  tables_ = tables;
  int before = 0;
  for (const auto& part : tables_->picker.parts()) {
    const QString element = to_text(part.element);
    auto* button = add_button(parts_->widget(), element, part.strokes, before);
    button->setObjectName(QStringLiteral("table_part_") + element);
    button->setAccessibleName(tr("%1, %n strokes", nullptr, part.strokes).arg(element));
    connect(button, &QPushButton::toggled, this,
            [this, element](bool chosen) { choose_part(element, chosen); });
    part_buttons_.append(button);
  }
  before = 0;
  for (const auto& radical : tables_->radicals) {
    QString names;
    for (const auto& name : radical.japanese_names) names += to_text(name) + QStringLiteral(" ");
    auto* button = add_button(radicals_->widget(), to_text(radical.form), radical.strokes, before);
    button->setObjectName(QStringLiteral("table_radical_%1").arg(radical.number));
    const QString says = QStringLiteral("%1 %2 · %3 %4")
                             .arg(radical.number)
                             .arg(to_text(radical.form), names.trimmed(), to_text(radical.english_name));
    button->setAccessibleName(says);
    button->setToolTip(says);
    connect(button, &QPushButton::toggled, this,
            [this, number = radical.number](bool chosen) { emit radical_chosen(chosen ? number : 0); });
    radical_buttons_.insert(radical.number, button);
  }
  fit();
  set_query(query_);
  if (awaits_tables_ && isVisible()) take_keyboard();
}

void TablePicker::show_table(int table) {
  if (table != kNone) stack_->setCurrentIndex(table);
}

void TablePicker::take_keyboard() {
  awaits_tables_ = tables_ == nullptr;
  const auto buttons = stack_->currentWidget()->findChildren<QPushButton*>();
  const auto first = std::find_if(buttons.begin(), buttons.end(), [](auto* b) { return b->isEnabled(); });
  if (first != buttons.end()) (*first)->setFocus(Qt::ShortcutFocusReason);
}

void TablePicker::set_query(const kanji::Query& query) {
  query_ = query;
  if (!tables_) return;
  const auto choice = tables_->picker.choose(query.parts);
  for (qsizetype i = 0; i < part_buttons_.size(); ++i) {
    const QSignalBlocker quiet(part_buttons_[i]);
    const auto& element = tables_->picker.parts()[static_cast<std::size_t>(i)].element;
    part_buttons_[i]->setChecked(std::find(query.parts.begin(), query.parts.end(), element) !=
                                 query.parts.end());
    part_buttons_[i]->setEnabled(choice.possible[static_cast<std::size_t>(i)]);
  }
  for (auto button = radical_buttons_.begin(); button != radical_buttons_.end(); ++button) {
    const QSignalBlocker quiet(*button);
    (*button)->setChecked(query.radical == button.key());
  }
}

void TablePicker::choose_part(const QString& element, bool chosen) {
  QString parts;
  for (const auto& part : query_.parts)
    if (to_text(part) != element) parts += to_text(part);
  if (chosen) parts += element;
  emit parts_chosen(parts);
}

void TablePicker::fit() {
  const double size_pt = QFontInfo(font()).pointSizeF();
  const QFont textbook = textbook_font(size_pt * 1.2);
  const int side = QFontMetrics(textbook).height() + 8;
  for (auto* button : findChildren<QPushButton*>()) {
    button->setFont(textbook);
    button->setFixedSize(side, side);
  }
}

void TablePicker::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

}  // namespace nazori::ui
