// SPDX-License-Identifier: Apache-2.0
// What Home says about the day, without a window around it.
#include "study/home_view.h"

#include <QApplication>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>

#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/study_words.h"
#include "session_under_test.h"
#include "study/home.h"
#include "study/home_parts.h"
#include "window/language.h"

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
    writing.result.accepted = rating != Rating::again;
    writing.result.duration = std::chrono::seconds(20);
    if (rating == Rating::again) writing.result.mistakes = {{kanji::MistakeKind::missing, 0}};
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing, ink()));
  }
  static study::Handwriting ink() { return {{{{10, 50}, 0.0, 1.0}, {{90, 50}, 0.5, 1.0}}}; }
  QString text(const char* name) {
    view_.refresh();
    return said(name);
  }
  /// The text that is shown, without reading the plan of the day again.
  QString said(const char* name) const {
    const auto* label = view_.findChild<QLabel*>(QString::fromLatin1(name));
    return label->isHidden() ? QStringLiteral("(hidden)") : label->text();
  }
  /// What the start button says to a screen reader.
  QString work() {
    view_.refresh();
    return button("home_start")->accessibleName();
  }
  /// The characters of the tiles in a box.
  QString tiles(const char* box) {
    view_.refresh();
    QString all;
    const auto* parent = view_.findChild<QWidget*>(QString::fromLatin1(box));
    if (parent->isHidden()) return all;
    for (const auto* tile : parent->findChildren<CharacterTile*>())
      if (!tile->isHidden()) all += tile->text();
    return all;
  }
  /// Lays the page out for a size, and names the labels and buttons whose words do not fit.
  QStringList clipped(int width, int height) {
    view_.resize(width, height);
    view_.show();
    view_.refresh();
    for (int pass = 0; pass < 5; ++pass) {
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
    }
    QStringList found;
    if (view_.widget()->width() > view_.viewport()->width()) found.append(QStringLiteral("the page"));
    for (const auto* label : view_.findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty()) continue;
      const QRect needed = label->fontMetrics().boundingRect(
          QRect(0, 0, label->contentsRect().width(), 10'000), Qt::TextWordWrap, label->text());
      if (needed.width() > label->contentsRect().width() + 1 || needed.height() > label->height() + 1)
        found.append(label->objectName() + QLatin1Char(':') + label->text());
    }
    for (const auto* one : view_.findChildren<QPushButton*>())
      if (one->isVisible() &&
          (one->width() < one->minimumSizeHint().width() ||
           one->mapTo(view_.widget(), QPoint(one->width(), 0)).x() > view_.widget()->width()))
        found.append(one->objectName() + QLatin1Char(':') + one->text());
    return found;
  }
  QPushButton* button(const char* name) { return view_.findChild<QPushButton*>(QString::fromLatin1(name)); }
  bool can_see(const char* name) {
    view_.refresh();
    return !button(name)->isHidden();
  }

  QWidget window_;
  HomeActions actions_{&window_};
  HomeView view_{*learner_, *session_, actions_};
};

TEST_F(HomeViewTest, GreetsAndTellsTheDayTheStreakAndWhoStudiesWhereThatIsNotTheUsualLearner) {
  EXPECT_EQ(text("home_greeting"), QStringLiteral("Good morning"));
  EXPECT_EQ(text("home_day"), QStringLiteral("Monday 2 March"));
  now_ += std::chrono::hours(9);
  EXPECT_EQ(text("home_greeting"), QStringLiteral("Good evening"));
  write(U'一', Rating::easy);
  EXPECT_EQ(text("home_day"), QStringLiteral("Monday 2 March · 1 day in a row"));
  now_ += days(2);
  write(U'二', Rating::easy);
  EXPECT_EQ(text("home_day"), QStringLiteral("Wednesday 4 March · 2 days in a row"))
      << "a day off is no break";
  now_ += days(9);
  EXPECT_EQ(text("home_day"), QStringLiteral("Friday 13 March")) << "a break is not mentioned";
  ASSERT_TRUE(learner_->switch_profile("Mari"));
  EXPECT_TRUE(text("home_day").endsWith(QStringLiteral(" · Mari"))) << text("home_day").toStdString();
}

TEST_F(HomeViewTest, TheStartButtonHoldsWhatIsDueAndForHowLong) {
  learn_from({U'一', U'二', U'三', U'四'}, 2);
  EXPECT_EQ(work(), QStringLiteral("Start: 2 new characters · about 6 minutes"));
  EXPECT_TRUE(view_.can_start());
  EXPECT_FALSE(can_see("home_reviews")) << "there are none";
  EXPECT_TRUE(said("home_advice").startsWith(QStringLiteral("You first watch each new character")));
  write(U'一', Rating::easy);
  EXPECT_EQ(work(), QStringLiteral("Start: 1 new character · about 3 minutes"));
  EXPECT_EQ(said("home_advice"), QStringLiteral("(hidden)"));
  now_ += days(9);
  EXPECT_EQ(work(), QStringLiteral("Start: 1 review and 2 new characters · about 6 minutes"));
  EXPECT_TRUE(can_see("home_reviews"));
  EXPECT_EQ(button("home_reviews")->text(), QStringLiteral("Only reviews, 1 min"));
  EXPECT_FALSE(can_see("home_more")) << "the day's own work comes first";
}

TEST_F(HomeViewTest, NewCharactersStandInTheirOrderWithTheirMeanings) {
  learn_from({U'休', U'二', U'三'}, 2);
  EXPECT_EQ(tiles("home_new"), QStringLiteral("休二"));
  EXPECT_TRUE(view_.findChild<CharacterTile*>()->accessibleName().startsWith(QStringLiteral("休, rest")))
      << view_.findChild<CharacterTile*>()->accessibleName().toStdString();
  QSignalSpy opened(&view_, &HomeView::character_wanted);
  view_.findChild<CharacterTile*>()->click();
  EXPECT_EQ(opened.at(0).at(0).value<char32_t>(), U'休');
  write(U'休', Rating::easy);
  EXPECT_EQ(tiles("home_new"), QStringLiteral("休二")) << "what was begun today is still new";
  now_ += days(1);
  EXPECT_EQ(tiles("home_new"), QStringLiteral("二三"));
}

TEST_F(HomeViewTest, WithNothingToDoItSaysWhyAndOffersMore) {
  learn_from({}, 2);
  EXPECT_TRUE(text("home_advice").startsWith(QStringLiteral("Nothing to learn yet.")));
  EXPECT_FALSE(view_.can_start());
  EXPECT_FALSE(can_see("home_start"));
  EXPECT_FALSE(can_see("home_more"));
  EXPECT_EQ(view_.focusProxy(), button("home_settings"));
  write(U'一', Rating::easy);
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. Tomorrow: new characters, no reviews."));
  EXPECT_TRUE(can_see("home_ahead"));
  EXPECT_EQ(view_.focusProxy(), view_.findChild<QLabel*>("home_advice"));
  EXPECT_EQ(button("home_ahead")->text(), QStringLiteral("Review ahead  A"));
  change([](study::Settings& to) { to.new_per_day = 0; });
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. Nothing is due tomorrow."));
  learn_from({U'一', U'二'}, 1);
  EXPECT_TRUE(can_see("home_more")) << "the goal of the day is reached, 二 is left";
  EXPECT_EQ(view_.focusProxy(), view_.findChild<QLabel*>("home_advice"));
  EXPECT_EQ(button("home_more")->text(), QStringLiteral("Five more new characters  F"));
  const QSignalSpy more(actions_.more, &QAction::triggered);
  button("home_more")->click();
  EXPECT_EQ(more.count(), 1);
}

TEST_F(HomeViewTest, SaysHowManyReviewsTomorrowBrings) {
  learn_from({}, 0);
  write(U'一', Rating::easy);
  now_ += *learner_->store().card(U'一').due_day - learner_->store().today() - days(1);
  EXPECT_EQ(text("home_advice"), QStringLiteral("Done for today. 1 review is due tomorrow."));
}

TEST_F(HomeViewTest, ReviewsBeyondTheLimitWait) {
  learn_from({}, 0);
  for (const char32_t character : {U'一', U'二', U'三'}) write(character, Rating::easy);
  change([](study::Settings& to) { to.reviews_per_day = 2; });
  now_ += *learner_->store().card(U'一').due_day - learner_->store().today();
  // After a week away half of the limit is asked for.
  ASSERT_FALSE(learner_->plan()->gentle);
  EXPECT_TRUE(work().startsWith(QStringLiteral("Start: 1 review ·"))) << work().toStdString();
  EXPECT_EQ(said("home_advice"),
            QStringLiteral("2 more reviews will wait for another day because of your daily limit."));
}

TEST_F(HomeViewTest, TheLearnersOwnInkIsShownOfTodayElseOfTheLastDay) {
  EXPECT_EQ(text("home_ink_title"), QStringLiteral("Today, in your hand"));
  EXPECT_NE(said("home_ink_empty"), QStringLiteral("(hidden)")) << "it says what will be there";
  EXPECT_FALSE(can_see("home_week"));
  write(U'一', Rating::good);
  write(U'二', Rating::again);
  EXPECT_EQ(text("home_ink_title"), QStringLiteral("Today, in your hand"));
  EXPECT_EQ(said("home_written"), QStringLiteral("2 written, 1 right · about 1 minute"));
  EXPECT_EQ(said("home_ink_empty"), QStringLiteral("(hidden)"));
  const auto* row = view_.findChild<InkRow*>();
  ASSERT_EQ(row->inks().size(), 2U);
  EXPECT_EQ(row->inks()[0].ink, ink());
  EXPECT_EQ(row->accessibleName(), QStringLiteral("Your handwriting: 一 二"));
  EXPECT_TRUE(can_see("home_week"));
  now_ += days(1);
  EXPECT_EQ(text("home_ink_title"), QStringLiteral("Yesterday, in your hand"));
  EXPECT_EQ(said("home_written"), QStringLiteral("2 written, 1 right · about 1 minute"));
  now_ += days(1);
  EXPECT_EQ(text("home_ink_title"), QStringLiteral("Monday 2 March, in your hand"));
  ASSERT_TRUE(learner_->store().undo());
  EXPECT_EQ(text("home_written"), QStringLiteral("1 written, 1 right · less than a minute"));
}

TEST_F(HomeViewTest, AllInkIsShownOnlyWhereOneRowIsTooShort) {
  const int em = QFontInfo(view_.font()).pixelSize();
  InkRow row;
  row.show_inks(std::vector<practice::InkedWriting>(8, {U'一', true, ink()}));
  row.resize(em * 50, em * 5);
  EXPECT_FALSE(row.has_more());
  row.resize(em * 9, em * 5);
  EXPECT_TRUE(row.has_more());
  const int one = row.heightForWidth(em * 9);
  row.show_all(true);
  EXPECT_EQ(row.heightForWidth(em * 9), 4 * one) << "two in a row";

  for (const char32_t character : {U'一', U'二', U'三', U'四', U'五', U'六', U'七', U'八'})
    write(character, Rating::good);
  EXPECT_EQ(clipped(em * 90, 900), QStringList());
  EXPECT_FALSE(button("home_all_ink")->isVisible());
  EXPECT_EQ(clipped(em * 25, 900), QStringList());
  EXPECT_TRUE(button("home_all_ink")->isVisible());
  view_.show_all_ink(true);
  EXPECT_EQ(button("home_all_ink")->text(), QStringLiteral("Show less"));
}

TEST_F(HomeViewTest, WhatWasHardTodayNeedsCareFirstElseWhatOftenFails) {
  learn_from({}, 0);
  EXPECT_EQ(tiles("home_care_characters"), QString());
  write(U'一', Rating::good);
  write(U'二', Rating::good);
  for (int day = 0; day < 2; ++day) {
    now_ += days(1);
    write(U'一', Rating::again);
  }
  write(U'二', Rating::again);
  EXPECT_EQ(tiles("home_care_characters"), QStringLiteral("一二")) << "not right today";
  EXPECT_EQ(said("home_care"), QStringLiteral("Stroke 1 of 一 is often left out."));
  EXPECT_EQ(button("home_practise")->text(), QStringLiteral("Practise these, 2 min"));
  EXPECT_EQ(view_.hard(), (std::vector{U'一', U'二'}));
  now_ += days(1);
  EXPECT_EQ(tiles("home_care_characters"), QStringLiteral("一")) << "it failed on two days";
  EXPECT_EQ(button("home_practise")->text(), QStringLiteral("Practise these, 1 min"));
  ASSERT_TRUE(learner_->switch_profile("Mari"));
  EXPECT_EQ(tiles("home_care_characters"), QString());
  EXPECT_TRUE(view_.hard().empty());
}

TEST_F(HomeViewTest, EachListThatIsBeingLearnedHasABarWithItsNumbers) {
  learn_from({U'一', U'二', U'三', U'四'}, 2);
  write(U'一', Rating::easy);
  view_.refresh();
  const auto bars = view_.findChildren<MilestoneBar*>();
  ASSERT_EQ(bars.size(), 2);
  EXPECT_EQ(bars[0]->findChild<QLabel*>(QStringLiteral("milestone_name"))->text(),
            QStringLiteral("My list: few"));
  EXPECT_EQ(bars[0]->findChild<QLabel*>(QStringLiteral("milestone_reached"))->text(),
            QStringLiteral("1 of 4"));
  EXPECT_EQ(bars[0]->findChild<QLabel*>(QStringLiteral("milestone_done"))->text(),
            QStringLiteral("Done in about 3 days at this pace."));
  EXPECT_EQ(bars[0]->findChild<QProgressBar*>()->maximum(), 4);
  EXPECT_EQ(bars[0]->findChild<QProgressBar*>()->value(), 1);
  EXPECT_EQ(bars[1]->findChild<QProgressBar*>()->accessibleName(), QStringLiteral("All school kanji"));
  EXPECT_EQ(bars[1]->findChild<QProgressBar*>()->accessibleDescription(), QStringLiteral("1 of 2,136."));
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
  EXPECT_EQ(tiles("home_care_characters"), QString()) << "it is not said twice";
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

TEST_F(HomeViewTest, ItsButtonsDoWhatTheirActionsDo) {
  view_.refresh();
  const std::pair<const char*, QAction*> all[] = {
      {"home_start", actions_.start},       {"home_reviews", actions_.reviews},
      {"home_more", actions_.more},         {"home_ahead", actions_.ahead},
      {"home_practise", actions_.practise}, {"home_leech_lesson", actions_.leeches},
      {"home_settings", actions_.settings}, {"home_free_writing", actions_.choose},
      {"home_all_ink", actions_.all_ink},   {"home_week", actions_.week},
      {"home_month", actions_.month}};
  for (const auto& [name, action] : all) {
    const QSignalSpy spy(action, &QAction::triggered);
    button(name)->click();
    EXPECT_EQ(spy.count(), 1) << name;
    EXPECT_TRUE(button(name)->autoDefault()) << name;
    if (action != actions_.start) {
      EXPECT_EQ(button(name)->toolTip(), action->toolTip());
    }
  }
}

TEST_F(HomeViewTest, IsTwoColumnsWhereThereIsRoomAndInTheMiddleOfAWideWindow) {
  learn_from({U'一', U'二'}, 2);
  view_.show();
  const int em = QFontInfo(view_.font()).pixelSize();
  const auto left_of = [this](const char* name) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    return view_.findChild<QWidget*>(QString::fromLatin1(name))->mapTo(&view_, QPoint()).x();
  };
  view_.resize(em * 60, 900);
  view_.refresh();
  EXPECT_GT(left_of("home_ink"), left_of("home_start") + em * 15);
  view_.resize(em * 40, 900);
  EXPECT_EQ(left_of("home_ink"), left_of("home_start"));
  view_.resize(em * 240, 900);
  const int left = left_of("home_start");
  const auto* card = view_.findChild<QWidget*>(QStringLiteral("home_ink"));
  const int right = view_.width() - card->mapTo(&view_, QPoint(card->width(), 0)).x();
  EXPECT_NEAR(left, right, em);
  EXPECT_GT(left, em * 60);
}

TEST_F(HomeViewTest, NoWordIsCutOffInANarrowWindowWithTheLargestText) {
  QFont large = view_.font();
  large.setPointSizeF(28);
  view_.setFont(large);
  learn_from({U'休', U'駅', U'湖', U'港', U'暑'}, 5);
  EXPECT_EQ(clipped(740, 500), QStringList());
  write(U'休', Rating::again);
  write(U'駅', Rating::again);
  EXPECT_EQ(clipped(740, 500), QStringList());
  now_ += days(60);
  EXPECT_EQ(clipped(740, 500), QStringList());
}

TEST_F(HomeViewTest, TheButtonToPressNextIsWholeInASmallWindowWithTheLargestText) {
  QFont large = view_.font();
  large.setPointSizeF(28);
  view_.setFont(large);
  learn_from({U'休', U'駅', U'湖', U'港', U'暑'}, 5);
  // What a window of 800 x 600 leaves to the page.
  view_.resize(708, 312);
  view_.show();
  view_.refresh();
  QCoreApplication::sendPostedEvents();
  QCoreApplication::processEvents();
  const auto* start = button("home_start");
  EXPECT_LE(start->mapTo(&view_, QPoint(0, start->height())).y(), view_.viewport()->height());
}

TEST_F(HomeViewTest, TheButtonToPressNextIsIndigoInBothThemes) {
  const QPalette before = QApplication::palette();
  for (const auto* colours : {&light_colours(), &dark_colours()}) {
    QApplication::setPalette(make_palette(*colours));
    view_.refresh();
    auto* start = button("home_start");
    start->resize(400, 120);
    const QImage picture = start->grab().toImage();
    EXPECT_EQ(picture.pixelColor(picture.width() / 2, picture.height() - 3), colours->indigo);
    EXPECT_GE(contrast_ratio(colours->indigo, colours->surface), 4.5);
  }
  QApplication::setPalette(before);
}

}  // namespace
}  // namespace nazori::ui
