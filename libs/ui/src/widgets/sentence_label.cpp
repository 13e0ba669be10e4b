// SPDX-License-Identifier: Apache-2.0
#include "widgets/sentence_label.h"

#include <QLabel>

#include "widgets/named.h"

namespace nazori::ui {

QLabel* sentence_label(const char* name, QWidget* parent) {
  auto* label = named(new QLabel(parent), name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace nazori::ui
