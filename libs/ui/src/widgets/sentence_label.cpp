// SPDX-License-Identifier: Apache-2.0
#include "widgets/sentence_label.h"

#include <QLabel>

namespace nazori::ui {

QLabel* sentence_label(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QString::fromLatin1(name));
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace nazori::ui
