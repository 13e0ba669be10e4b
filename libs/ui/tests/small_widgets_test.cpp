// SPDX-License-Identifier: Apache-2.0
// The small widgets of the page for characters, each alone: what they say, draw and emit.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPainter>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <cmath>

#include "characters/character_list_model.h"
#include "characters/character_tile_delegate.h"
#include "characters/compare_view.h"
#include "characters/glyph_view.h"
#include "characters/strictness_slider.h"
#include "characters/writing_report.h"
#include "nazori/widgets/look/palette.h"
#include "picture_under_test.h"
#include "study/ink_gallery.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using test::box_of;
using test::is;
using test::picture_of;

class SmallWidgets : public testing::Test {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }
};

TEST_F(SmallWidgets, StrictnessHasWordsForEveryStepAndKeysGoByAQuarter) {
  StrictnessSlider strictness(nullptr);
  auto* slider = strictness.findChild<QSlider*>(QStringLiteral("strictness"));
  auto* label = strictness.findChild<QLabel*>(QStringLiteral("strictness_words"));
  EXPECT_EQ(strictness.strictness(), 0.5);
  const QSignalSpy moved(&strictness, &StrictnessSlider::moved);
  for (int step = 0; step <= StrictnessSlider::kSteps; ++step) {
    strictness.set_strictness(step / 20.0);
    EXPECT_EQ(strictness.strictness(), step / 20.0);
    const QString expected = step == 0    ? QStringLiteral("lenient")
                             : step < 10  ? QStringLiteral("fairly lenient")
                             : step == 10 ? QStringLiteral("normal")
                             : step < 20  ? QStringLiteral("fairly strict")
                                          : QStringLiteral("strict");
    EXPECT_EQ(strictness.words(), expected) << step;
    EXPECT_EQ(label->text(), expected);
    EXPECT_EQ(slider->accessibleDescription(), expected);
  }
  EXPECT_EQ(moved.count(), 0) << "only a hand moves it";
  strictness.set_strictness(0.27);
  EXPECT_EQ(slider->value(), 5);
  strictness.set_strictness(0.28);
  EXPECT_EQ(slider->value(), 6);
  strictness.step(+2);
  EXPECT_EQ(slider->value(), 8);
  EXPECT_EQ(moved.count(), 1);
  EXPECT_EQ(moved.at(0).at(0).toDouble(), 0.4);
  strictness.step(-20);
  EXPECT_EQ(slider->value(), 0);
  strictness.step(-1);
  EXPECT_EQ(moved.count(), 2);
  EXPECT_EQ(slider->pageStep(), 5);
  EXPECT_EQ(slider->accessibleName(), QStringLiteral("Strictness"));
}

TEST_F(SmallWidgets, TheNamesUnderTheSliderAreThereWhereTheyFit) {
  StrictnessSlider strictness(nullptr);
  strictness.show();
  const auto marks = [&strictness] {
    QStringList all;
    for (const auto* label : strictness.findChildren<QLabel*>())
      if (label->property("role") == QStringLiteral("muted") && label->isVisible()) all.append(label->text());
    return all;
  };
  strictness.resize(600, 80);
  EXPECT_EQ(marks(),
            (QStringList{QStringLiteral("lenient"), QStringLiteral("normal"), QStringLiteral("strict")}));
  strictness.resize(60, 80);
  EXPECT_EQ(marks(), QStringList());
}

TEST_F(SmallWidgets, AListOfCharactersTellsThemWithMeaningAndReading) {
  CharacterListModel model;
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.at(0), 0U);
  EXPECT_EQ(model.row_of(U'休'), -1);
  kanji::Summary rest{U'休', "rest", "やす.む", 6, 1};
  kanji::Summary kana{U'あ', "", "", 3, {}};
  model.set_characters(std::make_shared<const std::vector<kanji::Summary>>(std::vector{rest, kana}));
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_EQ(model.rowCount(model.index(0)), 0);
  EXPECT_EQ(model.row_of(U'休'), 0);
  EXPECT_EQ(model.row_of(U'あ'), 1);
  EXPECT_EQ(model.row_of(U'木'), -1);
  EXPECT_EQ(model.at(1), U'あ');
  EXPECT_EQ(model.at(2), 0U);
  EXPECT_EQ(model.at(-1), 0U);
  const auto data = [&](int row, int role) { return model.data(model.index(row), role); };
  EXPECT_EQ(data(0, Qt::DisplayRole).toString(), QStringLiteral("休"));
  EXPECT_EQ(data(0, Qt::ToolTipRole).toString(), QStringLiteral("休 · rest · やす・む"));
  EXPECT_EQ(data(0, Qt::AccessibleTextRole).toString(), QStringLiteral("休, rest, やす・む"));
  EXPECT_EQ(data(1, Qt::ToolTipRole).toString(), QStringLiteral("あ"));
  EXPECT_EQ(data(1, CharacterListModel::kCodePointRole).toUInt(), static_cast<uint>(U'あ'));
  EXPECT_FALSE(data(0, Qt::DecorationRole).isValid());
  EXPECT_FALSE(model.data({}, Qt::DisplayRole).isValid());
}

TEST_F(SmallWidgets, TheTileOfTheShownCharacterStandsOutFromTheOthers) {
  CharacterListModel model;
  model.set_characters(std::make_shared<const std::vector<kanji::Summary>>(
      std::vector{kanji::Summary{U'田', "", "", 5, {}}, kanji::Summary{U'口', "", "", 3, {}}}));
  CharacterTileDelegate delegate;
  delegate.set_current(U'口');
  delegate.set_side(90);
  EXPECT_EQ(delegate.sizeHint({}, {}), QSize(90, 90));
  const auto painted = [&](int row, QStyle::State state) {
    QStyleOptionViewItem option;
    option.rect = QRect(5, 5, 90, 90);
    option.state = state;
    QImage picture(100, 100, QImage::Format_ARGB32);
    picture.fill(Qt::magenta);
    QPainter painter(&picture);
    delegate.paint(&painter, option, model.index(row));
    return picture;
  };
  const Colours& c = current_colours();
  const QPointF corner(14, 14);
  const auto plain = painted(0, QStyle::State_None);
  EXPECT_TRUE(is(plain, corner, c.surface));
  EXPECT_TRUE(is(plain, {2, 2}, Qt::magenta)) << "nothing beside the tile";
  EXPECT_TRUE(is(plain, {98, 98}, Qt::magenta));
  EXPECT_EQ(plain.pixel(50, 95), QColor(Qt::magenta).rgb()) << "a gap between the tiles";
  const auto current = painted(1, QStyle::State_None);
  EXPECT_NE(current.pixel(14, 14), plain.pixel(14, 14));
  EXPECT_FALSE(box_of(plain, c.ink).isNull());
  EXPECT_TRUE(box_of(current, c.ink).isNull()) << "drawn in the colour of the choice";
  EXPECT_NE(painted(0, QStyle::State_MouseOver).pixel(14, 14), plain.pixel(14, 14));
  EXPECT_NE(painted(0, QStyle::State_HasFocus), plain);
  const QRect glyph = box_of(plain, c.ink);
  EXPECT_NEAR(glyph.center().x(), 50, 6);
  EXPECT_NEAR(glyph.center().y(), 50, 10);
  EXPECT_GT(glyph.width(), 30);
  EXPECT_EQ(CharacterTileDelegate::tile_side(QFont()), QFontInfo(QFont()).pixelSize() * 3);
}

/// A level stroke through the middle, from 0.5 s to 1.5 s, and one below it from 2 s to 3 s.
std::vector<practice::HandStroke> two_strokes() {
  practice::HandStroke first, second;
  for (int i = 0; i <= 10; ++i) {
    first.push_back({{-0.03 + 0.006 * i, 0}, 0.5 + 0.1 * i, 0.5});
    second.push_back({{-0.03 + 0.006 * i, -0.03}, 2 + 0.1 * i, 0.5});
  }
  return {first, second};
}
practice::Tablet upright_model() {
  kanji::StrokeLine line;
  line.points = {{54.5, 20}, {54.5, 89}};
  return *tablet::CarvedTablet::from_lines({line}, 128);
}

TEST_F(SmallWidgets, ComparingReplaysTheWritingAtItsOwnSpeed) {
  CompareView view;
  EXPECT_EQ(view.points_shown(), 0);
  EXPECT_EQ(view.duration_s(), 0);
  view.show_writing(two_strokes(), {}, upright_model());
  EXPECT_EQ(view.points_shown(), 22);
  EXPECT_GE(view.duration_s(), 2.5);
  const QSignalSpy shown(&view, &CompareView::moment_shown);
  view.show_moment(0.55);
  EXPECT_EQ(view.points_shown(), 6);
  view.show_moment(1.55);
  EXPECT_EQ(view.points_shown(), 12);
  view.show_moment(0);
  EXPECT_EQ(view.points_shown(), 1);
  view.show_moment(-1);
  EXPECT_EQ(view.points_shown(), 22);
  EXPECT_EQ(shown.count(), 4);
  auto long_one = two_strokes();
  long_one[1].back().time_s = 100.5;
  view.show_writing(long_one, {}, upright_model());
  EXPECT_EQ(view.duration_s(), 100) << "the longer of both";
}

TEST_F(SmallWidgets, AReplayBeginsAtNothingAndEndsWithAll) {
  CompareView view;
  practice::HandStroke quick{{{0, 0}, 1, 0.5}, {{0.01, 0}, 1.01, 0.5}};
  kanji::StrokeLine dot;
  dot.points = {{50, 50}, {51, 50}};
  view.show_writing({quick}, {}, *tablet::CarvedTablet::from_lines({dot}, 128));
  QSignalSpy shown(&view, &CompareView::moment_shown);
  QSignalSpy finished(&view, &CompareView::finished);
  view.set_playing(false);
  EXPECT_EQ(shown.count(), 0) << "nothing was playing";
  view.set_playing(true);
  ASSERT_GE(shown.count(), 1);
  EXPECT_EQ(shown.at(0).at(0).toDouble(), 0);
  ASSERT_TRUE(finished.wait(20'000));
  EXPECT_EQ(finished.count(), 1);
  EXPECT_LT(shown.last().at(0).toDouble(), 0);
  EXPECT_EQ(view.points_shown(), 2);
  for (int i = 2; i + 1 < shown.count(); ++i)
    EXPECT_GE(shown.at(i).at(0).toDouble(), shown.at(i - 1).at(0).toDouble());
}

TEST_F(SmallWidgets, WritingAndModelAreDrawnBesideEachOtherInTheirPlaces) {
  CompareView view;
  view.resize(414, 300);  // two sides of 200
  view.show_writing(two_strokes(), {view::Verdict::right, view::Verdict::wrong}, upright_model());
  const QImage all = picture_of(view);
  const Colours& c = current_colours();
  EXPECT_TRUE(is(all, {102, 102}, c.moss)) << "the first stroke, judged right";
  EXPECT_TRUE(is(all, {112, 162}, c.vermilion)) << "the second, 30 mm lower";
  EXPECT_FALSE(is(all, {172, 102}, c.moss)) << "behind its end";
  const QRect model = box_of(all, c.ink, QRect(216, 4, 190, 190));
  EXPECT_NEAR(model.center().x(), 312, 3);
  EXPECT_NEAR(model.top(), 2 + 200 * 20 / 109.0, 8);
  EXPECT_NEAR(model.bottom(), 2 + 200 * 89 / 109.0, 8);
  view.show_moment(0.55);
  const QImage part = picture_of(view);
  EXPECT_TRUE(is(part, {70, 102}, c.moss));
  EXPECT_FALSE(is(part, {122, 102}, c.moss)) << "not yet written";
  EXPECT_FALSE(is(part, {112, 162}, c.vermilion));
  const QRect begun = box_of(part, c.ink, QRect(216, 4, 190, 190));
  EXPECT_LT(begun.height(), model.height());
  EXPECT_GT(view.sizeHint().width(), 2 * (view.sizeHint().height() - view.fontMetrics().height()));
  EXPECT_EQ(view.minimumSizeHint().height(), view.sizeHint().height());
}

TEST_F(SmallWidgets, TheGlyphIsLargeAndInTheMiddleAlsoDrawnFromStrokes) {
  GlyphView view;
  view.resize(200, 200);
  EXPECT_TRUE(box_of(picture_of(view), current_colours().ink).isNull());
  auto sheet = std::make_shared<practice::CharacterSheet>();
  sheet->character.code_point = U'田';
  view.show_character(sheet);
  EXPECT_EQ(view.accessibleName(), QStringLiteral("田"));
  auto drawn = std::make_shared<practice::CharacterSheet>();
  drawn->character.code_point = 0x10FFFD;  // in no font
  kanji::Stroke stroke;
  stroke.line.points = {{20, 20}, {89, 20}, {89, 89}};
  drawn->character.strokes = {stroke};
  view.show_character(drawn);
  const QRect box = box_of(picture_of(view), current_colours().ink);
  const auto pixel = [](double at) { return 200 * (0.08 + 0.84 * at / 109); };
  EXPECT_NEAR(box.left(), pixel(20), 6);
  EXPECT_NEAR(box.right(), pixel(89), 6);
  EXPECT_NEAR(box.top(), pixel(20), 6);
  EXPECT_NEAR(box.bottom(), pixel(89), 6);
  EXPECT_FALSE(is(picture_of(view), {pixel(55), pixel(55)}, current_colours().ink)) << "it is not filled";
  EXPECT_EQ(view.sizeHint().width(), view.sizeHint().height());
  view.show_character(nullptr);
  EXPECT_TRUE(view.accessibleName().isEmpty());
}

TEST_F(SmallWidgets, PiecesOfWritingStandInRowsWithTheirWords) {
  InkGallery gallery;
  EXPECT_EQ(gallery.heightForWidth(500), 0);
  study::HandwritingStroke stroke;
  for (int i = 0; i <= 20; ++i) stroke.push_back({{20 + 3.45 * i, 54.5}, i * 0.01, 0.5});
  const InkGallery::Piece piece{{stroke}, QStringLiteral("2 Mar 2026\nEasy")};
  gallery.show_pieces({piece, piece, piece});
  EXPECT_EQ(gallery.accessibleDescription(),
            QStringLiteral("2 Mar 2026\nEasy; 2 Mar 2026\nEasy; 2 Mar 2026\nEasy"));
  EXPECT_FALSE(gallery.isHidden());
  const int em = QFontInfo(gallery.font()).pixelSize();
  const int wide = em * 7 * 3;
  EXPECT_LT(gallery.heightForWidth(wide), 2 * wide / 3) << "all in one row";
  const int narrow = em * 7 * 2;
  EXPECT_GT(gallery.heightForWidth(narrow), narrow) << "two, and one below";
  EXPECT_EQ(gallery.heightForWidth(2 * em), gallery.heightForWidth(2 * em));
  gallery.resize(narrow, gallery.heightForWidth(narrow));
  const QImage picture = picture_of(gallery);
  const double side = (narrow - 8) / 2.0;
  const QColor ink = current_colours().ink;
  EXPECT_TRUE(is(picture, {side / 2, side / 2}, ink));
  EXPECT_TRUE(is(picture, {side + 8 + side / 2, side / 2}, ink));
  const double row = gallery.heightForWidth(narrow) / 2.0;
  EXPECT_TRUE(is(picture, {side / 2, row + side / 2}, ink)) << "the third begins the next row";
  EXPECT_FALSE(is(picture, {side * 0.1, side / 2}, ink)) << "before the stroke";
  gallery.show_pieces({});
  EXPECT_TRUE(gallery.isHidden());
}

TEST_F(SmallWidgets, AReportShowsTheFormInStarsAndSpeaksThem) {
  WritingReport report(nullptr);
  const auto label = [&report](const char* name) {
    return report.findChild<QLabel*>(QString::fromLatin1(name));
  };
  writing::Grade grade;
  grade.accepted = true;
  grade.form = 3;
  report.show_grade(grade, {});
  EXPECT_EQ(label("report_verdict")->text(), QStringLiteral("Correct. Form: ★★★☆☆"));
  EXPECT_EQ(label("report_verdict")->accessibleName(), QStringLiteral("Correct. Form: 3 of 5 stars"));
  EXPECT_FALSE(label("report_parts")->text().isEmpty());
  EXPECT_FALSE(label("report_parts")->isHidden());
  EXPECT_FALSE(label("report_faults")->text().isEmpty());
  EXPECT_TRUE(label("report_pen")->isHidden());
}

TEST_F(SmallWidgets, AReportOnARefusedWritingHasNoFigureThatLooksLikePraise) {
  WritingReport report(nullptr);
  writing::Grade grade;
  grade.score = 95;
  practice::PenReport pen;
  pen.motions = {writing::PenMotion{}};
  report.show_grade(grade, pen);
  auto* verdict = report.findChild<QLabel*>(QStringLiteral("report_verdict"));
  EXPECT_EQ(verdict->text(), QStringLiteral("Not quite"));
  EXPECT_EQ(verdict->accessibleName(), QStringLiteral("Not quite"));
  EXPECT_TRUE(report.findChild<QLabel*>(QStringLiteral("report_parts"))->isHidden());
  for (const auto* shown : report.findChildren<QLabel*>())
    EXPECT_TRUE(shown->isHidden() || !shown->text().contains(QStringLiteral("95")))
        << shown->text().toStdString();
}

}  // namespace
}  // namespace nazori::ui
