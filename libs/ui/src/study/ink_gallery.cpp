// SPDX-License-Identifier: Apache-2.0
#include "study/ink_gallery.h"

#include <QEvent>
#include <QFontInfo>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kGap = 8;
constexpr int kFew = 2;  ///< pieces in a row at least
constexpr int kWordsFlags = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;
constexpr double kPen = 0.03;  ///< width of the ink, of the side

void paint_piece(QPainter& painter, const study::Handwriting& ink, const QRectF& box) {
  const Colours& c = current_colours();
  painter.setPen(QPen(c.line, 1));
  painter.setBrush(c.surface);
  painter.drawRoundedRect(box, 6, 6);
  paint_handwriting(painter, ink, box, c.ink, kPen);
}

}  // namespace

InkGallery::InkGallery(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("ink_gallery"));
  setAccessibleName(tr("Earlier writing beside today's"));
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void InkGallery::show_pieces(std::vector<Piece> pieces) {
  pieces_ = std::move(pieces);
  QStringList all;
  for (const auto& piece : pieces_) all.append(piece.words);
  setAccessibleDescription(all.join(QStringLiteral("; ")));
  setVisible(!pieces_.empty());
  updateGeometry();
  update();
}

int InkGallery::columns(int width) const {
  return std::max(kFew, width / std::max(1, QFontInfo(font()).pixelSize() * 7));
}

int InkGallery::words_flags(int side) const {
  // A date is not cut off: if it is wider than the picture above it, it wraps.
  static const QRegularExpression between_words(QStringLiteral("\\s"));
  const QFontMetrics metrics(font());
  for (const auto& piece : pieces_)
    for (const auto& word : piece.words.split(between_words))
      if (metrics.horizontalAdvance(word) > side) return kWordsFlags | Qt::TextWrapAnywhere;
  return kWordsFlags;
}

int InkGallery::words_height(int side) const {
  int highest = 0;
  const int flags = words_flags(side);
  for (const auto& piece : pieces_)
    highest = std::max(
        highest,
        QFontMetrics(font()).boundingRect(QRect(0, 0, side, QWIDGETSIZE_MAX), flags, piece.words).height());
  return highest + 2;
}

int InkGallery::heightForWidth(int width) const {
  if (pieces_.empty()) return 0;
  const int across = columns(width);
  const int side = (width - kGap * (across - 1)) / across;
  const int rows = (static_cast<int>(pieces_.size()) + across - 1) / across;
  return rows * (side + words_height(side) + kGap);
}

QSize InkGallery::sizeHint() const {
  const int width = QFontInfo(font()).pixelSize() * 14;
  return {width, heightForWidth(width)};
}

void InkGallery::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int across = columns(width());
  const int side = (width() - kGap * (across - 1)) / across;
  const int words = words_height(side);
  const int flags = words_flags(side);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const int row = static_cast<int>(i) / across;
    const int column = static_cast<int>(i) % across;
    const QRectF box(column * (side + kGap), row * (side + words + kGap), side, side);
    paint_piece(painter, pieces_[i].ink, box.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setPen(current_colours().muted);
    painter.drawText(QRectF(box.left(), box.bottom() + 2, side, words), flags, pieces_[i].words);
  }
}

}  // namespace nazori::ui
