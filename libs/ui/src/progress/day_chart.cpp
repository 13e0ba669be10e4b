// SPDX-License-Identifier: Apache-2.0
#include "progress/day_chart.h"

#include <QBarLegendMarker>
#include <QBarSeries>
#include <QBarSet>
#include <QCategoryAxis>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QGraphicsLineItem>
#include <QKeyEvent>
#include <QLegendMarker>
#include <QLineSeries>
#include <QMouseEvent>
#include <QScatterSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "palette.h"

namespace nazori::ui {
namespace {

constexpr int kMostMarks = 62;
constexpr double kLine_px = 2.5;
constexpr double kMark_px = 8;
constexpr double kRoomBetweenLabels = 1.6;

/// A top of an axis that divides well: 1, 2, 4 or 5 times a power of ten over the value.
double nice_over(double value, bool whole) {
  if (value <= 0) return 1;
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 4.0, 5.0, 10.0})
    if (factor * power >= value) return whole ? std::max(1.0, std::ceil(factor * power)) : factor * power;
  return 10 * power;
}

}  // namespace

DayChart::DayChart(QWidget* parent) : QChartView(parent) {
  setRenderHint(QPainter::Antialiasing);
  setFocusPolicy(Qt::StrongFocus);
  setFrameShape(QFrame::NoFrame);
  setBackgroundBrush(Qt::NoBrush);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void DayChart::show_chart(const Chart& chart) {
  chart_ = chart;
  row_ = -1;
  draw();
}

void DayChart::draw() {
  auto* drawn = new QChart;
  const Colours& c = current_colours();
  drawn->setBackgroundVisible(false);
  drawn->setMargins(QMargins(4, 6, 4, 4));
  drawn->layout()->setContentsMargins(0, 0, 0, 0);
  drawn->legend()->setVisible(chart_.series.size() > 1);
  drawn->legend()->setAlignment(Qt::AlignBottom);
  drawn->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
  drawn->legend()->setFont(font());
  drawn->legend()->setLabelColor(c.ink);
  days_ = new QCategoryAxis;
  days_->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  days_->setLabelsFont(font());
  days_->setLabelsColor(c.muted);
  days_->setGridLineVisible(false);
  days_->setLinePenColor(c.line);
  const double last = chart_.places.isEmpty() ? 0 : chart_.places.back();
  days_->setStartValue(-0.5);
  days_->setRange(-0.5, last + 0.5);
  drawn->addAxis(days_, Qt::AlignBottom);
  QValueAxis* axes[2] = {nullptr, nullptr};
  const auto axis_for = [&](const ChartSeries& series) {
    QValueAxis*& axis = axes[series.axis == ChartSeries::Axis::right ? 1 : 0];
    if (axis != nullptr) return axis;
    axis = new QValueAxis;
    const auto [least, most] = std::minmax_element(series.values.begin(), series.values.end());
    const bool whole = series.form == ChartSeries::Form::bars;
    double low = std::min(0.0, *least < 0 ? -nice_over(-*least, false) : 0.0);
    double high = *most <= 0 && low < 0 ? 0.0 : nice_over(*most, whole);
    if (series.axis == ChartSeries::Axis::left && chart_.left_range) {
      low = chart_.left_range->first;
      high = chart_.left_range->second;
    }
    axis->setRange(low, high);
    const double span = high - low;
    axis->setTickCount(whole && span < 4 ? static_cast<int>(span) + 1 : 5);
    const double step = span / (axis->tickCount() - 1);
    const auto divides = [step](double by) { return std::abs(by * step - std::round(by * step)) < 1e-9; };
    const QString number = divides(1)    ? QStringLiteral("%.0f")
                           : divides(10) ? QStringLiteral("%.1f")
                                         : QStringLiteral("%.2f");
    axis->setLabelFormat(number + series.unit);
    axis->setLabelsFont(font());
    axis->setLabelsColor(c.muted);
    axis->setLinePenColor(c.line);
    axis->setGridLineColor(c.line);
    axis->setGridLineVisible(series.axis == ChartSeries::Axis::left);
    drawn->addAxis(axis, series.axis == ChartSeries::Axis::right ? Qt::AlignRight : Qt::AlignLeft);
    return axis;
  };
  bool second = false;
  for (const ChartSeries& series : chart_.series) {
    auto* axis = axis_for(series);
    const auto before = drawn->series().size();
    if (series.form == ChartSeries::Form::bars)
      add_bars(*drawn, series);
    else
      add_line(*drawn, series, std::exchange(second, true));
    const auto all = drawn->series();
    for (auto i = before; i < all.size(); ++i) {
      all[i]->attachAxis(days_);
      all[i]->attachAxis(axis);
    }
  }
  // The sign of bars is drawn without their colour otherwise, and is not seen on dark paper.
  for (auto* marker : drawn->legend()->markers())
    if (qobject_cast<QBarLegendMarker*>(marker) != nullptr) {
      marker->setShape(QLegend::MarkerShapeRectangle);
      marker->setBrush(blend(c.surface, c.indigo, 0.55));
      marker->setPen(c.indigo);
    }
  // Attaching bars spreads the axis over them; it is ours to say.
  days_->setRange(-0.5, last + 0.5);
  auto* old = chart();
  setChart(drawn);
  delete old;
  mark_ = new QGraphicsLineItem(drawn);
  mark_->setPen(QPen(c.indigo, 2, Qt::DotLine));
  mark_->setZValue(20);
  label_days();
  mark_row();
}

void DayChart::add_bars(QChart& chart, const ChartSeries& series) {
  const Colours& c = current_colours();
  auto* set = new QBarSet(series.name);
  // Bars stand at 0, 1, 2, ...: rows that are left out are empty ones.
  qsizetype row = 0;
  for (int place = 0; row < series.values.size(); ++place)
    set->append(std::lround(chart_.places[row]) == place ? series.values[row++] : 0.0);
  set->setColor(blend(c.surface, c.indigo, 0.55));
  set->setBorderColor(c.indigo);
  auto* bars = new QBarSeries;
  bars->setBarWidth(0.8);
  bars->append(set);
  chart.addSeries(bars);
}

void DayChart::add_line(QChart& chart, const ChartSeries& series, bool second) {
  const Colours& c = current_colours();
  const QColor colour = second ? c.indigo : c.ink;
  auto* line = new QLineSeries;
  line->setName(series.name);
  for (qsizetype row = 0; row < series.values.size(); ++row)
    line->append(chart_.places[row], series.values[row]);
  line->setPen(QPen(colour, kLine_px, second ? Qt::DashLine : Qt::SolidLine));
  chart.addSeries(line);
  if (series.values.size() > kMostMarks) return;
  auto* marks = new QScatterSeries;
  marks->setMarkerShape(second ? QScatterSeries::MarkerShapeRectangle : QScatterSeries::MarkerShapeCircle);
  marks->setMarkerSize(kMark_px);
  marks->setColor(second ? c.surface : colour);
  marks->setBorderColor(colour);
  marks->append(line->points());
  chart.addSeries(marks);
  for (auto* marker : chart.legend()->markers(marks)) marker->setVisible(false);
}

void DayChart::label_days() {
  if (days_ == nullptr || chart_.row_names.isEmpty()) return;
  for (const QString& label : days_->categoriesLabels()) days_->remove(label);
  double widest = 1;
  const QFontMetricsF metrics(font());
  for (const QString& name : chart_.row_names) widest = std::max(widest, metrics.horizontalAdvance(name));
  const double room = std::max(1.0, width() - 6 * widest / kRoomBetweenLabels);
  const int most = std::max(2, static_cast<int>(room / (widest * kRoomBetweenLabels)));
  // Rows need not lie evenly: days without study may be left out.
  const double apart = (chart_.places.back() + 1) / most;
  double next = chart_.places.front();
  for (qsizetype row = 0; row < chart_.row_names.size(); ++row) {
    if (chart_.places[row] < next) continue;
    next = chart_.places[row] + apart;
    // Rows of equal names (the same day in two years) would be one label.
    QString name = chart_.row_names[row];
    while (days_->categoriesLabels().contains(name)) name += QChar(0x200B);
    days_->append(name, chart_.places[row]);
  }
}

void DayChart::set_row(int row) {
  const int last = static_cast<int>(chart_.places.size()) - 1;
  row = last < 0 ? -1 : std::clamp(row, 0, last);
  if (row == row_) return;
  row_ = row;
  mark_row();
  emit row_changed(row_);
}

void DayChart::mark_row() {
  if (mark_ == nullptr) return;
  mark_->setVisible(row_ >= 0);
  if (row_ < 0) return;
  const QRectF plot = chart()->plotArea();
  const double span = chart_.places.back() + 1;
  const double x = plot.left() + plot.width() * (chart_.places[row_] + 0.5) / span;
  mark_->setLine(x, plot.top(), x, plot.bottom());
}

void DayChart::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(chart_.places.size()) - 1;
  switch (event->key()) {
    case Qt::Key_Left:
      set_row(row_ < 0 ? last : row_ - 1);
      return;
    case Qt::Key_Right:
      set_row(row_ < 0 ? 0 : row_ + 1);
      return;
    case Qt::Key_Home:
      set_row(0);
      return;
    case Qt::Key_End:
      set_row(last);
      return;
    default:
      // Not the view's own keys, which scroll.
      QWidget::keyPressEvent(event);
  }
}

void DayChart::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  const QRectF plot = chart()->plotArea();
  if (chart_.places.isEmpty() || plot.width() <= 0) return;
  const double x = (event->position().x() - plot.left()) / plot.width() * (chart_.places.back() + 1) - 0.5;
  const auto nearest = std::min_element(chart_.places.begin(), chart_.places.end(), [x](double a, double b) {
    return std::abs(a - x) < std::abs(b - x);
  });
  set_row(static_cast<int>(nearest - chart_.places.begin()));
}

void DayChart::resizeEvent(QResizeEvent* event) {
  QChartView::resizeEvent(event);
  label_days();
  mark_row();
}

void DayChart::focusInEvent(QFocusEvent* event) {
  QChartView::focusInEvent(event);
  parentWidget()->update();
}

void DayChart::focusOutEvent(QFocusEvent* event) {
  QChartView::focusOutEvent(event);
  parentWidget()->update();
}

void DayChart::wheelEvent(QWheelEvent* event) {
  // The page scrolls, not the chart.
  event->ignore();
}

}  // namespace nazori::ui
