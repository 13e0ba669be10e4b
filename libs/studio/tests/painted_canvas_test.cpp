// SPDX-License-Identifier: Apache-2.0
// The tablet in the making as it is drawn, and what it sends.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <functional>

#include "in_english.h"
#include "nazori/author/stroke_edits.h"
#include "nazori/studio/workshop/character_canvas.h"
#include "painting_under_test.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using author::Tool;
using test::box_words;
using test::Drawing;
using test::Drawn;
using test::drawn_by;
using test::in_words;
using test::line_words;
using test::words;

class PaintedCanvas : public testing::Test {
 protected:
  static constexpr double kUnit = 4;  ///< pixels of a glyph unit
  PaintedCanvas() {
    test::speak_english();
    qApp->setStyleSheet({});
    QApplication::setPalette(make_palette(light_colours()));
    test::resize_unseen(canvas_, {464, 564});  // 436 x 536 inside: the tablet has 436 pixels
  }
  static author::CharacterEditor editor() { return *author::CharacterEditor::create({}, 128); }
  void choose(Tool tool, double width = 7) {
    auto settings = bench_.settings();
    settings.tool = tool;
    settings.width = width;
    bench_.set_settings(settings);
  }
  void move_pen(geometry::GlyphPoint at, bool down) {
    geometry::WrittenPoint<geometry::GlyphFrame> pen;
    pen.at = at;
    pen.time_s = time_s_ += 0.02;
    bench_.move_pen(pen, down);
  }
  /// A level stroke of two placed points.
  void place(double x0, double x1, double y) {
    choose(Tool::place);
    for (const double x : {x0, x1}) {
      move_pen({x, y}, true);
      move_pen({x, y}, false);
    }
    ASSERT_TRUE(bench_.finish_placing());
    canvas_.refresh();
  }
  void show_relief(const std::function<float(int, int)>& height) {
    auto map = *surface::HeightMap::create(128);
    for (int row = 0; row < 128; ++row)
      for (int column = 0; column < 128; ++column) map.set(column, row, height(column, row));
    bench_.load_relief(map);
    canvas_.refresh_relief(carving::whole_map(128));
  }
  /// What is seen at a place of the tablet.
  QColor colour_at(double x, double y) {
    QImage seen(canvas_.size(), QImage::Format_RGB32);
    canvas_.render(&seen);
    return seen.pixelColor(at(x, y).toPoint());
  }
  static QPointF at(double x, double y) { return {14 + kUnit * x, 64 + kUnit * y}; }
  static QString square(QPointF middle, double half, const char* pen, const char* fill) {
    return box_words({middle.x() - half, middle.y() - half, 2 * half, 2 * half}, 0, words(pen), words(fill));
  }
  void mouse(QEvent::Type type, QPointF place, Qt::MouseButton button, Qt::MouseButtons held) {
    QMouseEvent event(type, place, canvas_.mapToGlobal(place), button, held, {});
    QCoreApplication::sendEvent(&canvas_, &event);
  }
  const Colours& c_ = light_colours();
  author::Workbench bench_{editor()};
  CharacterCanvas canvas_{bench_, nullptr};
  double time_s_ = 1;
};

TEST_F(PaintedCanvas, TheTabletIsInTheMiddleAndIsMagnifiedAroundAPoint) {
  EXPECT_EQ(canvas_.to_widget({0, 0}), at(0, 0));
  EXPECT_EQ(canvas_.to_widget({109, 109}), at(109, 109));
  EXPECT_NEAR(canvas_.to_glyph(at(30, 70)).x, 30, 1e-9);
  EXPECT_NEAR(canvas_.to_glyph(at(30, 70)).y, 70, 1e-9);
  EXPECT_EQ(in_words(drawn_by(canvas_).pictures()), QStringList{words("picture 14 64 436 436")});
  canvas_.zoom(2, at(40, 50));
  EXPECT_EQ(canvas_.zoomed(), 2);
  EXPECT_NEAR(canvas_.to_glyph(at(40, 50)).x, 40, 1e-9) << "it stays where it is";
  EXPECT_NEAR(canvas_.to_glyph(at(40, 50)).y, 50, 1e-9);
  EXPECT_NEAR(canvas_.to_widget({50, 50}).x() - canvas_.to_widget({40, 50}).x(), 80, 1e-9);
  canvas_.zoom(100, at(0, 0));
  EXPECT_EQ(canvas_.zoomed(), 16);
  canvas_.zoom(1e-6);
  EXPECT_EQ(canvas_.zoomed(), 1) << "no smaller than the room";
  EXPECT_EQ(canvas_.to_widget({0, 0}), at(0, 0));
  canvas_.zoom(4, at(0, 0));
  EXPECT_GE(canvas_.to_widget({0, 0}).x(), 14 - 1e-9 - 218) << "the tablet is not left behind";
  canvas_.show_whole();
  EXPECT_EQ(canvas_.to_widget({0, 0}), at(0, 0));
  const auto wheel = [&](int by) {
    QWheelEvent event(at(54.5, 54.5), at(54.5, 54.5), {}, {0, by}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&canvas_, &event);
  };
  wheel(120);
  EXPECT_NEAR(canvas_.zoomed(), 1.2, 1e-9);
  wheel(120);
  EXPECT_NEAR(canvas_.zoomed(), 1.44, 1e-9);
  wheel(-120);
  EXPECT_NEAR(canvas_.zoomed(), 1.2, 1e-9);
}

TEST_F(PaintedCanvas, TheMiddleButtonMovesTheTabletUnderIt) {
  canvas_.zoom(2);
  const auto before = canvas_.to_glyph({200, 300});
  mouse(QEvent::MouseButtonPress, {200, 300}, Qt::MiddleButton, Qt::MiddleButton);
  mouse(QEvent::MouseMove, {230, 280}, Qt::NoButton, Qt::MiddleButton);
  EXPECT_NEAR(canvas_.to_glyph({230, 280}).x, before.x, 1e-9);
  EXPECT_NEAR(canvas_.to_glyph({230, 280}).y, before.y, 1e-9);
  mouse(QEvent::MouseButtonRelease, {230, 280}, Qt::MiddleButton, Qt::NoButton);
  mouse(QEvent::MouseMove, {100, 100}, Qt::NoButton, Qt::NoButton);
  EXPECT_NEAR(canvas_.to_glyph({230, 280}).x, before.x, 1e-9) << "not without the button";
}

TEST_F(PaintedCanvas, AStrokeHasAPaleRimADotAtItsStartAnArrowAndItsNumber) {
  place(20, 80, 40);
  bench_.select({});
  canvas_.refresh();
  const Drawing all = drawn_by(canvas_);
  std::vector<Drawn> lines;
  for (const Drawn& one : all.boxes())
    if (one.points.size() > 3 && one.fill_words() == words("none")) lines.push_back(one);
  ASSERT_EQ(lines.size(), 2U) << "the rim and the line";
  EXPECT_EQ(lines[0].pen.color(), QColor(255, 255, 255, 170));
  EXPECT_NEAR(lines[0].pen.widthF(), 3.5, 0.01);
  EXPECT_EQ(lines[1].pen_words(), words("indigo 1.5"));
  for (const Drawn& line : lines) {
    EXPECT_EQ(line.points.front(), at(20, 40));
    EXPECT_NEAR(line.points.back().x(), at(80, 40).x(), 1e-6);
  }
  std::vector<Drawn> others;
  for (const Drawn& one : all.boxes())
    if (one.fill_words() == words("indigo")) others.push_back(one);
  ASSERT_EQ(others.size(), 1U);
  EXPECT_TRUE(others[0].round);
  EXPECT_EQ(in_words(others[0]),
            words("disc %1 %2 8 8, indigo 1.5, indigo").arg(at(20, 40).x() - 4).arg(at(20, 40).y() - 4));
  const Drawn number = all.words(words("1"));
  const auto placed = author::number_places(bench_.character().strokes)[0];
  EXPECT_NEAR(number.box.left(), canvas_.to_widget(placed).x(), 0.01);
  EXPECT_NEAR(number.baseline, canvas_.to_widget(placed).y(), 0.01);
  EXPECT_EQ(number.font.pixelSize(), 32) << "eight units";
  EXPECT_FALSE(number.font.bold());
  canvas_.set_shows_strokes(false);
  EXPECT_TRUE(drawn_by(canvas_).words().empty());
}

TEST_F(PaintedCanvas, TheArrowAtTheEndIsNinePixelsLongAndHalfAsWideOnEachSide) {
  place(20, 80, 40);
  bench_.select({});
  canvas_.refresh();
  const QPointF end = at(80, 40);
  bool found = false;
  for (const Drawn& one : drawn_by(canvas_).all)
    if (one.points.size() == 3) {
      found = true;
      EXPECT_NEAR(one.points[1].x(), end.x(), 1e-6);
      EXPECT_NEAR(one.points[0].x(), end.x() - 9, 1e-6);
      EXPECT_NEAR(one.points[2].x(), end.x() - 9, 1e-6);
      EXPECT_NEAR(one.points[0].y(), end.y() + 4.5, 1e-6);
      EXPECT_NEAR(one.points[2].y(), end.y() - 4.5, 1e-6);
    }
  EXPECT_TRUE(found);
}

TEST_F(PaintedCanvas, TheChosenStrokeIsVermilionWithItsPointsAndItsNumberInABox) {
  place(20, 80, 40);
  place(20, 80, 80);
  const auto last = bench_.character().strokes[0].points.size() - 1;
  bench_.select({0, last});
  canvas_.refresh();
  const Drawing all = drawn_by(canvas_);
  const auto boxes = in_words(all.boxes());
  EXPECT_TRUE(boxes.contains(square(at(20, 40), 3.5, "vermilion 2.5", "#ffffffff")))
      << boxes.join(u'\n').toStdString();
  EXPECT_TRUE(boxes.contains(square(at(80, 40), 6, "vermilion 2.5", "vermilion")));
  EXPECT_FALSE(boxes.contains(square(at(20, 80), 3.5, "indigo 1.5", "#ffffffff"))) << "not of the others";
  std::vector<Drawn> wide;
  for (const Drawn& one : all.boxes())
    if (one.pen.color() == QColor(255, 255, 255, 170)) wide.push_back(one);
  ASSERT_EQ(wide.size(), 2U);
  EXPECT_NEAR(wide[0].box.top(), at(0, 80).y(), 1e-6) << "the chosen one last, above the others";
  EXPECT_NEAR(wide[1].pen.widthF(), 5, 0.01);
  EXPECT_TRUE(all.words(words("1")).font.bold());
  EXPECT_FALSE(all.words(words("2")).font.bold());
  const auto box = author::number_box(1, author::number_places(bench_.character().strokes)[0]);
  const QString frame =
      box_words(QRectF(canvas_.to_widget({box.left, box.top}), canvas_.to_widget({box.right, box.bottom}))
                    .adjusted(-2, -2, 2, 2),
                0, words("vermilion 2.5"), words("none"));
  EXPECT_FALSE(boxes.contains(frame));
  bench_.select({0, std::nullopt, true});
  canvas_.refresh();
  EXPECT_TRUE(in_words(drawn_by(canvas_).boxes()).contains(frame));
}

TEST_F(PaintedCanvas, WhatIsUnderWayIsPaleAndAsWideAsTheTool) {
  choose(Tool::draw, 5);
  move_pen({20, 30}, true);
  for (int i = 1; i <= 10; ++i) move_pen({20 + 4.0 * i, 30}, true);
  const Drawn line = drawn_by(canvas_).boxes().back();
  QColor pale = c_.vermilion;
  pale.setAlphaF(0.45F);
  EXPECT_EQ(line.pen.color(), pale);
  EXPECT_NEAR(line.pen.widthF(), 5 * kUnit, 0.01);
  EXPECT_EQ(line.points.size(), 11);
  EXPECT_EQ(line.points.front(), at(20, 30));
  EXPECT_EQ(line.points.back(), at(60, 30));
  auto settings = bench_.settings();
  settings.straight = true;
  bench_.set_settings(settings);
  const Drawn straight = drawn_by(canvas_).all.back();
  EXPECT_EQ(straight.points, QPolygonF({at(20, 30), at(60, 30)}));
}

TEST_F(PaintedCanvas, PlacedPointsAreJoinedByADashedLine) {
  choose(Tool::place);
  for (const double x : {20.0, 40.0, 70.0}) {
    move_pen({x, 50}, true);
    move_pen({x, 50}, false);
  }
  const Drawing all = drawn_by(canvas_);
  std::vector<Drawn> discs;
  for (const Drawn& one : all.boxes())
    if (one.round) discs.push_back(one);
  ASSERT_EQ(discs.size(), 3U);
  for (const Drawn& disc : discs) {
    EXPECT_EQ(disc.pen_words(), words("vermilion 2"));
    EXPECT_EQ(disc.fill.color(), QColor(Qt::white));
    EXPECT_NEAR(disc.box.width(), 8, 0.01);
    EXPECT_NEAR(disc.box.center().y(), at(0, 50).y(), 0.01);
  }
  EXPECT_NEAR(discs[1].box.center().x(), at(40, 0).x(), 0.01);
  bool dashed = false;
  for (const Drawn& one : all.all) dashed = dashed || one.pen_words() == words("vermilion 2 dashed");
  EXPECT_TRUE(dashed);
}

TEST_F(PaintedCanvas, WithTheKeyboardItHasARingAndACrossAtTheCursor) {
  EXPECT_TRUE(drawn_by(canvas_).lines().empty());
  canvas_.show();
  canvas_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&canvas_));
  canvas_.setFocus();
  ASSERT_TRUE(canvas_.hasFocus());
  const QPointF middle = canvas_.to_widget(bench_.cursor());
  const Drawing all = drawn_by(canvas_);
  EXPECT_EQ(in_words(all.lines()),
            (QStringList{line_words(middle - QPointF(7, 0), middle + QPointF(7, 0), words("ink 1.5")),
                         line_words(middle - QPointF(0, 7), middle + QPointF(0, 7), words("ink 1.5"))}));
  EXPECT_EQ(in_words(all.boxes().back()), box_words({11, 61, 442, 442}, 0, words("indigo 2"), words("none")));
  choose(Tool::draw);
  bench_.press_at_cursor(5);
  EXPECT_EQ(drawn_by(canvas_).lines().back().pen_words(), words("vermilion 1.5"));
}

TEST_F(PaintedCanvas, TheReliefIsWoodThatIsDarkerInTheDepth) {
  show_relief([](int column, int /*row*/) { return column < 64 ? 1.0F : 0.5F; });
  const auto near = [&](double x, const QColor& wanted) {
    const QColor is = colour_at(x, 20);
    EXPECT_NEAR(is.red(), wanted.red(), 3) << x;
    EXPECT_NEAR(is.green(), wanted.green(), 3) << x;
    EXPECT_NEAR(is.blue(), wanted.blue(), 3) << x;
  };
  near(30, QColor(214, 188, 150));
  // Half as deep: 0.62 and half of 0.38 of the light.
  near(80, QColor(173, 152, 121));
}

TEST_F(PaintedCanvas, InTheDarkTheTabletIsDimmedAndItsNumbersAreWrittenInInk) {
  place(20, 80, 40);
  show_relief([](int /*column*/, int /*row*/) { return 1.0F; });
  canvas_.setPalette(make_palette(dark_colours()));
  // Black with 70 of 255 over the wood.
  const double left = 1 - 70 / 255.0;
  EXPECT_NEAR(colour_at(30, 80).red(), 214 * left, 3);
  EXPECT_NEAR(colour_at(30, 80).blue(), 150 * left, 3);
  const Drawing all = drawn_by(canvas_);
  EXPECT_EQ(all.words(words("1")).pen.color(), c_.ink) << "of the window, not of the stroke";
}

TEST_F(PaintedCanvas, ASlopeIsDarkOrBrightByTheWayItFaces) {
  const auto shade = [&](float right, float down) {
    show_relief([=](int column, int row) {
      return 0.5F - right * static_cast<float>(column - 64) - down * static_cast<float>(row - 64);
    });
    return colour_at(54.5, 54.5).red();
  };
  const auto part = [](float light) {
    return static_cast<int>(214.0F * (0.62F + 0.38F * 0.5F) * (1.0F + light));
  };
  // 128 samples are a tenth as deep as they are wide: a fall of 0.05 a sample makes 0.16 of 0.64 darker.
  constexpr float kFall = 0.05F, kLight = 0.16F * 12.8F * 0.05F;
  EXPECT_NEAR(shade(0, 0), part(0), 2);
  EXPECT_NEAR(shade(kFall, 0), part(-kLight), 4);
  EXPECT_NEAR(shade(0, kFall), part(-kLight), 4);
  EXPECT_NEAR(shade(kFall, kFall), part(-2 * kLight), 4);
  EXPECT_NEAR(shade(kFall, -kFall), part(0), 4) << "one cancels the other";
  EXPECT_NEAR(shade(-kFall, -kFall), part(2 * kLight), 4);
}

TEST_F(PaintedCanvas, APenAboveTheTabletSendsNothingAndOneOnItItsWay) {
  QSignalSpy moved(&canvas_, &CharacterCanvas::pen_moved);
  mouse(QEvent::MouseMove, at(20, 20), Qt::NoButton, Qt::NoButton);
  EXPECT_EQ(moved.count(), 0);
  mouse(QEvent::MouseButtonPress, {2, 2}, Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseMove, at(20, 20), Qt::NoButton, Qt::LeftButton);
  EXPECT_EQ(moved.count(), 0) << "it came down beside the tablet";
  mouse(QEvent::MouseButtonRelease, at(20, 20), Qt::LeftButton, Qt::NoButton);
  EXPECT_EQ(moved.count(), 0);
  mouse(QEvent::MouseButtonPress, at(20, 20), Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseMove, at(30, 25), Qt::NoButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, at(40, 30), Qt::LeftButton, Qt::NoButton);
  mouse(QEvent::MouseMove, at(50, 30), Qt::NoButton, Qt::NoButton);
  ASSERT_EQ(moved.count(), 3);
  const auto pen = [&](int i) {
    return moved.at(i).at(0).value<geometry::WrittenPoint<geometry::GlyphFrame>>();
  };
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(pen(i).at.x, 20 + 10 * i, 1e-9);
    EXPECT_NEAR(pen(i).at.y, 20 + 5 * i, 1e-9);
    EXPECT_EQ(moved.at(i).at(1).toBool(), i < 2);
    EXPECT_EQ(pen(i).pressure, std::nullopt);
  }
  QSignalSpy twice(&canvas_, &CharacterCanvas::double_clicked);
  mouse(QEvent::MouseButtonDblClick, at(60, 70), Qt::RightButton, Qt::RightButton);
  EXPECT_EQ(twice.count(), 0);
  mouse(QEvent::MouseButtonDblClick, at(60, 70), Qt::LeftButton, Qt::LeftButton);
  ASSERT_EQ(twice.count(), 1);
  EXPECT_NEAR(twice.at(0).at(0).value<geometry::GlyphPoint>().y, 70, 1e-9);
}

TEST_F(PaintedCanvas, ArrowKeysMoveByAUnitOrByAFifth) {
  std::vector<geometry::GlyphPoint> moved;
  int pressed = 0;
  QObject::connect(&canvas_, &CharacterCanvas::moved_by_key, &canvas_,
                   [&](geometry::GlyphPoint by) { moved.push_back(by); });
  QObject::connect(&canvas_, &CharacterCanvas::pressed_by_key, &canvas_, [&] { ++pressed; });
  for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Space, Qt::Key_A})
    QTest::keyClick(&canvas_, key);
  QTest::keyClick(&canvas_, Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(&canvas_, Qt::Key_Down, Qt::KeypadModifier);
  QTest::keyClick(&canvas_, Qt::Key_Down, Qt::ControlModifier);
  const std::vector<geometry::GlyphPoint> wanted{{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {0.2, 0}, {0, 1}};
  EXPECT_EQ(moved, wanted);
  EXPECT_EQ(pressed, 1);
}

}  // namespace
}  // namespace nazori::ui
