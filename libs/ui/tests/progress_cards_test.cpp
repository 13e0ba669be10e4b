// SPDX-License-Identifier: Apache-2.0
// The cards of the page of progress, and the page, without a window around them.
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QProgressBar>
#include <QScrollArea>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "nazori/practice/study_charts.h"
#include "nazori/widgets/charts/day_chart.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/controls/list_choice.h"
#include "progress/characters_card.h"
#include "progress/hard_strokes_card.h"
#include "progress/progress_view.h"
#include "progress/strength_grid.h"
#include "progress/year_view.h"
#include "session_under_test.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using std::chrono::days;
using study::Strength;

class ProgressCards : public SessionTest {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }
  static QString text(const QWidget& in, const char* name) {
    return in.findChild<QLabel*>(QString::fromLatin1(name))->text();
  }
  static QWidget* shown(const QWidget& card) {
    return card.findChild<QStackedWidget*>(QString(), Qt::FindDirectChildrenOnly)->currentWidget();
  }
  study::Statistics statistics() const {
    study::Statistics s;
    s.today = learner_->store().today();
    for (int i = 0; i < study::kForecastDays; ++i) s.forecast.push_back({s.today + days(i), 1});
    s.days = {{s.today - days(100), 4, 0, 0, std::chrono::minutes(1)},
              {s.today - days(40), 4, 0, 0, std::chrono::minutes(1)},
              {s.today - days(20), 4, 0, 0, std::chrono::minutes(1)},
              {s.today, 7, 0, 1, std::chrono::minutes(3)}};
    s.motion = {{s.today, 7, 218, -1.75}};
    s.retention_days = {{s.today, {5, 4, 0.89}}};
    s.characters = {{U'一', Strength::mature, 0.95},
                    {U'二', Strength::young, 0.9},
                    {U'三', Strength::learning, 0.8},
                    {U'四', Strength::young, 0.7}};
    s.hard_strokes = {{U'休', 2, 4, 9, {{kanji::MistakeKind::wrong, 4}}},
                      {U'人', 0, 2, 5, {{kanji::MistakeKind::order, 2}}}};
    s.streak = {3, 12, true, false};
    s.reviews = 1234;
    s.time = std::chrono::minutes(75);
    s.last_30_days = {20, 18, 0.88};
    return s;
  }
};

TEST_F(ProgressCards, TheKeyboardStaysOnWhatTakesThePlaceOfTheChart) {
  QWidget window;
  ChartCard card(QStringLiteral("x"), &window);
  const auto chart = practice::build_chart(practice::ChartId::forecast, statistics());
  card.show_chart(chart, StudyCharts::text(chart));
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  card.focus_content();
  EXPECT_TRUE(shown(card)->hasFocus());
  card.set_shows_numbers(true);
  auto* table = qobject_cast<QTableWidget*>(shown(card));
  EXPECT_TRUE(table->hasFocus());
  EXPECT_EQ(table->currentRow(), 0);
  table->setCurrentCell(3, 1);
  card.focus_content();
  EXPECT_EQ(table->currentRow(), 3) << "where the reader was";
  table->clearFocus();
  card.set_shows_numbers(false);
  EXPECT_FALSE(shown(card)->hasFocus());
}

TEST_F(ProgressCards, CharactersAreCountedByStrengthTheFirmestFirst) {
  CharactersCard card;
  auto s = statistics();
  s.characters.push_back({U'五', Strength::paused, 0.5});
  s.characters.push_back({U'六', Strength::leech, 0.5});
  card.show_characters(s, learner_->lists(), learner_->store());
  EXPECT_EQ(
      text(card, "characters_summary"),
      QStringLiteral(
          "● well known 1  ·  ◑ recently learned 2  ·  ◔ learning 1  ·  ! difficult 1  ·  ‖ suspended 1"));
  EXPECT_EQ(card.shown().numbers.rows.size(), 6);
  EXPECT_EQ(card.shown().numbers.rows[1],
            (QStringList{QStringLiteral("二"), QStringLiteral("recently learned"), QStringLiteral("90%")}));
  EXPECT_EQ(card.grid().states().rowCount(), 6);
  EXPECT_EQ(card.grid().accessibleName(), QStringLiteral("Characters by strength"));
  EXPECT_TRUE(card.grid().accessibleDescription().endsWith(QStringLiteral("Enter: open a character.")));
  auto* list = card.findChild<ListChoice*>();
  const QSignalSpy changed(&card, &CharactersCard::list_changed);
  list->setCurrentIndex(list->findData(QStringLiteral("grade-1")));
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(card.list(), QStringLiteral("grade-1"));
  card.show_characters(s, learner_->lists(), learner_->store());
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(card.grid().states().rowCount(), 80);
  EXPECT_TRUE(text(card, "characters_summary").endsWith(QStringLiteral("not studied 74")))
      << text(card, "characters_summary").toStdString();
  const auto& rows = card.shown().numbers.rows;
  EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const QStringList& row) {
    return row == QStringList{QStringLiteral("休"), QStringLiteral("not studied"), QStringLiteral("–")};
  }));
  card.show_characters(s, nullptr, learner_->store());
  EXPECT_TRUE(text(card, "characters_empty").startsWith(QStringLiteral("The list cannot be read: ")));
  card.set_list({});
  card.show_characters({}, learner_->lists(), learner_->store());
  EXPECT_TRUE(
      text(card, "characters_empty").startsWith(QStringLiteral("Characters you have studied appear here")));
}

TEST_F(ProgressCards, TheGridKeepsItsPlaceAndOpensWhatIsActivated) {
  StrengthGrid grid;
  QSignalSpy walked(&grid, &StrengthGrid::walked);
  QSignalSpy opened(&grid, &StrengthGrid::opened);
  grid.show_states(statistics().characters);
  EXPECT_EQ(grid.currentIndex().row(), 0);
  EXPECT_EQ(walked.last().at(0).toString(), QStringLiteral("一, well known, 95% likely to be remembered"));
  grid.setCurrentIndex(grid.model()->index(2, 0));
  auto others = statistics().characters;
  others.erase(others.begin());
  grid.show_states(others);
  EXPECT_EQ(grid.currentIndex().row(), 1) << "三 again";
  emit grid.activated(grid.currentIndex());
  EXPECT_EQ(opened.at(0).at(0).value<char32_t>(), U'三');
  EXPECT_EQ(StrengthDelegate::tile_side(grid.font()), QFontInfo(grid.font()).pixelSize() * 5 / 2);
}

TEST_F(ProgressCards, AHardStrokeIsSaidAndItsCharacterOpens) {
  HardStrokesCard card;
  card.show_strokes(statistics(), learner_->database());
  auto* list = card.findChild<QListWidget*>(QStringLiteral("hard_strokes_chart"));
  ASSERT_EQ(list->count(), 2);
  EXPECT_EQ(list->item(0)->text(),
            QStringLiteral("Stroke 3 had the wrong shape or position in 4 of 9 writings."));
  EXPECT_EQ(list->item(1)->data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("人: Stroke 1 was out of order in 2 of 5 writings."));
  EXPECT_EQ(text(card, "hard_strokes_summary"),
            QStringLiteral("Strokes that were wrong more than once: 2. Enter: open the character."));
  EXPECT_EQ(list->currentRow(), 0);
  EXPECT_EQ(list->accessibleName(), QStringLiteral("Hardest strokes"));
  QSignalSpy opened(&card, &HardStrokesCard::opened);
  emit list->itemActivated(list->item(1));
  EXPECT_EQ(opened.at(0).at(0).value<char32_t>(), U'人');
  card.show_strokes({}, nullptr);
  EXPECT_EQ(list->count(), 0);
  EXPECT_TRUE(card.shown().summary.isEmpty());
}

TEST_F(ProgressCards, OfAHardCharacterTheStrokeIsMarkedInItsPlace) {
  HardStrokesCard card;
  auto s = statistics();
  s.hard_strokes = {{U'二', 1, 4, 9, {}}};
  card.show_strokes(s, learner_->database());
  auto* list = card.findChild<QListWidget*>();
  QStyleOptionViewItem option;
  option.font = list->font();
  option.fontMetrics = list->fontMetrics();
  option.widget = list;
  option.rect = QRect(0, 0, 600, 200);
  const int side = list->itemDelegate()->sizeHint(option, list->model()->index(0, 0)).width();
  EXPECT_GE(list->itemDelegate()->sizeHint(option, list->model()->index(0, 0)).height(), side);
  QImage picture(600, 200, QImage::Format_ARGB32);
  picture.fill(current_colours().surface);
  {
    QPainter painter(&picture);
    list->itemDelegate()->paint(&painter, option, list->model()->index(0, 0));
  }
  const auto is = [](QRgb pixel, const QColor& colour) {
    return std::abs(qRed(pixel) - colour.red()) + std::abs(qGreen(pixel) - colour.green()) +
               std::abs(qBlue(pixel) - colour.blue()) <
           12;
  };
  int marked_top = 1000, marked_bottom = -1, other_bottom = -1;
  for (int y = 0; y < 200; ++y)
    for (int x = 6; x < side; ++x) {
      if (is(picture.pixel(x, y), current_colours().vermilion))
        marked_top = std::min(marked_top, y), marked_bottom = y;
      if (is(picture.pixel(x, y), current_colours().muted)) other_bottom = y;
    }
  ASSERT_GE(marked_bottom, 0);
  ASSERT_GE(other_bottom, 0);
  EXPECT_LT(other_bottom, marked_top) << "the lower stroke is the hard one";
  EXPECT_GT(marked_bottom, side / 2);
  EXPECT_LT(marked_bottom, side + 6);
}

class ProgressPageTest : public ProgressCards {
 protected:
  ProgressPageTest() : view_(*learner_) { view_.resize(1600, 900); }
  void show(const study::Statistics& s) {
    view_.show_statistics(std::make_shared<const study::Statistics>(s));
  }
  QStringList figures() const { return text(view_, "progress_figures").split(QLatin1Char('\n')); }
  ProgressView view_;
};

TEST_F(ProgressPageTest, TheFiguresSayWhatStudyBrought) {
  auto s = statistics();
  show(s);
  EXPECT_EQ(figures(),
            (QStringList{QStringLiteral("Days in a row: 3, longest 12"),
                         QStringLiteral("Reviews: 1,234 in 1 h 15 min"),
                         QStringLiteral("Recall in the last 30 days: 90% of 20 reviews (predicted: 88%)"),
                         QStringLiteral("Characters: 4 studied, 3 learned")}));
  s.streak.today_done = false;
  s.streak.day_off_used = true;
  s.last_30_days.reviews = 0;
  show(s);
  EXPECT_EQ(figures().size(), 3);
  EXPECT_EQ(figures()[0], QStringLiteral("Days in a row: 3, longest 12; not yet today"));
  s.last_30_days = {1, 1, 0.5};
  show(s);
  EXPECT_EQ(figures().value(2),
            QStringLiteral("Recall in the last 30 days: 100% of 1 reviews (predicted: 50%)"));
  s.last_30_days.reviews = 0;
  s.streak.today_done = true;
  show(s);
  EXPECT_EQ(figures()[0], QStringLiteral("Days in a row: 3, longest 12; day off used this week"));
  s.streak.days = 0;
  show(s);
  EXPECT_EQ(figures()[0], QStringLiteral("Days in a row: 0, longest 12"));
  s.characters.clear();
  show(s);
  EXPECT_TRUE(text(view_, "progress_way").startsWith(QStringLiteral("Nothing studied yet.")));
}

TEST_F(ProgressPageTest, ChartsOfTimeBeginWhereItIsChosen) {
  show(statistics());
  const auto rows = [this] { return view_.card(QStringLiteral("activity"))->shown().numbers.rows.size(); };
  EXPECT_EQ(view_.time_shown(), ProgressView::TimeShown::season);
  EXPECT_EQ(rows(), 41) << "from the day of study forty days ago";
  QSignalSpy changed(&view_, &ProgressView::time_changed);
  EXPECT_TRUE(view_.change_time_shown(-1));
  EXPECT_EQ(view_.time_shown(), ProgressView::TimeShown::month);
  EXPECT_EQ(rows(), 21) << "every day since, also without study";
  EXPECT_EQ(changed.count(), 1);
  EXPECT_FALSE(view_.change_time_shown(-1));
  EXPECT_EQ(view_.time_shown(), ProgressView::TimeShown::month);
  view_.set_time_shown(ProgressView::TimeShown::year);
  EXPECT_EQ(rows(), 16) << "weeks";
  EXPECT_TRUE(view_.change_time_shown(1));
  EXPECT_EQ(view_.time_shown(), ProgressView::TimeShown::everything);
  EXPECT_EQ(rows(), 16);
  EXPECT_FALSE(view_.change_time_shown(1));
  view_.set_time_shown(static_cast<ProgressView::TimeShown>(7));
  EXPECT_EQ(view_.time_shown(), ProgressView::TimeShown::month) << "no such time";
  const auto* time = view_.findChild<QComboBox*>(QStringLiteral("progress_time"));
  EXPECT_EQ(time->accessibleName(), QStringLiteral("Period shown"));
  QStringList names;
  for (int i = 0; i < time->count(); ++i) names.append(time->itemText(i));
  EXPECT_EQ(names, (QStringList{QStringLiteral("1 month"), QStringLiteral("3 months"),
                                QStringLiteral("1 year"), QStringLiteral("All time")}));
}

TEST_F(ProgressPageTest, EveryChartIsOnItsCard) {
  show(statistics());
  const char* const ids[] = {"forecast",   "retention",    "activity", "motion",
                             "characters", "hard_strokes", "calendar"};
  for (const char* id : ids) {
    auto* card = view_.card(QString::fromLatin1(id));
    EXPECT_EQ(card->objectName(), QString::fromLatin1(id) + QStringLiteral("_card"));
    EXPECT_FALSE(card->shown().numbers.rows.isEmpty()) << id;
    view_.go_to(QString::fromLatin1(id));
    EXPECT_EQ(view_.card_at_hand(), card);
    QSignalSpy wanted(&view_, &ProgressView::copy_wanted);
    card->findChild<QToolButton*>(QString::fromLatin1(id) + QStringLiteral("_copy"))->click();
    ASSERT_EQ(wanted.count(), 1) << id;
    EXPECT_EQ(wanted.at(0).at(0).value<ChartCard*>(), card);
  }
  EXPECT_EQ(view_.card(QStringLiteral("unknown"))->objectName(), QStringLiteral("calendar_card"));
}

TEST_F(ProgressPageTest, CardsStandInTwoColumnsWhereThereIsRoomForAHundredLetters) {
  show(statistics());
  view_.set_shows_more(true);
  view_.show();
  const int letter = view_.fontMetrics().averageCharWidth();
  const auto column_of = [this](const char* id) {
    QCoreApplication::processEvents();
    return view_.card(QString::fromLatin1(id))->x() > 100 ? 1 : 0;
  };
  view_.resize(letter * 100 + 2, 900);
  EXPECT_EQ(column_of("forecast"), 0);
  EXPECT_EQ(column_of("retention"), 1);
  EXPECT_EQ(column_of("activity"), 0);
  EXPECT_EQ(column_of("hard_strokes"), 1);
  EXPECT_EQ(column_of("characters"), 0);
  const auto* first = view_.card(QStringLiteral("forecast"));
  EXPECT_NEAR(first->width(), view_.card(QStringLiteral("retention"))->width(), 2);
  view_.resize(letter * 100 - 2, 900);
  EXPECT_EQ(column_of("retention"), 0);
  EXPECT_GT(first->width(), letter * 80);
}

TEST_F(ProgressPageTest, WorkAndTroubleAreShownAndGoAway) {
  auto* work = view_.findChild<QProgressBar*>(QStringLiteral("progress_work"));
  auto* trouble = view_.findChild<QLabel*>(QStringLiteral("progress_trouble"));
  auto* scroll = view_.findChild<QScrollArea*>(QStringLiteral("progress_scroll"));
  EXPECT_TRUE(work->isHidden());
  view_.show_work(0.255);
  EXPECT_FALSE(work->isHidden());
  EXPECT_EQ(work->value(), 25);
  EXPECT_EQ(work->maximum(), 100);
  view_.show_trouble(QStringLiteral("No."));
  EXPECT_FALSE(trouble->isHidden());
  EXPECT_EQ(trouble->text(), QStringLiteral("No."));
  EXPECT_TRUE(scroll->isHidden());
  show(statistics());
  EXPECT_TRUE(work->isHidden());
  EXPECT_TRUE(trouble->isHidden());
  EXPECT_FALSE(scroll->isHidden());
}

TEST_F(ProgressPageTest, WhatHasTheKeyboardIsAtHandAndWhatIsOpenedIsTold) {
  show(statistics());
  view_.show();
  view_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&view_));
  view_.setFocus();
  EXPECT_TRUE(view_.findChild<YearView*>()->hasFocus());
  view_.go_to(QStringLiteral("forecast"));
  EXPECT_TRUE(view_.shows_more()) << "a chart that is folded away is shown";
  view_.findChild<DayChart*>(QStringLiteral("motion_chart"))->setFocus();
  EXPECT_EQ(view_.card_at_hand()->objectName(), QStringLiteral("motion_card"));
  view_.go_to(QStringLiteral("hard_strokes"));
  auto* scroll = view_.findChild<QScrollArea*>(QStringLiteral("progress_scroll"));
  const auto* last = view_.card(QStringLiteral("hard_strokes"));
  const int top = last->mapTo(scroll->viewport(), QPoint()).y();
  EXPECT_LT(top, scroll->viewport()->height());
  QSignalSpy opened(&view_, &ProgressView::opened);
  auto* list = view_.findChild<QListWidget*>(QStringLiteral("hard_strokes_chart"));
  emit list->itemActivated(list->item(0));
  auto* grid = view_.findChild<StrengthGrid*>();
  emit grid->activated(grid->model()->index(1, 0));
  ASSERT_EQ(opened.count(), 2);
  EXPECT_EQ(opened.at(0).at(0).value<char32_t>(), U'休');
  EXPECT_EQ(opened.at(1).at(0).value<char32_t>(), U'二');
}

}  // namespace
}  // namespace nazori::ui
