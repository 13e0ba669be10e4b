// SPDX-License-Identifier: Apache-2.0
// A study session in the window, from its start to its summary.
#include <QPushButton>

#include "study/home_parts.h"
#include "study/ink_gallery.h"
#include "study_under_test.h"

namespace nazori::ui {
namespace {

using study::Rating;
using State = practice::StudySession::State;
using Study = StudyTest;

TEST_F(Study, TheWindowOpensWithWhatIsDueAndOneKeyStarts) {
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Home – Nazori"));
  EXPECT_EQ(find("home_start")->accessibleName(), QStringLiteral("Start: 1 new character · about 3 minutes"));
  EXPECT_EQ(text("home_day"), QStringLiteral("Monday 2 March")) << "no streak, and no word about it";
  ASSERT_EQ(window_->findChildren<CharacterTile*>().size(), 1);
  EXPECT_EQ(window_->findChild<CharacterTile*>()->accessibleName(), QStringLiteral("一, one"));
  EXPECT_EQ(window_->focusWidget(), find("home_start"));
  start();
  ASSERT_TRUE(is_shown());
  EXPECT_TRUE(find("session_bar")->isVisible());
  EXPECT_TRUE(find("question_view")->isVisible());
  EXPECT_FALSE(find("left_side")->isVisible()) << "the tablet has their room";
  EXPECT_FALSE(find("right_side")->isVisible());
  EXPECT_TRUE(text("session_progress").startsWith(QStringLiteral("1 of 1")));
  EXPECT_TRUE(action("watch")->isChecked());
}

TEST_F(Study, TheSpaceBarStartsToo) {
  QTest::keyClick(find<QPushButton>("home_start"), Qt::Key_Space);
  EXPECT_TRUE(session().is_running());
}

TEST_F(Study, ACharacterAskedForAtTheStartGoesStraightToIt) {
  QSignalSpy unused(window_.get(), &MainWindow::opened);
  open_window(U'水');
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("水 – Nazori"));
  EXPECT_FALSE(find("session_bar")->isVisible());
}

TEST_F(Study, FourRatingsTellWhenTheCharacterComesAgainAndEnterTakesTheProposedOne) {
  start();
  learn();
  ASSERT_TRUE(find("button_rate_good")->isVisible());
  EXPECT_TRUE(find<QPushButton>("button_rate_again")->text().contains(QStringLiteral("in 1 minute")));
  EXPECT_TRUE(find<QPushButton>("button_rate_good")->text().contains(QStringLiteral("in 10 minutes")));
  EXPECT_TRUE(find<QPushButton>("button_rate_easy")->text().contains(QStringLiteral("in 8 days")));
  EXPECT_TRUE(find<QPushButton>("button_rate_good")->accessibleName().contains(QStringLiteral("suggested")));
  EXPECT_FALSE(action("done")->isEnabled()) << "Enter has one meaning";
  go_on();
  EXPECT_EQ(store().card(U'一').memory.reps, 1);
  EXPECT_EQ(store().card(U'一').memory.phase, study::Phase::learning);
}

TEST_F(Study, TheRatingsAreOnOneToFour) {
  start();
  learn();
  press(Qt::Key_4);
  EXPECT_EQ(store().card(U'一').memory.phase, study::Phase::review);
  EXPECT_EQ(store().card(U'一').memory.scheduled_days, 8);
}

TEST_F(Study, NoKeyHasTwoMeaningsAtAnyStepOfASession) {
  start();
  const auto twice = [this] {
    QStringList keys;
    for (const auto* entry : window_->findChildren<QAction*>())
      if (entry->isVisible() && entry->isEnabled())
        for (const auto& key : entry->shortcuts()) keys.append(key.toString());
    return keys.removeDuplicates();
  };
  the_parts->preferences().one_hand = OneHand::left;
  the_parts->study_settings_changed();
  while (session().state() != State::judged) {
    do_stage();
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_EQ(twice(), 0);
    if (session().state() == State::offered) go_on();
  }
  the_parts->preferences().one_hand = OneHand::right;
  the_parts->study_settings_changed();
  EXPECT_EQ(twice(), 0);
  press(Qt::Key_8);
  EXPECT_EQ(store().card(U'一').memory.reps, 1) << "the right hand's key for hard";
}

TEST_F(Study, MeaningAndReadingsAreAskedAndTheCharacterIsHidden) {
  start();
  learn();
  press(Qt::Key_4);
  now_ += std::chrono::days(8);
  open_home();
  EXPECT_TRUE(find("home_start")->accessibleName().startsWith(QStringLiteral("Start: 1 review and 1 new")));
  start();
  ASSERT_TRUE(is_shown());
  EXPECT_EQ(session().task().kind, study::TaskKind::review);
  EXPECT_TRUE(action("memory")->isChecked());
  EXPECT_TRUE(text("session_question").contains(QStringLiteral("one")))
      << text("session_question").toStdString();
  EXPECT_TRUE(text("session_question").contains(QStringLiteral("イチ")));
  EXPECT_FALSE(text("session_question").contains(QStringLiteral("一")));
  EXPECT_FALSE(window_->windowTitle().contains(QStringLiteral("一")));
  EXPECT_FALSE(find("glyph")->isVisible());
}

TEST_F(Study, AWordWithTheCharacterLeftOutAsksInPlace) {
  start();
  learn();
  press(Qt::Key_4);
  const int reps = store().card(U'一').memory.reps;
  // One review in three asks by a word. The character and the number of its reviews decide which.
  now_ += std::chrono::days(8);
  open_home();
  the_parts->session().set_asks_by_words(true);
  start();
  ASSERT_TRUE(is_shown());
  const bool by_word = (reps + static_cast<int>(U'一')) % 3 == 0;
  EXPECT_EQ(session().word() != nullptr, by_word);
  if (by_word) {
    EXPECT_TRUE(text("session_question").contains(QStringLiteral("＿")));
    EXPECT_FALSE(text("session_question").contains(QStringLiteral("一")));
  }
}

TEST_F(Study, EarlierWritingStandsBesideTodaysOnceItIsJudged) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  auto* gallery = find<InkGallery>("ink_gallery");
  EXPECT_FALSE(gallery->isVisible()) << "it would show the character";
  write_from_memory(true);
  ASSERT_TRUE(gallery->isVisible());
  ASSERT_EQ(gallery->pieces().size(), 2U);
  EXPECT_EQ(gallery->pieces()[0].ink, session().ink());
  EXPECT_EQ(gallery->pieces()[1].words, QStringLiteral("2 Mar 2026\nEasy"));
}

TEST_F(Study, GivingUpIsAgainAndLeadsToGuidedWritingWithHelp) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  write_from_memory(false);
  EXPECT_EQ(session().proposed(), Rating::again);
  go_on();
  EXPECT_EQ(session().character(), U'一');
  EXPECT_TRUE(action("guided")->isChecked());
  EXPECT_GT(the_parts->tablet().overlay().lines_opacity, 0.2);
  do_stage();
  go_on();
  EXPECT_EQ(store().card(U'一').memory.lapses, 1);
}

TEST_F(Study, AStrokeRefusedThreeTimesIsShownAndTheLessonGoesOn) {
  start();
  while (session().stage() != study::Stage::memory) {
    do_stage();
    ASSERT_FALSE(HasFatalFailure());
    go_on();
  }
  ASSERT_TRUE(is_shown());
  auto* memory = &the_parts->practice().memory();
  practice::HandStroke down;
  for (int i = 0; i <= 40; ++i) down.push_back({{0.01, 0.03 - i * 0.0015}, i * 0.01, 0.5});
  for (int miss = 1; miss <= 3; ++miss) {
    the_parts->announce(Feedback::hint, QStringLiteral("not judged yet"));
    memory->add_stroke(down);
    ASSERT_TRUE(QTest::qWaitFor([&] { return feedback() != QStringLiteral("not judged yet"); }, 20000));
    EXPECT_EQ(memory->strokes().size(), miss < 3 ? 1U : 0U) << "the refused one made room";
    EXPECT_EQ(feedback().contains(QStringLiteral("H: show where")), miss == 2) << feedback().toStdString();
  }
  EXPECT_TRUE(feedback().contains(QStringLiteral("Stroke 1 is shown in blue"))) << feedback().toStdString();
  write_from_memory(true);
  EXPECT_EQ(session().proposed(), Rating::again) << "it had to be shown";
}

TEST_F(Study, GoingElsewhereKeepsTheSessionAndEnterComesBack) {
  start();
  ASSERT_TRUE(is_shown());
  show(U'雨');
  EXPECT_TRUE(session().is_away());
  EXPECT_TRUE(find("session_next")->isVisible());
  shown_character_ = 0;
  press(Qt::Key_Return);
  ASSERT_TRUE(is_shown());
  EXPECT_FALSE(session().is_away());
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(find<QPushButton>("home_start")->text(), QStringLiteral("Continue the session"));
  QTest::keyClick(find<QPushButton>("home_start"), Qt::Key_Return);
  EXPECT_TRUE(find("session_bar")->isVisible());
}

TEST_F(Study, TheEndTellsWhatWasDoneAndWhatComes) {
  start();
  learn();
  shown_character_ = 0;
  press(Qt::Key_3);
  // The review in ten minutes is asked now, because nothing else is due.
  ASSERT_TRUE(session().is_running());
  ASSERT_TRUE(is_shown());
  write_from_memory(true);
  press(Qt::Key_3);
  EXPECT_FALSE(session().is_running());
  EXPECT_TRUE(find("home_page")->isVisible());
  EXPECT_EQ(text("home_ink_title"), QStringLiteral("Today, in your hand"));
  EXPECT_EQ(text("home_written"), QStringLiteral("2 written, 2 right · less than a minute"));
  EXPECT_EQ(find<InkRow>("ink_row")->inks().size(), 1U) << "one of each character";
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("Done for today")))
      << text("home_advice").toStdString();
  EXPECT_FALSE(find("home_start")->isVisible());
  EXPECT_TRUE(text("home_day").endsWith(QStringLiteral("1 day in a row")));
  EXPECT_TRUE(find("home_more")->isVisible()) << "more may be learned";
  EXPECT_EQ(window_->focusWidget(), find("home_advice")) << "it is read aloud";
  press(Qt::Key_Return);
  press(Qt::Key_Space);
  EXPECT_FALSE(session().is_running()) << "one key too many begins nothing";
}

TEST_F(Study, FiveMoreNewCharactersComeByOneKeyAfterTheGoalOfTheDay) {
  start();
  learn();
  press(Qt::Key_4);
  ASSERT_TRUE(find("home_page")->isVisible());
  press(Qt::Key_F);
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().total(), 5);
  EXPECT_EQ(session().character(), U'二');
  session().end();
  press(Qt::Key_A);
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'一') << "the next to become due";
}

TEST_F(Study, WhatWasHardTodayIsPractisedByOneKey) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  press(Qt::Key_P);
  write_from_memory(false);
  go_on();
  session().end();
  EXPECT_EQ(text("home_written"), QStringLiteral("1 written, 0 right · less than a minute"));
  EXPECT_EQ(find<QPushButton>("home_practise")->text(), QStringLiteral("Practise these, 1 min"));
  press(Qt::Key_P);
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'一');
  EXPECT_EQ(session().stage(), study::Stage::memory);
}

TEST_F(Study, WhatIsTakenBackIsNoLongerShownAsWritten) {
  start();
  learn();
  press(Qt::Key_4);
  ASSERT_TRUE(find("home_written")->isVisible());
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(find("home_written")->isVisible());
  EXPECT_FALSE(find("ink_row")->isVisible());
}

TEST_F(Study, WhatWasKeptLastStandsAboveTheButtonThatTakesItBack) {
  start();
  EXPECT_FALSE(find("session_note")->isVisible());
  learn();
  shown_character_ = 0;
  press(Qt::Key_3);
  ASSERT_TRUE(session().is_running());
  ASSERT_TRUE(is_shown());
  EXPECT_FALSE(feedback().contains(QStringLiteral("Kept"))) << "the next task has words of its own";
  EXPECT_TRUE(text("session_note").contains(QStringLiteral("Good. Next review in 10 minutes")))
      << text("session_note").toStdString();
  EXPECT_TRUE(find("session_note")->isVisible());
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(text("session_note").contains(QStringLiteral("Undone"))) << text("session_note").toStdString();
}

TEST_F(Study, AnAcceptedWritingThatTookHintsSaysWhyLessIsProposed) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  press(Qt::Key_H);
  press(Qt::Key_H);
  write_from_memory(true);
  EXPECT_EQ(session().proposed(), Rating::again);
  ASSERT_TRUE(find("session_reason")->isVisible());
  EXPECT_EQ(text("session_reason"), QStringLiteral("Suggested: Again (several hints)"));
}

TEST_F(Study, TheTabletKeepsItsPlaceWhateverIsSaidUnderIt) {
  start();
  ASSERT_TRUE(is_shown());
  const auto tablet = [this] {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QCoreApplication::processEvents();
    return find("tablet")->geometry();
  };
  the_parts->announce(Feedback::hint, QStringLiteral("Short."));
  const QRect before = tablet();
  const int top = find("tablet")->mapTo(window_.get(), QPoint()).y();
  the_parts->announce(Feedback::hint,
                      QStringLiteral("A sentence as long as those that explain two faults of a writing "
                                     "at once, which takes a second line in a window like this."));
  ASSERT_GT(find<QLabel>("feedback_text")->heightForWidth(find("feedback_text")->width()),
            find("feedback_text")->fontMetrics().lineSpacing() * 3 / 2);
  EXPECT_EQ(tablet(), before);
  learn();
  EXPECT_TRUE(find("button_rate_good")->isVisible());
  // The information comes back beside it.
  EXPECT_EQ(tablet().height(), before.height());
  EXPECT_EQ(find("tablet")->mapTo(window_.get(), QPoint()).y(), top);
}

}  // namespace
}  // namespace nazori::ui
