// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/flow_layout.h"

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
  // The layout may be narrower than its widest item. The item is then made narrower, so that its text wraps.
  QSize size;
  for (const auto* item : items_) size = size.expandedTo(item->minimumSize());
  return {0, size.height()};
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  arrange(rect, true);
}

int FlowLayout::arrange(const QRect& rect, bool apply) const {
  struct Placed {
    QLayoutItem* item;
    QRect box;
  };
  QList<Placed> line;
  int x = rect.x();
  int y = rect.y();
  int height = 0;
  // Items of one line are centred vertically.
  const auto end_line = [&] {
    for (auto& [item, box] : line)
      if (apply) item->setGeometry(box.translated(0, (height - box.height()) / 2));
    line.clear();
  };
  for (auto* item : items_) {
    if (item->isEmpty()) continue;
    QSize size = item->sizeHint();
    if (size.width() > rect.width() && rect.width() > 0) {
      size.setWidth(rect.width());
      if (item->hasHeightForWidth()) size.setHeight(item->heightForWidth(rect.width()));
    }
    if (x > rect.x() && x + size.width() > rect.x() + rect.width()) {
      end_line();
      x = rect.x();
      y += height + vertical_gap_;
      height = 0;
    }
    line.append({item, QRect(QPoint(x, y), size)});
    x += size.width() + horizontal_gap_;
    height = std::max(height, size.height());
  }
  end_line();
  return y + height - rect.y();
}

}  // namespace nazori::ui
