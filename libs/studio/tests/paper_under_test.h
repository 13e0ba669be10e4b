// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <vector>

#include "nazori/studio/brush/brush_cursor.h"
#include "nazori/studio/brush/paper_view.h"
#include "painted_lightly.h"
#include "print_qt.h"

namespace nazori::ui::test {

/// A straight brush: its tip at the pen, its root two centimetres above it.
inline calligraphy::BrushShape upright(double half_width_m = 0.004) {
  calligraphy::BrushShape brush;
  brush.shaft_m = 0.008;
  brush.touches = true;
  for (const double z_m : {0.02, 0.01, 0.0}) {
    brush::TuftSection section;
    section.z_m = z_m;
    section.half_width_m = half_width_m * z_m / 0.02;
    brush.sections.push_back(section);
  }
  return brush;
}

/// The sheet under the brush, and what a mouse or a pen makes on it.
class PaperViewTest : public PaintedLightly {
 protected:
  PaperViewTest() {
    view_.set_picture_side(64);
    resize_unseen(view_, {300, 300});  // a sheet of 272 pixels at 14, 14
    QObject::connect(&view_, &PaperView::pen_moved, &view_,
                     [this](const brush::PenSample& sample) { samples_.push_back(sample); });
    QObject::connect(&view_, &PaperView::pen_lost, &view_, [this] { ++lost_; });
    QObject::connect(&view_, &PaperView::eraser_used, &view_, [this] { ++erased_; });
  }
  QImage painted() {
    QImage picture(view_.size(), QImage::Format_RGB32);
    picture.fill(Qt::magenta);
    view_.render(&picture, {}, {}, QWidget::RenderFlags());
    return picture;
  }
  /// The colour at a place of the sheet, by metres from its middle.
  QColor at(const QImage& picture, double x_m, double y_m) {
    return picture.pixelColor(view_.place().to_widget({x_m, y_m}).toPoint());
  }
  static void expect_colour(const QColor& seen, const QColor& wanted) {
    EXPECT_NEAR(seen.red(), wanted.red(), 2) << seen.name().toStdString();
    EXPECT_NEAR(seen.green(), wanted.green(), 2) << seen.name().toStdString();
    EXPECT_NEAR(seen.blue(), wanted.blue(), 2) << seen.name().toStdString();
  }
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button = Qt::LeftButton, quint64 ms = 0) {
    QMouseEvent event(type, at, at, button, button, {});
    event.setTimestamp(ms);
    QCoreApplication::sendEvent(&view_, &event);
  }
  struct PenState {
    double pressure = 0.5;
    QPointF tilt = {};
    double rotation = 0;
  };
  void pen(const QPointingDevice& from, QEvent::Type type, QPointF at, const PenState& state,
           Qt::MouseButton button = Qt::LeftButton) {
    QTabletEvent event(type, &from, at, at, state.pressure, static_cast<float>(state.tilt.x()),
                       static_cast<float>(state.tilt.y()), 0, state.rotation, 0, Qt::NoModifier, button,
                       button);
    event.setTimestamp(ms_ += 10);
    QCoreApplication::sendEvent(&view_, &event);
    EXPECT_TRUE(event.isAccepted()) << "Qt would make a mouse of it";
  }
  static QPointingDevice device(QPointingDevice::PointerType pointer, QInputDevice::Capabilities can) {
    return QPointingDevice(QStringLiteral("pen"), 60 + static_cast<int>(pointer) + 10 * can.toInt(),
                           QInputDevice::DeviceType::Stylus, pointer, can, 1, 3);
  }
  void expect_at(const brush::PenSample& sample, QPointF place) {
    const auto wanted = view_.place().to_paper(place);
    EXPECT_NEAR(sample.at.x, wanted.x, 1e-9);
    EXPECT_NEAR(sample.at.y, wanted.y, 1e-9);
  }
  const QPointF middle_{150, 150};
  const QColor paper_{247, 244, 236};
  quint64 ms_ = 50'000;
  PaperView view_{nullptr};
  std::vector<brush::PenSample> samples_;
  int lost_ = 0, erased_ = 0;
};

}  // namespace nazori::ui::test
