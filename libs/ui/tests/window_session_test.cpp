// SPDX-License-Identifier: Apache-2.0
// A session in the window: the room of the tablet, panels that fold away, and what is shown of a mistake.
#include <QAbstractButton>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>

#include "nazori/widgets/controls/spoken_line.h"
#include "study_under_test.h"

namespace nazori::ui {
namespace {

using State = practice::StudySession::State;

class SessionWindow : public StudyTest {
 protected:
  /// Widgets of the session that are cut off by the window or by their place.
  QStringList cut() {
    QStringList names;
    for (const char* name :
         {"session_progress", "session_menu", "button_study_undo", "session_question", "session_verdict",
          "button_show_right", "button_hint", "button_give_up", "session_next", "button_rate_again",
          "button_rate_hard", "button_rate_good", "button_rate_easy", "feedback_text"}) {
      auto* widget = find(name);
      if (widget == nullptr || !widget->isVisible()) continue;
      const bool is_whole = widget->visibleRegion().boundingRect() == widget->rect();
      const bool fits = widget->width() >= widget->minimumSizeHint().width() &&
                        (qobject_cast<QAbstractButton*>(widget) == nullptr ||
                         widget->height() >= widget->fontMetrics().height());
      if (!is_whole || !fits)
        names.append(QStringLiteral("%1 (%2x%3, needs %4)")
                         .arg(QLatin1String(name))
                         .arg(widget->width())
                         .arg(widget->height())
                         .arg(widget->minimumSizeHint().width()));
    }
    return names;
  }
  /// The smaller side of the tablet, as a share of the shorter side of the window.
  double share_of_tablet() {
    const QSize tablet = find("tablet")->size();
    const double shorter = std::min(window_->width(), window_->height());
    return std::min(tablet.width(), tablet.height()) / shorter;
  }
  void expect_room(const char* when) {
    for (const auto& [text_pt, width, height] :
         {std::tuple(12, 1280, 800), std::tuple(12, 800, 600), std::tuple(20, 1024, 768),
          std::tuple(28, 1280, 800), std::tuple(28, 1024, 768), std::tuple(28, 800, 600)}) {
      set_text_size(text_pt, width, height);
      const std::string at = std::to_string(text_pt) + " pt, " + std::to_string(width) + " x " +
                             std::to_string(height) + ", " + when;
      EXPECT_GE(share_of_tablet(), 0.5) << at;
      EXPECT_EQ(cut().join(QStringLiteral(", ")).toStdString(), "") << at;
      const int least = find("question_view")->minimumSizeHint().height();
      EXPECT_GE(find("question_view")->height(), std::min(least, find("question_view")->maximumHeight()))
          << at;
    }
  }
};

TEST_F(SessionWindow, TheTabletHasHalfOfTheShorterSideAndNothingIsCutAtAnySize) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  expect_room("asked");
  press(Qt::Key_G);
  ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000));
  for (const char* name : {"button_rate_again", "button_rate_hard", "button_rate_good", "button_rate_easy"})
    EXPECT_TRUE(find(name)->isVisible());
  expect_room("judged");
}

TEST_F(SessionWindow, TheSameInJapanese) {
  install_language(QStringLiteral("ja"));
  open_home();
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  expect_room("asked");
  press(Qt::Key_G);
  ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000));
  expect_room("judged");
}

TEST_F(SessionWindow, PanelsAndToolbarFoldAwayWhileSomethingIsWrittenAndComeBackAsTheyWere) {
  window_->go_to(QStringLiteral("characters"));
  ASSERT_TRUE(find("left_side")->isVisible());
  action("left_panel")->trigger();
  ASSERT_FALSE(find("left_side")->isVisible());
  ASSERT_TRUE(find("right_side")->isVisible());
  window_->go_to(QStringLiteral("home"));
  start();
  EXPECT_FALSE(find("right_side")->isVisible());
  EXPECT_FALSE(find("toolbar_frame") != nullptr && find("toolbar_frame")->isVisible());
  learn();
  ASSERT_EQ(session().state(), State::judged);
  EXPECT_TRUE(find("right_side")->isVisible()) << "with the verdict";
  EXPECT_FALSE(find("left_side")->isVisible());
  EXPECT_TRUE(find("writing_report")->isVisible());
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(session().state(), State::doing);
  EXPECT_FALSE(find("right_side")->isVisible()) << "it is written again";
  session().end();
  window_->go_to(QStringLiteral("characters"));
  EXPECT_TRUE(find("right_side")->isVisible());
  EXPECT_FALSE(find("left_side")->isVisible()) << "as the learner left it";
}

TEST_F(SessionWindow, WhenAllStrokesWereShownTheSentenceNamesTheKeyOfTheButton) {
  start();
  ASSERT_TRUE(is_shown());
  auto& watch = the_parts->practice().watch();
  ASSERT_TRUE(watch.is_entered());
  watch.set_playing(true);
  watch.show_moment(watch.player().duration_s() - 0.05);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return text("feedback_text").endsWith(QStringLiteral("Space: play again. Enter: trace.")); },
      10'000))
      << text("feedback_text").toStdString();
  EXPECT_TRUE(find<QPushButton>("session_next")->text().endsWith(QStringLiteral("⏎")));
}

TEST_F(SessionWindow, AFoldedPanelOpensForAMomentWithoutBeingRemembered) {
  start();
  ASSERT_TRUE(is_shown());
  press(Qt::Key_F2);
  EXPECT_TRUE(find("left_side")->isVisible());
  press(Qt::Key_F2);
  EXPECT_FALSE(find("left_side")->isVisible());
  session().end();
  window_->go_to(QStringLiteral("characters"));
  EXPECT_TRUE(find("left_side")->isVisible()) << "as before the session";
}

TEST_F(SessionWindow, NothingBesideTheTabletGivesTheAnswerAway) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  press(Qt::Key_F3);
  QStringList told{window_->windowTitle()};
  for (const auto* widget : window_->findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    told.append(widget->accessibleName());
    told.append(widget->accessibleDescription());
    if (const auto* label = qobject_cast<const QLabel*>(widget)) told.append(label->text());
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) told.append(button->text());
  }
  for (const QString& one : told) EXPECT_FALSE(one.contains(QStringLiteral("一"))) << one.toStdString();
}

TEST_F(SessionWindow, TheButtonOfTheNextStepGoesThroughAWholeLesson) {
  start();
  auto* next = find<QPushButton>("session_next");
  while (session().stage() != study::Stage::memory) {
    do_stage();
    ASSERT_FALSE(HasFatalFailure());
    ASSERT_TRUE(next->isVisible()) << next->text().toStdString();
    next->click();
  }
  ASSERT_TRUE(is_shown());
  EXPECT_EQ(next->text(), QStringLiteral("Finish  ⏎"));
  for (const auto& line : test::model(U'一'))
    the_parts->practice().memory().add_stroke(test::hand_stroke(line, 0));
  ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000));
  int primary = 0;
  for (const auto* button : window_->findChildren<QPushButton*>())
    primary += button->isVisible() && button->property("role") == QLatin1String("primary") ? 1 : 0;
  EXPECT_EQ(primary, 1) << "there is one obvious button";
  find<QPushButton>("button_rate_easy")->click();
  EXPECT_EQ(store().card(U'一').memory.reps, 1);
}

TEST_F(SessionWindow, WhatIsWrongIsDrawnOverTheWritingByOneKey) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  the_parts->preferences().reduced_motion = true;
  auto& memory = the_parts->practice().memory();
  EXPECT_FALSE(action("show_right")->isEnabled()) << "it would be a hint";
  practice::HandStroke down;
  for (int i = 0; i <= 40; ++i) down.push_back({{0.01, 0.03 - i * 0.0015}, i * 0.01, 0.5});
  memory.set_judges_each(false);
  memory.add_stroke(down);
  press(Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000));
  EXPECT_TRUE(feedback().endsWith(QStringLiteral("D: show it."))) << feedback().toStdString();
  ASSERT_TRUE(find("button_show_right")->isVisible());
  const auto models = [] {
    const auto overlay = the_parts->tablet().overlay();
    return std::count_if(overlay.writing.begin(), overlay.writing.end(), [](const view::InkedStroke& stroke) {
      return stroke.verdict == view::Verdict::shown && stroke.opacity == 1;
    });
  };
  EXPECT_EQ(models(), 0);
  press(Qt::Key_D);
  EXPECT_EQ(models(), 1) << "at once, because motion is reduced";
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(models(), 0);
}

TEST_F(SessionWindow, TheRightStrokesMoveUntilTheyAreThere) {
  learn_and_come_back();
  ASSERT_FALSE(HasFatalFailure());
  auto& memory = the_parts->practice().memory();
  practice::HandStroke down;
  for (int i = 0; i <= 40; ++i) down.push_back({{0.01, 0.03 - i * 0.0015}, i * 0.01, 0.5});
  memory.set_judges_each(false);
  memory.add_stroke(down);
  press(Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([] { return session().state() == State::judged; }, 20000));
  press(Qt::Key_D);
  EXPECT_TRUE(memory.is_showing_right());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !memory.is_showing_right(); }, 20000));
}

TEST_F(SessionWindow, AWritingCrossIsSwitchedByKeyShownInEveryStageAndRemembered) {
  using view::WritingCross;
  show(U'十');
  const auto cross = [] { return the_parts->tablet().overlay().cross; };
  EXPECT_EQ(cross(), WritingCross::none);
  press(Qt::Key_C);
  EXPECT_EQ(cross(), WritingCross::halves);
  EXPECT_EQ(feedback(), QStringLiteral("Writing cross: 十."));
  for (const auto stage : {Qt::Key_F5, Qt::Key_F6, Qt::Key_F7, Qt::Key_F8}) {
    press(stage);
    EXPECT_EQ(cross(), WritingCross::halves);
  }
  press(Qt::Key_C);
  EXPECT_EQ(cross(), WritingCross::quarters);
  EXPECT_TRUE(window_->close());
  EXPECT_EQ(Preferences::load(folder_.filePath(QStringLiteral("nazori.ini"))).cross, WritingCross::quarters);
  open_home();
  show(U'十');
  EXPECT_EQ(cross(), WritingCross::quarters);
  press(Qt::Key_C);
  EXPECT_EQ(cross(), WritingCross::none);
}

TEST_F(SessionWindow, AWritingIsPutAsideByTheMenuOfTheSession) {
  start();
  ASSERT_TRUE(is_shown());
  for (auto* entry : find<QToolButton>("session_menu")->menu()->actions())
    if (entry->objectName() == QLatin1String("study_postpone")) entry->trigger();
  EXPECT_TRUE(store().card(U'一').postponed_until.has_value());
}

}  // namespace
}  // namespace nazori::ui
