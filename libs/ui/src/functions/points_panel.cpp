// SPDX-License-Identifier: Apache-2.0
#include "functions/points_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "functions/plot_words.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;

QTableWidgetItem* cell(const QString& text, const QString& words) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item->setData(Qt::AccessibleTextRole, words);
  item->setToolTip(words);
  return item;
}

}  // namespace

PointsPanel::PointsPanel(QWidget* parent)
    : QWidget(parent),
      summary_(new QLabel(this)),
      caption_(new QLabel(tr("Points of &interest"), this)),
      table_(new QTableWidget(0, 3, this)),
      empty_(new QLabel(tr("There are none in this window."), this)) {
  setObjectName(QStringLiteral("points_panel"));
  setAccessibleName(tr("About the plot"));
  summary_->setObjectName(QStringLiteral("plot_summary"));
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  caption_->setProperty("role", QStringLiteral("heading"));
  caption_->setBuddy(table_);
  empty_->setProperty("role", QStringLiteral("muted"));
  empty_->setWordWrap(true);
  table_->setObjectName(QStringLiteral("points_table"));
  table_->setAccessibleName(tr("Points of interest"));
  table_->setHorizontalHeaderLabels({tr("Kind"), QStringLiteral("x"), QStringLiteral("y")});
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setShowGrid(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  connect(table_, &QTableWidget::cellClicked, this, &PointsPanel::point_chosen);
  connect(table_, &QTableWidget::cellActivated, this, &PointsPanel::point_chosen);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(10);
  column->addWidget(summary_);
  column->addWidget(caption_);
  column->addWidget(empty_);
  column->addWidget(table_, 1);
  column->addStretch(0);
}

void PointsPanel::show_drawing(const SharedDrawing& drawing) {
  summary_->setText(drawing ? localised(drawing->summary) : QString());
  const auto count = drawing ? static_cast<int>(drawing->points.size()) : 0;
  table_->clearContents();
  table_->setRowCount(count);
  for (int row = 0; row < count; ++row) {
    const auto& point = drawing->points[static_cast<std::size_t>(row)];
    QString kind = kind_words(point.kind);
    const auto& statements = drawing->asked.plot.statements;
    if (statements.size() > 1) {
      kind += point.other >= 0 ? tr(", curves %1 and %2").arg(point.statement + 1).arg(point.other + 1)
                               : tr(", curve %1").arg(point.statement + 1);
    }
    const QString words = point_words(point);
    table_->setItem(row, 0, cell(kind, words));
    table_->setItem(row, 1, cell(coordinate_text(point.x, point.x_name), words));
    table_->setItem(row, 2, cell(coordinate_text(point.y, point.y_name), words));
  }
  table_->setVisible(count > 0);
  empty_->setVisible(count == 0);
}

void PointsPanel::set_current(int row) { table_->setCurrentCell(row, 0); }

void PointsPanel::focus_table() {
  if (table_->rowCount() == 0) {
    summary_->setFocus(Qt::ShortcutFocusReason);
    return;
  }
  if (table_->currentRow() < 0) table_->setCurrentCell(0, 0);
  table_->setFocus(Qt::ShortcutFocusReason);
}

}  // namespace nazori::ui
