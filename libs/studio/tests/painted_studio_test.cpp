// SPDX-License-Identifier: Apache-2.0
// What the pages and dialogs for making something draw, shape by shape.
#include <gtest/gtest.h>

#include <QApplication>
#include <QFontInfo>
#include <QTest>
#include <QWheelEvent>
#include <limits>

#include "nazori/studio/brush/correction_marks.h"
#include "nazori/studio/brush/paper_view.h"
#include "nazori/studio/print/page_view.h"
#include "nazori/studio/print/photo_view.h"
#include "nazori/studio/print/relief_view.h"
#include "painted_lightly.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using test::box_words;
using test::Drawing;
using test::Drawn;
using test::drawn_by;
using test::in_words;
using test::line_words;
using test::words;

class PaintedStudio : public test::PaintedLightly {};

class PaintedPaper : public PaintedStudio {
 protected:
  PaintedPaper() {
    view_.set_picture_side(64);
    test::resize_unseen(view_, {428, 300});  // 400 x 272 inside
  }
  PaperView view_{nullptr};
};

TEST_F(PaintedPaper, AloneTheSheetIsInTheMiddle) {
  EXPECT_EQ(view_.place().rect, QRectF(78, 14, 272, 272));
  test::resize_unseen(view_, {300, 428});
  EXPECT_EQ(view_.place().rect, QRectF(14, 78, 272, 272));
}

TEST_F(PaintedPaper, TheModelBesideItStandsWhereTheWritingHandIsNot) {
  view_.show_model({}, {}, ModelPlace::beside);
  // 400 less 14 between them, in the ratio of 2 to 1.
  const double side = 386 / 1.5;
  const double other = 386 - side;
  const double top = 14 + (272 - side) / 2;
  const auto beside = [this] {
    const Drawing drawn = drawn_by(view_);
    for (const Drawn& one : drawn.boxes())
      if (one.pen_words() == words("line 1")) return one.box;
    return QRectF();
  };
  EXPECT_EQ(view_.place().rect, QRectF(std::round(14 + other + 14), std::round(top), 257, 257));
  EXPECT_NEAR(beside().left(), 14, 0.01);
  EXPECT_NEAR(beside().top(), top, 0.01);
  EXPECT_NEAR(beside().width(), other, 0.01);
  EXPECT_NEAR(beside().height(), other, 0.01);
  view_.set_left_hand(true);
  EXPECT_EQ(view_.place().rect, QRectF(14, std::round(top), 257, 257));
  EXPECT_NEAR(beside().left(), 14 + side + 14, 0.01);
  test::resize_unseen(view_,
                      {1028, 228});  // low: the sheet is as high as there is room, and both are in the middle
  EXPECT_EQ(view_.place().rect.width(), 200);
  EXPECT_NEAR(beside().width(), 200, 0.01);
  EXPECT_NEAR(view_.place().rect.left() + beside().right(), 1028, 1);
}

TEST_F(PaintedPaper, HasAShadowItsPictureAndTheRingOfTheKeyboard) {
  const QRectF sheet(78, 14, 272, 272);
  const Drawing plain = drawn_by(view_);
  ASSERT_EQ(plain.boxes().size(), 4U) << "the ground and three shadows";
  EXPECT_EQ(plain.boxes()[0].fill.color(), c_.paper);
  const QString shade = test::name_of(QColor(0, 0, 0, 14));
  EXPECT_EQ(in_words(plain.boxes()[1]), box_words(sheet.adjusted(-4, -3, 6, 7), 3, words("none"), shade));
  EXPECT_EQ(in_words(plain.boxes()[2]), box_words(sheet.adjusted(-2, -1, 4, 5), 3, words("none"), shade));
  EXPECT_EQ(in_words(plain.boxes()[3]), box_words(sheet.adjusted(0, 1, 2, 3), 3, words("none"), shade));
  EXPECT_EQ(in_words(plain.pictures()), QStringList{words("picture 78 14 272 272")});
  view_.show_model({}, {{{0, 0}, 0.1}}, ModelPlace::none);
  EXPECT_EQ(drawn_by(view_).pictures().size(), 2U) << "the ruling over it";
  give_keyboard(view_);
  EXPECT_EQ(in_words(drawn_by(view_).boxes().back()),
            box_words(sheet.adjusted(-3, -3, 3, 3), 0, words("indigo 2"), words("none")));
}

TEST_F(PaintedPaper, AModelBesideItIsFilledInItsPlace) {
  calligraphy::ModelStroke stroke;
  stroke.points = {{-0.02, 0}, {0.02, 0}};
  stroke.half_width_m = {0.004, 0.002};
  view_.show_model({stroke}, {}, ModelPlace::beside);
  EXPECT_EQ(view_.model().size(), 1U);
  const Drawing drawn = drawn_by(view_);
  QRectF frame;
  for (const Drawn& one : drawn.boxes())
    if (one.pen_words() == words("line 1")) frame = one.box;
  SheetPlace place;
  place.rect = frame;
  std::vector<Drawn> discs;
  for (const Drawn& one : drawn.boxes())
    if (one.round) discs.push_back(one);
  ASSERT_EQ(discs.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(discs[i].box.center().x(), place.to_widget(stroke.points[i]).x(), 0.01);
    EXPECT_NEAR(discs[i].box.center().y(), frame.center().y(), 0.01);
    EXPECT_NEAR(discs[i].box.width(), 2 * stroke.half_width_m[i] * place.per_m(), 0.01);
    EXPECT_EQ(discs[i].fill.color(), QColor(60, 52, 46));
  }
  const Drawn whole = drawn.all.back();
  EXPECT_NEAR(whole.box.left(), discs[0].box.left(), 0.01);
  EXPECT_NEAR(whole.box.right(), discs[1].box.right(), 0.01);
}

TEST(CorrectionsOnPaper, HaveTheirPlacesAndTheirSize) {
  using Kind = calligraphy::CorrectionMark::Kind;
  SheetPlace place;
  place.rect = QRectF(0, 0, 1000, 1000);
  const double m = place.per_m();
  const auto drawn = [&](const calligraphy::CorrectionMark& mark) {
    return drawn_by(QSize(1000, 1000), [&](QPainter& painter) { paint_marks(painter, {&mark, 1}, place); });
  };
  const QColor vermilion(214, 58, 34);
  calligraphy::CorrectionMark mark;
  mark.kind = Kind::circle;
  mark.to = {0.01, 0.02};
  mark.radius_m = 0.005;
  const auto circle = drawn(mark).all;
  ASSERT_EQ(circle.size(), 1U);
  EXPECT_TRUE(circle[0].round);
  EXPECT_NEAR(circle[0].box.center().x(), 500 + 0.01 * m, 0.01);
  EXPECT_NEAR(circle[0].box.center().y(), 500 - 0.02 * m, 0.01);
  EXPECT_NEAR(circle[0].box.width(), 0.01 * m, 0.01);
  EXPECT_EQ(circle[0].pen.color(), vermilion);
  EXPECT_NEAR(circle[0].pen.widthF(), std::max(0.0006 * m, 1.5), 0.01);
  mark.kind = Kind::arrow;
  mark.from = {-0.02, 0};
  mark.to = {0.02, 0};
  const auto arrow = drawn(mark).all;
  ASSERT_EQ(arrow.size(), 2U);
  EXPECT_NEAR(arrow[0].points[0].x(), 500 - 0.02 * m, 0.01);
  EXPECT_NEAR(arrow[0].points[1].x(), 500 + 0.02 * m, 0.01);
  const double head = 0.0026 * m;
  ASSERT_EQ(arrow[1].points.size(), 3);
  EXPECT_NEAR(arrow[1].box.left(), 500 + 0.02 * m - head, 0.01);
  EXPECT_NEAR(arrow[1].box.right(), 500 + 0.02 * m, 0.01);
  EXPECT_NEAR(arrow[1].box.height(), 1.1 * head, 0.01);
  EXPECT_NEAR(arrow[1].points[1].x(), 500 + 0.02 * m, 0.01) << "the tip in the middle";
  mark.to = {-0.02 + 0.002, 0};
  EXPECT_NEAR(drawn(mark).all[1].box.width(), 0.6 * 0.002 * m, 0.01) << "a short arrow has a small head";
  mark.to = mark.from;
  EXPECT_TRUE(drawn(mark).all.empty());
  mark.kind = Kind::outline;
  mark.outline = {{{0, 0}, {0.01, 0}, {0.01, 0.01}}};
  const auto outline = drawn(mark).all;
  ASSERT_EQ(outline.size(), 1U);
  EXPECT_NEAR(outline[0].box.width(), 0.01 * m, 0.01);
  EXPECT_NEAR(outline[0].box.bottom(), 500, 0.01);
  EXPECT_EQ(outline[0].fill.color(), QColor(214, 58, 34, 40));
  EXPECT_TRUE(drawn_by(QSize(9, 9), [&](QPainter& painter) { paint_marks(painter, {}, place); }).all.empty());
}

TEST_F(PaintedStudio, APageIsAsLargeAsThereIsRoomWithTheMarksOfTheDocument) {
  PageView view;
  view.setFont(font_);
  EXPECT_EQ(view.sizeHint(), QSize(12 * 22, 12 * 28));
  EXPECT_EQ(view.minimumSizeHint(), QSize(120, 120));
  view.resize(224, 424);  // 200 x 400 inside
  EXPECT_TRUE(view.paper().isEmpty());
  EXPECT_TRUE(drawn_by(view).all.empty());
  auto page = std::make_shared<print::PageDrawing>();
  page->width_mm = 100;
  page->height_mm = 150;
  using Step = print::PathStep;
  print::PageMark line;
  line.path = {{Step::Kind::move, {{{10, 20}}}}, {Step::Kind::line, {{{60, 20}}}}};
  line.width_mm = 2;
  line.grey = 0.5;
  line.dash_mm = 6;
  print::PageMark bow;
  bow.path = {{Step::Kind::move, {{{10, 60}}}}, {Step::Kind::curve, {{{10, 90}, {70, 90}, {70, 60}}}}};
  bow.width_mm = 1;
  bow.round = true;
  print::PageMark area;
  area.filled = true;
  area.path = {{Step::Kind::move, {{{10, 30}}}},
               {Step::Kind::line, {{{40, 30}}}},
               {Step::Kind::line, {{{40, 50}}}},
               {Step::Kind::close, {}}};
  page->marks = {line, area, bow};
  view.show_page(page, words("Page 1"));
  EXPECT_EQ(view.accessibleDescription(), words("Page 1"));
  EXPECT_EQ(view.paper(), QRectF(12, 62, 200, 300));
  const Drawing all = drawn_by(view);
  ASSERT_EQ(all.all.size(), 5U);
  EXPECT_EQ(in_words(all.all[0]).section(u',', 0, 0), words("box 12 62 200 300"));
  EXPECT_EQ(all.all[0].fill.color(), QColor(Qt::white));
  EXPECT_EQ(in_words(all.all[1]).section(u',', 0, 0), words("line 32 102 132 102"));
  EXPECT_NEAR(all.all[1].pen.widthF(), 4, 0.01);
  EXPECT_EQ(all.all[1].pen.color(), blend(Qt::black, Qt::white, 0.5));
  EXPECT_EQ(all.all[1].pen.dashPattern(), (QList<qreal>{3, 3}));
  EXPECT_EQ(all.all[1].pen.capStyle(), Qt::FlatCap);
  EXPECT_NEAR(all.all[2].box.left(), 32, 0.01);
  EXPECT_NEAR(all.all[2].box.height(), 40, 0.01);
  EXPECT_EQ(all.all[2].fill.color(), QColor(Qt::black));
  // A curve with two control points reaches three quarters of the way to them.
  EXPECT_NEAR(all.all[3].box.left(), 32, 0.01);
  EXPECT_NEAR(all.all[3].box.width(), 120, 0.01);
  EXPECT_NEAR(all.all[3].box.top(), 62 + 120, 0.01);
  EXPECT_NEAR(all.all[3].box.bottom(), 62 + 165, 0.5);
  EXPECT_EQ(all.all[3].pen.capStyle(), Qt::RoundCap);
  EXPECT_EQ(all.all[3].pen.joinStyle(), Qt::RoundJoin);
  EXPECT_EQ(all.all[3].pen.style(), Qt::SolidLine);
  EXPECT_EQ(in_words(all.all[4]),
            box_words({11.5, 61.5, 201, 301}, 0, words("edge 1"), all.all[4].fill_words()));
  give_keyboard(view);
  EXPECT_EQ(in_words(drawn_by(view).all.back()),
            box_words({1, 1, 222, 422}, 4, words("indigo 2"), words("none")));
  view.clear();
  EXPECT_EQ(view.page(), nullptr);
  EXPECT_TRUE(view.accessibleDescription().isEmpty());
}

TEST_F(PaintedStudio, PagesAreTurnedByKeysAndByWholeNotchesOfTheWheel) {
  PageView view;
  std::vector<int> turned;
  QObject::connect(&view, &PageView::turned, &view, [&](int pages) { turned.push_back(pages); });
  for (const Qt::Key key : {Qt::Key_PageDown, Qt::Key_PageUp, Qt::Key_Home, Qt::Key_End, Qt::Key_A})
    QTest::keyClick(&view, key);
  EXPECT_EQ(turned, (std::vector{1, -1, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}));
  turned.clear();
  const auto wheel = [&](int by) {
    QWheelEvent event({1, 1}, {1, 1}, {}, {0, by}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &event);
  };
  wheel(-119);
  EXPECT_TRUE(turned.empty());
  wheel(-1);
  wheel(-240);
  wheel(120);
  EXPECT_EQ(turned, (std::vector{1, 2, -1}));
}

TEST_F(PaintedStudio, APhotographIsAsLargeAsThereIsRoomAndASheetInItIsMarkedTwice) {
  PhotoView view;
  view.setFont(font_);
  EXPECT_EQ(view.sizeHint(), QSize(12 * 26, 12 * 32));
  view.resize(216, 416);  // 200 x 400 inside
  EXPECT_TRUE(drawn_by(view).all.empty());
  surface::ColourPicture photo{40, 20, std::vector<std::uint8_t>(40 * 20 * 3, 200)};
  view.show_picture(photo, words("A photo"));
  EXPECT_EQ(view.accessibleDescription(), words("A photo"));
  EXPECT_EQ(in_words(drawn_by(view).all),
            (QStringList{words("picture 8 158 200 100"),
                         box_words({8, 158, 200, 100}, 0, words("edge 1"), words("none"))}));
  view.mark(QPolygonF({{0, 0}, {20, 0}, {20, 10}, {0, 10}}));
  const auto marked = drawn_by(view).boxes();
  ASSERT_EQ(marked.size(), 3U);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_NEAR(marked[i].box.left(), 8, 0.01);
    EXPECT_NEAR(marked[i].box.top(), 158, 0.01);
    EXPECT_NEAR(marked[i].box.width(), 100, 0.01);
    EXPECT_NEAR(marked[i].box.height(), 50, 0.01);
  }
  EXPECT_EQ(marked[1].pen_words(), words("paper 7"));
  EXPECT_EQ(marked[2].pen_words(), words("indigo 3.5"));
  view.show_picture(photo, words("Another"));
  EXPECT_EQ(drawn_by(view).boxes().size(), 1U) << "its mark is gone";
  view.clear();
  EXPECT_TRUE(drawn_by(view).all.empty());
}

TEST_F(PaintedStudio, AReliefIsAsLargeAsThereIsRoom) {
  ReliefView view;
  view.setFont(font_);
  EXPECT_EQ(view.sizeHint(), QSize(12 * 22, 12 * 22));
  view.resize(216, 116);  // 200 x 100 inside
  view.show_picture({20, 20, std::vector<std::uint8_t>(400, 128)}, words("A plate"));
  EXPECT_EQ(view.accessibleDescription(), words("A plate"));
  EXPECT_EQ(in_words(drawn_by(view).all),
            (QStringList{words("picture 58 8 100 100"),
                         box_words({58, 8, 100, 100}, 0, words("edge 1"), words("none"))}));
  const QImage seen = view.grab().toImage();
  EXPECT_EQ(seen.pixelColor(108, 58).red(), 128);
  view.clear();
  EXPECT_TRUE(drawn_by(view).all.empty());
}

TEST_F(PaintedStudio, InTheDarkPaperAndPlatesAreDimmed) {
  QApplication::setPalette(make_palette(dark_colours()));
  PageView page;
  page.resize(224, 424);
  auto drawing = std::make_shared<print::PageDrawing>();
  drawing->width_mm = 100;
  drawing->height_mm = 150;
  page.show_page(drawing, {});
  ASSERT_EQ(drawn_by(page).all.size(), 2U);
  EXPECT_EQ(drawn_by(page).all[0].fill.color(), blend(Qt::white, Qt::black, 0.18));
  EXPECT_EQ(drawn_by(page).all[1].pen.color(), dark_colours().edge);
  ReliefView relief;
  relief.resize(216, 116);
  relief.show_picture({20, 20, std::vector<std::uint8_t>(400, 128)}, {});
  const auto boxes = drawn_by(relief).boxes();
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_EQ(boxes[0].box, QRectF(58, 8, 100, 100));
  EXPECT_EQ(boxes[0].fill.color(), QColor::fromRgbF(0, 0, 0, 0.25F));
  EXPECT_EQ(boxes[1].pen.color(), dark_colours().edge);
  QApplication::setPalette(make_palette(light_colours()));
}

}  // namespace
}  // namespace nazori::ui
