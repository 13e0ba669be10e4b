// SPDX-License-Identifier: Apache-2.0
#include "functions/points_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

#include "functions/plot_words.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;
constexpr int kPadding = 4;

/// In a narrow table the coordinates are under the kind, so that they can be read without widening the panel.
class StackedCell final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void set_stacked(bool stacked) { stacked_ = stacked; }
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    if (!stacked_) return QStyledItemDelegate::sizeHint(option, index);
    QStyleOptionViewItem filled = option;
    initStyleOption(&filled, index);
    const QSize text =
        QFontMetrics(filled.font).boundingRect(room_for_text(filled), kText, filled.text).size();
    // A gap shows which lines belong to one point.
    return {text.width() + 2 * kPadding, text.height() + QFontMetrics(filled.font).height() / 2};
  }

  // The style sheet moves the text of a chosen row inwards: lines would break there that do not break
  // elsewhere.
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    if (!stacked_) return QStyledItemDelegate::paint(painter, option, index);
    QStyleOptionViewItem filled = option;
    initStyleOption(&filled, index);
    const QString text = std::exchange(filled.text, QString());
    filled.widget->style()->drawControl(QStyle::CE_ItemViewItem, &filled, painter, filled.widget);
    painter->save();
    painter->setFont(filled.font);
    painter->setPen(filled.widget->palette().color(QPalette::Text));
    painter->drawText(room_for_text(filled).translated(0, QFontMetrics(filled.font).height() / 4), kText,
                      text);
    painter->restore();
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!stacked_ || index.column() != 0) return;
    for (int column = 1; column < index.model()->columnCount(); ++column) {
      const QString value = index.siblingAtColumn(column).data().toString();
      if (value != no_coordinate())
        option->text +=
            QLatin1Char('\n') +
            (value.startsWith(QStringLiteral("≈")) ? QStringLiteral("%1 %2") : QStringLiteral("%1 = %2"))
                .arg(index.model()->headerData(column, Qt::Horizontal).toString(), value);
    }
  }

 private:
  static constexpr int kText = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  static QRect room_for_text(const QStyleOptionViewItem& option) {
    // The height of a row follows its text.
    return {option.rect.left() + kPadding, option.rect.top(), option.rect.width() - 2 * kPadding,
            QWIDGETSIZE_MAX};
  }

  bool stacked_ = false;
};

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
      summary_(text_label("plot_summary", this)),
      caption_(with_role(new QLabel(tr("Points of &interest"), this), "heading")),
      table_(named(new QTableWidget(0, 3, this), "points_table", tr("Points of interest"))),
      empty_(with_role(new QLabel(tr("None in this range."), this), "muted")) {
  setObjectName(QStringLiteral("points_panel"));
  setAccessibleName(tr("About the plot"));
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  caption_->setBuddy(table_);
  caption_->setWordWrap(true);
  empty_->setWordWrap(true);
  table_->setHorizontalHeaderLabels({tr("Type"), QStringLiteral("x"), QStringLiteral("y")});
  make_row_table(table_);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setWordWrap(true);
  cells_ = new StackedCell(table_);
  table_->setItemDelegate(cells_);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->viewport()->installEventFilter(this);
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

void PointsPanel::show_drawing(const functions::SharedDrawing& drawing) {
  const bool stopped = drawing && !drawing->final;
  summary_->setText(!drawing  ? QString()
                    : stopped ? tr("The drawing was stopped before the points of interest were found.")
                              : localised(drawing->summary));
  const auto count = drawing ? static_cast<int>(drawing->points.size()) : 0;
  table_->setRowCount(count);
  for (int row = 0; row < count; ++row) {
    const auto& point = drawing->points[static_cast<std::size_t>(row)];
    QString kind = kind_words(point.kind);
    const auto& statements = drawing->request.plot.statements;
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
  empty_->setVisible(count == 0 && !stopped);
  fit();
}

void PointsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

bool PointsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && event->type() == QEvent::Resize) fit();
  return QWidget::eventFilter(watched, event);
}

void PointsPanel::fit() {
  if (fitting_) return;
  fitting_ = true;
  auto& cells = static_cast<StackedCell&>(*cells_);
  cells.set_stacked(false);
  int wanted = 0;
  std::array<int, 3> widths{};
  for (int column = 0; column < table_->columnCount(); ++column) {
    auto& width = widths[static_cast<std::size_t>(column)];
    width = std::max(static_cast<QAbstractItemView*>(table_)->sizeHintForColumn(column),
                     table_->horizontalHeader()->sectionSizeHint(column));
    wanted += width;
  }
  const int room = table_->viewport()->width();
  const bool stacked = wanted > room;
  cells.set_stacked(stacked);
  for (int column = 0; column < table_->columnCount(); ++column) {
    table_->setColumnHidden(column, stacked && column > 0);
    table_->setColumnWidth(column, stacked ? room : widths[static_cast<std::size_t>(column)]);
  }
  table_->horizontalHeader()->setVisible(!stacked);
  // With large text the sentence would leave no space for the table. A key announces it, and it is shown
  // below the tablet too.
  const int sentence = summary_->heightForWidth(width() - 2 * kMargin);
  summary_->setVisible(table_->rowCount() == 0 || sentence <= height() * 2 / 5);
  table_->resizeRowsToContents();
  fitting_ = false;
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
