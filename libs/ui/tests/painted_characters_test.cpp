// SPDX-License-Identifier: Apache-2.0
// What the page for characters draws, shape by shape: in its exact place, in its colour.
#include <gtest/gtest.h>

#include <QFontInfo>
#include <QPushButton>

#include "characters/character_list_model.h"
#include "characters/character_tile_delegate.h"
#include "characters/compare_view.h"
#include "characters/confusable_view.h"
#include "characters/glyph_view.h"
#include "nazori/widgets/words/kanji_text.h"
#include "painted_page.h"

namespace nazori::ui {
namespace {

using study::Strength;
using test::box_words;
using test::Drawing;
using test::Drawn;
using test::drawn_by;
using test::in_words;
using test::words;

class PaintedCharacters : public test::PaintedPage {
 protected:
  /// The tile of 口, known that well.
  Drawing tile(Strength strength, QStyle::State state = QStyle::State_None, char32_t current = 0) {
    CharacterListModel model;
    model.set_characters(std::make_shared<const std::vector<kanji::Summary>>(
        std::vector{kanji::Summary{U'口', "", "", 3, {}}}));
    model.set_strengths([strength](char32_t) { return strength; });
    CharacterTileDelegate delegate;
    delegate.set_current(current);
    return drawn_by(QSize(100, 100), [&](QPainter& painter) {
      delegate.paint(&painter, option(QRect(0, 0, 100, 100), state), model.index(0));
    });
  }
  /// The row of a search, with why it was found.
  Drawing row(practice::SearchRow found, QSize size) {
    CharacterListModel model;
    auto answer = std::make_shared<practice::SearchAnswer>();
    answer->rows = {std::move(found)};
    model.set_answer(answer);
    const CharacterTileDelegate delegate;
    return drawn_by(size, [&](QPainter& painter) {
      delegate.paint(&painter, option(QRect(QPoint(), size), QStyle::State_None), model.index(0));
    });
  }
  static practice::SearchRow found_row() {
    practice::SearchRow made;
    made.character = {U'休', "rest", "やす.む", 6, 1};
    made.reason = kanji::Reason::meaning;
    made.text = "day off";
    return made;
  }
  const Colours& c_ = current_colours();
};

TEST_F(PaintedCharacters, ATileHasABarAsLongAsItsCharacterIsKnownAndASign) {
  const QRectF frame(2.5, 2.5, 95, 95);
  const QString edge = box_words(frame, 6, words("line 1"), words("surface"));
  const std::tuple<Strength, double, const char*> all[] = {
      {Strength::unseen, 0, ""},  {Strength::learning, 0.3, "◔"}, {Strength::young, 0.6, "◑"},
      {Strength::mature, 1, "●"}, {Strength::leech, 0.3, "!"},    {Strength::paused, 0, "‖"}};
  for (const auto& [strength, share, sign] : all) {
    const Drawing drawn = tile(strength);
    QStringList boxes{edge};
    const char* colour = strength == Strength::leech ? "amber" : "indigo";
    if (share > 0) {
      boxes.append(box_words({6.5, 92.5, 87, 3}, 1.5, words("none"), words("line")));
      boxes.append(box_words({6.5, 92.5, 87 * share, 3}, 1.5, words("none"), words(colour)));
    }
    EXPECT_EQ(in_words(drawn.boxes()), boxes) << static_cast<int>(strength);
    ASSERT_EQ(drawn.words().size(), *sign == 0 ? 1U : 2U);
    if (*sign == 0) continue;
    const Drawn mark = drawn.words(words(sign));
    EXPECT_EQ(mark.font.pixelSize(), 20) << "0.22 of the tile";
    EXPECT_TRUE(mark.font.bold());
    EXPECT_NEAR(mark.box.right(), 94.5, 1.01);
    EXPECT_NEAR(mark.box.top(), 3.5, 1.01);
    EXPECT_EQ(test::name_of(mark.pen.color()), words(strength == Strength::leech ? "amber" : "muted"));
  }
}

TEST_F(PaintedCharacters, ATileShowsWhereThePointerTheKeyboardAndThePageAre) {
  const QRectF frame(2.5, 2.5, 95, 95);
  const auto box = [&](QStyle::State state, char32_t current = 0) {
    return in_words(tile(Strength::unseen, state, current).boxes()[0]);
  };
  const QString hovered = blend(c_.surface, c_.line, 0.35).name(QColor::HexArgb);
  const QString chosen = blend(c_.surface, c_.indigo, 0.13).name(QColor::HexArgb);
  EXPECT_EQ(box(QStyle::State_MouseOver), box_words(frame, 6, words("line 1"), hovered));
  EXPECT_EQ(box(QStyle::State_HasFocus), box_words(frame, 6, words("indigo 2"), words("surface")));
  EXPECT_EQ(box(QStyle::State_None, U'口'), box_words(frame, 6, words("indigo 2"), chosen));
  EXPECT_EQ(box(QStyle::State_MouseOver, U'口'), box_words(frame, 6, words("indigo 2"), chosen));
  const Drawn glyph = tile(Strength::unseen).words(words("口"));
  EXPECT_EQ(glyph.font.pixelSize(), 58) << "0.62 of the tile";
  EXPECT_NEAR(glyph.box.center().x(), 50, 1.01);
  EXPECT_NEAR(glyph.box.center().y(), 50, 1.51);
  EXPECT_EQ(test::name_of(glyph.pen.color()), words("ink"));
  EXPECT_EQ(test::name_of(tile(Strength::unseen, {}, U'口').words(words("口")).pen.color()), words("indigo"));
  EXPECT_EQ(CharacterTileDelegate::tile_side(font_), 36);
  EXPECT_EQ(CharacterTileDelegate::row_height(font_), 40);
}

TEST_F(PaintedCharacters, ARowOfASearchHasWhatMatchesAboveTheRest) {
  const Drawing drawn = row(found_row(), {400, 45});  // a tile of 395 x 40
  const Drawn glyph = drawn.words(words("休"));
  EXPECT_EQ(glyph.font.pixelSize(), 22) << "0.56 of the height";
  EXPECT_NEAR(glyph.box.center().x(), 2.5 + 20, 1.01) << "in a square at the left";
  const Drawn upper = drawn.words(words("day off"));
  const Drawn lower = drawn.words(words("やす"));
  for (const Drawn& one : {upper, lower}) EXPECT_NEAR(one.box.left(), 2.5 + 40 + 4, 1.01);
  EXPECT_NEAR(upper.box.center().y(), 5.5 + 8.5, 1.51) << "the upper half of 34 pixels";
  EXPECT_NEAR(lower.box.center().y(), 5.5 + 25.5, 1.51);
  EXPECT_EQ(test::name_of(upper.pen.color()), words("ink"));
  EXPECT_EQ(test::name_of(lower.pen.color()), words("muted"));
  auto only = found_row();
  only.character.reading.clear();
  const Drawing one_line = row(only, {400, 45});
  ASSERT_EQ(one_line.words().size(), 2U);
  EXPECT_NEAR(one_line.words(words("day off")).box.center().y(), 22.5, 1.51) << "one line is in the middle";
}

TEST_F(PaintedCharacters, WhatIsTooLongForARowIsCutSixPixelsFromItsEnd) {
  auto found = found_row();
  found.text = std::string(200, 'x');
  const Drawing drawn = row(found, {400, 45});  // a tile of 395 x 40
  const QFontMetricsF metrics(font_);
  const double room = 395 - 40 - 4 - 6;
  EXPECT_EQ(drawn.words(words("xx")).text, metrics.elidedText(QString(200, u'x'), Qt::ElideRight, room));
  EXPECT_GT(metrics.horizontalAdvance(drawn.words(words("xx")).text), room - 12);
}

TEST_F(PaintedCharacters, ALongWordInARowIsWrittenSmallerSoThatItHasLessThanHalf) {
  auto found = found_row();
  found.word = practice::FoundWord{"一二三四五六七八", "いち", {"long"}};
  const Drawing wide = row(found, {1000, 45});
  EXPECT_EQ(wide.words(words("一")).font.pixelSize(), 22);
  const Drawing narrow = row(found, {200, 45});
  const Drawn word = narrow.words(words("一"));
  QFont font = word.font;
  font.setPixelSize(22);
  const double needed = QFontMetricsF(font).horizontalAdvance(words("一二三四五六七八")) + 16;
  EXPECT_EQ(word.font.pixelSize(), std::max(10, static_cast<int>(22 * 0.45 * 195 / needed)));
  EXPECT_NEAR(narrow.words(words("いち")).box.left(), 2.5 + 0.45 * 195 + 4, 1.01);
}

/// A level stroke through the middle and one below it.
std::vector<practice::HandStroke> two_strokes() {
  return {{{{-0.03, 0}, 0.5, 0.5}, {{0.03, 0}, 1.5, 0.5}},
          {{{-0.03, -0.03}, 2, 0.5}, {{0.03, -0.03}, 3, 0.5}}};
}

practice::Tablet upright_model() {
  kanji::StrokeLine line;
  line.points = {{54.5, 20}, {54.5, 89}};
  return *tablet::CarvedTablet::from_lines({line}, 128);
}

TEST_F(PaintedCharacters, WritingAndModelStandOnTwoSheetsWithSignsAtTheStarts) {
  CompareView view;
  view.setFont(font_);
  view.resize(414, 300);  // two sides of 200
  view.show_writing(two_strokes(), {view::Verdict::nearly, view::Verdict::none}, upright_model());
  const Drawing all = drawn_by(view);
  const auto boxes = all.boxes();
  ASSERT_GE(boxes.size(), 3U);
  EXPECT_EQ(in_words(boxes[0]), box_words({2, 2, 200, 200}, 8, words("line 1"), words("surface")));
  EXPECT_EQ(in_words(boxes[1]), box_words({212, 2, 200, 200}, 8, words("line 1"), words("surface")));
  EXPECT_EQ(in_words(boxes[2]), words("disc 25.8 85.8 18 18, amber 1, surface"))
      << "of 9 pixels, a little above the start";
  EXPECT_EQ(in_words(all.pictures()), QStringList{words("picture 28.8 88.8 12 12")})
      << "no sign without a verdict";
  const auto lines = in_words(all.lines());
  for (const char* cross : {"line 102 7 102 197, line 1 dashed", "line 7 102 197 102, line 1 dashed",
                            "line 312 7 312 197, line 1 dashed", "line 217 102 407 102, line 1 dashed"})
    EXPECT_TRUE(lines.contains(words(cross))) << cross;
  const auto drawn_in = [&](const char* colour, int* count) {
    QRectF box;
    for (const Drawn& one : all.all)
      if (one.kind == Drawn::Kind::shape && !one.round && test::name_of(one.pen.color()) == words(colour) &&
          one.pen.style() == Qt::SolidLine) {
        box = box.isNull() && *count == 0 ? one.box : box.united(one.box);
        ++*count;
      }
    return box;
  };
  int strokes = 0;
  const QRectF first = drawn_in("amber", &strokes);
  EXPECT_EQ(strokes, 1);
  EXPECT_NEAR(first.left(), 42, 0.01);
  EXPECT_NEAR(first.right(), 162, 0.01);
  EXPECT_NEAR(first.top(), 102, 0.01);
  const Drawn model = all.all.back();
  EXPECT_EQ(test::name_of(model.pen.color()), words("ink"));
  EXPECT_NEAR(model.pen.widthF(), 7, 0.01) << "0.035 of the side";
  EXPECT_NEAR(model.box.left(), 312, 0.1);
  EXPECT_NEAR(model.box.top(), 2 + 200 * 20 / 109.0, 0.1);
  EXPECT_NEAR(model.box.bottom(), 2 + 200 * 89 / 109.0, 0.1);
  const Drawn yours = all.words(words("yours"));
  EXPECT_NEAR(yours.box.center().x(), 102, 1.01);
  EXPECT_NEAR(all.words(words("model")).box.center().x(), 312, 1.01);
  EXPECT_NEAR(yours.baseline, 204 + QFontMetrics(font_).ascent(), 1.51);
  view.show_moment(10);
  EXPECT_EQ(drawn_by(view).pictures().size(), 0U) << "no signs while it is written";
  EXPECT_EQ(view.sizeHint(), QSize(2 * 108 + 14, 108 + 4 + QFontMetrics(font_).height()));
  EXPECT_EQ(view.minimumSizeHint().width(), 115);
  view.resize(600, 150);
  const double low = 150 - 4 - QFontMetrics(font_).height();
  EXPECT_EQ(in_words(drawn_by(view).boxes()[1]),
            box_words({2 + low + 10, 2, low, low}, 8, words("line 1"), words("surface")));
}

TEST_F(PaintedCharacters, EachVerdictHasItsColourAndItsSign) {
  const std::tuple<view::Verdict, const char*, std::size_t> all[] = {{view::Verdict::right, "moss", 1},
                                                                     {view::Verdict::nearly, "amber", 1},
                                                                     {view::Verdict::wrong, "vermilion", 1},
                                                                     {view::Verdict::none, "ink", 0},
                                                                     {view::Verdict::shown, "ink", 1}};
  for (const auto& [verdict, colour, signs] : all) {
    CompareView view;
    view.resize(414, 300);
    view.show_writing({two_strokes()[0]}, {verdict}, upright_model());
    const Drawing drawn = drawn_by(view);
    EXPECT_EQ(drawn.pictures().size(), signs);
    EXPECT_EQ(test::name_of(drawn.lines()[4].pen.color()), words(colour));
  }
}

TEST_F(PaintedCharacters, AGlyphOfStrokesFillsItsSheet) {
  GlyphView view;
  view.setFont(font_);
  EXPECT_EQ(view.sizeHint(), QSize(96, 96)) << "eight letters";
  view.resize(200, 300);
  auto sheet = std::make_shared<practice::CharacterSheet>();
  sheet->character.code_point = 0x10FFFD;  // in no font
  kanji::Stroke stroke;
  stroke.line.points = {{20, 30}, {89, 30}};
  sheet->character.strokes = {stroke};
  view.show_character(sheet);
  const Drawing all = drawn_by(view);
  EXPECT_EQ(in_words(all.boxes()),
            QStringList{box_words({0.5, 0.5, 199, 199}, 10, words("line 1"), words("surface"))});
  const double unit = 200 * 0.84 / 109;
  const Drawn line = all.lines().back();
  EXPECT_NEAR(line.box.left(), 16 + 20 * unit, 0.01);
  EXPECT_NEAR(line.box.right(), 16 + 89 * unit, 0.01);
  EXPECT_NEAR(line.box.top(), 16 + 30 * unit, 0.01);
  EXPECT_NEAR(line.pen.widthF(), 4.4 * unit, 0.01);
  QFont large = font_;
  large.setPixelSize(40);
  view.setFont(large);
  EXPECT_EQ(view.sizeHint(), QSize(210, 210)) << "no larger";
}

TEST_F(PaintedCharacters, AGlyphOfTheTextbookFontStandsWithItsInkInTheMiddle) {
  if (!textbook_font_has(U'田')) GTEST_SKIP() << "the font is not installed";
  GlyphView view;
  view.resize(200, 200);
  auto sheet = std::make_shared<practice::CharacterSheet>();
  sheet->character.code_point = U'田';
  view.show_character(sheet);
  const Drawn glyph = drawn_by(view).words(words("田"));
  EXPECT_EQ(glyph.font.pixelSize(), 164) << "0.82 of the side";
  EXPECT_NEAR(glyph.box.center().x(), 100, 1.01);
  const QRectF ink = QFontMetricsF(glyph.font).tightBoundingRect(words("田"));
  EXPECT_NEAR(glyph.baseline + ink.center().y(), 100, 0.51);
}

TEST_F(PaintedCharacters, OfConfusableCharactersTheStrokesThatDifferAreThick) {
  practice::CharacterSheet sheet;
  const auto character = [](char32_t code_point, std::vector<double> heights) {
    kanji::Character made;
    made.code_point = code_point;
    for (const double y : heights) {
      kanji::Stroke stroke;
      stroke.line.points = {{20, y}, {89, y}};
      made.strokes.push_back(stroke);
    }
    return made;
  };
  sheet.character = character(U'二', {30, 80});
  sheet.confusables = {character(U'三', {30, 55, 80})};
  ConfusableView view({}, nullptr);
  view.setFont(font_);
  view.show_sheet(sheet);
  auto* picture = view.findChild<QPushButton*>(words("confusable_三"));
  ASSERT_NE(picture, nullptr);
  const double side = picture->width();
  EXPECT_EQ(side, 5 * QFontInfo(picture->font()).pixelSize());
  const Drawing all = drawn_by(*picture);
  EXPECT_EQ(in_words(all.boxes()),
            QStringList{box_words({1, 1, side - 2, side - 2}, 6, words("line 1"), words("surface"))});
  const double unit = side * 0.8 / 109;
  ASSERT_EQ(all.lines().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Drawn line = all.lines()[i];
    EXPECT_NEAR(line.box.left(), side * 0.1 + 20 * unit, 0.01);
    EXPECT_NEAR(line.box.right(), side * 0.1 + 89 * unit, 0.01);
    EXPECT_NEAR(line.box.top(), side * 0.1 + (30 + 25.0 * static_cast<double>(i)) * unit, 0.01);
    EXPECT_NEAR(line.pen.widthF(), (i == 1 ? 8 : 4) * unit, 0.01);
    EXPECT_EQ(test::name_of(line.pen.color()), words(i == 1 ? "indigo" : "ink"));
  }
  for (const Drawn& one : drawn_by(*view.findChild<QPushButton*>(words("confusable_二"))).lines())
    EXPECT_EQ(test::name_of(one.pen.color()), words("ink"));
  picture->setAttribute(Qt::WA_UnderMouse);
  EXPECT_EQ(drawn_by(*picture).boxes()[0].fill.color(), blend(c_.surface, c_.line, 0.35));
}

}  // namespace
}  // namespace nazori::ui
