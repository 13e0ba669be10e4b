// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/groove_curve.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QFontInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr double kReach_px = 14;     ///< how near a click must be to a point, sideways
constexpr double kTremble_px = 2;    ///< a click that moves less is no drag
constexpr double kWidthStep = 0.25;  ///< of an arrow key: half a unit of the width [glyph units]
constexpr double kDepthStep = 0.05;
constexpr double kFine = 0.2;    ///< share of a step, with Shift
constexpr double kLeastTop = 8;  ///< of the scale for half widths [glyph units]

/// The curve as a control with a value, which assistive technology can read and change.
class CurveAccess final : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit CurveAccess(GrooveCurve* curve) : QAccessibleWidget(curve, QAccessible::Slider) {}

  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ValueInterface ? static_cast<QAccessibleValueInterface*>(this)
                                               : QAccessibleWidget::interface_cast(type);
  }
  [[nodiscard]] QString text(QAccessible::Text which) const override {
    if (which == QAccessible::Value || which == QAccessible::Description) return curve().value_words();
    return QAccessibleWidget::text(which);
  }
  [[nodiscard]] QVariant currentValue() const override { return curve().value().value_or(0); }
  void setCurrentValue(const QVariant& value) override { curve().set_value(value.toDouble()); }
  [[nodiscard]] QVariant maximumValue() const override { return curve().largest(); }
  [[nodiscard]] QVariant minimumValue() const override { return 0.0; }
  [[nodiscard]] QVariant minimumStepSize() const override { return curve().step(); }

 private:
  [[nodiscard]] GrooveCurve& curve() const { return *static_cast<GrooveCurve*>(widget()); }
};

QAccessibleInterface* make_curve(const QString& /*class_name*/, QObject* object) {
  auto* curve = qobject_cast<GrooveCurve*>(object);
  return curve != nullptr ? new CurveAccess(curve) : nullptr;
}

}  // namespace

GrooveCurve::GrooveCurve(Quantity quantity, const char* name, QWidget* parent)
    : QWidget(parent), quantity_(quantity) {
  QAccessible::installFactory(make_curve);  // once, however often it is asked for
  const bool width = quantity == Quantity::half_width;
  named(this, name, width ? tr("Width along the stroke") : tr("Depth along the stroke"));
  setToolTip(width ? tr("Drag a point up or down, or choose one with Left and Right and make it wider or "
                        "thinner with Up and Down")
                   : tr("Drag a point up or down, or choose one with Left and Right and make it shallower or "
                        "deeper with Up and Down"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize GrooveCurve::sizeHint() const {
  const int em = QFontInfo(font()).pixelSize();
  return {em * 8, em * 6};
}

double GrooveCurve::largest() const { return quantity_ == Quantity::depth ? 1 : carving::kWidestHalf; }

double GrooveCurve::step() const { return quantity_ == Quantity::depth ? kDepthStep : kWidthStep; }

double GrooveCurve::value_of(const carving::GroovePoint& point) const {
  return quantity_ == Quantity::depth ? point.depth : point.half_width;
}

std::optional<double> GrooveCurve::value() const {
  if (!point_) return {};
  return value_of(groove_[*point_]);
}

void GrooveCurve::show_groove(const carving::Groove& groove, std::optional<std::size_t> point) {
  const auto before = std::pair(value(), point_);
  groove_ = groove;
  point_ = point && *point < groove.size() ? point : std::nullopt;
  along_.assign(groove.size(), 0);
  line_.clear();
  if (!groove.empty()) {
    const auto smooth = carving::smooth_line(groove);
    const double length = std::max(smooth.back().arc_length, 1e-9);
    for (const auto& place : smooth) {
      const double along = place.arc_length / length;
      line_.append({along, quantity_ == Quantity::depth ? place.depth : place.half_width});
      // The first place of a segment is the point where it begins.
      if (place.segment > 0 && along_[place.segment] == 0) along_[place.segment] = along;
    }
    // Of points at one place only the last has a place of its own.
    for (std::size_t i = 1; i < along_.size(); ++i) along_[i] = std::max(along_[i], along_[i - 1]);
  }
  // The scale stays while a point is dragged: the point would run away from the pointer.
  if (!drags_) {
    top_ = quantity_ == Quantity::depth ? 1 : kLeastTop;
    if (quantity_ == Quantity::half_width)
      for (const auto& one : groove) top_ = std::max(top_, 1.25 * one.half_width);
  }
  update();
  if (before != std::pair(value(), point_)) note_value();
}

void GrooveCurve::note_value() {
  QAccessibleValueChangeEvent changed(this, value().value_or(0));
  QAccessible::updateAccessibility(&changed);
}

QString GrooveCurve::value_words() const {
  if (groove_.empty()) return tr("No stroke is chosen.");
  if (!point_) return tr("%n points. Left and Right choose one.", nullptr, static_cast<int>(groove_.size()));
  const QString which = tr("Point %1 of %2: %3").arg(*point_ + 1).arg(groove_.size());
  return quantity_ == Quantity::depth
             ? which.arg(tr("depth %1%").arg(QLocale().toString(100 * *value(), 'f', 0)))
             : which.arg(tr("width %1").arg(QLocale().toString(2 * *value(), 'f', 1)));
}

QRectF GrooveCurve::room() const {
  const double line = QFontInfo(font()).pixelSize() * 1.5;
  return QRectF(rect()).adjusted(10, line, -10, -8);
}

QPointF GrooveCurve::to_widget(double along, double value) const {
  const QRectF r = room();
  const double share = value / top_;
  return {r.left() + along * r.width(),
          quantity_ == Quantity::depth ? r.top() + share * r.height() : r.bottom() - share * r.height()};
}

double GrooveCurve::value_at(double y) const {
  const QRectF r = room();
  const double share =
      (quantity_ == Quantity::depth ? y - r.top() : r.bottom() - y) / std::max(r.height(), 1.0);
  return std::clamp(share * top_, 0.0, largest());
}

QPointF GrooveCurve::place_of(std::size_t point) const {
  return to_widget(along_[point], value_of(groove_[point]));
}

void GrooveCurve::step_to(std::size_t point) {
  if (point != point_) emit point_chosen(point);
  emit said(value_words());
}

void GrooveCurve::change(double value, bool goes_on) {
  emit value_moved(*point_, std::clamp(value, 0.0, largest()), goes_on);
}

void GrooveCurve::set_value(double value) {
  if (!point_) return;
  change(value, false);
  emit said(value_words());
}

void GrooveCurve::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || groove_.empty()) return;
  // The nearest point; of several at one place the one nearest in height.
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t point) {
    const QPointF away = place_of(point) - event->position();
    return std::hypot(away.x(), away.y() / 4);
  };
  for (std::size_t i = 1; i < groove_.size(); ++i)
    if (distance(i) < distance(nearest)) nearest = i;
  if (std::abs(place_of(nearest).x() - event->position().x()) > kReach_px) return;
  drags_ = true;
  has_dragged_ = false;
  if (nearest != point_) emit point_chosen(nearest);
  // The page may have refused.
  drags_ = point_ == nearest;
  if (drags_) grip_ = place_of(nearest).y() - event->position().y();
}

void GrooveCurve::mouseMoveEvent(QMouseEvent* event) {
  if (!drags_ || !point_) return;
  const double y = event->position().y() + grip_;
  if (!has_dragged_ && std::abs(y - place_of(*point_).y()) < kTremble_px) return;
  change(value_at(y), std::exchange(has_dragged_, true));
}

void GrooveCurve::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !std::exchange(drags_, false)) return;
  // The scale fits again.
  show_groove(carving::Groove(groove_), point_);
  emit said(value_words());
}

void GrooveCurve::keyPressEvent(QKeyEvent* event) {
  const auto modifiers = event->modifiers() & ~Qt::KeypadModifier;
  const bool plain = modifiers == Qt::NoModifier || modifiers == Qt::ShiftModifier;
  if (!plain || groove_.empty()) return QWidget::keyPressEvent(event);
  const double by = step() * (modifiers == Qt::ShiftModifier ? kFine : 1);
  // The Up key moves the point up in the picture: that makes a groove wider, or shallower.
  const double up = quantity_ == Quantity::depth ? -by : by;
  const std::size_t last = groove_.size() - 1;
  const auto move = [&](double change_by) {
    if (!point_) return step_to(0);
    change(*value() + change_by, event->isAutoRepeat());
    emit said(value_words());
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return step_to(point_.value_or(1) > 0 ? point_.value_or(1) - 1 : 0);
    case Qt::Key_Right:
      return step_to(point_ ? std::min(*point_ + 1, last) : 0);
    case Qt::Key_Home:
      return step_to(0);
    case Qt::Key_End:
      return step_to(last);
    case Qt::Key_Up:
      return move(up);
    case Qt::Key_Down:
      return move(-up);
    default:
      QWidget::keyPressEvent(event);
  }
}

void GrooveCurve::paintEvent(QPaintEvent* /*event*/) {
  const Colours& c = current_colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(hasFocus() ? c.indigo : c.edge, hasFocus() ? 2 : 1));
  painter.setBrush(c.surface);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  const QRectF head = QRectF(rect()).adjusted(8, 3, -8, 0);
  painter.setPen(c.muted);
  painter.drawText(head, Qt::AlignLeft | Qt::AlignTop,
                   quantity_ == Quantity::depth ? tr("Depth") : tr("Width"));
  if (line_.isEmpty()) return;
  if (const auto held = value()) {
    painter.setPen(c.ink);
    painter.drawText(head, Qt::AlignRight | Qt::AlignTop,
                     quantity_ == Quantity::depth ? tr("%1%").arg(QLocale().toString(100 * *held, 'f', 0))
                                                  : QLocale().toString(2 * *held, 'f', 1));
  }
  painter.setClipRect(QRectF(rect()).adjusted(2, 2, -2, -2));
  QPolygonF curve;
  for (const QPointF& place : line_) curve.append(to_widget(place.x(), place.y()));
  QPolygonF area = curve;
  area.append(to_widget(line_.back().x(), 0));
  area.append(to_widget(line_.front().x(), 0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(blend(c.surface, c.indigo, 0.18));
  painter.drawPolygon(area);
  painter.setPen(QPen(c.indigo, 1.5));
  painter.drawPolyline(curve);
  for (std::size_t i = 0; i < groove_.size(); ++i) {
    const bool chosen = i == point_;
    const double half = chosen ? 5 : 3;
    painter.setPen(QPen(chosen ? c.vermilion : c.indigo, 1.5));
    painter.setBrush(chosen ? c.vermilion : c.surface);
    painter.drawRect(QRectF(place_of(i) - QPointF(half, half), QSizeF(2 * half, 2 * half)));
  }
}

void GrooveCurve::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void GrooveCurve::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace nazori::ui
