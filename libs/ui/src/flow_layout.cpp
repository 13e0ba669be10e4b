// SPDX-License-Identifier: Apache-2.0
#include "flow_layout.h"

#include <algorithm>

namespace nazori::ui {

FlowLayout::FlowLayout(int horizontal_gap, int vertical_gap, QWidget* parent)
    : QLayout(parent), horizontal_gap_(horizontal_gap), vertical_gap_(vertical_gap) {
  setContentsMargins(0, 0, 0, 0);
}

FlowLayout::~FlowLayout() { qDeleteAll(items_); }

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < items_.size() ? items_.takeAt(index) : nullptr;
}

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const auto* item : items_) size = size.expandedTo(item->minimumSize());
  return size;
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  arrange(rect, true);
}

int FlowLayout::arrange(const QRect& rect, bool apply) const {
  int x = rect.x();
  int y = rect.y();
  int line = 0;
  for (auto* item : items_) {
    if (item->isEmpty()) continue;
    QSize size = item->sizeHint();
    if (size.width() > rect.width() && rect.width() > 0) {
      size.setWidth(rect.width());
      if (item->hasHeightForWidth()) size.setHeight(item->heightForWidth(rect.width()));
    }
    if (x > rect.x() && x + size.width() > rect.x() + rect.width()) {
      x = rect.x();
      y += line + vertical_gap_;
      line = 0;
    }
    if (apply) item->setGeometry(QRect(QPoint(x, y), size));
    x += size.width() + horizontal_gap_;
    line = std::max(line, size.height());
  }
  return y + line - rect.y();
}

}  // namespace nazori::ui
