// SPDX-License-Identifier: Apache-2.0
// The sheet in the window: its picture, its guides and the brush above it.
#include <QApplication>
#include <cmath>

#include "paper_under_test.h"

namespace nazori::ui {
namespace {

using SheetUnderTheBrush = test::PaperViewTest;

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
  frame.brush = test::upright();
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

}  // namespace
}  // namespace nazori::ui
