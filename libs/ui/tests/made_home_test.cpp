// SPDX-License-Identifier: Apache-2.0
// What stands where on Home, how its parts are made, and the picture of a week in its exact places.
#include <QScrollBar>

#include "chosen_session_under_test.h"
#include "described_widget.h"
#include "nazori/practice/day_record.h"
#include "picture_under_test.h"
#include "study/home.h"
#include "study/home_parts.h"
#include "study/home_view.h"
#include "study/period_picture.h"

namespace nazori::ui {
namespace {

using std::chrono::days;
using study::Rating;
using test::expect_laid_out;
using test::expect_made;

class MadeHome : public ChosenSessionTest {
 protected:
  MadeHome() {
    install_language(QStringLiteral("en"));
    test::use_plain_look();
  }
  static int em() { return QFontInfo(QApplication::font()).pixelSize(); }
  void add(char32_t character, Rating rating = Rating::good) {
    study::Writing writing;
    writing.rating = rating;
    writing.result.accepted = rating != Rating::again;
    writing.result.duration = std::chrono::seconds(20);
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing, ink()));
  }
  static study::Handwriting ink() { return {{{{10, 50}, 0.0, 1.0}, {{90, 50}, 0.5, 1.0}}}; }
};

class MadeHomeView : public MadeHome {
 protected:
  std::string laid_out(QSize size) {
    test::resize_unseen(*view_.viewport(), size);
    return test::layout_words(*view_.widget()).toStdString();
  }
  bool sees(const char* name) {
    view_.refresh();
    return !view_.findChild<QWidget*>(QString::fromLatin1(name))->isHidden();
  }
  QWidget window_;
  HomeActions actions_{&window_};
  HomeView view_{*learner_, *session_, actions_};
};

TEST_F(MadeHomeView, CardsAndColumnsHoldTheirPartsInTheirOrder) {
  expect_laid_out(
      view_,
      {{"around home_start",
        "column 0 0 0 0 gap 18: home_trouble, home_try_again, home_start, home_advice, QWidget, home_way, "
        "stretch*1"},
       {"around home_new",
        "column 0 0 0 0 gap 18: “New today”, home_new, home_ink_title, home_ink, “Needs care”, "
        "home_care_card, stretch*1"},
       {"around home_reviews",
        "flow 0 0 0 0 gap 9 9: home_reviews, home_more, home_ahead, home_brush, home_free_writing, "
        "home_settings"},
       {"home_way", "column 18 18 18 18 gap 18: “On the way”, QWidget"},
       {"home_ink", "column 18 18 18 18 gap 9: ink_row, home_ink_empty, home_written, QWidget"},
       {"around home_week", "flow 0 0 0 0 gap 9 9: home_all_ink, home_week, home_month"},
       {"home_care_card",
        "column 18 18 18 18 gap 9: home_care_characters, home_care, QWidget, home_leeches, "
        "QWidget"},
       {"around home_practise", "flow 0 0 0 0: home_practise"},
       {"around home_leech_lesson", "flow 0 0 0 0: home_leech_lesson"}});
  learn_from({U'一', U'二', U'三'});
  add(U'一');
  view_.refresh();
  expect_laid_out(view_, {{"home_new", "flow 0 0 0 0 gap 9 9: character_tile, character_tile"},
                          {"around ink_row",
                           "column 18 18 18 18 gap 9: ink_row, home_ink_empty, home_written, QWidget"}});
  const auto* bar = view_.findChild<MilestoneBar*>();
  ASSERT_NE(bar, nullptr);
  EXPECT_EQ(test::layout_words(*bar->parentWidget()).toStdString(),
            "column 0 0 0 0 gap 18: MilestoneBar, MilestoneBar");
}

TEST_F(MadeHomeView, EachPartIsMadeForWhatItIs) {
  laid_out({40 * em(), 900});
  const std::string label = "textFormat PlainText; wordWrap";
  const std::string sentence = "textFormat PlainText; textInteractionFlags TextSelectableByMouse; wordWrap";
  expect_made(
      view_,
      {{"home_page",
        "accessibleName Today; frameShape NoFrame; horizontalScrollBarPolicy ScrollBarAlwaysOff; "
        "widgetResizable"},
       {"home_day", ("alignment left; role muted; " + sentence).c_str()},
       {"home_trouble", ("role trouble; " + sentence).c_str()},
       {"home_try_again", "autoDefault; text Try again"},
       {"home_start", "autoDefault; sizePolicy Expanding Minimum with height; toolTip Enter or Space: start"},
       {"home_more",
        "accessibleName Five more new characters; autoDefault; text Five more new characters  F; "
        "toolTip Learn five more new characters today, beyond your daily goal (F)"},
       {"home_ahead",
        "accessibleName Review ahead; autoDefault; text Review ahead  A; toolTip Review the next characters "
        "before they are due, twenty at most (A)"},
       {"home_advice", ("focusPolicy TabFocus; " + sentence).c_str()},
       {"home_ink_empty",
        ("role muted; text What you write from memory will appear here, in your own hand.; " + label)
            .c_str()},
       {"home_written", ("role muted; " + sentence).c_str()},
       {"home_all_ink",
        "autoDefault; role link; text See all; toolTip Show everything you wrote on the last day, or one row "
        "of "
        "it (I)"},
       {"home_week",
        "autoDefault; role link; text Picture of the week…; toolTip Save what you wrote this week as a "
        "picture "
        "(PNG) (W)"},
       {"home_way", "role card"},
       {"home_ink", "role card"},
       {"home_care_card", "role card"},
       {"ink_row", "sizePolicy Expanding Preferred with height"},
       {"home_leech_lesson",
        "autoDefault; role link; text Relearn these; toolTip Relearn characters you forgot too often, "
        "starting "
        "with Watch (Ctrl+Shift+Return)"}});
  actions_.more->setShortcut(QKeySequence(Qt::Key_Z));
  EXPECT_EQ(view_.findChild<QPushButton*>(QStringLiteral("home_more"))->text(),
            QStringLiteral("Five more new characters  Z"));
  actions_.more->setShortcut({});
  EXPECT_EQ(view_.findChild<QPushButton*>(QStringLiteral("home_more"))->text(),
            QStringLiteral("Five more new characters"));
}

TEST_F(MadeHomeView, MarginsGrowBeyond88LettersAndColumnsBecomeOneBelow48) {
  const std::string two =
      "(grid gap 18 4: home_greeting 0/0, home_day 0/1, columns 3 4), "
      "(grid gap 36 18: QWidget 0/0, QWidget 0/1, columns 3 4), stretch*1";
  const std::string one =
      "(grid gap 18 4: home_greeting 0/0, home_day 1/0, columns 3 0), "
      "(grid gap 36 18: QWidget 0/0, QWidget 1/0, columns 3 0), stretch*1";
  const int high = 18 * em();
  EXPECT_EQ(laid_out({48 * em() + 56, high}), "column 28 28 28 28 gap 24: " + two);
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("home_day"))->alignment(),
            Qt::AlignRight | Qt::AlignBottom);
  EXPECT_EQ(laid_out({48 * em() + 55, high}), "column 28 28 28 28 gap 24: " + one);
  EXPECT_EQ(view_.findChild<QLabel*>(QStringLiteral("home_day"))->alignment(), Qt::AlignLeft);
  EXPECT_EQ(laid_out({88 * em() + 200, high}), "column 100 28 100 28 gap 24: " + two);
  expect_made(view_, {{"home_greeting", "letters 1.7; textFormat PlainText; wordWrap"}});
  EXPECT_EQ(laid_out({48 * em() + 56, high - 1}), "column 28 9 28 28 gap 9: " + two)
      << "a low page leaves its room to the button";
  expect_made(view_, {{"home_greeting", "letters 1.2; textFormat PlainText; wordWrap"}});
}

TEST_F(MadeHomeView, OneDayOffAWeekIsExplainedWhereThereIsARow) {
  const auto tip = [this] {
    view_.refresh();
    return view_.findChild<QLabel*>(QStringLiteral("home_day"))->toolTip().toStdString();
  };
  EXPECT_EQ(tip(), "");
  add(U'一');
  EXPECT_EQ(tip(), "One day off a week is fine.");
  now_ += days(2);
  add(U'二');
  EXPECT_EQ(tip(), "One day off a week is fine; this week's is used.");
}

TEST_F(MadeHomeView, MoreIsOfferedOnlyWhereTheDayIsDone) {
  learn_from({U'一', U'二', U'三'});
  EXPECT_TRUE(sees("home_start"));
  for (const char* name : {"home_more", "home_ahead", "home_reviews", "home_brush"})
    EXPECT_FALSE(sees(name)) << name;
  add(U'一', Rating::easy);
  add(U'二', Rating::easy);
  EXPECT_TRUE(sees("home_more"));
  EXPECT_TRUE(sees("home_ahead"));
  now_ += days(10);
  EXPECT_TRUE(sees("home_reviews")) << "two reviews and a new one";
  ASSERT_TRUE(session_->start());
  EXPECT_FALSE(sees("home_reviews")) << "a session runs";
  EXPECT_FALSE(sees("home_more"));
  session_->end();
  learn_from({U'一', U'二'});
  EXPECT_FALSE(sees("home_reviews")) << "nothing else is due";
  EXPECT_TRUE(sees("home_start"));
}

TEST_F(MadeHomeView, OfManyNewCharactersTenAreShownAndOfManyHardOnesThree) {
  std::vector<char32_t> many;
  for (const char32_t one : std::u32string_view(U"一二三四五六七八九十百千")) many.push_back(one);
  learn_from(many);
  auto settings = learner_->store().settings();
  settings.new_per_day = 12;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  view_.refresh();
  const auto tiles = [this](const char* box) {
    QString all;
    for (const auto* tile :
         view_.findChild<QWidget*>(QString::fromLatin1(box))->findChildren<CharacterTile*>())
      if (!tile->isHidden()) all += tile->text();
    return all.toStdString();
  };
  EXPECT_EQ(tiles("home_new"), "一二三四五六七八九十");
  for (std::size_t i = 0; i < 4; ++i) add(many[i], Rating::again);
  view_.refresh();
  EXPECT_EQ(tiles("home_care_characters"), "一二三");
  EXPECT_EQ(view_.hard(), std::vector<char32_t>(many.begin(), many.begin() + 3));
  for (std::size_t i = 4; i < 11; ++i) add(many[i]);
  view_.refresh();
  EXPECT_EQ(tiles("home_new"), "一二三四五六七八九十") << "eleven were begun";
}

TEST_F(MadeHomeView, ACharacterThatNeedsCareHasASmallTileWithoutItsMeaning) {
  learn_from({U'休'});
  add(U'休', Rating::again);
  view_.refresh();
  const auto* first = view_.findChild<QWidget*>(QStringLiteral("home_new"))->findChild<CharacterTile*>();
  const auto* care =
      view_.findChild<QWidget*>(QStringLiteral("home_care_characters"))->findChild<CharacterTile*>();
  EXPECT_EQ(care->accessibleName(), QStringLiteral("休"));
  const CharacterTile small(U'休', {}, 0.55);
  EXPECT_EQ(care->sizeHint(), small.sizeHint());
  EXPECT_GT(first->sizeHint().width(), care->sizeHint().width());
  expect_made(*care,
              {{"character_tile", "accessibleName 休; autoDefault; text 休; toolTip Show 休 and its words"}});
}

class PictureOfAPeriod : public MadeHome {
 protected:
  QImage draw(const practice::DaySpan& span) {
    const auto picture = PeriodPicture::draw(learner_->store(), span);
    EXPECT_TRUE(picture);
    return picture.value_or(QImage());
  }
  practice::DaySpan week() const { return practice::week_of(learner_->store().today()); }
  const Colours& c_ = light_colours();
};

TEST_F(PictureOfAPeriod, ACharacterStandsInATileOf150InTheMiddleBelowTheFigures) {
  add(U'一');
  const QImage all = draw(week());
  // A margin of 70, a title of 46 and figures of 24, each with as much room again; below 24 and its margin.
  constexpr int kTop = 70 + 2 * 46 + 2 * 24;
  ASSERT_EQ(all.size(), QSize(1200, kTop + 150 + 2 * 24 + 70));
  constexpr int kLeft = (1200 - 7 * 150) / 2;  // seven beside each other
  const auto at = [&](int x, int y) { return all.pixelColor(kLeft + x, kTop + y); };
  EXPECT_EQ(at(2, 75), c_.paper);
  EXPECT_EQ(at(6, 75), c_.surface) << "the frame is 4 from the edge";
  EXPECT_EQ(at(144, 75), c_.surface);
  EXPECT_EQ(at(148, 75), c_.paper);
  EXPECT_EQ(at(75, 2), c_.paper);
  EXPECT_EQ(at(75, 6), c_.surface);
  EXPECT_EQ(at(75, 148), c_.paper);
  EXPECT_EQ(at(5, 5), c_.paper) << "its corners are round";
  // A level stroke from 10 to 90 of the 109 units, at 50, in a box that is 12 smaller on each side.
  const double unit = 126.0 / 109;
  const QRect stroke = test::box_of(all, c_.ink, {kLeft, kTop, 150, 150});
  EXPECT_NEAR(stroke.left(), kLeft + 12 + 10 * unit, 4);
  EXPECT_NEAR(stroke.right(), kLeft + 12 + 90 * unit, 4);
  EXPECT_NEAR(stroke.center().y(), kTop + 12 + 50 * unit, 1.01);
  EXPECT_NEAR(stroke.height(), 0.045 * 126, 2.01);
  const QRect title = test::box_of(all, c_.ink, {0, 0, 1200, kTop});
  EXPECT_GE(title.left(), 70);
  EXPECT_LT(title.left(), 78);
  EXPECT_GT(title.top(), 70);
  EXPECT_LT(title.bottom(), 70 + 46 * 3 / 2);
  const QRect figures = test::box_of(all, c_.muted, {0, 140, 1200, kTop - 140});
  EXPECT_GE(figures.left(), 70);
  EXPECT_LT(figures.left(), 76);
  EXPECT_GT(figures.top(), 70 + 46 * 3 / 2 + 12);
  EXPECT_LT(figures.bottom(), 70 + 46 * 3 / 2 + 12 + 24 * 3 / 2);
  const QRect name = test::box_of(all, c_.muted, {0, kTop + 150, 1200, 118});
  EXPECT_GT(name.right(), 1120);
  EXPECT_LE(name.right(), 1130);
  EXPECT_GT(name.top(), kTop + 150 + 24);
  EXPECT_LT(name.bottom(), kTop + 150 + 24 + 24 * 3 / 2);
}

TEST_F(PictureOfAPeriod, TilesAreSmallerTheMoreThereAre) {
  // Seven in a row and six rows of 150 are 900 high. One more: eight in a row and six rows of 130.
  std::u32string all;
  for (const auto& one :
       learner_->lists()->members("grade-1", learner_->store()).value_or(std::vector<char32_t>()))
    if (all.size() < 43) all += one;
  ASSERT_EQ(all.size(), 43U);
  for (std::size_t i = 0; i < 42; ++i) add(all[i]);
  EXPECT_EQ(draw(week()).height(), 210 + 6 * 150 + 118);
  add(all[42]);
  const QImage more = draw(week());
  EXPECT_EQ(more.height(), 210 + 6 * 130 + 118);
  constexpr int kLeft = (1200 - 8 * 130) / 2;
  const auto tile = [&](int column, int row) {
    return more.pixelColor(kLeft + column * 130 + 65, 210 + row * 130 + 115) == c_.surface;
  };
  EXPECT_TRUE(tile(0, 0) && tile(7, 0) && tile(0, 5) && tile(2, 5));
  EXPECT_FALSE(tile(3, 5)) << "43 are five rows of eight, and three";
}

TEST_F(PictureOfAPeriod, OfAMonthItHasWhatWasWrittenInItAndAFileOfItsName) {
  add(U'一');
  now_ += days(8);
  const auto month = practice::month_of(learner_->store().today());
  EXPECT_TRUE(draw(week()).isNull()) << "it was the week before";
  EXPECT_FALSE(draw(month).isNull());
  EXPECT_EQ(PeriodPicture::file_name(month), QStringLiteral("nazori-2026-03.png"));
  EXPECT_EQ(PeriodPicture::file_name(week()), QStringLiteral("nazori-2026-03-09.png"));
}

}  // namespace
}  // namespace nazori::ui
