// SPDX-License-Identifier: Apache-2.0
// What the page for progress draws, shape by shape: in its exact place, in its colour.
#include <QFontInfo>
#include <QListWidget>
#include <QTest>

#include "painted_page.h"
#include "progress/hard_strokes_card.h"
#include "progress/strength_grid.h"
#include "progress/year_view.h"
#include "session_under_test.h"

namespace nazori::ui {
namespace {

using study::Strength;
using test::box_words;
using test::Drawing;
using test::Drawn;
using test::drawn_by;
using test::in_words;
using test::words;

class PaintedProgress : public test::PaintedPage {
 protected:
  const Colours& c_ = current_colours();
};

TEST_F(PaintedProgress, ATileOfTheGridHasItsLookItsCharacterAndItsSign) {
  for (const auto strength : {Strength::unseen, Strength::learning, Strength::young, Strength::mature,
                              Strength::leech, Strength::paused}) {
    StrengthModel model;
    model.set_states({{U'口', strength, 0.9}});
    const StrengthDelegate delegate;
    const auto drawn = [&](QStyle::State state) {
      return drawn_by(QSize(120, 120), [&](QPainter& painter) {
        delegate.paint(&painter, option(QRect(10, 10, 100, 100), state), model.index(0));
      });
    };
    const auto look = look_of(strength, c_);
    const QRectF frame(12, 12, 96, 96);
    const Drawing plain = drawn(QStyle::State_None);
    EXPECT_EQ(in_words(plain.boxes()),
              QStringList{box_words(frame, 5, look.dashed ? words("line 1 dashed") : words("line 1"),
                                    test::name_of(look.fill))});
    EXPECT_EQ(in_words(drawn(QStyle::State_HasFocus).boxes()),
              QStringList{box_words(frame, 5, words("ink 3"), test::name_of(look.fill))});
    const Drawn glyph = plain.words(words("口"));
    EXPECT_EQ(glyph.font.pixelSize(), 57) << "0.6 of the tile";
    EXPECT_NEAR(glyph.box.center().x(), 12 + 96 * 0.88 / 2, 1.01) << "beside the sign";
    EXPECT_NEAR(glyph.box.center().y(), 12 + 96 * 1.08 / 2, 1.51) << "and below it";
    EXPECT_EQ(glyph.pen.color(), look.text);
    ASSERT_EQ(plain.words().size(), look.sign.isEmpty() ? 1U : 2U);
    if (look.sign.isEmpty()) continue;
    const Drawn sign = plain.words(look.sign);
    EXPECT_EQ(sign.font.pixelSize(), 25) << "0.27 of the tile";
    EXPECT_TRUE(sign.font.bold());
    EXPECT_NEAR(sign.box.right(), 105, 1.01);
    EXPECT_NEAR(sign.box.top(), 12, 1.01);
  }
}

TEST_F(PaintedProgress, ATinyTileOfTheGridStillHasLettersThatCanBeRead) {
  StrengthModel model;
  model.set_states({{U'口', Strength::mature, 0.9}});
  const StrengthDelegate delegate;
  const Drawing drawn = drawn_by(QSize(20, 20), [&](QPainter& painter) {
    delegate.paint(&painter, option(QRect(0, 0, 16, 16), {}), model.index(0));
  });
  EXPECT_EQ(drawn.words(words("口")).font.pixelSize(), 8);
  EXPECT_EQ(drawn.words(words("●")).font.pixelSize(), 7);
  EXPECT_EQ(delegate.sizeHint(option({}, {}), model.index(0)), QSize(30, 30)) << "two and a half letters";
}

class PaintedYear : public PaintedProgress {
 protected:
  /// 2026, studied on its first days; today is 2 March. 1 January is a Thursday.
  PaintedYear() {
    const auto day = [](unsigned month, unsigned number) {
      return study::Day(std::chrono::year(2026) / std::chrono::month(month) / std::chrono::day(number));
    };
    statistics_.today = day(3, 2);
    int number = 0;
    for (const int times : {0, 1, 10, 30, 60}) {
      ++number;
      if (times > 0)
        statistics_.days.push_back(
            {day(1, static_cast<unsigned>(number)), times, 0, 0, std::chrono::minutes(1)});
    }
    font_.setPixelSize(12);
    year_.setFont(font_);
    year_.show_year(practice::year_calendar(statistics_, 2026));
    year_.resize(540, year_.heightForWidth(540));  // squares of 10
  }
  /// The square in a column and a row, counted from 0.
  QRectF square(int column, int row) const { return {column * 10.0, months() + row * 10.0, 8.8, 8.8}; }
  double months() const { return QFontMetrics(font_).lineSpacing() + 4; }
  study::Statistics statistics_;
  YearView year_;
};

TEST_F(PaintedYear, EachDayIsASquareInItsWeekAsStrongAsItsLevel) {
  const auto boxes = in_words(drawn_by(year_).boxes());
  ASSERT_EQ(boxes.size(), 365 + 1 + 5) << "the days, the frame of today, the levels";
  const double shares[] = {0.28, 0.52, 0.76, 1.0};
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(boxes[1 + i], box_words(i < 3 ? square(0, 4 + i) : square(1, 0), 2, words("none"),
                                      test::name_of(blend(c_.surface, c_.indigo, shares[i]))))
        << "from Friday on";
  const QString none = test::name_of(blend(c_.surface, c_.line, 0.6));
  EXPECT_EQ(boxes[0], box_words(square(0, 3), 2, words("none"), none));
  EXPECT_EQ(boxes[60], box_words(square(9, 0), 2, words("none"), none)) << "2 March is a Monday";
  EXPECT_EQ(boxes[61], box_words(square(9, 0).adjusted(1, 1, -1, -1), 2, words("ink 2"), words("none")));
  EXPECT_EQ(boxes[62],
            box_words(square(9, 1).adjusted(0.5, 0.5, -0.5, -0.5), 2, words("line 1"), words("none")));
  EXPECT_EQ(year_.heightForWidth(540), 2 * static_cast<int>(months()) + 6 + 70);
  EXPECT_EQ(year_.heightForWidth(100), 2 * static_cast<int>(months()) + 6 + 42) << "squares of 6 at least";
  EXPECT_EQ(year_.heightForWidth(9000), 2 * static_cast<int>(months()) + 6 + 210) << "of 30 at most";
  EXPECT_EQ(year_.sizeHint(), QSize(324, year_.heightForWidth(540)));
}

TEST_F(PaintedYear, TheMonthsStandAboveAndTheLevelsBelow) {
  const Drawing all = drawn_by(year_);
  const QFontMetrics metrics(font_);
  const int columns[] = {0, 4, 8, 13, 17, 22, 26, 30, 35, 39, 43, 48};
  for (int month = 0; month < 12; ++month) {
    const Drawn name = all.words(QLocale().standaloneMonthName(month + 1, QLocale::ShortFormat));
    EXPECT_NEAR(name.box.left(), columns[month] * 10, 0.01) << month;
    EXPECT_NEAR(name.baseline, metrics.ascent(), 0.51);
    EXPECT_EQ(test::name_of(name.pen.color()), words("muted"));
  }
  const auto boxes = all.boxes();
  const double side = metrics.ascent() * 0.8;
  const double top = months() + 70 + 6;
  double x = 0;
  const char* const names[] = {"none", "1 to 9", "10 to 29", "30 to 59", "60 or more"};
  for (int i = 0; i < 5; ++i) {
    const Drawn& box = boxes[static_cast<std::size_t>(366 + i)];
    EXPECT_NEAR(box.box.left(), x, 0.01) << names[i];
    EXPECT_NEAR(box.box.top(), top + metrics.ascent() * 0.2, 0.01);
    EXPECT_NEAR(box.box.width(), side, 0.01);
    EXPECT_NEAR(box.box.height(), side, 0.01);
    EXPECT_NEAR(box.corner, 2, 0.01);
    const Drawn name = all.words(words(names[i]));
    EXPECT_NEAR(name.box.left(), x + side + 5, 0.05);
    EXPECT_NEAR(name.baseline, top + metrics.ascent(), 0.51);
    x += side + 5 + metrics.horizontalAdvance(words(names[i])) + 2 * metrics.averageCharWidth();
  }
  EXPECT_EQ(boxes[370].fill.color(), c_.indigo);
  // In little room some months have no name, and levels at the end are left out.
  year_.resize(100, year_.heightForWidth(100));
  const Drawing small = drawn_by(year_);
  double free_from = -1;
  for (const Drawn& one : small.words())
    if (one.baseline < months()) {
      EXPECT_GT(one.box.left(), free_from);
      EXPECT_LE(one.box.right(), 100.01);
      free_from = one.box.right();
    }
  EXPECT_LT(small.boxes().size(), 371U);
}

TEST_F(PaintedYear, TheDayAtHandHasAFrameWhileTheCalendarHasTheKeyboard) {
  year_.set_day(2);
  EXPECT_EQ(drawn_by(year_).boxes().size(), 371U);
  year_.show();
  year_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&year_));
  year_.setFocus();
  const auto boxes = in_words(drawn_by(year_).boxes());
  ASSERT_EQ(boxes.size(), 372);
  EXPECT_EQ(boxes[366],
            box_words(square(0, 5).adjusted(-1.5, -1.5, 1.5, 1.5), 3, words("indigo 2"), words("none")));
}

TEST_F(PaintedYear, ThePointerGoesToTheDayUnderIt) {
  const auto click = [this](double x, double y) {
    QTest::mouseClick(&year_, Qt::LeftButton, {}, QPointF(x, months() + y).toPoint());
    return year_.day();
  };
  EXPECT_EQ(click(95, 5), 59 + 1) << "2 March";
  EXPECT_EQ(click(5, 35), 0);
  EXPECT_EQ(click(5, 25), 0) << "before the year: nothing changes";
  EXPECT_EQ(click(15, 65), 10);
  EXPECT_EQ(click(15, 71), 10) << "below the last row";
  EXPECT_EQ(click(15, -2), 10) << "above the first";
  EXPECT_EQ(click(525, 35), 364);
  EXPECT_EQ(click(525, 45), 364) << "after the year";
  QTest::keyClick(&year_, Qt::Key_Right);
  EXPECT_EQ(year_.day(), 364);
  QTest::keyClick(&year_, Qt::Key_Left);
  EXPECT_EQ(year_.day(), 357);
  QTest::keyClick(&year_, Qt::Key_Up);
  EXPECT_EQ(year_.day(), 356);
  QTest::keyClick(&year_, Qt::Key_Down);
  EXPECT_EQ(year_.day(), 357);
  QTest::keyClick(&year_, Qt::Key_Home);
  EXPECT_EQ(year_.day(), 0);
  QTest::keyClick(&year_, Qt::Key_End);
  EXPECT_EQ(year_.day(), 364);
}

class PaintedHardStroke : public SessionTest {};

TEST_F(PaintedHardStroke, IsThickInThePictureOfItsCharacterBesideTheSentence) {
  install_language(QStringLiteral("en"));
  HardStrokesCard card;
  study::Statistics statistics;
  statistics.hard_strokes = {{U'二', 1, 4, 9, {{kanji::MistakeKind::wrong, 4}}}};
  card.show_strokes(statistics, learner_->database());
  auto* list = card.findChild<QListWidget*>();
  QStyleOptionViewItem option;
  option.font = list->font();
  option.font.setPixelSize(12);
  option.fontMetrics = QFontMetrics(option.font);
  option.widget = list;
  option.rect = QRect(0, 0, 600, 100);
  const auto drawn = [&](QStyle::State state) {
    option.state = state;
    return drawn_by(QSize(600, 100), [&](QPainter& painter) {
      list->itemDelegate()->paint(&painter, option, list->model()->index(0, 0));
    });
  };
  const Drawing plain = drawn(QStyle::State_None);
  std::vector<Drawn> drawn_strokes;
  for (const Drawn& one : plain.all)
    if (one.kind == Drawn::Kind::shape && one.corner == 0) drawn_strokes.push_back(one);
  ASSERT_EQ(drawn_strokes.size(), 2U);
  const QString frame = box_words({5.5, 5.5, 47, 47}, 6, words("line 1"), words("surface"));
  EXPECT_EQ(in_words(plain.boxes()[0]), frame) << "four letters";
  const double unit = 48 * 0.88 / 109;
  const auto strokes = learner_->database()->find(U'二')->strokes;
  for (std::size_t i = 0; i < 2; ++i) {
    const Drawn stroke = drawn_strokes[i];
    const auto& points = strokes[i].line.points;
    EXPECT_NEAR(stroke.points.front().x(), 5 + 48 * 0.06 + points.front().x * unit, 0.01);
    EXPECT_NEAR(stroke.points.front().y(), 5 + 48 * 0.06 + points.front().y * unit, 0.01);
    EXPECT_NEAR(stroke.points.back().x(), 5 + 48 * 0.06 + points.back().x * unit, 0.01);
    EXPECT_NEAR(stroke.pen.widthF(), (i == 1 ? 8 : 3.5) * unit, 0.01);
    EXPECT_EQ(test::name_of(stroke.pen.color()), words(i == 1 ? "vermilion" : "muted"));
  }
  const Drawn sentence = plain.words(words("Stroke 2"));
  EXPECT_NEAR(sentence.box.left(), 5 + 48 + 10, 1.01);
  EXPECT_NEAR(sentence.box.center().y(), 50, 1.51);
  EXPECT_EQ(test::name_of(sentence.pen.color()), words("ink"));
  const auto focused = drawn(QStyle::State_HasFocus).boxes();
  ASSERT_EQ(focused.size(), plain.boxes().size() + 1);
  EXPECT_EQ(in_words(focused[0]), box_words({1, 1, 598, 98}, 6, words("indigo 2"), words("none")));
  const QSize one_line = list->itemDelegate()->sizeHint(option, list->model()->index(0, 0));
  EXPECT_EQ(one_line, QSize(48, 58));
  option.rect.setWidth(48 + 30 + 50);
  EXPECT_EQ(list->itemDelegate()->sizeHint(option, list->model()->index(0, 0)).height(),
            std::max(48, QFontMetrics(option.font)
                             .boundingRect(0, 0, 50, 9999, Qt::TextWordWrap, list->item(0)->text())
                             .height()) +
                10);
}

}  // namespace
}  // namespace nazori::ui
