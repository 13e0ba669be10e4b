// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/relief_view.h"

#include <QFontInfo>
#include <QPainter>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kEdge_px = 8;
constexpr double kDimmed = 0.25;  ///< so that the plate is not bright in a dark window

}  // namespace

ReliefView::ReliefView(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ReliefView::show_picture(const practice::ReliefPicture& picture, const QString& words) {
  picture_ = QImage(picture.width, picture.height, QImage::Format_Grayscale8);
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(picture.grey.begin() + static_cast<std::ptrdiff_t>(y) * picture.width, picture.width,
                picture_.scanLine(y));
  setAccessibleDescription(words);
  update();
}

void ReliefView::clear() {
  picture_ = {};
  setAccessibleDescription({});
  update();
}

QSize ReliefView::sizeHint() const {
  const int em = QFontInfo(font()).pixelSize();
  return {em * 22, em * 22};
}

void ReliefView::paintEvent(QPaintEvent* /*event*/) {
  if (picture_.isNull()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QSizeF room = QSizeF(size()) - QSizeF(2 * kEdge_px, 2 * kEdge_px);
  const QSizeF fitted = QSizeF(picture_.size()).scaled(room, Qt::KeepAspectRatio);
  const QRectF place(QPointF((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted);
  painter.drawImage(place, picture_);
  if (is_dark(palette())) painter.fillRect(place, QColor::fromRgbF(0, 0, 0, kDimmed));
  painter.setPen(QPen(current_colours().edge, 1));
  painter.drawRect(place);
}

}  // namespace nazori::ui
