// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/parts/panel_parts.h"

#include <QAction>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {

QVBoxLayout* make_panel_column(QWidget* content) {
  constexpr int kMargin = 12;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(kPanelGap);
  return column;
}

QFormLayout* add_form(QVBoxLayout* column) {
  auto* form = new QFormLayout;
  form->setVerticalSpacing(kPanelGap);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  column->addLayout(form);
  return form;
}

void add_buttons(QVBoxLayout* column, const QList<QAction*>& actions, QWidget* content) {
  auto* row = new FlowLayout(kPanelGap, kPanelGap);
  for (auto* action : actions) row->addWidget(action_button(action, action->iconText(), content));
  column->addLayout(row);
}

}  // namespace nazori::ui
