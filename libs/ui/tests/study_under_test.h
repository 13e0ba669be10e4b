// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPushButton>

#include "characters/characters.h"
#include "hand_under_test.h"
#include "nazori/widgets/page/window_parts.h"
#include "study/home.h"
#include "window_under_test.h"

namespace nazori::ui {

/// A learner of characters of few strokes, with a clock that the test moves.
class StudyTest : public WindowTest {
 protected:
  StudyTest() {
    pages_ = {make_home, make_characters};
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
    QObject::connect(window_.get(), &MainWindow::character_shown,
                     [this](char32_t c) { shown_character_ = c; });
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    ASSERT_TRUE(opened.count() > 0 || opened.wait(20000));
    window_->resize(1280, 800);
    the_parts->session().set_asks_by_words(false);
    QCoreApplication::processEvents();
  }

  static practice::StudySession& session() { return the_parts->session(); }
  static study::LearnerStore& store() { return the_parts->learner().store(); }

  void start() {
    ASSERT_TRUE(find("home_page")->isVisible());
    ASSERT_TRUE(find<QPushButton>("home_start")->isVisible()) << text("home_advice").toStdString();
    shown_character_ = 0;
    QTest::keyClick(find<QPushButton>("home_start"), Qt::Key_Return);
    ASSERT_TRUE(session().is_running());
  }

  /// A character is learnt today and is asked as a review eight days later.
  void learn_and_come_back() {
    start();
    learn();
    press(Qt::Key_4);
    now_ += std::chrono::days(8);
    open_home();
    start();
    ASSERT_TRUE(is_shown());
  }

  bool is_shown() {
    return QTest::qWaitFor([&] { return shown_character_ == session().character(); }, 20000);
  }

  /// Writes from memory as the model, or shows the answer. Then the check is done.
  void write_from_memory(bool well) {
    ASSERT_EQ(session().stage(), study::Stage::memory);
    const char32_t character = session().character();
    if (!well) {
      press(Qt::Key_G);
    } else {
      double time_s = 0;
      for (const auto& line : test::model(character)) {
        const practice::HandStroke stroke = test::hand_stroke(line, time_s);
        time_s = stroke.back().time_s.value_or(0);
        the_parts->practice().memory().add_stroke(stroke);
      }
    }
    ASSERT_TRUE(
        QTest::qWaitFor([] { return session().state() == practice::StudySession::State::judged; }, 20000))
        << feedback().toStdString();
  }

  /// Completes the current stage without mistakes.
  void do_stage() {
    ASSERT_TRUE(is_shown());
    switch (session().stage()) {
      case study::Stage::watch:
        ASSERT_TRUE(action("watch")->isChecked());
        action("play")->setChecked(false);
        for (int i = 0; i < 30 && session().state() == practice::StudySession::State::doing; ++i)
          action("step_on")->trigger();
        break;
      case study::Stage::trace:
      case study::Stage::guided:
        for (const auto& line : test::model(session().character())) test::write(the_parts->tablet(), line);
        break;
      case study::Stage::memory:
        write_from_memory(true);
        return;
      case study::Stage::brush:
        FAIL() << "no stage of a lesson";
    }
    ASSERT_TRUE(
        QTest::qWaitFor([] { return session().state() == practice::StudySession::State::offered; }, 5000))
        << feedback().toStdString();
  }

  /// Enter goes on. Waits until another character is shown.
  void go_on() {
    const char32_t before = session().character();
    shown_character_ = 0;
    press(Qt::Key_Return);
    if (session().is_running() && session().character() == before) shown_character_ = before;
  }

  /// A new character, up to the check of its writing.
  void learn() {
    while (session().state() != practice::StudySession::State::judged) {
      do_stage();
      if (HasFatalFailure()) return;
      if (session().state() == practice::StudySession::State::offered) go_on();
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

  static std::unique_ptr<Page> make_home(WindowParts& parts) { return std::make_unique<Home>(parts); }

  static std::unique_ptr<Page> make_characters(WindowParts& parts) {
    the_parts = &parts;
    auto made = std::make_unique<Characters>(parts);
    the_characters = made.get();
    return made;
  }

  static inline WindowParts* the_parts = nullptr;
  static inline Characters* the_characters = nullptr;
  study::Time now_ = *study::parse_time("2026-03-02T10:00Z");
  char32_t shown_character_ = 0;
};

}  // namespace nazori::ui
