// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/charts/chart_card.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QStackedWidget>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "nazori/widgets/charts/day_chart.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 14;
constexpr int kLinesHigh = 13;

}  // namespace

ChartCard::ChartCard(const QString& id, QWidget* parent) : QFrame(parent) {
  day_chart_ = new DayChart(this);
  build(id, day_chart_);
  connect(day_chart_, &DayChart::row_changed, this, &ChartCard::read_row);
}

ChartCard::ChartCard(const QString& id, QWidget* drawing, QWidget* parent) : QFrame(parent) {
  drawing->setParent(this);
  build(id, drawing);
}

void ChartCard::build(const QString& id, QWidget* drawing) {
  drawing_ = drawing;
  setObjectName(id + QStringLiteral("_card"));
  setProperty("role", QStringLiteral("card"));
  const auto label = [&](const char* name, const char* role) {
    return text_label((id.toLatin1() + name).constData(), this, role);
  };
  heading_ = label("_heading", "card_title");
  summary_ = label("_summary", "");
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  reading_ = label("_reading", "muted");
  empty_ = label("_empty", "muted");
  empty_->setAlignment(Qt::AlignCenter);
  numbers_ = new QToolButton(this);
  numbers_->setObjectName(id + QStringLiteral("_numbers"));
  numbers_->setText(tr("Numbers"));
  numbers_->setCheckable(true);
  numbers_->setToolTip(tr("Show the numbers as a table (N)"));
  copy_ = new QToolButton(this);
  copy_->setObjectName(id + QStringLiteral("_copy"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copy the numbers (Ctrl+C)"));
  drawing_->setObjectName(id + QStringLiteral("_chart"));
  table_ = new QTableWidget(this);
  table_->setObjectName(id + QStringLiteral("_table"));
  make_row_table(table_);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  stack_ = new QStackedWidget(this);
  stack_->addWidget(drawing_);
  stack_->addWidget(table_);
  stack_->addWidget(empty_);

  auto* head = new QHBoxLayout;
  head->setSpacing(6);
  head->addWidget(heading_, 1);
  head->addWidget(numbers_, 0, Qt::AlignTop);
  head->addWidget(copy_, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(8);
  column->addLayout(head);
  column->addWidget(summary_);
  column->addWidget(stack_, 1);
  column->addWidget(reading_);
  connect(numbers_, &QToolButton::toggled, this, &ChartCard::set_shows_numbers);
  connect(copy_, &QToolButton::clicked, this, &ChartCard::copy_wanted);
  refresh_appearance();
}

void ChartCard::show_chart(const practice::Chart& chart, const ChartText& text) {
  if (day_chart_ != nullptr) day_chart_->show_chart(chart, text);
  show_text(text);
}

void ChartCard::show_text(const ChartText& text) {
  text_ = text;
  const bool any = !text_.numbers.rows.isEmpty();
  heading_->setText(text_.title);
  summary_->setText(text_.summary);
  summary_->setVisible(!text_.summary.isEmpty());
  empty_->setText(text_.empty);
  empty_->setFocusPolicy(any ? Qt::NoFocus : Qt::StrongFocus);
  empty_->setAccessibleName(QStringLiteral("%1. %2").arg(text_.title, text_.empty));
  setAccessibleName(text_.title);
  drawing_->setAccessibleName(text_.title);
  drawing_->setAccessibleDescription(
      tr("%1 Left and Right: read row by row. N: show all numbers.").arg(text_.summary));
  numbers_->setVisible(any);
  numbers_->setAccessibleName(tr("Numbers of %1").arg(text_.title));
  copy_->setVisible(any);
  copy_->setAccessibleName(tr("Copy the numbers of %1").arg(text_.title));
  table_->setAccessibleName(tr("Numbers of %1").arg(text_.title));
  fill_table();
  read_row(-1);
  stack_->setCurrentWidget(!any ? empty_ : numbers_->isChecked() ? static_cast<QWidget*>(table_) : drawing_);
}

void ChartCard::fill_table() {
  const Numbers& numbers = text_.numbers;
  table_->clear();
  table_->setColumnCount(static_cast<int>(numbers.head.size()));
  table_->setHorizontalHeaderLabels(numbers.head);
  table_->setRowCount(static_cast<int>(numbers.rows.size()));
  for (int row = 0; row < numbers.rows.size(); ++row) {
    const QString words = numbers.row_text(row);
    for (int column = 0; column < numbers.rows[row].size(); ++column) {
      auto* cell = new QTableWidgetItem(numbers.rows[row][column]);
      cell->setData(Qt::AccessibleTextRole, words);
      table_->setItem(row, column, cell);
    }
  }
  fit_table();
}

void ChartCard::fit_table() {
  // Thousands of rows are measured only when the table is shown.
  if (numbers_->isChecked()) table_->resizeColumnsToContents();
}

void ChartCard::read_row(int row) {
  const QString words = text_.numbers.row_text(row);
  reading_->setText(words.isEmpty() ? tr("Left and Right: read row by row.") : words);
  reading_->setVisible(day_chart_ != nullptr && !text_.row_names.isEmpty() && !numbers_->isChecked());
  if (words.isEmpty()) return;
  drawing_->setAccessibleDescription(words);
  QAccessibleEvent event(drawing_, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&event);
}

bool ChartCard::shows_numbers() const { return numbers_->isChecked(); }

void ChartCard::set_shows_numbers(bool numbers) {
  if (numbers_->isChecked() != numbers) {
    numbers_->setChecked(numbers);
    return;
  }
  if (stack_->currentWidget() == empty_) return;
  const bool had_focus = stack_->currentWidget()->hasFocus();
  fit_table();
  stack_->setCurrentWidget(numbers ? static_cast<QWidget*>(table_) : drawing_);
  reading_->setVisible(day_chart_ != nullptr && !numbers);
  if (had_focus) focus_content();
}

void ChartCard::focus_content() {
  QWidget* content = stack_->currentWidget();
  if (content == table_ && table_->currentRow() < 0) table_->setCurrentCell(0, 0);
  content->setFocus(Qt::ShortcutFocusReason);
}

void ChartCard::refresh_appearance() {
  const QFontMetrics metrics(font());
  stack_->setMinimumHeight(metrics.lineSpacing() * kLinesHigh);
  table_->verticalHeader()->setDefaultSectionSize(metrics.lineSpacing() + 8);
  fit_table();
  if (day_chart_ != nullptr) {
    day_chart_->setFont(font());
    day_chart_->refresh_appearance();
  }
}

}  // namespace nazori::ui
