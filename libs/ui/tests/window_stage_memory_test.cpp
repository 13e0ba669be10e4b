// SPDX-License-Identifier: Apache-2.0
// What a stage remembers while the learner goes on, and what it forgets.
#include "study_under_test.h"

namespace nazori::ui {
namespace {

class StageMemory : public StudyTest {
 protected:
  void bring(char32_t character) {
    window_->show_character(character);
    ASSERT_TRUE(QTest::qWaitFor([&] { return shown_character_ == character; }, 20'000));
  }
  static practice::MemoryStage& memory() { return the_parts->practice().memory(); }
  /// Writes from memory and waits for the announcement.
  void put(const test::Points& line) {
    the_parts->announce(Feedback::hint, QStringLiteral("not judged yet"));
    memory().add_stroke(test::hand_stroke(line));
    ASSERT_TRUE(QTest::qWaitFor([&] { return feedback() != QStringLiteral("not judged yet"); }, 20'000));
  }
};

TEST_F(StageMemory, HelpThatFadedForOneCharacterIsWholeAgainForAnother) {
  const auto lines = [] { return the_parts->tablet().overlay().lines_opacity; };
  bring(U'一');
  action("guided")->trigger();
  const double whole = lines();
  test::write(the_parts->tablet(), test::model(U'一').front());
  ASSERT_TRUE(feedback().startsWith(QStringLiteral("No mistakes"))) << feedback().toStdString();
  const double faded = lines();
  ASSERT_LT(faded, whole);
  action("trace")->trigger();
  action("guided")->trigger();
  EXPECT_EQ(lines(), faded) << "it is the same character";
  EXPECT_EQ(feedback(), QStringLiteral("Follow the groove. Written without mistakes so far: 1."));
  bring(U'二');
  EXPECT_EQ(lines(), whole);
  EXPECT_EQ(feedback(), QStringLiteral("Follow the groove."));
}

TEST_F(StageMemory, AfterARefusedStrokeIsTakenBackTheNextTakesNoOtherAway) {
  study::Writing learnt;
  learnt.rating = study::Rating::easy;
  ASSERT_TRUE(store().add_writing(U'二', 2, learnt));
  now_ += std::chrono::days(40);
  open_home();
  start();
  ASSERT_TRUE(is_shown());
  ASSERT_EQ(session().character(), U'二');
  const auto lines = test::model(U'二');
  put(lines[0]);
  ASSERT_TRUE(feedback().startsWith(QStringLiteral("Stroke 1 is correct"))) << feedback().toStdString();
  const test::Points refused{{70, 20}, {70, 95}};
  put(refused);
  put(refused);
  ASSERT_EQ(memory().strokes().size(), 2U) << "what was refused made room for the next try";
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(memory().strokes().size(), 1U);
  put(lines[1]);
  EXPECT_EQ(memory().strokes().size(), 2U);
  EXPECT_TRUE(
      QTest::qWaitFor([] { return session().state() == practice::StudySession::State::judged; }, 20'000))
      << feedback().toStdString();
  EXPECT_TRUE(session().result().accepted);
}

TEST_F(StageMemory, WhatTheJudgeSaysOfAWritingThatWasPutAsideMeanwhileIsNotTold) {
  bring(U'十');
  action("memory")->trigger();
  int judged = 0;
  const base::Connection counting =
      the_parts->judge().judged.connect([&](std::uint64_t, const writing::Grade&) { ++judged; });
  memory().add_stroke(test::hand_stroke(test::model(U'十').front()));
  action("give_up")->trigger();
  const QString told = feedback();
  window_->go_to(QStringLiteral("home"));
  window_->go_to(QStringLiteral("characters"));
  ASSERT_EQ(feedback(), told);
  ASSERT_EQ(judged, 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged > 0; }, 20'000));
  EXPECT_EQ(feedback(), told);
  EXPECT_EQ(memory().strokes().size(), 1U) << "it is there again";
}

TEST_F(StageMemory, AfterTheAnswerIsShownNothingIsSaidOfAStrokeThatIsStillBeingChecked) {
  bring(U'一');
  action("memory")->trigger();
  int judged = 0;
  const base::Connection counting =
      the_parts->judge().judged.connect([&](std::uint64_t, const writing::Grade&) { ++judged; });
  memory().add_stroke(test::hand_stroke(test::model(U'一').front()));
  ASSERT_EQ(judged, 0);
  action("give_up")->trigger();
  const QString told = feedback();
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged > 0; }, 20'000));
  EXPECT_EQ(feedback(), told);
}

}  // namespace
}  // namespace nazori::ui
