// SPDX-License-Identifier: Apache-2.0
// What the pages for study draw, shape by shape: in its exact place, in its colour.
#include <QFontInfo>
#include <QTest>

#include "characters/drawing_pad.h"
#include "characters/word_boxes.h"
#include "painted_page.h"
#include "session_under_test.h"
#include "start/choice_button.h"
#include "study/home_parts.h"
#include "study/ink_gallery.h"

namespace nazori::ui {
namespace {

using test::box_words;
using test::Drawing;
using test::Drawn;
using test::in_words;

class PaintedStudy : public test::PaintedPage {
 protected:
  /// What a widget draws of this size, in letters of 12 pixels.
  Drawing drawn(QWidget& widget, QSize size) {
    widget.setFont(font_);
    widget.resize(size);
    return test::drawn_by(widget);
  }
  /// A level stroke from 10 to 90 of the 109 units, at 50.
  static study::Handwriting ink() { return {{{{10, 50}, 0.0, 1.0}, {{90, 50}, 0.5, 1.0}}}; }
  /// Where such a stroke is drawn in a box.
  static QRectF stroke_in(const QRectF& box) {
    const double unit = box.width() / 109;
    return {box.left() + 10 * unit, box.top() + 50 * unit, 80 * unit, 0};
  }
  static void expect_at(const QRectF& is, const QRectF& wanted) {
    EXPECT_NEAR(is.left(), wanted.left(), 0.01);
    EXPECT_NEAR(is.top(), wanted.top(), 0.01);
    EXPECT_NEAR(is.width(), wanted.width(), 0.01);
    EXPECT_NEAR(is.height(), wanted.height(), 0.01);
  }
  const Colours& c_ = current_colours();
};

TEST_F(PaintedStudy, TheStartButtonHasItsWordItsKeyAndBelowThemWhatItHolds) {
  StartButton button;
  button.show_work(QStringLiteral("Go"), QStringLiteral("12 reviews"));
  const auto plain = drawn(button, {400, 120});
  EXPECT_EQ(in_words(plain.boxes()),
            QStringList{box_words({0, 0, 400, 120}, 10, QStringLiteral("none"), QStringLiteral("indigo"))});
  ASSERT_EQ(plain.words().size(), 3U);
  QFont large = font_;
  large.setPointSizeF(QFontInfo(font_).pointSizeF() * 1.4);
  const QFontMetrics word(large);
  const Drawn go = plain.words(QStringLiteral("Go"));
  EXPECT_NEAR(go.font.pointSizeF(), large.pointSizeF(), 1e-6);
  EXPECT_NEAR(go.box.left(), 15, 0.01) << "one and a quarter letters";
  EXPECT_NEAR(go.baseline, 15 + word.ascent(), 1.01);
  const Drawn key = plain.words(QStringLiteral("Enter"));
  EXPECT_NEAR(key.box.right(), 400 - 15, 1.01);
  EXPECT_LT(key.baseline, 15 + word.lineSpacing());
  const Drawn details = plain.words(QStringLiteral("12"));
  EXPECT_NEAR(details.box.left(), 15, 0.01);
  EXPECT_NEAR(details.baseline, 15 + word.lineSpacing() + QFontMetrics(font_).ascent(), 1.01);
  for (const Drawn& one : plain.words()) EXPECT_EQ(test::name_of(one.pen.color()), QStringLiteral("surface"));
  EXPECT_EQ(button.heightForWidth(400), word.lineSpacing() + QFontMetrics(font_).height() + 30);
  EXPECT_EQ(button.sizeHint(), QSize(144, button.heightForWidth(400)));
  EXPECT_GT(button.heightForWidth(60), button.heightForWidth(400)) << "its words wrap";
  button.show_work(QStringLiteral("Go"), {});
  EXPECT_EQ(button.heightForWidth(400), word.lineSpacing() + 30);
  EXPECT_EQ(button.accessibleName(), QStringLiteral("Go"));
}

TEST_F(PaintedStudy, TheKeyOfTheStartButtonIsLeftOutWhereItDoesNotFitBesideTheWord) {
  StartButton button;
  button.show_work(QStringLiteral("Go"), {});
  QFont large = font_;
  large.setPointSizeF(QFontInfo(font_).pointSizeF() * 1.4);
  const int needed = QFontMetrics(large).horizontalAdvance(QStringLiteral("Go")) +
                     QFontMetrics(font_).horizontalAdvance(QStringLiteral("Enter")) + 12 + 2 * 15;
  EXPECT_EQ(drawn(button, {needed, 80}).words().size(), 2U);
  EXPECT_EQ(drawn(button, {needed - 1, 80}).words().size(), 1U);
  font_.setPixelSize(40);
  const auto wide = drawn(button, {600, 200});
  EXPECT_NEAR(wide.words(QStringLiteral("Go")).box.left(), 20, 0.01) << "never more than 20 pixels";
}

TEST_F(PaintedStudy, TheStartButtonStandsOutUnderThePointerAndShowsTheKeyboard) {
  StartButton button;
  button.show_work(QStringLiteral("Go"), {});
  button.setAttribute(Qt::WA_UnderMouse);
  EXPECT_EQ(drawn(button, {200, 80}).boxes()[0].fill.color(), blend(c_.indigo, c_.ink, 0.12));
  button.setDown(true);
  EXPECT_EQ(drawn(button, {200, 80}).boxes()[0].fill.color(), blend(c_.indigo, c_.ink, 0.25));
  button.setDown(false);
  button.setAttribute(Qt::WA_UnderMouse, false);
  give_keyboard(button);
  button.setAttribute(Qt::WA_UnderMouse, false);
  EXPECT_EQ(
      in_words(drawn(button, {200, 80}).boxes()),
      (QStringList{box_words({0, 0, 200, 80}, 10, QStringLiteral("none"), QStringLiteral("indigo")),
                   box_words({4, 4, 192, 72}, 7, QStringLiteral("surface 2"), QStringLiteral("none"))}));
}

TEST_F(PaintedStudy, ATileHasItsCharacterInTheMiddleAndTheCaptionBelow) {
  CharacterTile tile(U'休', QStringLiteral("rest"), 1.0);
  const auto plain = drawn(tile, {120, 140});
  EXPECT_EQ(in_words(plain.boxes()), QStringList{box_words({1, 1, 118, 138}, 10, QStringLiteral("edge 1"),
                                                           QStringLiteral("surface"))});
  const Drawn glyph = plain.words(QStringLiteral("休"));
  EXPECT_NEAR(glyph.font.pointSizeF(), 48, 1e-6);
  const QFontMetrics large(glyph.font);
  EXPECT_NEAR(glyph.box.center().x(), 60, 1.01);
  EXPECT_NEAR(glyph.baseline, 3 + large.ascent(), 1.01) << "a quarter of a letter from above";
  EXPECT_EQ(test::name_of(glyph.pen.color()), QStringLiteral("ink"));
  const Drawn caption = plain.words(QStringLiteral("rest"));
  EXPECT_NEAR(caption.box.center().x(), 60, 1.01);
  EXPECT_NEAR(caption.baseline, 3 + large.height() + QFontMetrics(font_).ascent(), 1.01);
  EXPECT_EQ(test::name_of(caption.pen.color()), QStringLiteral("muted"));
  const QFontMetrics small(font_);
  EXPECT_EQ(tile.sizeHint(), QSize(std::max(large.horizontalAdvance(QStringLiteral("休")) + 15, 12 * 13 / 2),
                                   large.height() + small.height() + 12));
  tile.setAttribute(Qt::WA_UnderMouse);
  EXPECT_EQ(drawn(tile, {120, 140}).boxes()[0].pen_words(), QStringLiteral("indigo 1"));
  tile.setAttribute(Qt::WA_UnderMouse, false);
  give_keyboard(tile);
  tile.setAttribute(Qt::WA_UnderMouse, false);
  EXPECT_EQ(drawn(tile, {120, 140}).boxes()[0].pen_words(), QStringLiteral("indigo 2"));
}

TEST_F(PaintedStudy, ATileIsAsWideAsItsLongestWordAndGrowsWithLargeText) {
  const QString longest = QStringLiteral("counterrevolutionaries");
  CharacterTile tile(U'休', QStringLiteral("of ") + longest, 1.0);
  tile.setFont(font_);
  const QFontMetrics small(font_);
  EXPECT_EQ(tile.sizeHint().width(), small.horizontalAdvance(longest) + 12);
  CharacterTile bare(U'休', {}, 0.5);
  const auto without = drawn(bare, {80, 60});
  ASSERT_EQ(without.words().size(), 1U);
  const QFontMetrics half(without.words()[0].font);
  EXPECT_NEAR(without.words()[0].font.pointSizeF(), 24, 1e-6);
  EXPECT_EQ(bare.sizeHint(), QSize(half.horizontalAdvance(QStringLiteral("休")) + 15, half.height() + 6));
  font_.setPointSizeF(32);
  bare.setFont(font_);
  // 0.75 of 32 points over 12: twice as large.
  EXPECT_NEAR(drawn(bare, {200, 200}).words()[0].font.pointSizeF(), 48, 0.5);
}

TEST_F(PaintedStudy, HandwritingStandsInARowOrInSeveral) {
  InkRow row;
  row.show_inks(std::vector<practice::InkedWriting>(3, {U'一', true, ink()}));
  constexpr int kSide = 50;  // 4.2 letters of 12 pixels
  const auto one_row = drawn(row, {2 * kSide + 5, 200});
  ASSERT_EQ(one_row.lines().size(), 2U) << "as many as fit";
  for (int i = 0; i < 2; ++i) {
    const Drawn line = one_row.lines()[static_cast<std::size_t>(i)];
    expect_at(line.box, stroke_in(QRectF(i * kSide + 3, 3, 44, 44)));
    EXPECT_EQ(line.pen_words(), QStringLiteral("ink 1.98")) << "0.045 of the side";
  }
  EXPECT_EQ(row.heightForWidth(2 * kSide + 5), kSide);
  row.show_all(true);
  const auto all = drawn(row, {2 * kSide + 5, 200});
  ASSERT_EQ(all.lines().size(), 3U);
  expect_at(all.lines()[2].box, stroke_in(QRectF(3, kSide + 3, 44, 44)));
  EXPECT_EQ(row.heightForWidth(2 * kSide + 5), 2 * kSide);
  EXPECT_EQ(row.heightForWidth(kSide - 1), 3 * kSide) << "one in a row at least";
  EXPECT_EQ(row.sizeHint(), QSize(3 * kSide, kSide)) << "three in a row";
  row.show_inks({});
  EXPECT_EQ(row.heightForWidth(500), kSide);
  EXPECT_EQ(drawn(row, {300, 200}).lines().size(), 0U);
}

TEST_F(PaintedStudy, EarlierWritingsStandInFramesWithTheirWordsBelow) {
  InkGallery gallery;
  const InkGallery::Piece piece{ink(), QStringLiteral("now")};
  gallery.show_pieces({piece, piece, piece});
  gallery.setFont(font_);
  constexpr int kWidth = 108;  // two of 50, and 8 between them
  const int words = QFontMetrics(font_).height() + 2;
  EXPECT_EQ(gallery.heightForWidth(kWidth), 2 * (50 + words + 8));
  EXPECT_EQ(gallery.heightForWidth(12 * 7 * 3 - 1), 2 * (121 + words + 8));
  EXPECT_EQ(gallery.heightForWidth(12 * 7 * 3), 78 + words + 8) << "three of seven letters";
  EXPECT_EQ(gallery.sizeHint(), QSize(168, gallery.heightForWidth(168)));
  const auto all = drawn(gallery, {kWidth, gallery.heightForWidth(kWidth)});
  const QPoint places[] = {{0, 0}, {58, 0}, {0, 50 + words + 8}};
  ASSERT_EQ(all.boxes().size(), 3U);
  ASSERT_EQ(all.lines().size(), 3U);
  ASSERT_EQ(all.words().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const QRectF box(places[i].x() + 0.5, places[i].y() + 0.5, 49, 49);
    EXPECT_EQ(in_words(all.boxes()[i]),
              box_words(box, 6, QStringLiteral("line 1"), QStringLiteral("surface")));
    expect_at(all.lines()[i].box, stroke_in(box));
    EXPECT_EQ(all.lines()[i].pen_words(), QStringLiteral("ink 1.5")) << "no thinner";
    EXPECT_NEAR(all.words()[i].box.center().x(), places[i].x() + 25, 1.01);
    EXPECT_NEAR(all.words()[i].baseline, places[i].y() + 52 + QFontMetrics(font_).ascent(), 1.01);
    EXPECT_EQ(test::name_of(all.words()[i].pen.color()), QStringLiteral("muted"));
  }
}

TEST_F(PaintedStudy, TheBoxesOfAWordStandBesideEachOtherWithASignWhereOneIsFinished) {
  WordBoxes boxes(nullptr);
  boxes.setFont(font_);
  EXPECT_EQ(boxes.sizeHint(), QSize(0, 60));
  WordBoxes::Box finished, current;
  finished.is_finished = true;
  finished.strokes = {{{{-0.03, 0}, 0, 1.0}, {{0.03, 0}, 0.5, 1.0}}};
  finished.verdicts = {view::Verdict::wrong};
  current.is_current = true;
  boxes.show_boxes({finished, current});
  EXPECT_EQ(boxes.sizeHint(), QSize(2 * 60 + 6, 60)) << "five letters, and a gap";
  const auto all = drawn(boxes, {126, 60});
  EXPECT_EQ(
      in_words(all.boxes()),
      (QStringList{box_words({1, 1, 58, 58}, 6, QStringLiteral("line 1"), QStringLiteral("surface")),
                   box_words({67, 1, 58, 58}, 6, QStringLiteral("indigo 2"), QStringLiteral("surface"))}));
  const auto lines = all.lines();
  ASSERT_EQ(lines.size(), 5U) << "two crosses and a stroke";
  EXPECT_EQ(in_words(lines[0]), QStringLiteral("line 30 5 30 55, line 1 dashed"));
  EXPECT_EQ(in_words(lines[1]), QStringLiteral("line 5 30 55 30, line 1 dashed"));
  EXPECT_NEAR(lines[2].points[0].x(), 30 - 0.3 * 58, 0.01);
  EXPECT_NEAR(lines[2].points[1].x(), 30 + 0.3 * 58, 0.01);
  EXPECT_NEAR(lines[2].points[0].y(), 30, 0.01);
  EXPECT_EQ(test::name_of(lines[2].pen.color()), QStringLiteral("vermilion"));
  EXPECT_EQ(in_words(all.pictures()), QStringList{QStringLiteral("picture 43 43 14 14")});
}

TEST_F(PaintedStudy, TheInkOfABoxHasTheColourOfItsVerdict) {
  WordBoxes boxes(nullptr);
  const std::pair<view::Verdict, const char*> all[] = {{view::Verdict::right, "ink"},
                                                       {view::Verdict::nearly, "amber"},
                                                       {view::Verdict::wrong, "vermilion"},
                                                       {view::Verdict::none, "ink"},
                                                       {view::Verdict::shown, "ink"}};
  for (const auto& [verdict, colour] : all) {
    WordBoxes::Box box;
    box.strokes = {{{{-0.03, 0}, 0, 1.0}, {{0.03, 0}, 0.5, 1.0}}};
    box.verdicts = {verdict};
    boxes.show_boxes({box});
    EXPECT_EQ(test::name_of(drawn(boxes, {60, 60}).lines().back().pen.color()), QString::fromLatin1(colour));
  }
}

TEST_F(PaintedStudy, ThePadIsASquareWithACrossAndSaysWhatItIsForWhileItIsEmpty) {
  DrawingPad pad;
  const auto empty = drawn(pad, {300, 200});
  EXPECT_EQ(in_words(empty.boxes()),
            QStringList{box_words({1, 1, 198, 198}, 8, QStringLiteral("line 1"), QStringLiteral("surface"))});
  EXPECT_EQ(in_words(empty.lines()), (QStringList{QStringLiteral("line 100 8 100 192, line 1 dashed"),
                                                  QStringLiteral("line 8 100 192 100, line 1 dashed")}));
  const Drawn words = empty.words(QStringLiteral("Draw"));
  EXPECT_NEAR(words.box.center().x(), 100, 1.01);
  EXPECT_EQ(test::name_of(words.pen.color()), QStringLiteral("muted"));
  EXPECT_TRUE(drawn(pad, {40, 40}).words().empty()) << "too little room for words";
  pad.resize(200, 200);
  QTest::mousePress(&pad, Qt::LeftButton, {}, {20, 40});
  QTest::mouseMove(&pad, {120, 40});
  QMouseEvent move(QEvent::MouseMove, {120, 40}, {120, 40}, Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&pad, &move);
  const auto written = drawn(pad, {200, 200});
  EXPECT_TRUE(written.words().empty());
  ASSERT_GE(written.lines().size(), 3U);
  const Drawn first = written.lines()[2];
  EXPECT_NEAR(first.points.front().x(), 20, 0.01);
  EXPECT_NEAR(first.points.front().y(), 40, 0.01);
  EXPECT_NEAR(written.lines().back().points.back().x(), 120, 0.01);
  // 0.012 of the side, and 0.024 more at full pressure; a mouse presses with 0.6.
  EXPECT_EQ(first.pen_words(), QStringLiteral("ink 5.28"));
}

TEST_F(PaintedStudy, AChoiceIsMarkedByItsEdgeAndATint) {
  ChoiceButton choice("yes", QStringLiteral("Yes"), nullptr);
  const auto box = [&](QSize size) { return in_words(drawn(choice, size).boxes()[0]); };
  const QRectF frame(1, 1, 98, 38);
  EXPECT_EQ(box({100, 40}), box_words(frame, 10, QStringLiteral("edge 1"), QStringLiteral("surface")));
  const Drawn yes = drawn(choice, {100, 40}).words(QStringLiteral("Yes"));
  EXPECT_NEAR(yes.box.center().x(), 50, 1.01);
  EXPECT_NEAR(yes.box.center().y(), 20, 1.51);
  choice.setAttribute(Qt::WA_UnderMouse);
  const QString half = blend(c_.surface, c_.indigo, 0.05).name(QColor::HexArgb);
  const QString whole = blend(c_.surface, c_.indigo, 0.1).name(QColor::HexArgb);
  EXPECT_EQ(box({100, 40}), box_words(frame, 10, QStringLiteral("edge 1"), half));
  choice.setChecked(true);
  EXPECT_EQ(box({100, 40}), box_words(frame, 10, QStringLiteral("indigo 2"), whole));
  choice.setAttribute(Qt::WA_UnderMouse, false);
  EXPECT_EQ(box({100, 40}), box_words(frame, 10, QStringLiteral("indigo 2"), whole));
  EXPECT_EQ(drawn(choice, {100, 40}).boxes().size(), 1U);
  choice.setAutoExclusive(false);
  choice.setChecked(false);
  give_keyboard(choice);
  choice.setAttribute(Qt::WA_UnderMouse, false);
  EXPECT_EQ(in_words(drawn(choice, {100, 40}).boxes()),
            (QStringList{box_words(frame, 10, QStringLiteral("indigo 2"), QStringLiteral("surface")),
                         box_words({5, 5, 90, 30}, 6, QStringLiteral("indigo 1"), QStringLiteral("none"))}));
}

TEST_F(PaintedStudy, AChoiceWithACharacterHasThreeLinesBelowEachOther) {
  ChoiceButton choice("kana", QStringLiteral("Hiragana"), nullptr, QStringLiteral("あ"),
                      QStringLiteral("46 letters"));
  choice.setFont(font_);
  const auto all = drawn(choice, {300, 200});
  ASSERT_EQ(all.words().size(), 3U);
  const Drawn glyph = all.words()[0], words = all.words()[1], more = all.words()[2];
  const double pt = QFontInfo(font_).pointSizeF();
  EXPECT_NEAR(glyph.font.pointSizeF(), 2.6 * pt, 1e-6);
  EXPECT_NEAR(more.font.pointSizeF(), 0.9 * pt, 1e-6);
  const QFontMetrics first(glyph.font), second(font_), third(more.font);
  for (const Drawn& one : all.words()) EXPECT_NEAR(one.box.left(), 18, 1.01);
  EXPECT_NEAR(glyph.baseline, 10 + first.ascent(), 1.01);
  EXPECT_NEAR(words.baseline, 10 + first.lineSpacing() + second.ascent(), 1.01);
  EXPECT_NEAR(more.baseline, 10 + first.lineSpacing() + second.lineSpacing() + third.ascent(), 1.01);
  EXPECT_EQ(test::name_of(glyph.pen.color()), QStringLiteral("ink"));
  EXPECT_EQ(test::name_of(words.pen.color()), QStringLiteral("ink"));
  EXPECT_EQ(test::name_of(more.pen.color()), QStringLiteral("muted"));
  EXPECT_EQ(choice.sizeHint(), QSize(std::max({second.horizontalAdvance(choice.text()),
                                               third.horizontalAdvance(QStringLiteral("46 letters")),
                                               16 * second.averageCharWidth()}) +
                                         36,
                                     first.lineSpacing() + second.lineSpacing() + third.lineSpacing() + 20));
  ChoiceButton plain("no", QStringLiteral("No"), nullptr);
  plain.setFont(font_);
  EXPECT_EQ(plain.sizeHint(),
            QSize(second.horizontalAdvance(QStringLiteral("No")) + 36, second.lineSpacing() + 20));
}

}  // namespace
}  // namespace nazori::ui
