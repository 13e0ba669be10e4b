// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/field_row.h"

#include <QBoxLayout>
#include <QLabel>
#include <algorithm>

namespace nazori::ui {
namespace {

constexpr int kGap_px = 6;

}  // namespace

FieldRow::FieldRow(const QString& name, QWidget* field, QWidget* parent)
    : QWidget(parent), name_(new QLabel(name, this)), layout_(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  name_->setBuddy(field);
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(kGap_px);
  layout_->addWidget(name_);
  layout_->addWidget(field, 1);
}

void FieldRow::arrange(const std::vector<FieldRow*>& rows, bool above) {
  int widest = 0;
  for (const auto* row : rows) widest = std::max(widest, row->name_->sizeHint().width());
  for (auto* row : rows) {
    row->layout_->setDirection(above ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    row->layout_->setSpacing(above ? 0 : kGap_px);
    row->name_->setMinimumWidth(above ? 0 : widest);
    row->name_->setWordWrap(above);
  }
}

}  // namespace nazori::ui
