// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/photo_view.h"

#include <QFontInfo>
#include <QPainter>
#include <algorithm>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kEdge_px = 8;
constexpr int kMostSide_px = 1600;  ///< a photograph has far more pixels than a dialog shows

}  // namespace

PhotoView::PhotoView(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PhotoView::show_picture(const surface::ColourPicture& picture, const QString& words) {
  const QImage whole(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                     QImage::Format_RGB888);
  const int side = std::max(picture.width, picture.height);
  picture_ = side > kMostSide_px ? whole.scaled(whole.size() * kMostSide_px / side, Qt::KeepAspectRatio,
                                                Qt::SmoothTransformation)
                                 : whole.copy();
  whole_ = whole.size();
  marked_.clear();
  setAccessibleDescription(words);
  update();
}

void PhotoView::clear() {
  picture_ = {};
  marked_.clear();
  setAccessibleDescription({});
  update();
}

void PhotoView::mark(const QPolygonF& corners) {
  marked_ = corners;
  update();
}

QSize PhotoView::sizeHint() const {
  const int em = QFontInfo(font()).pixelSize();
  return {em * 26, em * 32};
}

void PhotoView::paintEvent(QPaintEvent* /*event*/) {
  if (picture_.isNull()) return;
  QPainter painter(this);
  painter.setRenderHints(QPainter::SmoothPixmapTransform | QPainter::Antialiasing);
  const QSizeF room = QSizeF(size()) - QSizeF(2 * kEdge_px, 2 * kEdge_px);
  const QSizeF fitted = whole_.scaled(room, Qt::KeepAspectRatio);
  const QRectF place(QPointF((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted);
  painter.drawImage(place, picture_);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(current_colours().edge, 1));
  painter.drawRect(place);
  if (marked_.isEmpty()) return;
  QTransform to_widget;
  to_widget.translate(place.x(), place.y());
  to_widget.scale(place.width() / whole_.width(), place.height() / whole_.height());
  const QPolygonF corners = to_widget.map(marked_);
  // Two colours, so that the mark is seen on any paper.
  for (const auto& [colour, width] :
       {std::pair(light_colours().paper, 7.0), std::pair(light_colours().indigo, 3.5)}) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(corners);
  }
}

}  // namespace nazori::ui
