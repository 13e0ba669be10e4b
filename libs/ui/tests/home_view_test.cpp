// SPDX-License-Identifier: Apache-2.0
// What Home says about the day, without a window around it.
#include "study/home_view.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include "session_under_test.h"
#include "words/language.h"
#include "words/study_words.h"

namespace nazori::ui {
namespace {

using std::chrono::days;
using std::chrono::minutes;
using study::Rating;

class HomeViewTest : public SessionTest {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }

  void change(const std::function<void(study::Settings&)>& what) {
    auto settings = learner_->store().settings();
    what(settings);
    ASSERT_TRUE(learner_->store().change_settings(settings));
    learner_->renew_order();
  }
  void learn_from(std::vector<char32_t> characters, int new_per_day) {
    ASSERT_TRUE(learner_->store().save_list({"few", std::move(characters)}));
    change([&](study::Settings& to) {
      to.new_lists = {"list:few"};
      to.new_order = study::NewOrder::own;
      to.new_per_day = new_per_day;
    });
  }
  void write(char32_t character, Rating rating) {
    study::Writing writing;
    writing.rating = rating;
    writing.result.duration = std::chrono::seconds(20);
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing));
  }
  QString text(const char* name) {
    view_.refresh();
    return said(name);
  }
  /// The text that is shown, without reading the plan of the day again.
  QString said(const char* name) const {
    const auto* label = view_.findChild<QLabel*>(QString::fromLatin1(name));
    return label->isHidden() ? QStringLiteral("(hidden)") : label->text();
  }
  QString words(const char* tile) {
    view_.refresh();
    const auto* number = view_.findChild<QLabel*>(QString::fromLatin1(tile));
    return number->accessibleName();
  }
  QPushButton* button(const char* name) { return view_.findChild<QPushButton*>(QString::fromLatin1(name)); }
  bool can_see(const char* name) {
    view_.refresh();
    return !button(name)->isHidden();
  }

  HomeView view_{*learner_, *session_};
};

TEST_F(HomeViewTest, TellsTheDayAndWhoStudiesWhereThatIsNotTheUsualLearner) {
  EXPECT_EQ(text("home_day"), QStringLiteral("Monday 2 March"));
  ASSERT_TRUE(learner_->switch_profile("Mari"));
  EXPECT_TRUE(text("home_day").endsWith(QStringLiteral(" · Mari"))) << text("home_day").toStdString();
}

TEST_F(HomeViewTest, CountsWhatIsDueAndWhatIsNew) {
  learn_from({U'一', U'二', U'三', U'四'}, 2);
  EXPECT_EQ(words("home_due"), QStringLiteral("0 due now"));
  EXPECT_EQ(words("home_new"), QStringLiteral("2 new today"));
  EXPECT_TRUE(view_.can_start());
  const auto estimate = learner_->plan()->estimate;
  EXPECT_EQ(text("home_time"), QString::number(std::chrono::round<minutes>(estimate).count()));
  EXPECT_EQ(words("home_streak"), QStringLiteral("0 days in a row"));
  EXPECT_EQ(button("home_start")->text(),
            QStringLiteral("Start: 2 characters, ") + StudyWords::about(estimate));
  EXPECT_TRUE(said("home_advice").startsWith(QStringLiteral("You first watch each new character")));
  EXPECT_TRUE(said("home_advice").endsWith(QStringLiteral("\nNew today: 一二")));
  write(U'一', Rating::easy);
  EXPECT_EQ(words("home_new"), QStringLiteral("1 new (1 already done today)"));
  EXPECT_EQ(words("home_streak"), QStringLiteral("1 day in a row (one day off per week is fine)"));
  EXPECT_EQ(said("home_advice"), QStringLiteral("New today: 二"));
  now_ += days(2);
  write(U'二', Rating::easy);
  EXPECT_EQ(words("home_streak"), QStringLiteral("2 days in a row (day off used this week)"));
  now_ += days(6);
  EXPECT_EQ(words("home_due"), QStringLiteral("1 due now"));
}

TEST_F(HomeViewTest, NamesTwelveNewCharactersAndNoMore) {
  learn_from({U'一', U'二', U'三', U'四', U'五', U'六', U'七', U'八', U'九', U'十', U'百', U'千', U'日'}, 12);
  EXPECT_TRUE(text("home_advice").endsWith(QStringLiteral("New today: 一二三四五六七八九十百千")));
  change([](study::Settings& to) { to.new_per_day = 13; });
  EXPECT_TRUE(text("home_advice").endsWith(QStringLiteral("New today: 一二三四五六七八九十百千…")));
}

TEST_F(HomeViewTest, WithNothingToDoItSaysWhy) {
  learn_from({}, 2);
  EXPECT_TRUE(text("home_advice").startsWith(QStringLiteral("Nothing to learn yet.")));
  EXPECT_FALSE(view_.can_start());
  EXPECT_FALSE(can_see("home_start"));
  EXPECT_EQ(words("home_time"), QStringLiteral("0 minutes (estimate)"));
  EXPECT_EQ(view_.focusProxy(), button("home_settings"));
  write(U'一', Rating::easy);
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. Tomorrow: new characters, no reviews."));
  change([](study::Settings& to) { to.new_per_day = 0; });
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. Nothing is due tomorrow."));
}

TEST_F(HomeViewTest, SaysHowManyReviewsTomorrowBrings) {
  learn_from({}, 0);
  write(U'一', Rating::easy);
  const auto due = learner_->store().card(U'一').due_day;
  ASSERT_TRUE(due);
  now_ += *due - learner_->store().today() - days(1);
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. 1 review is due tomorrow."));
  const char32_t one = U'一';
  ASSERT_TRUE(learner_->store().postpone(std::span(&one, 1), *due + days(1)));
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. Nothing is due tomorrow."));
  now_ += days(1);
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. 1 review is due tomorrow."))
      << "postponed to it";
  ASSERT_TRUE(learner_->store().pause(std::span(&one, 1)));
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. Nothing is due tomorrow."));
}

TEST_F(HomeViewTest, APostponedCharacterThatIsStillNewIsNoReviewOfTomorrow) {
  learn_from({U'一'}, 0);
  study::Writing practice;
  practice.stage = study::Stage::watch;
  ASSERT_TRUE(learner_->store().add_writing(U'一', 1, practice));
  const char32_t one = U'一';
  ASSERT_TRUE(learner_->store().postpone(std::span(&one, 1), learner_->store().today() + days(1)));
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. Nothing is due tomorrow."));
}

TEST_F(HomeViewTest, ReviewsBeyondTheLimitWait) {
  learn_from({}, 0);
  for (const char32_t character : {U'一', U'二', U'三'}) write(character, Rating::easy);
  change([](study::Settings& to) { to.reviews_per_day = 2; });
  now_ += *learner_->store().card(U'一').due_day - learner_->store().today();
  // After a week away half of the limit is asked for.
  ASSERT_FALSE(learner_->plan()->gentle);
  EXPECT_EQ(words("home_due"), QStringLiteral("1 due now"));
  EXPECT_EQ(said("home_advice"),
            QStringLiteral("2 more reviews will wait for another day because of your daily limit."));
}

TEST_F(HomeViewTest, WhatIsForgottenOftenIsOfferedAnotherLesson) {
  learn_from({}, 0);
  change([](study::Settings& to) { to.leech_lapses = 2; });
  EXPECT_EQ(text("home_leeches"), QStringLiteral("(hidden)"));
  EXPECT_FALSE(can_see("home_leech_lesson"));
  write(U'一', Rating::easy);
  while (!learner_->store().card(U'一').leech) {
    now_ += days(40);
    write(U'一', Rating::again);
    now_ += minutes(15);
    write(U'一', Rating::good);
  }
  EXPECT_EQ(text("home_leeches"),
            QStringLiteral("1 character was forgotten too often and taken out of reviews: 一"));
  EXPECT_TRUE(can_see("home_leech_lesson"));
  EXPECT_EQ(said("home_advice"), QStringLiteral("Done for today. Nothing is due tomorrow."));
  ASSERT_TRUE(session_->start(true));
  EXPECT_FALSE(can_see("home_leech_lesson")) << "one session at a time";
  EXPECT_EQ(button("home_start")->text(), QStringLiteral("Continue the session"));
  EXPECT_TRUE(view_.can_start());
}

TEST_F(HomeViewTest, WhereNothingCanBeKeptItSaysSoAndOffersToTryAgain) {
  EXPECT_FALSE(can_see("home_try_again"));
  EXPECT_EQ(text("home_trouble"), QStringLiteral("(hidden)"));
  learner_->let_go(practice::LearnerEvent::Kind::replacing);
  EXPECT_EQ(text("home_trouble"), replaced());
  EXPECT_TRUE(can_see("home_try_again"));
  EXPECT_FALSE(can_see("home_start"));
  EXPECT_FALSE(view_.can_start());
  EXPECT_EQ(view_.focusProxy(), button("home_try_again"));
  button("home_try_again")->click();
  EXPECT_TRUE(learner_->can_write());
  EXPECT_FALSE(can_see("home_try_again"));
  EXPECT_EQ(text("home_trouble"), QStringLiteral("(hidden)"));
  EXPECT_EQ(view_.focusProxy(), button("home_start"));
}

TEST_F(HomeViewTest, TheSummaryOfASessionHasALineForEachThingThatWasDone) {
  EXPECT_EQ(said("home_summary"), QStringLiteral("(hidden)"));
  practice::SessionSummary summary;
  summary.reviews = 6;
  summary.ratings = {1, 0, 3, 2};
  summary.practices = 4;
  summary.met = {U'一', U'二'};
  summary.lessons = {U'三'};
  summary.again = {U'四'};
  summary.time = minutes(4);
  view_.show_summary(summary);
  EXPECT_EQ(said("home_summary"),
            QStringLiteral("Written from memory: 6\nAgain 1 · Good 3 · Easy 2\nNew: 一二\n"
                           "Relearned: 三\nComing back soon: 四\nTime: about 4 minutes"));
  practice::SessionSummary practice;
  practice.practices = 1;
  practice.time = minutes(2);
  view_.show_summary(practice);
  EXPECT_EQ(said("home_summary"), QStringLiteral("Time: about 2 minutes"));
  view_.show_summary({});
  EXPECT_EQ(said("home_summary"), QStringLiteral("(hidden)"));
}

TEST_F(HomeViewTest, ItsButtonsAskForWhatTheySay) {
  view_.refresh();
  const std::pair<const char*, void (HomeView::*)()> all[] = {
      {"home_start", &HomeView::start_wanted},
      {"home_leech_lesson", &HomeView::leeches_wanted},
      {"home_settings", &HomeView::settings_wanted},
      {"home_free_writing", &HomeView::free_writing_wanted}};
  for (const auto& [name, wanted] : all) {
    const QSignalSpy spy(&view_, wanted);
    button(name)->click();
    EXPECT_EQ(spy.count(), 1) << name;
    EXPECT_TRUE(button(name)->autoDefault()) << name;
  }
}

TEST_F(HomeViewTest, TilesStandInARowWhereThereIsRoom) {
  view_.show();
  const int em = QFontInfo(view_.font()).pixelSize();
  const auto top = [this](const char* tile) {
    QCoreApplication::processEvents();
    const auto* number = view_.findChild<QLabel*>(QString::fromLatin1(tile));
    return number->mapTo(&view_, QPoint()).y();
  };
  view_.resize(em * 70, 900);
  EXPECT_EQ(top("home_due"), top("home_streak"));
  view_.resize(em * 34, 900);
  EXPECT_EQ(top("home_due"), top("home_new"));
  EXPECT_LT(top("home_new"), top("home_time"));
  EXPECT_EQ(top("home_time"), top("home_streak"));
  view_.resize(em * 20, 900);
  EXPECT_LT(top("home_due"), top("home_new"));
  EXPECT_LT(top("home_time"), top("home_streak"));
}

}  // namespace
}  // namespace nazori::ui
