// SPDX-License-Identifier: Apache-2.0
// The brush above the paper, shape by shape, and the sheet under it: its picture, its guides and its pen.
#include <gtest/gtest.h>

#include <QFontInfo>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QTouchEvent>
#include <cmath>
#include <numbers>

#include "nazori/studio/brush/brush_cursor.h"
#include "nazori/studio/brush/paper_view.h"
#include "painted_lightly.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using test::Drawn;

constexpr double kPerM = 4000;

/// A straight brush: its tip at the pen, its root two centimetres above it.
calligraphy::BrushShape upright(double half_width_m = 0.004) {
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

std::vector<Drawn> drawn(const calligraphy::BrushShape& brush, QPointF pen, bool left = false) {
  return test::drawn_by(
             QSize(900, 900),
             [&](QPainter& painter) { paint_brush(painter, brush, QColor(28, 26, 25), pen, kPerM, left); })
      .all;
}

/// The box of a ribbon from a pen to a root, as wide as the root and with a point at the pen.
QRectF ribbon(QPointF pen, QPointF root, double half_px) {
  const QPointF way = pen - root;
  const QPointF across = QPointF(-way.y(), way.x()) / std::hypot(way.x(), way.y()) * half_px;
  return QPolygonF({root + across, pen, root - across}).boundingRect();
}

void expect_same(const QRectF& seen, const QRectF& wanted) {
  EXPECT_NEAR(seen.left(), wanted.left(), 0.01);
  EXPECT_NEAR(seen.top(), wanted.top(), 0.01);
  EXPECT_NEAR(seen.right(), wanted.right(), 0.01);
  EXPECT_NEAR(seen.bottom(), wanted.bottom(), 0.01);
}

TEST(BrushInTheAir, ItsShadowFallsToTheLowerRightSofterFromOutsideIn) {
  const QPointF pen(300, 400);
  const auto all = drawn(upright(), pen);
  ASSERT_EQ(all.size(), 3U + 2 + 8 + 1) << "shadows, hair and root, hairs, shaft";
  const QRectF shadow = ribbon(pen, pen + QPointF(0.16, 0.10) * 0.02 * kPerM, 16);
  const double widths[] = {6, 3, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    expect_same(all[i].box, shadow);
    EXPECT_EQ(all[i].fill.color(), QColor(30, 20, 10, 26));
    if (widths[i] == 0) {
      EXPECT_EQ(all[i].pen.style(), Qt::NoPen);
    } else {
      EXPECT_EQ(all[i].pen.widthF(), widths[i]);
      EXPECT_EQ(all[i].pen.color(), QColor(30, 20, 10, 16));
    }
  }
}

TEST(BrushInTheAir, ItsHairGoesFromItsOwnColourToThatOfTheInk) {
  const QPointF pen(300, 400);
  for (const bool left : {false, true}) {
    const auto all = drawn(upright(), pen, left);
    ASSERT_EQ(all.size(), 14U);
    const QPointF root = pen + QPointF(left ? -0.20 : 0.20, -0.42) * 0.02 * kPerM;
    expect_same(all[3].box, ribbon(pen, root, 16));
    const auto* wet = all[3].fill.gradient();
    ASSERT_NE(wet, nullptr);
    const QColor ink(28, 26, 25);
    EXPECT_EQ(wet->stops(),
              (QGradientStops{{0, QColor(58, 46, 38)}, {0.35, ink.darker(120)}, {1, ink.darker(150)}}));
    EXPECT_EQ(all[3].pen.style(), Qt::NoPen);
    EXPECT_TRUE(all[4].round);
    expect_same(all[4].box, QRectF(root - QPointF(16, 12), QSizeF(32, 24)));
  }
}

TEST(BrushInTheAir, EightHairsDivideItEvenlyAndEndAboveTheTip) {
  const QPointF pen(300, 400);
  const auto all = drawn(upright(), pen);
  ASSERT_EQ(all.size(), 14U);
  const QPointF root = pen + QPointF(0.20, -0.42) * 0.02 * kPerM;
  const QPointF way = pen - root;
  const QPointF across = QPointF(-way.y(), way.x()) / std::hypot(way.x(), way.y());
  for (int line = 1; line <= 8; ++line) {
    const Drawn& hair = all[static_cast<std::size_t>(4 + line)];
    ASSERT_EQ(hair.points.size(), 2) << line;
    // From one side of the ribbon to the other, in ninths.
    const double share = 1 - 2 * line / 9.0;
    const QPointF from = root + across * (16 * share), to = root + way / 2 + across * (8 * share);
    EXPECT_NEAR(hair.points[0].x(), from.x(), 0.01) << line;
    EXPECT_NEAR(hair.points[0].y(), from.y(), 0.01) << line;
    EXPECT_NEAR(hair.points[1].x(), to.x(), 0.01) << line;
    EXPECT_NEAR(hair.points[1].y(), to.y(), 0.01) << line;
    EXPECT_EQ(hair.pen.color(), QColor(150, 130, 112, 90));
    EXPECT_NEAR(hair.pen.widthF(), 0.05 * 16, 0.001) << "a twentieth of the root";
  }
  const auto* bamboo = all.back().fill.gradient();
  ASSERT_NE(bamboo, nullptr);
  EXPECT_EQ(bamboo->stops(), (QGradientStops{{0, QColor(128, 96, 54, 225)},
                                             {0.12, QColor(196, 160, 104, 215)},
                                             {1, QColor(196, 160, 104, 0)}}));
  const auto& along = static_cast<const QLinearGradient&>(*bamboo);
  EXPECT_NEAR(along.start().y(), root.y(), 0.01) << "pale towards its end";
  EXPECT_LT(along.finalStop().y(), root.y());
}

TEST(BrushInTheAir, TheFinestBrushCanStillBeSeen) {
  const auto all = drawn(upright(0.0001), {300, 400});  // 0.4 pixels
  ASSERT_EQ(all.size(), 14U);
  EXPECT_NEAR(all[4].box.width(), 2, 0.01);
  EXPECT_NEAR(all[4].box.height(), 1.5, 0.01);
  EXPECT_NEAR(all[5].pen.widthF(), 0.6, 0.001);
}

TEST(BrushInTheAir, ItsTipIsAbovePenHoweverTheHairIsBent) {
  const QPointF pen(300, 400);
  auto bent = upright();
  bent.pen = {0.001, 0.002};
  for (auto& section : bent.sections) section.at = {0.011, 0.002 + 0.005};
  const auto box = [&](bool touches) {
    bent.touches = touches;
    return drawn(bent, pen)[3].box;
  };
  const QPointF root(0.20 * 0.02 * kPerM, -0.42 * 0.02 * kPerM);
  // On the paper it is where the hair is: 1 cm to the right and half a centimetre up, which is y on paper.
  const QPointF there = pen + QPointF(40, -20);
  expect_same(box(true), ribbon(there, there + root, 16));
  expect_same(box(false), ribbon(pen, pen + root, 16));
}

TEST(BrushInTheAir, ItsBoundsHoldHairShaftAndShadowOfBothHands) {
  calligraphy::BrushShape brush;
  brush.shaft_m = 0.008;
  brush.touches = true;
  brush::TuftSection section;
  section.z_m = 0.01;
  section.half_width_m = 0.002;
  brush.sections = {section};
  const QPointF pen(300, 400);
  // The shaft ends 8.5 cm above the paper: 0.2 of that to each side, 0.42 up, and its shadow 0.1 down.
  const QRectF seen(QPointF(300 - 68, 400 - 142.8), QPointF(300 + 68 + 1, 400 + 34 + 1));
  expect_same(brush_bounds(brush, pen, kPerM), seen.adjusted(-40, -40, 40, 40));
  brush.sections[0].half_width_m = 0.01;
  expect_same(brush_bounds(brush, pen, kPerM), seen.adjusted(-48, -48, 48, 48));
  brush.sections[0].at = {0.01, 0.02};
  expect_same(brush_bounds(brush, pen, kPerM),
              seen.translated(40, -80).united(QRectF(pen, QSizeF(1, 1))).adjusted(-48, -48, 48, 48));
  brush.touches = false;
  expect_same(brush_bounds(brush, pen, kPerM), seen.adjusted(-48, -48, 48, 48));
  brush.sections.clear();
  expect_same(brush_bounds(brush, pen, kPerM), QRectF(300 - 40, 400 - 40, 81, 81));
}

class SheetUnderTheBrush : public test::PaintedLightly {
 protected:
  SheetUnderTheBrush() {
    view_.set_picture_side(64);
    test::resize_unseen(view_, {300, 300});  // a sheet of 272 pixels at 14, 14
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

TEST_F(SheetUnderTheBrush, IsCalledSoAndTakesKeysAndFingers) {
  EXPECT_EQ(view_.objectName(), QStringLiteral("paper_view"));
  EXPECT_EQ(view_.accessibleName(), QStringLiteral("Sheet of paper"));
  EXPECT_EQ(view_.focusPolicy(), Qt::StrongFocus);
  EXPECT_TRUE(view_.hasMouseTracking());
  EXPECT_TRUE(view_.testAttribute(Qt::WA_AcceptTouchEvents));
  EXPECT_TRUE(view_.testAttribute(Qt::WA_OpaquePaintEvent));
  EXPECT_EQ(view_.sizePolicy(), QSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding));
  EXPECT_EQ(view_.picture().size(), QSize(64, 64));
  EXPECT_EQ(view_.picture().pixelColor(63, 63), paper_);
}

TEST_F(SheetUnderTheBrush, ATileIsSeenInItsPlaceAndOneBeyondTheSheetIsLeftOut) {
  constexpr int kSide = calligraphy::PictureTile::kSide;
  view_.set_picture_side(2 * kSide);
  calligraphy::BrushFrame frame;
  calligraphy::PictureTile tile;
  tile.column = kSide;
  tile.row = 0;
  for (std::size_t i = 0; i < tile.rgb.size(); i += 3) {
    tile.rgb[i] = 200;
    tile.rgb[i + 1] = 100;
    tile.rgb[i + 2] = 50;
  }
  frame.tiles = {tile};
  for (const auto& [column, row] :
       {std::pair(2 * kSide, 0), std::pair(0, 2 * kSide), std::pair(kSide + 1, 0)}) {
    frame.tiles.push_back(tile);
    frame.tiles.back().column = column;
    frame.tiles.back().row = row;
    frame.tiles.back().rgb.fill(7);
  }
  view_.show_frame(frame);
  const QColor ink(200, 100, 50);
  EXPECT_EQ(view_.picture().pixelColor(kSide, 0), ink);
  EXPECT_EQ(view_.picture().pixelColor(2 * kSide - 1, kSide - 1), ink);
  EXPECT_EQ(view_.picture().pixelColor(kSide - 1, 0), paper_);
  EXPECT_EQ(view_.picture().pixelColor(kSide, kSide), paper_);
  const QImage seen = painted();
  expect_colour(seen.pixelColor(14 + 204, 14 + 68), ink);
  expect_colour(seen.pixelColor(14 + 68, 14 + 68), paper_);
  expect_colour(seen.pixelColor(14 + 204, 14 + 204), paper_);
  // Up to the edges of the tile, but for the pixels that are mixed there.
  expect_colour(seen.pixelColor(14 + 136 + 3, 14 + 2), ink);
  expect_colour(seen.pixelColor(14 + 269, 14 + 136 - 4), ink);
  expect_colour(seen.pixelColor(14 + 136 - 4, 14 + 2), paper_);
}

TEST_F(SheetUnderTheBrush, AModelBeneathItAndTheRulingShineThrough) {
  calligraphy::ModelStroke stroke;
  stroke.points = {{-0.025, 0}, {0.025, 0}};
  stroke.half_width_m = {0.006, 0.006};
  view_.show_model({stroke}, {{{0, 0}, 0.08}}, ModelPlace::beneath);
  const QImage seen = painted();
  const auto times = [this](const QColor& other) {
    return QColor(paper_.red() * other.red() / 255, paper_.green() * other.green() / 255,
                  paper_.blue() * other.blue() / 255);
  };
  expect_colour(at(seen, 0.015, 0.002), times(QColor(242, 196, 182)));
  expect_colour(at(seen, -0.029, 0.002), times(QColor(242, 196, 182)));
  expect_colour(at(seen, 0.015, 0.012), paper_);
  // The square is ruled with a solid line, and its middle with dashed ones.
  const auto ruled = [&](double x_m, double y_m) {
    const QPoint middle = view_.place().to_widget({x_m, y_m}).toPoint();
    int found = 0;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const QColor colour = seen.pixelColor(middle + QPoint(dx, dy));
        found += std::abs(colour.green() - times(QColor(226, 178, 162)).green()) < 4 ? 1 : 0;
      }
    return found;
  };
  for (const double along : {-0.035, -0.02, 0.01, 0.03}) {
    EXPECT_GT(ruled(along, 0.04), 3) << along;
    EXPECT_GT(ruled(along, -0.04), 3) << along;
    EXPECT_GT(ruled(0.04, along), 3) << along;
    EXPECT_GT(ruled(-0.04, along), 3) << along;
  }
  int solid = 0;
  for (int y = view_.place().to_widget({0, 0.036}).toPoint().y();
       y < view_.place().to_widget({0, 0.008}).toPoint().y(); ++y)
    solid += std::abs(seen.pixelColor(static_cast<int>(view_.place().to_widget({0, 0}).x()), y).green() -
                      paper_.green()) > 10
                 ? 1
                 : 0;
  EXPECT_GT(solid, 10) << "dashes";
  EXPECT_LT(solid, 65) << "and gaps";
  view_.show_model({stroke}, {}, ModelPlace::none);
  expect_colour(at(painted(), 0.015, 0.002), paper_);
}

TEST_F(SheetUnderTheBrush, InTheDarkItIsDimmedAndCorrectionsAreNot) {
  QApplication::setPalette(make_palette(dark_colours()));
  calligraphy::CorrectionMark mark;
  mark.kind = calligraphy::CorrectionMark::Kind::circle;
  mark.radius_m = 0.03;
  view_.show_marks({mark});
  EXPECT_EQ(view_.marks().size(), 1U);
  const QImage seen = painted();
  // Black with 84 of 255 over it.
  const double left = 1 - 84 / 255.0;
  expect_colour(at(seen, 0.01, 0.01), QColor(static_cast<int>(247 * left), static_cast<int>(244 * left),
                                             static_cast<int>(236 * left)));
  const QColor line = at(seen, 0.03, 0);
  EXPECT_GT(line.red(), line.green() + 60) << "vermilion";
  QApplication::setPalette(make_palette(light_colours()));
}

TEST_F(SheetUnderTheBrush, AMouseWritesFromItsPressOnTheSheetToItsRelease) {
  mouse(QEvent::MouseButtonPress, {5, 5});
  mouse(QEvent::MouseMove, {9, 9});
  EXPECT_TRUE(samples_.empty()) << "beside the sheet, and above it";
  mouse(QEvent::MouseButtonPress, middle_, Qt::RightButton, 59'000);
  EXPECT_TRUE(samples_.empty());
  mouse(QEvent::MouseButtonPress, middle_, Qt::LeftButton, 60'000);
  mouse(QEvent::MouseMove, middle_ + QPointF(40, 20), Qt::NoButton, 60'250);
  mouse(QEvent::MouseButtonRelease, middle_, Qt::RightButton, 60'300);
  mouse(QEvent::MouseButtonRelease, middle_ + QPointF(60, 30), Qt::LeftButton, 60'500);
  ASSERT_EQ(samples_.size(), 3U);
  const auto tilt = calligraphy::assumed_tilt(false);
  const QPointF places[] = {middle_, middle_ + QPointF(40, 20), middle_ + QPointF(60, 30)};
  const double times[] = {60, 60.25, 60.5};
  for (std::size_t i = 0; i < 3; ++i) {
    expect_at(samples_[i], places[i]);
    EXPECT_NEAR(samples_[i].time_s, times[i], 1e-9);
    EXPECT_EQ(samples_[i].down, i < 2);
    EXPECT_FALSE(samples_[i].pressure);
    EXPECT_EQ(samples_[i].lean_rad, tilt.lean_rad);
    EXPECT_EQ(samples_[i].lean_to_rad, tilt.lean_to_rad);
    EXPECT_EQ(samples_[i].twist_rad, 0);
  }
  mouse(QEvent::MouseMove, middle_, Qt::NoButton, 60'600);
  EXPECT_EQ(samples_.size(), 3U) << "above the paper only the brush moves";
  view_.set_left_hand(true);
  mouse(QEvent::MouseButtonPress, middle_, Qt::LeftButton, 60'700);
  EXPECT_EQ(samples_.back().lean_to_rad, calligraphy::assumed_tilt(true).lean_to_rad);
  mouse(QEvent::MouseButtonRelease, middle_, Qt::LeftButton, 60'800);
}

TEST_F(SheetUnderTheBrush, ThePointerIsTheBrushAboveTheSheet) {
  mouse(QEvent::MouseMove, middle_, Qt::NoButton);
  EXPECT_EQ(view_.cursor().shape(), Qt::BlankCursor);
  mouse(QEvent::MouseMove, {3, 3}, Qt::NoButton);
  EXPECT_EQ(view_.cursor().shape(), Qt::ArrowCursor);
  view_.set_shows_brush(false);
  view_.show_brush_at({0, 0});
  EXPECT_EQ(view_.cursor().shape(), Qt::CrossCursor);
  view_.take_brush_away();
  EXPECT_EQ(view_.cursor().shape(), Qt::ArrowCursor);
}

TEST_F(SheetUnderTheBrush, TheBrushIsDrawnWhereItIsAndNotWhenItLeft) {
  calligraphy::BrushFrame frame;
  frame.brush = upright();
  frame.state.ink = "vermilion";
  view_.show_frame(frame);
  const auto shapes = [this] { return test::drawn_by(view_).all.size(); };
  const std::size_t alone = shapes();
  view_.show_brush_at({0, 0});
  EXPECT_EQ(shapes(), alone + 14);
  const auto all = test::drawn_by(view_).all;
  const auto& hair = all[alone + 3];
  ASSERT_NE(hair.fill.gradient(), nullptr);
  EXPECT_EQ(hair.fill.gradient()->stops().back().second, QColor(196, 62, 38).darker(150));
  view_.set_shows_brush(false);
  EXPECT_EQ(shapes(), alone);
  view_.set_shows_brush(true);
  view_.show_brush_at({0.5, 0.5});
  EXPECT_EQ(shapes(), alone) << "beside the sheet";
  view_.show_brush_at({0, 0});
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&view_, &leave);
  EXPECT_EQ(shapes(), alone);
  // While it writes it stays, also where the pointer leaves.
  mouse(QEvent::MouseButtonPress, middle_, Qt::LeftButton, 60'000);
  QCoreApplication::sendEvent(&view_, &leave);
  EXPECT_EQ(shapes(), alone + 14);
  mouse(QEvent::MouseMove, {2, 2}, Qt::NoButton, 60'100);
  EXPECT_EQ(shapes(), alone + 14) << "also beyond the edge";
  mouse(QEvent::MouseButtonRelease, {2, 2}, Qt::LeftButton, 60'200);
  EXPECT_EQ(shapes(), alone);
}

TEST_F(SheetUnderTheBrush, APenHasItsPressureItsTiltAndItsTurn) {
  using Can = QInputDevice::Capability;
  const auto full = device(QPointingDevice::PointerType::Pen,
                           Can::Position | Can::Pressure | Can::XTilt | Can::YTilt | Can::Rotation);
  pen(full, QEvent::TabletPress, middle_, {0.7, {30, 10}, 90});
  ASSERT_EQ(samples_.size(), 1U);
  EXPECT_TRUE(samples_[0].down);
  EXPECT_EQ(samples_[0].pressure, 0.7);
  const auto tilt = calligraphy::holder_tilt(30, 10, false);
  EXPECT_NEAR(samples_[0].lean_rad, tilt.lean_rad, 1e-6);
  EXPECT_NEAR(samples_[0].lean_to_rad, tilt.lean_to_rad, 1e-6);
  EXPECT_NEAR(samples_[0].twist_rad, -std::numbers::pi / 2, 1e-6) << "clockwise";
  EXPECT_NEAR(samples_[0].time_s, 50.01, 1e-9);
  pen(full, QEvent::TabletRelease, middle_, {0, {}, 0});
  EXPECT_FALSE(samples_.back().down);
  view_.set_left_hand(true);
  pen(full, QEvent::TabletPress, middle_, {0.7, {30, 10}, 90});
  EXPECT_NEAR(samples_.back().twist_rad, std::numbers::pi / 2, 1e-6);
  EXPECT_NEAR(samples_.back().lean_to_rad, calligraphy::holder_tilt(30, 10, true).lean_to_rad, 1e-6);
  pen(full, QEvent::TabletRelease, middle_, {0, {}, 0});
  view_.set_left_hand(false);
  const auto plain = device(QPointingDevice::PointerType::Pen, Can::Position);
  pen(plain, QEvent::TabletPress, middle_, {0.7, {30, 10}, 90});
  EXPECT_FALSE(samples_.back().pressure);
  EXPECT_EQ(samples_.back().lean_rad, calligraphy::assumed_tilt(false).lean_rad);
  EXPECT_EQ(samples_.back().twist_rad, 0);
  pen(plain, QEvent::TabletRelease, middle_, {0, {}, 0});
}

TEST_F(SheetUnderTheBrush, OnlyTheTipWritesAndOnlyWhereItCameDownOnTheSheet) {
  using Can = QInputDevice::Capability;
  const auto one = device(QPointingDevice::PointerType::Pen, Can::Position | Can::Pressure);
  pen(one, QEvent::TabletPress, middle_, {0.5}, Qt::RightButton);
  pen(one, QEvent::TabletPress, {3, 3}, {0.5});
  pen(one, QEvent::TabletMove, middle_, {0.5}, Qt::NoButton);
  EXPECT_TRUE(samples_.empty());
  pen(one, QEvent::TabletRelease, middle_, {0});
  pen(one, QEvent::TabletPress, middle_, {0.5});
  pen(one, QEvent::TabletRelease, middle_, {0.5}, Qt::RightButton);
  ASSERT_EQ(samples_.size(), 2U);
  EXPECT_TRUE(samples_.back().down) << "the tip is still down";
  pen(one, QEvent::TabletRelease, middle_, {0});
  EXPECT_FALSE(samples_.back().down);
  const auto rubber = device(QPointingDevice::PointerType::Eraser, Can::Position | Can::Pressure);
  const std::size_t before = samples_.size();
  pen(rubber, QEvent::TabletPress, middle_, {0.5}, Qt::RightButton);
  EXPECT_EQ(erased_, 0);
  pen(rubber, QEvent::TabletPress, middle_, {0.5});
  pen(rubber, QEvent::TabletMove, middle_, {0.5}, Qt::NoButton);
  pen(rubber, QEvent::TabletRelease, middle_, {0.5});
  EXPECT_EQ(erased_, 1);
  EXPECT_EQ(samples_.size(), before);
}

TEST_F(SheetUnderTheBrush, AFingerWritesAndASecondOneEndsIt) {
  view_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
  // Qt keeps the devices of a program until its end.
  static auto* const screen = QTest::createTouchDevice();
  const QPoint middle = view_.place().rect.center().toPoint();
  QTest::touchEvent(&view_, screen).press(1, middle);
  QTest::touchEvent(&view_, screen).move(1, middle + QPoint(20, 10));
  QTest::touchEvent(&view_, screen).release(1, middle + QPoint(20, 10));
  ASSERT_EQ(samples_.size(), 3U);
  expect_at(samples_[0], middle);
  expect_at(samples_[1], middle + QPoint(20, 10));
  EXPECT_TRUE(samples_[0].down);
  EXPECT_TRUE(samples_[1].down);
  EXPECT_FALSE(samples_[2].down);
  EXPECT_FALSE(samples_[1].pressure);
  EXPECT_EQ(samples_[1].lean_rad, calligraphy::assumed_tilt(false).lean_rad);
  EXPECT_EQ(lost_, 0);
  QTest::touchEvent(&view_, screen).press(1, {2, 2});
  QTest::touchEvent(&view_, screen).move(1, middle);
  QTest::touchEvent(&view_, screen).release(1, middle);
  EXPECT_EQ(samples_.size(), 3U) << "it began beside the sheet";
  QTest::touchEvent(&view_, screen).press(1, middle);
  QTest::touchEvent(&view_, screen).stationary(1).press(2, middle + QPoint(40, 0));
  EXPECT_EQ(lost_, 1);
  EXPECT_EQ(samples_.size(), 4U);
  QTest::touchEvent(&view_, screen).release(1, middle).release(2, middle + QPoint(40, 0));
  EXPECT_EQ(samples_.size(), 4U);
}

TEST_F(SheetUnderTheBrush, KeysMoveTheBrushNoFasterThanACalmHand) {
  mouse(QEvent::MouseMove, {3, 3}, Qt::NoButton, 70'000);
  const double begin_s = view_.pen_clock_s();
  EXPECT_GE(begin_s, 70);
  EXPECT_LT(begin_s, 80);
  view_.move_brush({0.04, 0}, true, 0.4);
  view_.move_brush({0.04, 0.03}, true, 0.6);
  view_.move_brush({0.01, 0.03}, false, 0);
  ASSERT_EQ(samples_.size(), 3U);
  EXPECT_GE(samples_[0].time_s, begin_s);
  // 3 cm take half a second.
  EXPECT_NEAR(samples_[1].time_s - samples_[0].time_s, 0.5, 0.05);
  EXPECT_NEAR(samples_[2].time_s - samples_[1].time_s, 0.5, 0.05);
  EXPECT_NEAR(samples_[1].at.x, 0.04, 1e-9);
  EXPECT_NEAR(samples_[1].at.y, 0.03, 1e-9);
  EXPECT_EQ(samples_[0].pressure, 0.4);
  EXPECT_EQ(samples_[1].pressure, 0.6);
  EXPECT_TRUE(samples_[1].down);
  EXPECT_FALSE(samples_[2].down);
}

}  // namespace
}  // namespace nazori::ui
