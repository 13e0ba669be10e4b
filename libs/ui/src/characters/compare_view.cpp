// SPDX-License-Identifier: Apache-2.0
#include "characters/compare_view.h"

#include <QFontInfo>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "look/icons.h"
#include "look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kFrame_ms = 16;
constexpr int kGap = 10;
constexpr int kMargin = 2;
constexpr double kTabletWidth_m = 0.1;

QPointF to_pixel(geometry::TabletPoint p, const QRectF& box) {
  return {box.center().x() + p.x / kTabletWidth_m * box.width(),
          box.center().y() - p.y / kTabletWidth_m * box.height()};
}

void paint_paper(QPainter& painter, const QRectF& box) {
  const Colours& c = current_colours();
  painter.setPen(QPen(c.line, 1));
  painter.setBrush(c.surface);
  painter.drawRoundedRect(box, 8, 8);
  painter.setPen(QPen(c.line, 1, Qt::DashLine));
  painter.drawLine(QPointF(box.center().x(), box.top() + 5), QPointF(box.center().x(), box.bottom() - 5));
  painter.drawLine(QPointF(box.left() + 5, box.center().y()), QPointF(box.right() - 5, box.center().y()));
}

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
  strokes_ = strokes;
  verdicts_ = verdicts;
  if (model != model_) {
    model_ = model;
    player_.set_strokes(model->paths(), model->lines());
  }
  update();
}

double CompareView::own_duration_s() const {
  return strokes_.empty()
             ? 0.0
             : strokes_.back().back().time_s.value_or(0) - strokes_.front().front().time_s.value_or(0);
}

double CompareView::duration_s() const { return std::max(own_duration_s(), player_.duration_s()); }

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

int CompareView::points_shown() const {
  int count = 0;
  for (const auto& stroke : strokes_)
    for (const auto& point : stroke)
      count +=
          time_s_ < 0 || point.time_s.value_or(0) - strokes_.front().front().time_s.value_or(0) <= time_s_
              ? 1
              : 0;
  return count;
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
  paint_paper(painter, own);
  paint_paper(painter, model);
  painter.setPen(current_colours().muted);
  painter.drawText(QRectF(own.left(), own.bottom() + 2, side, words), Qt::AlignCenter, tr("yours"));
  painter.drawText(QRectF(model.left(), model.bottom() + 2, side, words), Qt::AlignCenter, tr("model"));
  paint_own(painter, own);
  paint_model(painter, model);
}

void CompareView::paint_own(QPainter& painter, const QRectF& box) const {
  const double per_m = box.width() / kTabletWidth_m;
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const auto& stroke = strokes_[i];
    const auto verdict = i < verdicts_.size() ? verdicts_[i] : view::Verdict::none;
    const QColor colour = colour_of(verdict);
    const double zero_s = strokes_.front().front().time_s.value_or(0);
    for (std::size_t k = 1; k < stroke.size(); ++k) {
      if (time_s_ >= 0 && stroke[k].time_s.value_or(0) - zero_s > time_s_) return;
      painter.setPen(QPen(colour, std::max(2 * per_m * view::ink_half_width_m(stroke[k]), 1.5), Qt::SolidLine,
                          Qt::RoundCap, Qt::RoundJoin));
      painter.drawLine(to_pixel(stroke[k - 1].at, box), to_pixel(stroke[k].at, box));
    }
    if (time_s_ >= 0 || verdict == view::Verdict::none) continue;
    const Icon drawing = verdict == view::Verdict::right    ? Icon::tick
                         : verdict == view::Verdict::nearly ? Icon::advice
                                                            : Icon::cross;
    constexpr int kSign = 12;
    constexpr int kDisc = 9;
    const QPointF middle = to_pixel(stroke.front().at, box) - QPointF(kDisc, kDisc) * 0.8;
    painter.setPen(QPen(colour, 1));
    painter.setBrush(current_colours().surface);
    painter.drawEllipse(middle, kDisc, kDisc);
    painter.drawPixmap(middle - QPointF(kSign, kSign) / 2, sign(drawing, colour, kSign, devicePixelRatioF()));
  }
}

void CompareView::paint_model(QPainter& painter, const QRectF& box) const {
  if (!model_) return;
  const auto& paths = model_->paths();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(current_colours().ink, std::max(box.width() * 0.035, 2.0), Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  for (std::size_t n = 0; n < paths.size(); ++n) {
    const double share = time_s_ < 0 ? 1.0 : player_.share_at(static_cast<int>(n) + 1, time_s_);
    if (share <= 0) continue;
    const auto& points = paths[n].points;
    double whole_m = 0;
    for (std::size_t k = 1; k < points.size(); ++k) whole_m += glm::distance(points[k - 1], points[k]);
    double left_m = whole_m * share;
    QPainterPath path(to_pixel({points.front().x, points.front().y}, box));
    for (std::size_t k = 1; k < points.size() && left_m > 0; ++k) {
      const double piece_m = glm::distance(points[k - 1], points[k]);
      const auto to = piece_m > left_m ? glm::mix(points[k - 1], points[k], left_m / piece_m) : points[k];
      path.lineTo(to_pixel({to.x, to.y}, box));
      left_m -= piece_m;
    }
    painter.drawPath(path);
  }
}

}  // namespace nazori::ui
