// SPDX-License-Identifier: Apache-2.0
// A chart, paper and ink as they are drawn, shape by shape: each in its exact place.
#include <gtest/gtest.h>

#include <QFontMetricsF>

#include "nazori/view/inked_stroke.h"
#include "nazori/widgets/charts/day_chart.h"
#include "nazori/widgets/charts/role_colours.h"
#include "nazori/widgets/look/ink_painting.h"
#include "painting_under_test.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using practice::Side;
using test::box_words;
using test::Drawing;
using test::Drawn;
using test::drawn_by;
using test::in_words;
using test::line_words;
using test::words;

class PaintedChart : public testing::Test {
 protected:
  PaintedChart() {
    font_.setPixelSize(12);
    view_.setFont(font_);
    view_.setFrameShape(QFrame::NoFrame);
    view_.resize(600, 300);
  }
  /// A row a day from 1 March on.
  void show(std::vector<practice::Series> series, const std::vector<std::vector<double>>& values,
            std::vector<double> positions) {
    practice::Chart chart;
    ChartText text;
    for (const auto& column : values) chart.columns.push_back({practice::Quantity::reviews, column});
    chart.series = std::move(series);
    chart.positions = std::move(positions);
    for (std::size_t row = 0; row < chart.positions.size(); ++row)
      text.row_names.append(QStringLiteral("%1 Mar").arg(row + 1));
    for (std::size_t i = 0; i < chart.series.size(); ++i)
      text.series_names.append(QStringLiteral("Series %1").arg(QChar(static_cast<char16_t>(u'A' + i))));
    view_.show_chart(chart, text);
  }
  /// Bars of 5 and 10, and a line from 2 to 1 on the right.
  void show_both() {
    show({{0, practice::bars_look(), Side::left}, {1, practice::second_line_look(), Side::right}},
         {{5, 10}, {2, 1}}, {0, 1});
  }
  static QRectF box_at(QPointF middle, double side) {
    return {middle.x() - side / 2, middle.y() - side / 2, side, side};
  }
  const Colours& c_ = current_colours();
  QFont font_;
  const QFontMetricsF& metrics() const {
    static QFontMetricsF made(font_);
    made = QFontMetricsF(view_.font());
    return made;
  }
  DayChart view_;
};

TEST_F(PaintedChart, ThePlotLeavesRoomForItsNumbersItsDaysAndItsLegend) {
  const auto& m = metrics();
  show({{0, practice::bars_look(), Side::left}}, {{5, 10}}, {0, 1});
  const QRectF alone = view_.plot_area();
  const double number = m.horizontalAdvance(words("10.0"));
  EXPECT_NEAR(alone.top(), 4 + m.height() / 2, 0.01);
  EXPECT_NEAR(alone.bottom(), 300 - (m.descent() + 2 + m.height() + 4), 0.01);
  EXPECT_NEAR(alone.right(), 600 - 4, 0.01) << "nothing on the right";
  EXPECT_NEAR(alone.left(), 4 + 7 + number, 1.01) << "a tick, a gap and the widest number";
  show_both();
  const QRectF both = view_.plot_area();
  EXPECT_NEAR(both.bottom(), alone.bottom() - m.height() - 20, 0.01) << "the legend";
  EXPECT_LT(both.right(), alone.right() - 7);
}

TEST_F(PaintedChart, BarsAndMarksStandWhereTheirValuesAre) {
  show_both();
  const QRectF plot = view_.plot_area();
  const Drawing all = drawn_by(view_);
  const auto boxes = all.boxes();
  const QString bar_fill = test::name_of(colour_of(practice::bars_look().fill, c_));
  ASSERT_EQ(boxes.size(), 5U) << "two bars, two marks, the sign of bars";
  const double wide = plot.width() / 2 * 0.8;
  for (int i = 0; i < 2; ++i) {
    const double high = plot.height() * (i + 1) / 2;
    const double x = plot.left() + plot.width() * (0.25 + 0.5 * i);
    EXPECT_EQ(in_words(boxes[static_cast<std::size_t>(i)]),
              box_words({x - wide / 2, plot.bottom() - high, wide, high}, 0, words("indigo 1"), bar_fill));
  }
  // The axis on the right ends at 2.
  const QPointF marks[] = {{plot.left() + plot.width() / 4, plot.top()},
                           {plot.left() + plot.width() * 3 / 4, plot.center().y()}};
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(in_words(boxes[static_cast<std::size_t>(2 + i)]),
              box_words(box_at(marks[i], 8), 0, words("indigo 1"), words("surface")));
  EXPECT_TRUE(in_words(all.lines()).contains(line_words(marks[0], marks[1], words("indigo 2.5 dashed"))));
}

TEST_F(PaintedChart, AValueOfNothingHasNoBarAndADiscIsNoSquare) {
  show({{0, practice::bars_look(), Side::left}, {1, practice::first_line_look(), Side::left}},
       {{0, 10}, {5, 10}}, {0, 1});
  const QRectF plot = view_.plot_area();
  const auto boxes = drawn_by(view_).boxes();
  ASSERT_EQ(boxes.size(), 4U) << "one bar, two discs, the sign of bars";
  EXPECT_TRUE(boxes[1].round);
  EXPECT_NEAR(boxes[1].box.left(), plot.left() + plot.width() / 4 - 4, 0.01);
  EXPECT_NEAR(boxes[1].box.width(), 8, 0.01);
  EXPECT_EQ(boxes[1].fill_words(), words("ink"));
}

TEST_F(PaintedChart, TheLeftAxisHasAGridAndTheRightOneTicks) {
  show_both();
  const QRectF plot = view_.plot_area();
  const Drawing all = drawn_by(view_);
  const QStringList lines = in_words(all.lines());
  EXPECT_TRUE(lines.contains(line_words(plot.topLeft(), plot.bottomLeft(), words("line 1"))));
  EXPECT_TRUE(lines.contains(line_words(plot.topRight(), plot.bottomRight(), words("line 1"))));
  EXPECT_TRUE(lines.contains(line_words(plot.bottomLeft(), plot.bottomRight(), words("line 1"))));
  const char* const numbers[] = {"0.0", "2.5", "5.0", "7.5", "10.0"};
  const char* const right[] = {"0.0", "0.5", "1.0", "1.5", "2.0"};
  for (int tick = 0; tick < 5; ++tick) {
    const double y = std::floor(plot.bottom() - plot.height() * tick / 4) + 0.5;
    EXPECT_TRUE(lines.contains(line_words({plot.left() - 4, y}, {plot.right(), y}, words("line 1")))) << tick;
    EXPECT_TRUE(lines.contains(line_words({plot.right() + 4, y}, {plot.right(), y}, words("line 1"))))
        << tick;
    int found = 0;
    for (const Drawn& one : all.words()) {
      if (std::abs(one.box.center().y() - y) > 2) continue;
      if (one.box.right() < plot.left()) {
        EXPECT_EQ(one.text.toDouble(), words(numbers[tick]).toDouble());
        EXPECT_NEAR(one.box.right(), plot.left() - 7, 1.01);
        EXPECT_EQ(test::name_of(one.pen.color()), words("muted"));
        ++found;
      } else if (one.box.left() > plot.right()) {
        EXPECT_EQ(one.text.toDouble(), words(right[tick]).toDouble());
        EXPECT_NEAR(one.box.left(), plot.right() + 7, 1.01);
        ++found;
      }
    }
    EXPECT_EQ(found, 2) << tick;
  }
}

TEST_F(PaintedChart, DaysAreNamedBelowTheirTicksInsideTheFrame) {
  show_both();
  const QRectF plot = view_.plot_area();
  const auto& m = metrics();
  const Drawing all = drawn_by(view_);
  const QStringList lines = in_words(all.lines());
  for (int i = 0; i < 2; ++i) {
    const double x = plot.left() + plot.width() * (0.25 + 0.5 * i);
    const Drawn name = all.words(QStringLiteral("%1 Mar").arg(i + 1));
    EXPECT_NEAR(name.box.center().x(), x, 1.01);
    EXPECT_NEAR(name.baseline, plot.bottom() + m.descent() + 2 + m.ascent(), 0.51);
    EXPECT_EQ(test::name_of(name.pen.color()), words("muted"));
    EXPECT_TRUE(lines.contains(line_words({x, plot.bottom()}, {x, plot.bottom() + 4}, words("line 1"))));
  }
  // The first and the last of many: their names would leave the frame.
  practice::Chart chart;
  ChartText text;
  chart.columns.push_back({practice::Quantity::reviews, std::vector<double>(60, 1.0)});
  chart.series = {{0, practice::bars_look(), Side::left}};
  for (int row = 0; row < 60; ++row) {
    chart.positions.push_back(row);
    text.row_names.append(QStringLiteral("a very long name of a day in the month of March"));
  }
  view_.show_chart(chart, text);
  for (const Drawn& one : drawn_by(view_).words()) {
    EXPECT_GE(one.box.left(), -0.01);
    EXPECT_LE(one.box.right(), 601);
  }
}

TEST_F(PaintedChart, BetweenTwoNamesIsRoomForMoreThanHalfAName) {
  for (const int width : {300, 600, 1100}) {
    view_.resize(width, 300);
    show({{0, practice::bars_look(), Side::left}}, {std::vector<double>(60, 1.0)}, [] {
      std::vector<double> all;
      for (int row = 0; row < 60; ++row) all.push_back(row);
      return all;
    }());
    double widest = 1;
    for (int row = 0; row < 60; ++row)
      widest = std::max(widest, metrics().horizontalAdvance(QStringLiteral("%1 Mar").arg(row + 1)));
    // As many as there are 1.6 names in the width, less a margin of 6 names over 1.6.
    const int most = std::max(2, static_cast<int>((width - 6 * widest / 1.6) / (1.6 * widest)));
    const double apart = 60.0 / most;
    int named = 0;
    double next = 0;
    for (int row = 0; row < 60; ++row)
      if (row >= next) {
        next = row + apart;
        ++named;
      }
    EXPECT_EQ(view_.named_rows().size(), static_cast<std::size_t>(named)) << width;
  }
}

TEST_F(PaintedChart, TheLegendNamesEachSeriesBesideItsSignInTheMiddle) {
  show_both();
  const auto& m = metrics();
  const Drawing all = drawn_by(view_);
  const double name_wide = m.horizontalAdvance(words("Series A"));
  const double other_wide = m.horizontalAdvance(words("Series B"));
  const double whole = 2 * (14 + 5) + name_wide + other_wide + 10;
  // The middle of the frame: a rectangle of pixels ends before its last one.
  const double left = QRectF(view_.contentsRect()).center().x() - whole / 2;
  const double y = 300 - 4 - (m.height() + 20) / 2;
  const Drawn a = all.words(words("Series A"));
  const Drawn b = all.words(words("Series B"));
  EXPECT_NEAR(a.box.left(), left + 19, 0.01);
  EXPECT_NEAR(b.box.left(), left + 19 + name_wide + 10 + 19, 0.01);
  for (const Drawn& one : {a, b}) {
    EXPECT_NEAR(one.baseline, y + (m.ascent() - m.descent()) / 2, 0.01);
    EXPECT_EQ(test::name_of(one.pen.color()), words("ink"));
  }
  const double side = m.ascent() * 0.6;
  const Drawn bars = all.boxes().back();
  EXPECT_NEAR(bars.box.left(), left + 14 - side, 0.01);
  EXPECT_NEAR(bars.box.top(), y - side / 2, 0.01);
  EXPECT_NEAR(bars.box.width(), side, 0.01);
  const double line_from = left + 19 + name_wide + 10;
  EXPECT_TRUE(in_words(all.lines())
                  .contains(line_words({line_from, y}, {line_from + 14, y}, words("indigo 2.5 dashed"))))
      << in_words(all.lines()).join(u'\n').toStdString();
}

TEST_F(PaintedChart, TheRowThatIsReadHasADottedLine) {
  show_both();
  const std::size_t before = drawn_by(view_).lines().size();
  view_.set_row(1);
  const QRectF plot = view_.plot_area();
  const auto lines = drawn_by(view_).lines();
  ASSERT_EQ(lines.size(), before + 1);
  const double x = plot.left() + plot.width() * 0.75;
  EXPECT_EQ(in_words(lines.back()),
            line_words({x, plot.top()}, {x, plot.bottom()}, words("indigo 2 dashed")));
  EXPECT_EQ(lines.back().pen.style(), Qt::DotLine);
}

TEST(PaperForPractice, HasAFrameAndADashedCrossApartFromIt) {
  const Drawing drawn = drawn_by(QSize(200, 200), [](QPainter& painter) {
    paint_paper(painter, QRectF(10, 20, 100, 120), 8, 6, QPen(current_colours().edge, 2));
  });
  EXPECT_EQ(in_words(drawn.all),
            (QStringList{box_words({10, 20, 100, 120}, 8, words("edge 2"), words("surface")),
                         line_words({60, 26}, {60, 134}, words("line 1 dashed")),
                         line_words({16, 80}, {104, 80}, words("line 1 dashed"))}));
}

TEST(PaperForPractice, APointOfTheTabletHasItsPlaceOnTheSheet) {
  const QRectF sheet(10, 20, 100, 200);
  EXPECT_EQ(on_sheet({0, 0}, sheet), QPointF(60, 120));
  EXPECT_EQ(on_sheet({0.05, 0.05}, sheet), QPointF(110, 20)) << "a tablet is 0.1 m wide, and y goes up";
  EXPECT_EQ(on_sheet({-0.025, -0.05}, sheet), QPointF(35, 220));
}

TEST(InkOfAHand, IsAsWideAsThePenPressedAndNeverTooThinToSee) {
  const std::vector<geometry::WrittenPoint<geometry::TabletFrame>> ink{
      {{-0.05, 0}, 0, 0.0}, {{0, 0}, 0.1, 1.0}, {{0.05, 0}, 0.2, 0.0}};
  const auto drawn = [&](double side) {
    return drawn_by(QSize(400, 400),
                    [&](QPainter& painter) {
                      paint_ink(painter, ink, current_colours().moss, QRectF(0, 0, side, side));
                    })
        .lines();
  };
  const auto large = drawn(400);
  ASSERT_EQ(large.size(), 2U);
  EXPECT_NEAR(large[0].points[0].x(), 0, 0.01);
  EXPECT_NEAR(large[0].points[1].x(), 200, 0.01);
  EXPECT_NEAR(large[1].points[1].x(), 400, 0.01);
  EXPECT_NEAR(large[1].points[1].y(), 200, 0.01);
  EXPECT_GT(large[0].pen.widthF(), large[1].pen.widthF()) << "of the point where it ends";
  // A sheet of 400 pixels shows 0.1 m: twice the half width, 4000 pixels a metre.
  EXPECT_NEAR(large[0].pen.widthF(), 2 * 4000 * view::ink_half_width_m(ink[1]), 0.01);
  EXPECT_NEAR(drawn(200)[0].pen.widthF(), large[0].pen.widthF() / 2, 0.01);
  EXPECT_EQ(large[0].pen.capStyle(), Qt::RoundCap);
  EXPECT_EQ(test::name_of(large[0].pen.color()), words("moss"));
  EXPECT_NEAR(drawn(10)[1].pen.widthF(), 1.5, 0.01);
}

TEST(InkOfAHand, ThatWasSavedIsDrawnAcrossItsBox) {
  const geometry::WrittenStrokes<geometry::GlyphFrame> ink{{{{0, 0}, 0.0, 1.0}, {{109, 54.5}, 0.5, 1.0}}};
  const auto line = [&](double side, double pen) {
    return in_words(drawn_by(QSize(400, 400), [&](QPainter& painter) {
                      paint_handwriting(painter, ink, QRectF(5, 7, side, side), current_colours().ink, pen);
                    }).all);
  };
  EXPECT_EQ(line(100, 0.05), QStringList{line_words({5, 7}, {105, 57}, words("ink 5"))});
  EXPECT_EQ(line(10, 0.05), QStringList{line_words({5, 7}, {15, 12}, words("ink 1.5"))});
}

}  // namespace
}  // namespace nazori::ui
