// SPDX-License-Identifier: Apache-2.0
#include "characters/compare_view.h"

#include <QFontInfo>
#include <QPainter>
#include <algorithm>
#include <vector>

#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kFrame_ms = 16;
constexpr int kGap = 10;
constexpr int kMargin = 2;

QColor colour_of(view::Verdict verdict) {
  const Colours& c = current_colours();
  switch (verdict) {
    case view::Verdict::right:
      return c.moss;
    case view::Verdict::nearly:
      return c.amber;
    case view::Verdict::wrong:
      return c.vermilion;
    case view::Verdict::none:
    case view::Verdict::shown:
      break;
  }
  return c.ink;
}

}  // namespace

CompareView::CompareView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("compare_view"));
  setAccessibleName(tr("Your writing beside the model"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  timer_.setInterval(kFrame_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double next_s = time_s_ + static_cast<double>(since_.restart()) / 1000;
    show_moment(next_s);
    if (next_s >= duration_s()) {
      set_playing(false);
      emit finished();
    }
  });
}

void CompareView::show_writing(const std::vector<practice::HandStroke>& strokes,
                               const std::vector<view::Verdict>& verdicts, const practice::Tablet& model) {
  replay_.set(strokes, model);
  verdicts_ = verdicts;
  update();
}

void CompareView::set_playing(bool playing) {
  if (playing) {
    since_.start();
    show_moment(0);
    timer_.start();
  } else if (timer_.isActive()) {
    timer_.stop();
    show_moment(-1);
  }
}

void CompareView::show_moment(double time_s) {
  time_s_ = time_s;
  update();
  emit moment_shown(time_s);
}

QSize CompareView::sizeHint() const {
  const int side = std::min(QFontInfo(font()).pixelSize() * 9, 200);
  return {2 * side + kGap + 2 * kMargin, side + 2 * kMargin + QFontMetrics(font()).height()};
}

QSize CompareView::minimumSizeHint() const {
  // In a narrower view both are drawn smaller.
  return {sizeHint().width() / 2, sizeHint().height()};
}

void CompareView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int words = QFontMetrics(font()).height();
  const double side = std::min((width() - kGap - 2.0 * kMargin) / 2, height() - 2.0 * kMargin - words);
  const QRectF own(kMargin, kMargin, side, side);
  const QRectF model(kMargin + side + kGap, kMargin, side, side);
  paint_paper(painter, own, 8, 5, QPen(current_colours().line, 1));
  paint_paper(painter, model, 8, 5, QPen(current_colours().line, 1));
  painter.setPen(current_colours().muted);
  painter.drawText(QRectF(own.left(), own.bottom() + 2, side, words), Qt::AlignCenter, tr("yours"));
  painter.drawText(QRectF(model.left(), model.bottom() + 2, side, words), Qt::AlignCenter, tr("model"));
  paint_own(painter, own);
  paint_model(painter, model);
}

void CompareView::paint_own(QPainter& painter, const QRectF& box) const {
  for (std::size_t i = 0; i < replay_.strokes().size(); ++i) {
    const auto verdict = i < verdicts_.size() ? verdicts_[i] : view::Verdict::none;
    const QColor colour = colour_of(verdict);
    paint_ink(painter, replay_.written(i, time_s_), colour, box);
    if (time_s_ >= 0 || verdict == view::Verdict::none) continue;
    const Icon drawing = verdict == view::Verdict::right    ? Icon::tick
                         : verdict == view::Verdict::nearly ? Icon::advice
                                                            : Icon::cross;
    constexpr int kSign = 12;
    constexpr int kDisc = 9;
    const QPointF middle = on_sheet(replay_.strokes()[i].front().at, box) - QPointF(kDisc, kDisc) * 0.8;
    painter.setPen(QPen(colour, 1));
    painter.setBrush(current_colours().surface);
    painter.drawEllipse(middle, kDisc, kDisc);
    painter.drawPixmap(middle - QPointF(kSign, kSign) / 2, sign(drawing, colour, kSign, devicePixelRatioF()));
  }
}

void CompareView::paint_model(QPainter& painter, const QRectF& box) const {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(current_colours().ink, std::max(box.width() * 0.035, 2.0), Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  for (int stroke = 1; stroke <= replay_.model_strokes(); ++stroke) {
    std::vector<QPointF> line;
    for (const auto& at : replay_.model_written(stroke, time_s_)) line.push_back(on_sheet(at, box));
    painter.drawPolyline(line.data(), static_cast<int>(line.size()));
  }
}

}  // namespace nazori::ui
