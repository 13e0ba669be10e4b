// SPDX-License-Identifier: Apache-2.0
#include "characters/word_boxes.h"

#include <QEvent>
#include <QFontInfo>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kBoxGap = 6;
constexpr double kFrame = 2;  ///< width of the frame of the current box
constexpr int kSide_em = 5;
constexpr int kSign_px = 14;

QColor ink_of(view::Verdict verdict) {
  const Colours& c = current_colours();
  switch (verdict) {
    case view::Verdict::nearly:
      return c.amber;
    case view::Verdict::wrong:
      return c.vermilion;
    case view::Verdict::right:
    case view::Verdict::none:
    case view::Verdict::shown:
      break;
  }
  return c.ink;
}

}  // namespace

WordBoxes::WordBoxes(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("word_boxes"));
  setAccessibleName(tr("The characters of the word"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void WordBoxes::show_boxes(std::vector<Box> boxes) {
  const bool is_resized = boxes.size() != boxes_.size();
  boxes_ = std::move(boxes);
  QStringList all;
  int number = 0;
  for (const auto& box : boxes_) {
    ++number;
    all.append(box.is_finished
                   ? (box.is_right ? tr("Character %1: right") : tr("Character %1: not right")).arg(number)
               : box.is_current ? tr("Character %1: being written").arg(number)
                                : tr("Character %1: empty").arg(number));
  }
  setAccessibleDescription(all.join(QStringLiteral("; ")));
  if (is_resized) updateGeometry();
  update();
}

int WordBoxes::side() const { return QFontInfo(font()).pixelSize() * kSide_em; }

QSize WordBoxes::sizeHint() const {
  const int count = static_cast<int>(boxes_.size());
  return {count * side() + std::max(0, count - 1) * kBoxGap, side()};
}

void WordBoxes::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Colours& c = current_colours();
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const auto& box = boxes_[i];
    const QRectF place =
        QRectF(static_cast<double>(i) * (side() + kBoxGap), 0, side(), side()).adjusted(1, 1, -1, -1);
    paint_paper(painter, place, 6, 4, box.is_current ? QPen(c.indigo, kFrame) : QPen(c.line, 1));
    for (std::size_t k = 0; k < box.strokes.size(); ++k)
      paint_ink(painter, box.strokes[k],
                ink_of(k < box.verdicts.size() ? box.verdicts[k] : view::Verdict::none), place);
    if (!box.is_finished) continue;
    const QPixmap mark = sign(box.is_right ? Icon::tick : Icon::cross, box.is_right ? c.moss : c.vermilion,
                              kSign_px, devicePixelRatioF());
    painter.drawPixmap(QPointF(place.right() - kSign_px - 2, place.bottom() - kSign_px - 2), mark);
  }
}

}  // namespace nazori::ui
