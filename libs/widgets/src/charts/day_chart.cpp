// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/charts/day_chart.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "nazori/widgets/charts/role_colours.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

using practice::Series;
using practice::SeriesLook;
using practice::Side;
using practice::ValueAxis;

constexpr double kMargin_px = 4;
constexpr double kTick_px = 4;
constexpr double kLabelGap_px = 3;
constexpr double kLine_px = 2.5;
constexpr double kMark_px = 8;
constexpr double kBarShare = 0.8;
constexpr double kRoomBetweenLabels = 1.6;
constexpr double kLegendSign_px = 14;  // one dash of a dashed line and its gap
constexpr double kLegendSignGap_px = 5;
constexpr double kLegendGap_px = 10;

double row_names_gap(const QFontMetricsF& metrics) { return metrics.descent() + 2; }
double legend_height(const QFontMetricsF& metrics) { return metrics.height() + 2 * kLegendGap_px; }

QPen line_pen(const Series& series, const Colours& colours) {
  return {colour_of(series.look.edge, colours), kLine_px, series.look.dashed ? Qt::DashLine : Qt::SolidLine};
}

void paint_mark(QPainter& painter, SeriesLook::Mark mark, const QPointF& at) {
  const QRectF box(at.x() - kMark_px / 2, at.y() - kMark_px / 2, kMark_px, kMark_px);
  if (mark == SeriesLook::Mark::disc)
    painter.drawEllipse(box);
  else if (mark == SeriesLook::Mark::square)
    painter.drawRect(box);
}

}  // namespace

DayChart::DayChart(QWidget* parent) : QFrame(parent) {
  setProperty("role", QStringLiteral("chart"));
  setFocusPolicy(Qt::StrongFocus);
}

void DayChart::show_chart(const practice::Chart& chart, const ChartText& text) {
  chart_ = chart;
  row_names_ = text.row_names;
  series_names_ = text.series_names;
  row_ = -1;
  update();
}

QString DayChart::label(const ValueAxis& axis, int tick) const {
  const QString number = QString::number(axis.value(tick), 'f', axis.numbers.decimals);
  return axis.numbers.percent ? StudyCharts::tr("%1%").arg(number) : number;
}

double DayChart::label_room(Side side) const {
  const auto axis = practice::value_axis(chart_, side);
  if (!axis) return 0;
  const QFontMetricsF metrics(font());
  double widest = 0;
  for (int tick = 0; tick < axis->ticks; ++tick)
    widest = std::max(widest, metrics.horizontalAdvance(label(*axis, tick)));
  return widest + kTick_px + kLabelGap_px;
}

QRectF DayChart::plot_area() const {
  const QFontMetricsF metrics(font());
  // Half of the uppermost label is above the plot.
  const double above = kMargin_px + metrics.height() / 2;
  const double below =
      row_names_gap(metrics) + metrics.height() + kMargin_px + (has_legend() ? legend_height(metrics) : 0);
  return QRectF(contentsRect())
      .adjusted(kMargin_px + label_room(Side::left), above, -kMargin_px - label_room(Side::right), -below);
}

std::vector<int> DayChart::named_rows() const {
  const QFontMetricsF metrics(font());
  double widest = 1;
  for (const QString& name : row_names_) widest = std::max(widest, metrics.horizontalAdvance(name));
  const double room = std::max(1.0, width() - 6 * widest / kRoomBetweenLabels);
  return practice::named_rows(chart_, std::max(2, static_cast<int>(room / (widest * kRoomBetweenLabels))));
}

double DayChart::mark_x() const {
  const QRectF plot = plot_area();
  return plot.left() + plot.width() * practice::share_of_row(chart_, row_);
}

QPointF DayChart::point(const Series& series, const ValueAxis& axis, int row) const {
  const QRectF plot = plot_area();
  const double value = chart_.columns[series.column].values[static_cast<std::size_t>(row)];
  return {plot.left() + plot.width() * practice::share_of_row(chart_, row),
          plot.bottom() - plot.height() * (value - axis.low) / (axis.high - axis.low)};
}

void DayChart::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  const QRectF plot = plot_area();
  if (practice::row_count(chart_) == 0 || plot.width() <= 0 || plot.height() <= 0) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  paint_axis(painter, Side::left);
  paint_axis(painter, Side::right);
  paint_row_names(painter);
  painter.save();
  // A second series may be larger than the range of the axis.
  const double room = kMark_px / 2 + 1;
  painter.setClipRect(plot.adjusted(-room, -room, room, room));
  for (const Series& series : chart_.series) {
    if (series.look.form == SeriesLook::Form::bars)
      paint_bars(painter, series);
    else
      paint_line(painter, series);
  }
  painter.restore();
  if (has_legend()) paint_legend(painter);
  if (row_ < 0) return;
  painter.setPen(QPen(current_colours().indigo, 2, Qt::DotLine));
  painter.drawLine(QPointF(mark_x(), plot.top()), QPointF(mark_x(), plot.bottom()));
}

void DayChart::paint_axis(QPainter& painter, Side side) const {
  const auto axis = practice::value_axis(chart_, side);
  if (!axis) return;
  const Colours& c = current_colours();
  const QRectF plot = plot_area();
  const bool left = side == Side::left;
  const double x = left ? plot.left() : plot.right();
  const double out = left ? -1 : 1;
  const double half = QFontMetricsF(font()).height() / 2;
  const QPen line(c.line, 1);
  painter.setPen(line);
  painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
  for (int tick = 0; tick < axis->ticks; ++tick) {
    // In the middle of a pixel, so that the line is sharp.
    const double y = std::floor(plot.bottom() - plot.height() * tick / (axis->ticks - 1)) + 0.5;
    painter.setPen(line);
    painter.drawLine(QPointF(x + out * kTick_px, y), QPointF(axis->grid ? plot.right() : x, y));
    painter.setPen(c.muted);
    const double from = x + out * (kTick_px + kLabelGap_px);
    const QRectF room =
        left ? QRectF(0, y - half, from, 2 * half) : QRectF(from, y - half, width() - from, 2 * half);
    painter.drawText(room, Qt::AlignVCenter | Qt::TextDontClip | (left ? Qt::AlignRight : Qt::AlignLeft),
                     label(*axis, tick));
  }
}

void DayChart::paint_row_names(QPainter& painter) const {
  const Colours& c = current_colours();
  const QRectF plot = plot_area();
  const QFontMetricsF metrics(font());
  painter.setPen(QPen(c.line, 1));
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  for (const int row : named_rows()) {
    const double x = plot.left() + plot.width() * practice::share_of_row(chart_, row);
    const QString name = row_names_.value(row);
    const double wide = metrics.horizontalAdvance(name);
    // The first and the last name stay inside the frame.
    const double left =
        std::max<double>(contentsRect().left(), std::min(x - wide / 2, contentsRect().right() - wide));
    painter.setPen(QPen(c.line, 1));
    painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + kTick_px));
    painter.setPen(c.muted);
    painter.drawText(QPointF(left, plot.bottom() + row_names_gap(metrics) + metrics.ascent()), name);
  }
}

void DayChart::paint_bars(QPainter& painter, const Series& series) const {
  const auto axis = practice::value_axis(chart_, series.side);
  if (!axis) return;
  const Colours& c = current_colours();
  const QRectF plot = plot_area();
  const double wide = plot.width() * practice::share_of_period(chart_) * kBarShare;
  painter.setPen(QPen(colour_of(series.look.edge, c), 1));
  painter.setBrush(colour_of(series.look.fill, c));
  for (int row = 0; row < practice::row_count(chart_); ++row) {
    const QPointF top = point(series, *axis, row);
    if (top.y() < plot.bottom())
      painter.drawRect(QRectF(top.x() - wide / 2, top.y(), wide, plot.bottom() - top.y()));
  }
}

void DayChart::paint_line(QPainter& painter, const Series& series) const {
  const auto axis = practice::value_axis(chart_, series.side);
  if (!axis) return;
  const Colours& c = current_colours();
  QPolygonF line;
  for (int row = 0; row < practice::row_count(chart_); ++row) line.append(point(series, *axis, row));
  painter.setPen(line_pen(series, c));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(line);
  if (!practice::has_marks(chart_, series)) return;
  painter.setPen(QPen(colour_of(series.look.edge, c), 1));
  painter.setBrush(colour_of(series.look.fill, c));
  for (const QPointF& at : line) paint_mark(painter, series.look.mark, at);
}

void DayChart::paint_legend(QPainter& painter) const {
  const Colours& c = current_colours();
  const QFontMetricsF metrics(font());
  const auto width_of = [&](const QString& name) {
    return kLegendSign_px + kLegendSignGap_px + metrics.horizontalAdvance(name);
  };
  double all = kLegendGap_px * static_cast<double>(series_names_.size() - 1);
  for (const QString& name : series_names_) all += width_of(name);
  const QRectF inside(contentsRect());
  double x = std::max(inside.left(), inside.center().x() - all / 2);
  const double y = inside.bottom() - kMargin_px - legend_height(metrics) / 2;
  for (std::size_t i = 0; i < chart_.series.size(); ++i) {
    const Series& series = chart_.series[i];
    const QString name = series_names_.value(static_cast<qsizetype>(i));
    if (series.look.form == SeriesLook::Form::bars) {
      const double side = metrics.ascent() * 0.6;
      painter.setPen(QPen(colour_of(series.look.edge, c), 1));
      painter.setBrush(colour_of(series.look.fill, c));
      painter.drawRect(QRectF(x + kLegendSign_px - side, y - side / 2, side, side));
    } else {
      painter.setPen(line_pen(series, c));
      painter.drawLine(QPointF(x, y), QPointF(x + kLegendSign_px, y));
    }
    painter.setPen(c.ink);
    painter.drawText(
        QPointF(x + kLegendSign_px + kLegendSignGap_px, y + (metrics.ascent() - metrics.descent()) / 2),
        name);
    x += width_of(name) + kLegendGap_px;
  }
}

void DayChart::set_row(int row) {
  const int last = practice::row_count(chart_) - 1;
  row = last < 0 ? -1 : std::clamp(row, 0, last);
  if (row == row_) return;
  row_ = row;
  update();
  emit row_changed(row_);
}

void DayChart::keyPressEvent(QKeyEvent* event) {
  using practice::RowStep;
  const auto step = [this](RowStep by) { set_row(practice::row_after(chart_, row_, by)); };
  switch (event->key()) {
    case Qt::Key_Left:
      step(RowStep::previous);
      return;
    case Qt::Key_Right:
      step(RowStep::next);
      return;
    case Qt::Key_Home:
      step(RowStep::first);
      return;
    case Qt::Key_End:
      step(RowStep::last);
      return;
    default:
      QFrame::keyPressEvent(event);
  }
}

void DayChart::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  const QRectF plot = plot_area();
  if (plot.width() > 0)
    set_row(practice::row_near(chart_, (event->position().x() - plot.left()) / plot.width()));
}

}  // namespace nazori::ui
