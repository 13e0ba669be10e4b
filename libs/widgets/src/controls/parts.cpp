// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/parts.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QUrl>

namespace nazori::ui {

QLabel* text_label(const char* name, QWidget* parent, const char* role) {
  auto* label = named(new QLabel(parent), name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return role != nullptr ? with_role(label, role) : label;
}

QLabel* sentence_label(const char* name, QWidget* parent, const char* role) {
  auto* label = text_label(name, parent, role);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = with_role(new QLabel(text, parent), "heading");
  label->setWordWrap(true);
  return label;
}

QPushButton* action_button(QAction* action, const QString& text, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QStringLiteral("button_") + action->objectName());
  button->setToolTip(action->toolTip());
  QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
  return button;
}

void make_narrow(QComboBox* box, int letters) {
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(letters);
}

void make_row_table(QTableWidget* table) {
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);
  table->setShowGrid(false);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setStretchLastSection(true);
  table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void make_scrolling(QScrollArea* area, QWidget* content) {
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidgetResizable(true);
  area->setWidget(content);
  area->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
}

void clear_layout(QLayout* layout) {
  while (QLayoutItem* item = layout->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
}

QDialogButtonBox* dialog_buttons(QDialogButtonBox::StandardButtons which, QDialog* dialog) {
  auto* buttons = new QDialogButtonBox(which, dialog);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  return buttons;
}

bool has_keyboard(const QWidget& panel) {
  const auto* with_it = panel.window()->focusWidget();
  return with_it != nullptr && panel.isVisible() && panel.isAncestorOf(with_it);
}

void focus_window_container(QWidget& container, const QWindow* inside) {
  if (inside == nullptr || QGuiApplication::focusWindow() != inside) container.setFocus(Qt::OtherFocusReason);
}

bool is_tablet(const QObject* object) {
  return object->objectName() == QLatin1String("tablet") ||
         object->objectName() == QLatin1String("tablet_window");
}

QStringList local_files(const QMimeData* data) {
  QStringList paths;
  for (const auto& url : data->urls())
    if (url.isLocalFile()) paths.append(url.toLocalFile());
  return paths;
}

}  // namespace nazori::ui
