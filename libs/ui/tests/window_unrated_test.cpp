// SPDX-License-Identifier: Apache-2.0
// What stays and what is lost while a writing waits for its rating: other pages, looks, learners, closing.
#include <QAbstractButton>
#include <QComboBox>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>

#include "characters/character_actions.h"
#include "characters/characters.h"
#include "hand_under_test.h"
#include "nazori/widgets/page/window_parts.h"
#include "study/home.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using State = practice::StudySession::State;

WindowParts* the_parts = nullptr;
Characters* the_characters = nullptr;

std::unique_ptr<Page> make_home(WindowParts& parts) { return std::make_unique<Home>(parts); }

std::unique_ptr<Page> make_characters(WindowParts& parts) {
  the_parts = &parts;
  auto made = std::make_unique<Characters>(parts);
  the_characters = made.get();
  return made;
}

/// A session that asks for 人 from memory.
class Unrated : public WindowTest {
 protected:
  Unrated() {
    pages_ = {make_home, make_characters};
    clock_ = [] { return *study::parse_time("2026-03-02T10:00Z"); };
  }

  void SetUp() override {
    install_language(QStringLiteral("en"));
    const auto file = std::filesystem::path(folder_.filePath(QStringLiteral("learners")).toStdString()) /
                      "learner" / "learner.db";
    auto store = study::LearnerStore::open(file, study::Access::write, clock_);
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->save_list({"few", {U'人', U'八'}}));
    study::Settings settings;
    settings.time_zone = "UTC";
    settings.new_lists = {"list:few"};
    settings.new_order = study::NewOrder::own;
    settings.new_per_day = 1;
    ASSERT_TRUE(store->change_settings(settings));
    store = study::LearnerStore::in_memory(clock_);
    open();
  }

  void open() {
    window_ = std::make_unique<MainWindow>(setup(), appearance_);
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    ASSERT_TRUE(opened.count() > 0 || opened.wait(20000));
    window_->resize(1280, 800);
    the_parts->session().set_asks_by_words(false);
  }

  static practice::StudySession& session() { return the_parts->session(); }
  static practice::MemoryStage& memory() { return the_parts->practice().memory(); }
  static std::size_t lines_on_tablet() { return the_parts->tablet().overlay().writing.size(); }
  static int reps() { return the_parts->learner().store().card(U'人').memory.reps; }

  /// Starts a session and finishes the stages before the question from memory.
  void ask() {
    QSignalSpy shown(window_.get(), &MainWindow::character_shown);
    action("home_study")->trigger();
    ASSERT_TRUE(session().is_running());
    ASSERT_TRUE(shown.count() > 0 || shown.wait(20000));
    while (session().stage() != study::Stage::memory || session().state() != State::doing) {
      if (session().state() == State::doing) session().finish_stage(session().stage(), {});
      ASSERT_EQ(session().state(), State::offered);
      session().go_on();
    }
    ASSERT_EQ(session().character(), U'人');
    ASSERT_TRUE(action("memory")->isChecked());
  }

  static practice::HandStroke stroke(int number) {
    practice::HandStroke made;
    const auto line = test::model(U'人')[static_cast<std::size_t>(number - 1)];
    double time_s = number;
    for (double at = 0; at <= geometry::arc_length<geometry::GlyphFrame>(line); at += 1)
      made.push_back({geometry::glyph_to_tablet(geometry::point_at<geometry::GlyphFrame>(line, at), {}),
                      time_s += 0.01, 0.5});
    return made;
  }

  void write() {
    memory().add_stroke(stroke(1));
    memory().add_stroke(stroke(2));
    ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000))
        << feedback().toStdString();
  }

  void write_what_is_asked() {
    ask();
    if (!HasFatalFailure()) write();
  }

  void away_and_back() {
    window_->go_to(QStringLiteral("home"));
    window_->go_to(QStringLiteral("characters"));
  }

  /// The number of keys that belong to more than one visible and enabled action.
  int keys_with_two_meanings() {
    QStringList keys;
    for (const auto* entry : window_->findChildren<QAction*>())
      if (entry->isVisible() && entry->isEnabled())
        for (const auto& key : entry->shortcuts()) keys.append(key.toString());
    return static_cast<int>(keys.removeDuplicates());
  }

  /// Answers the question when the window closes: presses the first button whose text begins with `words`.
  void answer_with(const QString& words) {
    auto* timer = new QTimer(window_.get());
    connect_answer(timer, words);
    timer->start(10);
  }
  void connect_answer(QTimer* timer, const QString& words) {
    QObject::connect(timer, &QTimer::timeout, window_.get(), [this, timer, words] {
      auto* box = find<QMessageBox>("unrated_box");
      if (box == nullptr || !box->isVisible()) return;
      timer->stop();
      question_ = box->text();
      for (auto* button : box->buttons())
        if (button->text().startsWith(words)) return button->click();
      box->reject();
    });
  }

  QString question_;  ///< that closing asked
};

TEST_F(Unrated, AJudgedWritingIsThereAgainAfterAnotherPageAndEnterRatesIt) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  const auto before = lines_on_tablet();
  const QString verdict = feedback();
  away_and_back();
  EXPECT_EQ(memory().strokes().size(), 2U);
  EXPECT_EQ(lines_on_tablet(), before);
  EXPECT_EQ(feedback(), verdict);
  EXPECT_TRUE(find("writing_report")->isVisible());
  EXPECT_TRUE(find("button_rate_good")->isVisible());
  EXPECT_EQ(keys_with_two_meanings(), 0);
  press(Qt::Key_Return);
  EXPECT_EQ(reps(), 1);
}

TEST_F(Unrated, AJudgedWritingIsThereAgainAfterALookAtTheStrokes) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  press(Qt::Key_F5);
  EXPECT_EQ(keys_with_two_meanings(), 0);
  press(Qt::Key_F8);
  EXPECT_EQ(memory().strokes().size(), 2U);
  EXPECT_EQ(keys_with_two_meanings(), 0);
  press(Qt::Key_Return);
  EXPECT_EQ(reps(), 1);
}

TEST_F(Unrated, AJudgedWritingIsThereAgainAfterAnotherCharacterWasWritten) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  show(U'八');
  EXPECT_TRUE(memory().strokes().empty()) << "this one is not written yet";
  memory().add_stroke(stroke(1));
  EXPECT_EQ(keys_with_two_meanings(), 0) << "Enter judges what is written";
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  session().go_on();
  ASSERT_TRUE(shown.wait(20000));
  EXPECT_EQ(memory().strokes().size(), 2U);
  EXPECT_EQ(session().state(), State::judged);
  press(Qt::Key_Return);
  EXPECT_EQ(reps(), 1);
}

TEST_F(Unrated, WhatIsHalfWrittenGoesOnAfterAnotherPage) {
  ask();
  ASSERT_FALSE(HasFatalFailure());
  memory().add_stroke(stroke(1));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return feedback().contains(QStringLiteral("Stroke 1 is correct")); }, 20000));
  away_and_back();
  ASSERT_EQ(memory().strokes().size(), 1U);
  EXPECT_EQ(keys_with_two_meanings(), 0);
  memory().add_stroke(stroke(2));
  ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000))
      << feedback().toStdString();
}

TEST_F(Unrated, TakenBackAfterAnotherPageEnterStillHasOneMeaning) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  away_and_back();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(memory().strokes().size(), 1U);
  EXPECT_EQ(keys_with_two_meanings(), 0);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(keys_with_two_meanings(), 0);
  press(Qt::Key_Return);
  EXPECT_EQ(reps(), 1) << "nothing is written that could be judged: Enter rates";
}

TEST_F(Unrated, WhatIsRatedDoesNotComeBack) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  press(Qt::Key_4);
  ASSERT_EQ(reps(), 1);
  window_->go_to(QStringLiteral("characters"));
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  window_->show_character(U'人');
  shown.wait(20000);
  press(Qt::Key_F8);
  EXPECT_TRUE(memory().strokes().empty());
}

TEST_F(Unrated, AnotherLearnerSeesNeitherTheInkNorTheSummaryOfTheLast) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  press(Qt::Key_4);
  session().end();
  window_->go_to(QStringLiteral("home"));
  ASSERT_TRUE(find("home_written")->isVisible());
  window_->go_to(QStringLiteral("characters"));
  press(Qt::Key_F8);
  memory().add_stroke(stroke(1));
  window_->go_to(QStringLiteral("home"));
  ASSERT_TRUE(the_parts->learner().switch_profile("aiko"));
  EXPECT_FALSE(find("home_written")->isVisible());
  window_->go_to(QStringLiteral("characters"));
  press(Qt::Key_F8);
  EXPECT_TRUE(memory().strokes().empty());
}

TEST_F(Unrated, QuittingAsksAndGoingBackLosesNothing) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  answer_with(QStringLiteral("Go back"));
  action("quit")->trigger();
  EXPECT_EQ(question_, QStringLiteral("Your writing of 人 is not rated yet."));
  EXPECT_TRUE(window_->isVisible());
  EXPECT_EQ(session().state(), State::judged);
  EXPECT_EQ(memory().strokes().size(), 2U);
}

TEST_F(Unrated, QuittingCanRateFirst) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  answer_with(QStringLiteral("Rate as"));
  action("quit")->trigger();
  EXPECT_FALSE(window_->isVisible());
  EXPECT_EQ(reps(), 1);
}

TEST_F(Unrated, QuittingWithoutRatingSavesNoRating) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  answer_with(QStringLiteral("Quit"));
  EXPECT_TRUE(window_->close());
  EXPECT_FALSE(window_->isVisible());
  EXPECT_EQ(reps(), 0);
}

TEST_F(Unrated, AnotherLanguageIsChosenOnlyOnceTheWritingIsRatedOrGivenUp) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  QSignalSpy chosen(window_.get(), &MainWindow::language_chosen);
  answer_with(QStringLiteral("Go back"));
  action("language_japanese")->trigger();
  EXPECT_EQ(question_, QStringLiteral("Your writing of 人 is not rated yet."));
  EXPECT_EQ(chosen.count(), 0);
  EXPECT_TRUE(action("language_desktop")->isChecked());
  EXPECT_EQ(session().state(), State::judged);
  answer_with(QStringLiteral("Rate as"));
  action("language_japanese")->trigger();
  EXPECT_EQ(chosen.count(), 1);
  EXPECT_EQ(reps(), 1);
}

TEST_F(Unrated, QuittingWithNothingUnratedAsksNothing) {
  ask();
  ASSERT_FALSE(HasFatalFailure());
  answer_with(QStringLiteral("Go back"));
  EXPECT_TRUE(window_->close());
  EXPECT_TRUE(question_.isEmpty());
}

TEST_F(Unrated, TheQuestionAndTheHeadingTakeAnotherLookAtOnce) {
  ask();
  ASSERT_FALSE(HasFatalFailure());
  const double small = QFontInfo(window_->font()).pointSizeF();
  const auto asked = [this] { return text("session_question"); };
  ASSERT_TRUE(asked().contains(QStringLiteral("font-size:%1pt").arg(small * 1.8))) << asked().toStdString();
  action("text_larger")->trigger();
  action("text_larger")->trigger();
  const double large = QFontInfo(window_->font()).pointSizeF();
  ASSERT_GT(large, small);
  EXPECT_TRUE(asked().contains(QStringLiteral("font-size:%1pt").arg(large * 1.8))) << asked().toStdString();
  for (auto* label : window_->findChildren<QLabel*>())
    if (label->isVisible() && !label->text().isEmpty()) {
      EXPECT_GE(QFontInfo(label->font()).pointSizeF(), large * 0.85) << label->objectName().toStdString();
    }
}

TEST_F(Unrated, WithTheLargestTextEveryButtonOfTheSessionIsInTheWindow) {
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  while (action("text_larger")->isEnabled()) action("text_larger")->trigger();
  resize(1280, 800);
  for (const char* name : {"button_rate_again", "button_rate_hard", "button_rate_good", "button_rate_easy",
                           "button_study_undo", "session_menu"}) {
    auto* button = find<QAbstractButton>(name);
    ASSERT_TRUE(button->isVisible()) << name;
    EXPECT_EQ(button->visibleRegion().boundingRect(), button->rect()) << name;
    EXPECT_GE(button->width(), button->minimumSizeHint().width())
        << name << " in " << button->parentWidget()->width();
  }
}

TEST_F(Unrated, WithTheLargestTextNoPanelIsWiderThanItsPlace) {
  const auto cut = [this] {
    QStringList names;
    for (const char* side : {"left_side", "right_side"})
      for (auto* area : find(side)->findChildren<QScrollArea*>())
        if (area->isVisible() && area->widget() != nullptr &&
            area->widget()->minimumSizeHint().width() > area->viewport()->width())
          names.append(area->objectName() + widest_parts(area->widget(), area->viewport()->width()).c_str());
    return names;
  };
  write_what_is_asked();
  ASSERT_FALSE(HasFatalFailure());
  while (action("text_larger")->isEnabled()) action("text_larger")->trigger();
  resize(1280, 800);
  EXPECT_EQ(cut(), QStringList());
  press(Qt::Key_4);
  window_->go_to(QStringLiteral("characters"));
  resize(1281, 800);
  EXPECT_EQ(cut(), QStringList());
  const auto* lists = find<QComboBox>("lists");
  ASSERT_TRUE(lists->isVisible());
  EXPECT_LE(lists->fontMetrics().horizontalAdvance(lists->currentText()) + 40, lists->width());
}

TEST_F(Unrated, NoMenuCoversTheMenuBar) {
  window_->go_to(QStringLiteral("characters"));
  window_->move(0, 0);
  auto* bar = window_->menuBar();
  const int under = bar->mapToGlobal(QPoint(0, bar->height())).y();
  const int room = window_->screen()->availableGeometry().bottom() - under;
  for (auto* entry : bar->actions())
    EXPECT_LE(entry->menu()->sizeHint().height(), room) << entry->text().toStdString();
  while (action("text_larger")->isEnabled()) action("text_larger")->trigger();
  QCoreApplication::processEvents();
  for (auto* entry : window_->menuBar()->actions()) {
    auto* menu = entry->menu();
    const int top = bar->mapToGlobal(QPoint(0, bar->height())).y();
    menu->popup(QPoint(0, top));
    EXPECT_GE(menu->geometry().top(), top) << entry->text().toStdString();
    menu->close();
  }
}

TEST_F(Unrated, TheFirstWindowFitsOnItsScreenWithItsFrame) {
  window_.reset();
  QFile::remove(folder_.filePath(QStringLiteral("nazori.ini")));
  window_ = std::make_unique<MainWindow>(setup(), appearance_);
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  const QSize room = window_->screen()->availableSize();
  EXPECT_LE(window_->width(), room.width() - 8);
  EXPECT_LE(window_->height(), room.height() - 30) << "a title bar takes as much";
}

}  // namespace
}  // namespace nazori::ui
