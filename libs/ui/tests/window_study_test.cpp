// SPDX-License-Identifier: Apache-2.0
#include <QAbstractButton>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <algorithm>
#include <map>

#include "characters/character_actions.h"
#include "characters/characters.h"
#include "characters/memory_stage.h"
#include "characters/watch_stage.h"
#include "desk.h"
#include "hand_under_test.h"
#include "nazori/study/backups.h"
#include "study/home.h"
#include "study/ink_gallery.h"
#include "study/study_words.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using study::Rating;
using State = StudySession::State;

Desk* the_desk = nullptr;
Characters* the_characters = nullptr;

std::unique_ptr<Workplace> make_home(Desk& desk) { return std::make_unique<Home>(desk); }

std::unique_ptr<Workplace> make_characters(Desk& desk) {
  the_desk = &desk;
  auto made = std::make_unique<Characters>(desk);
  the_characters = made.get();
  return made;
}

/// A learner of characters of few strokes, with a clock that the test moves.
class Study : public WindowTest {
 protected:
  Study() {
    workplaces_ = {make_home, make_characters};
    clock_ = [this] { return now_; };
  }

  void SetUp() override {
    install_language(QStringLiteral("en"));
    auto store = study::LearnerStore::open(learner_file(), study::Access::write, clock_);
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->save_list({"few", {U'一', U'二', U'十', U'人', U'八', U'入', U'丁'}}));
    study::Settings settings;
    settings.time_zone = "UTC";
    settings.new_lists = {"list:few"};
    settings.new_order = study::NewOrder::own;
    settings.new_per_day = 1;
    ASSERT_TRUE(store->change_settings(settings));
    store = study::LearnerStore::in_memory(clock_);
    open_home();
  }

  [[nodiscard]] std::filesystem::path learner_file() const {
    return std::filesystem::path(folder_.filePath(QStringLiteral("learners")).toStdString()) / "learner" /
           "learner.db";
  }

  void open_home() {
    window_.reset();
    window_ = std::make_unique<MainWindow>(setup(), appearance_);
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    QObject::connect(window_.get(), &MainWindow::character_shown, [this](char32_t c) { on_desk_ = c; });
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    ASSERT_TRUE(opened.count() > 0 || opened.wait(20000));
    window_->resize(1280, 800);
    the_desk->session().set_asks_by_words(false);
    QCoreApplication::processEvents();
  }

  static StudySession& session() { return the_desk->session(); }
  static study::LearnerStore& store() { return the_desk->learner().store(); }

  void start() {
    ASSERT_TRUE(find("home_page")->isVisible());
    ASSERT_TRUE(find<QPushButton>("home_start")->isVisible()) << text("home_advice").toStdString();
    on_desk_ = 0;
    QTest::keyClick(find<QPushButton>("home_start"), Qt::Key_Return);
    ASSERT_TRUE(session().is_running());
  }

  /// A character is learnt today and lies on the desk as a review eight days later.
  void learn_and_come_back() {
    start();
    learn();
    press(Qt::Key_4);
    now_ += std::chrono::days(8);
    open_home();
    start();
    ASSERT_TRUE(is_on_desk());
  }

  bool is_on_desk() {
    return QTest::qWaitFor([&] { return on_desk_ == session().character(); }, 20000);
  }

  /// Writes from memory as the model is, or gives up; the judgement stands then.
  void write_from_memory(bool well) {
    ASSERT_EQ(session().stage(), study::Stage::memory);
    const char32_t character = session().character();
    if (!well) {
      press(Qt::Key_G);
    } else {
      double time_s = 0;
      for (const auto& line : test::model(character)) {
        HandStroke stroke;
        for (double at = 0; at <= geometry::arc_length<geometry::GlyphFrame>(line); at += 1)
          stroke.push_back({geometry::glyph_to_tablet(geometry::point_at<geometry::GlyphFrame>(line, at), {}),
                            time_s += 0.01, 0.5});
        the_characters->findChild<MemoryStage*>()->add_stroke(stroke);
      }
    }
    ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000))
        << feedback().toStdString();
  }

  /// The stage at hand, done well.
  void do_stage() {
    ASSERT_TRUE(is_on_desk());
    switch (session().stage()) {
      case study::Stage::watch:
        ASSERT_TRUE(action("watch")->isChecked());
        action("play")->setChecked(false);
        for (int i = 0; i < 30 && session().state() == State::doing; ++i) action("step_on")->trigger();
        break;
      case study::Stage::trace:
      case study::Stage::guided:
        for (const auto& line : test::model(session().character())) test::write(the_desk->controller(), line);
        break;
      case study::Stage::memory:
        write_from_memory(true);
        return;
    }
    ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::offered; }, 5000))
        << feedback().toStdString();
  }

  /// Enter goes on; another character is waited for.
  void go_on() {
    const char32_t before = session().character();
    on_desk_ = 0;
    press(Qt::Key_Return);
    if (session().is_running() && session().character() == before) on_desk_ = before;
  }

  /// A new character up to its judgement.
  void learn() {
    while (session().state() != State::judged) {
      do_stage();
      if (HasFatalFailure()) return;
      if (session().state() == State::offered) go_on();
    }
  }

  int reviews_in_log() {
    int count = 0;
    EXPECT_TRUE(store().for_each_entry(true, [&](const study::LearnerStore::LoggedEntry& logged) {
      count +=
          logged.entry.kind == study::EntryKind::writing && logged.entry.writing.stage == study::Stage::memory
              ? 1
              : 0;
      return true;
    }));
    return count;
  }

  study::Time now_ = *study::parse_time("2026-03-02T10:00Z");
  char32_t on_desk_ = 0;
};

TEST_F(Study, TheWindowOpensWithWhatIsDueAndOneKeyStarts) {
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Home – Nazori"));
  EXPECT_EQ(text("home_due"), QStringLiteral("0"));
  EXPECT_EQ(text("home_new"), QStringLiteral("1"));
  EXPECT_EQ(text("home_time"), QStringLiteral("3"));
  EXPECT_EQ(text("home_streak"), QStringLiteral("0"));
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("一")));
  EXPECT_EQ(window_->focusWidget(), find("home_start"));
  start();
  ASSERT_TRUE(is_on_desk());
  EXPECT_TRUE(find("session_bar")->isVisible());
  EXPECT_TRUE(find("session_panel")->isVisible());
  EXPECT_FALSE(find("library_panel")->isVisible());
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
  EXPECT_TRUE(find<QPushButton>("button_rate_good")->accessibleName().contains(QStringLiteral("proposed")));
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
  the_desk->preferences().one_hand = OneHand::left;
  the_desk->note_study_settings();
  while (session().state() != State::judged) {
    do_stage();
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_EQ(twice(), 0);
    if (session().state() == State::offered) go_on();
  }
  the_desk->preferences().one_hand = OneHand::right;
  the_desk->note_study_settings();
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
  EXPECT_EQ(text("home_due"), QStringLiteral("1"));
  start();
  ASSERT_TRUE(is_on_desk());
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
  // One review in three asks so; the character and the number of its reviews decide.
  now_ += std::chrono::days(8);
  open_home();
  the_desk->session().set_asks_by_words(true);
  start();
  ASSERT_TRUE(is_on_desk());
  const bool by_word = (reps + static_cast<int>(U'一')) % 3 == 0;
  EXPECT_EQ(session().word() != nullptr, by_word);
  if (by_word) {
    EXPECT_TRUE(text("session_question").contains(QStringLiteral("◯")));
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
  EXPECT_GT(the_desk->controller().overlay().lines_opacity, 0.2);
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
  ASSERT_TRUE(is_on_desk());
  auto* memory = the_characters->findChild<MemoryStage*>();
  HandStroke down;
  for (int i = 0; i <= 40; ++i) down.push_back({{0.01, 0.03 - i * 0.0015}, i * 0.01, 0.5});
  for (int miss = 1; miss <= 3; ++miss) {
    the_desk->say(Feedback::hint, QStringLiteral("not judged yet"));
    memory->add_stroke(down);
    ASSERT_TRUE(QTest::qWaitFor([&] { return feedback() != QStringLiteral("not judged yet"); }, 20000));
    EXPECT_EQ(memory->strokes().size(), miss < 3 ? 1U : 0U) << "the refused one made room";
    EXPECT_EQ(feedback().contains(QStringLiteral("H shows where")), miss == 2) << feedback().toStdString();
  }
  EXPECT_TRUE(feedback().contains(QStringLiteral("Stroke 1 is shown in blue"))) << feedback().toStdString();
  write_from_memory(true);
  EXPECT_EQ(session().proposed(), Rating::again) << "it had to be shown";
}

TEST_F(Study, GoingElsewhereKeepsTheSessionAndEnterComesBack) {
  start();
  ASSERT_TRUE(is_on_desk());
  show(U'雨');
  EXPECT_TRUE(session().is_away());
  EXPECT_TRUE(find("session_next")->isVisible());
  on_desk_ = 0;
  press(Qt::Key_Return);
  ASSERT_TRUE(is_on_desk());
  EXPECT_FALSE(session().is_away());
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(find<QPushButton>("home_start")->text(), QStringLiteral("Go on with the session"));
  QTest::keyClick(find<QPushButton>("home_start"), Qt::Key_Return);
  EXPECT_TRUE(find("session_bar")->isVisible());
}

TEST_F(Study, TheEndTellsWhatWasDoneAndWhatComes) {
  start();
  learn();
  press(Qt::Key_3);
  // The step of ten minutes is near enough with nothing else to do.
  ASSERT_TRUE(session().is_running());
  on_desk_ = 0;
  ASSERT_TRUE(is_on_desk());
  write_from_memory(true);
  press(Qt::Key_3);
  EXPECT_FALSE(session().is_running());
  EXPECT_TRUE(find("home_page")->isVisible());
  EXPECT_TRUE(text("home_summary").contains(QStringLiteral("2 written from memory")))
      << text("home_summary").toStdString();
  EXPECT_TRUE(text("home_summary").contains(QStringLiteral("Good 2")));
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("Done for today")))
      << text("home_advice").toStdString();
  EXPECT_FALSE(find("home_start")->isVisible());
  EXPECT_EQ(text("home_streak"), QStringLiteral("1"));
}

TEST_F(Study, UndoFromHomeTakesBackReviewsOfOtherDaysToo) {
  start();
  learn();
  press(Qt::Key_4);
  ASSERT_EQ(reviews_in_log(), 1);
  now_ += std::chrono::days(1);
  open_home();
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(feedback().contains(QStringLiteral("Taken back: the last writing of 一")))
      << feedback().toStdString();
  EXPECT_EQ(reviews_in_log(), 0);
  EXPECT_EQ(store().card(U'一').next_stage, study::Stage::memory);
}

TEST_F(Study, WhatIsTakenBackIsNoLongerInTheSummary) {
  start();
  learn();
  press(Qt::Key_4);
  ASSERT_TRUE(find("home_summary")->isVisible());
  EXPECT_EQ(text("home_streak"), QStringLiteral("1"));
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(find("home_summary")->isVisible());
}

TEST_F(Study, WhatWasKeptLastStandsAboveTheButtonThatTakesItBack) {
  start();
  EXPECT_FALSE(find("session_note")->isVisible());
  learn();
  press(Qt::Key_3);
  ASSERT_TRUE(session().is_running());
  on_desk_ = 0;
  ASSERT_TRUE(is_on_desk());
  EXPECT_FALSE(feedback().contains(QStringLiteral("Kept"))) << "the next task has words of its own";
  EXPECT_TRUE(text("session_note").contains(QStringLiteral("“Good” and comes in 10 minutes")))
      << text("session_note").toStdString();
  EXPECT_TRUE(find("session_note")->isVisible());
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(text("session_note").contains(QStringLiteral("Taken back")))
      << text("session_note").toStdString();
}

TEST_F(Study, AnAcceptedWritingThatTookHintsSaysWhyLessIsProposed) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  press(Qt::Key_H);
  press(Qt::Key_H);
  EXPECT_FALSE(find("session_help")->isVisible());
  write_from_memory(true);
  EXPECT_EQ(session().proposed(), Rating::again);
  EXPECT_TRUE(find("session_help")->isVisible());
  EXPECT_EQ(text("session_help"), QStringLiteral("“Again” is proposed: 2 hints."));
}

TEST_F(Study, TheTabletKeepsItsPlaceWhateverIsSaidUnderIt) {
  start();
  ASSERT_TRUE(is_on_desk());
  const auto tablet = [this] {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QCoreApplication::processEvents();
    return find("tablet")->geometry();
  };
  the_desk->say(Feedback::hint, QStringLiteral("Short."));
  const QRect before = tablet();
  the_desk->say(Feedback::hint,
                QStringLiteral("A sentence as long as those that explain two faults of a writing "
                               "at once, which takes a second line in a window like this."));
  ASSERT_GT(find<QLabel>("feedback_text")->heightForWidth(find("feedback_text")->width()),
            find("feedback_text")->fontMetrics().lineSpacing() * 3 / 2);
  EXPECT_EQ(tablet(), before);
  learn();
  EXPECT_TRUE(find("button_rate_good")->isVisible());
  EXPECT_EQ(tablet(), before);
}

TEST_F(Study, ASecondWindowIsToldAndChangesNothing) {
  start();
  learn();
  press(Qt::Key_4);
  MainWindow::Setup second_setup = setup();
  second_setup.settings_file = folder_.filePath(QStringLiteral("second.ini"));
  Desk* const first_desk = the_desk;
  Characters* const first_characters = the_characters;
  {
    MainWindow second(second_setup, appearance_);
    second.show();
    const auto* trouble = second.findChild<QLabel*>(QStringLiteral("home_trouble"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return trouble->isVisible(); }));
    EXPECT_TRUE(trouble->text().contains(QStringLiteral("another window"))) << trouble->text().toStdString();
    EXPECT_FALSE(second.findChild<QPushButton*>(QStringLiteral("home_start"))->isVisible());
    EXPECT_TRUE(second.findChild<QPushButton*>(QStringLiteral("home_try_again"))->isVisible());
    EXPECT_EQ(the_desk->learner().store().card(U'一').memory.reps, 1) << "reading is possible";
  }
  the_desk = first_desk;
  the_characters = first_characters;
  EXPECT_TRUE(the_desk->learner().can_write());
}

TEST_F(Study, ABackupThatFailedStaysSaidAtHome) {
  window_.reset();
  const auto backups = learner_file().parent_path() / "backups";
  std::filesystem::remove_all(backups);
  std::filesystem::copy_file(learner_file(), backups);
  open_home();
  ASSERT_TRUE(QTest::qWaitFor([this] { return find("home_trouble")->isVisible(); }, 20'000));
  EXPECT_TRUE(text("home_trouble").startsWith(QStringLiteral("Today's backup could not be made")));
  EXPECT_TRUE(find("home_trouble")->isVisible());
  EXPECT_TRUE(find<QPushButton>("home_start")->isVisible()) << "studying works";
  emit the_desk->learner().changed();
  EXPECT_TRUE(find("home_trouble")->isVisible());
  window_.reset();
  std::filesystem::remove(backups);
  open_home();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !study::backups_of(learner_file()).empty(); }, 20'000));
  EXPECT_FALSE(find("home_trouble")->isVisible());
}

TEST_F(Study, AfterAMonthAwayThereIsAPlanAndNoWall) {
  start();
  learn();
  press(Qt::Key_4);
  auto settings = store().settings();
  settings.reviews_per_day = 1;
  settings.new_per_day = 4;
  ASSERT_TRUE(store().change_settings(settings));
  for (const char32_t character : {U'二', U'十', U'人'}) {
    study::Writing writing;
    writing.rating = Rating::easy;
    ASSERT_TRUE(store().add_writing(character, 2, writing));
  }
  now_ += std::chrono::days(40);
  open_home();
  EXPECT_EQ(text("home_due"), QStringLiteral("1"));
  EXPECT_EQ(text("home_new"), QStringLiteral("0"));
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("4 reviews have piled up")))
      << text("home_advice").toStdString();
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("4 days")));
}

TEST_F(Study, AWeekThroughTheWindowAndAMonthAwayLoseNothingThatWasRatedWhateverEndsThem) {
  int rated = 0;
  std::map<char32_t, int> seen;
  for (int day = 0; day < 7; ++day) {
    now_ = *study::parse_time("2026-03-02T10:00Z") + std::chrono::days(day);
    open_home();
    ASSERT_EQ(reviews_in_log(), rated) << "day " << day;
    ASSERT_TRUE(find<QPushButton>("home_start")->isVisible()) << "day " << day;
    on_desk_ = 0;
    start();
    int steps = 0;
    while (session().is_running() && ++steps < 60) {
      ASSERT_TRUE(is_on_desk());
      const char32_t character = session().character();
      if (session().stage() == study::Stage::memory) {
        // On the fourth day one is forgotten.
        write_from_memory(!(day == 3 && steps == 1));
        ASSERT_FALSE(HasFatalFailure());
        ++seen[character];
        ++rated;
        on_desk_ = 0;
        press(Qt::Key_Return);
        if (session().is_running() && session().character() == character &&
            session().stage() != study::Stage::memory)
          on_desk_ = character;
      } else {
        do_stage();
        ASSERT_FALSE(HasFatalFailure()) << "day " << day << ", step " << steps;
        go_on();
      }
      // On the third day the window goes in the middle, with a stage half done.
      if (day == 2 && rated > 0 && steps == 2) break;
    }
    if (day != 2) {
      EXPECT_FALSE(session().is_running());
      EXPECT_TRUE(find("home_page")->isVisible());
    }
    window_.reset();
  }
  open_home();
  EXPECT_EQ(reviews_in_log(), rated);
  EXPECT_EQ(seen.size(), 7U) << "one new a day";
  EXPECT_EQ(text("home_streak"), QStringLiteral("7"));
  const auto rebuilt = store().rebuild();
  ASSERT_TRUE(rebuilt);
  EXPECT_EQ(rebuilt->differences, 0);

  // Six weeks later, for a learner of four reviews a day: half of them on the first day back.
  auto settings = store().settings();
  settings.reviews_per_day = 4;
  settings.new_per_day = 2;
  ASSERT_TRUE(store().change_settings(settings));
  now_ = *study::parse_time("2026-04-20T10:00Z");
  open_home();
  EXPECT_EQ(text("home_due"), QStringLiteral("2"));
  EXPECT_EQ(text("home_new"), QStringLiteral("0"));
  EXPECT_EQ(text("home_streak"), QStringLiteral("0"));
  // Of seven two, three and then the last two.
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("7 reviews have piled up. No hurry: today 2")))
      << text("home_advice").toStdString();
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("Catching up takes 3 days")))
      << text("home_advice").toStdString();
  on_desk_ = 0;
  start();
  for (int review = 0; review < 2; ++review) {
    ASSERT_TRUE(session().is_running());
    ASSERT_TRUE(is_on_desk());
    EXPECT_EQ(session().task().kind, study::TaskKind::review);
    write_from_memory(true);
    ASSERT_FALSE(HasFatalFailure());
    ++rated;
    on_desk_ = 0;
    press(Qt::Key_Return);
  }
  EXPECT_FALSE(session().is_running());
  EXPECT_TRUE(text("home_summary").contains(QStringLiteral("2 written from memory")));
  EXPECT_TRUE(text("home_advice").contains(QStringLiteral("your limit is reached")))
      << text("home_advice").toStdString();
  EXPECT_EQ(reviews_in_log(), rated);

  // Every one of them can be taken back, to the first.
  int taken_back = 0;
  while (reviews_in_log() > 0 && taken_back < 500) {
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    ++taken_back;
  }
  EXPECT_GE(taken_back, rated);
}

/// Does something with a modal dialog as soon as it is there.
void with_dialog(const char* name, const std::function<void(QWidget*)>& what) {
  auto* timer = new QTimer;
  timer->setInterval(20);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, name, what] {
    auto* dialog = QApplication::activeModalWidget();
    if (dialog == nullptr || dialog->objectName() != QString::fromLatin1(name)) return;
    timer->deleteLater();
    timer->stop();
    what(dialog);
  });
  timer->start();
}

TEST_F(Study, SettingsAreChosenInTheWindowAndHoldAtOnce) {
  with_dialog("study_settings_dialog", [](QWidget* dialog) {
    dialog->findChild<QSpinBox*>(QStringLiteral("study_new"))->setValue(3);
    dialog->findChild<QSpinBox*>(QStringLiteral("study_reviews"))->setValue(40);
    auto* order = dialog->findChild<QComboBox*>(QStringLiteral("study_order"));
    order->setCurrentIndex(order->findData(static_cast<int>(study::NewOrder::strokes)));
    const auto* workload = dialog->findChild<QLabel*>(QStringLiteral("study_workload"));
    EXPECT_TRUE(workload->text().contains(QStringLiteral("3 new a day"))) << workload->text().toStdString();
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  });
  press(Qt::Key_Comma, Qt::ControlModifier);
  EXPECT_EQ(store().settings().new_per_day, 3);
  EXPECT_EQ(store().settings().reviews_per_day, 40);
  EXPECT_EQ(store().settings().new_order, study::NewOrder::strokes);
  EXPECT_EQ(text("home_new"), QStringLiteral("3"));
}

TEST_F(Study, AListFromTextIsTakenAndABadLineRefusedWithItsNumber) {
  with_dialog("study_settings_dialog", [](QWidget* dialog) {
    with_dialog("new_list_dialog", [](QWidget* list) {
      list->findChild<QLineEdit*>(QStringLiteral("new_list_name"))->setText(QStringLiteral("week"));
      auto* words = list->findChild<QPlainTextEdit*>(QStringLiteral("new_list_text"));
      words->setPlainText(QStringLiteral("月火水\n월木"));
      list->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
      const auto* trouble = list->findChild<QLabel*>(QStringLiteral("new_list_trouble"));
      EXPECT_TRUE(trouble->text().contains(QLatin1Char('2'))) << trouble->text().toStdString();
      words->setPlainText(QStringLiteral("月火水 # three days\n木"));
      list->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    });
    dialog->findChild<QPushButton*>(QStringLiteral("list_new"))->click();
    auto* lists = dialog->findChild<QListWidget*>(QStringLiteral("study_lists"));
    EXPECT_EQ(lists->currentItem()->text(), QStringLiteral("Own list: week"));
    EXPECT_EQ(lists->currentItem()->checkState(), Qt::Checked);
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  });
  press(Qt::Key_Comma, Qt::ControlModifier);
  EXPECT_EQ(store().settings().new_lists, (std::vector<std::string>{"list:few", "list:week"}));
}

TEST_F(Study, ALeftHandedLayoutChangesSides) {
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return on_desk_ != 0; }, 20000));
  const auto x_of = [this](const char* name) { return find(name)->mapTo(window_.get(), QPoint()).x(); };
  EXPECT_LT(x_of("library_panel"), x_of("information_panel"));
  the_desk->preferences().left_handed = true;
  the_desk->note_study_settings();
  QCoreApplication::processEvents();
  EXPECT_GT(x_of("library_panel"), x_of("information_panel"));
  EXPECT_GE(find("tablet")->width(), 639);
}

}  // namespace
}  // namespace nazori::ui
