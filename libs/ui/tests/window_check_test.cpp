// SPDX-License-Identifier: Apache-2.0
// The test of what a learner can write already: its questions, its buttons and its end; and the sentences
// about its result.
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>

#include "characters/characters.h"
#include "hand_under_test.h"
#include "nazori/widgets/page/window_parts.h"
#include "start/check_page.h"
#include "start/start_page.h"
#include "start/start_words.h"
#include "study/home.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

class CheckInTheWindow : public WindowTest {
 protected:
  CheckInTheWindow() {
    pages_ = {[](WindowParts& parts) -> std::unique_ptr<Page> {
                the_parts = &parts;
                return std::make_unique<Home>(parts);
              },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<StartPage>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<CheckPage>(parts); }};
  }
  void SetUp() override {
    install_language(QStringLiteral("en"));
    window_ = std::make_unique<MainWindow>(setup(), appearance_);
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    ASSERT_TRUE(QTest::qWaitFor([this] { return find("start_page")->isVisible(); }, 20'000));
    find<QRadioButton>("start_check")->click();
    find<QPushButton>("start_write")->click();
    ASSERT_TRUE(placement().is_running());
  }
  static practice::PlacementRun& placement() { return the_parts->placement(); }
  /// The first stroke of あ, as if it were written.
  void write() { placement().add_stroke(test::hand_stroke(test::model(U'あ').front())); }
  static inline WindowParts* the_parts = nullptr;
};

TEST_F(CheckInTheWindow, EachQuestionIsCountedAskedAndAnswered) {
  EXPECT_TRUE(find("check_bar")->isVisible());
  EXPECT_TRUE(find("check_buttons")->isVisible());
  EXPECT_EQ(text("check_progress"), QStringLiteral("Question 1 of about 12. Write from memory."));
  auto* line = find<QProgressBar>("check_line");
  EXPECT_EQ(line->maximum(), 12);
  EXPECT_EQ(line->minimumHeight(), 8);
  EXPECT_FALSE(line->isTextVisible());
  const QString asked = text("check_question");
  EXPECT_TRUE(asked.startsWith(QStringLiteral("hiragana: "))) << asked.toStdString();
  EXPECT_EQ(feedback(), QStringLiteral("Write: ") + asked);
  EXPECT_NEAR(find<QLabel>("check_question")->font().pointSizeF(),
              1.5 * QFontInfo(find("check_bar")->font()).pointSizeF(), 0.01);
  find<QPushButton>("button_check_unknown")->click();
  EXPECT_EQ(text("check_progress"), QStringLiteral("Question 2 of about 12. Write from memory."));
  EXPECT_EQ(line->value(), 1);
  EXPECT_NE(text("check_question"), asked);
  EXPECT_EQ(feedback(), QStringLiteral("Write: ") + text("check_question"));
  find<QPushButton>("check_done_button")->click();
  EXPECT_EQ(feedback(), QStringLiteral("Write the character first, or press I if you don't know it."));
  EXPECT_EQ(placement().answered(), 1);
}

TEST_F(CheckInTheWindow, WhatIsWrittenCanBeTakenBack) {
  write();
  write();
  EXPECT_TRUE(placement().has_writing());
  action("check_undo")->trigger();
  EXPECT_TRUE(placement().has_writing());
  action("check_undo")->trigger();
  EXPECT_FALSE(placement().has_writing());
  write();
  write();
  action("check_clear")->trigger();
  EXPECT_FALSE(placement().has_writing());
  write();
  action("check_done")->trigger();
  EXPECT_FALSE(feedback().startsWith(QStringLiteral("Write the character first")))
      << feedback().toStdString();
  EXPECT_TRUE(QTest::qWaitFor([] { return placement().answered() == 1; }, 20'000));
}

TEST_F(CheckInTheWindow, ItsEndLeadsBackToTheQuestions) {
  find<QPushButton>("button_check_end")->click();
  EXPECT_FALSE(placement().is_running());
  EXPECT_TRUE(find("start_page")->isVisible());
  EXPECT_EQ(feedback(), QStringLiteral("The test was ended. Nothing was saved."));
  EXPECT_FALSE(find("check_bar")->isVisible());
  EXPECT_FALSE(find("check_buttons")->isVisible());
  find<QPushButton>("start_write")->click();
  ASSERT_TRUE(placement().is_running()) << "the answers are as they were";
  window_->go_to(QStringLiteral("characters"));
  EXPECT_FALSE(placement().is_running());
  EXPECT_FALSE(find("check_bar")->isVisible());
  EXPECT_FALSE(find("check_buttons")->isVisible());
}

TEST(StartWords, AResultIsToldInTheMeasureOfItsGoal) {
  install_language(QStringLiteral("en"));
  using Goal = practice::LearningGoal;
  practice::PlacementResult result;
  EXPECT_EQ(StartWords::found(result, Goal::hiragana),
            QStringLiteral("You are at the beginning. Nothing is marked as known."));
  result.known = std::vector<char32_t>(1200, U'日');
  result.known.back() = U'月';
  result.characters = 2136;
  result.grade = 6;
  result.old_jlpt_level = 3;
  const std::pair<std::optional<Goal>, const char*> all[] = {
      {Goal::hiragana, "You can write about 1,200 of the 2,136 hiragana, up to 月."},
      {Goal::katakana, "You can write about 1,200 of the 2,136 katakana, up to 月."},
      {Goal::own_list, "You can write about 1,200 of the 2,136 characters of your list."},
      {Goal::kanji_by_jlpt, "You can write about 1,200 of the 2,136 kanji of the old JLPT, up to level 3."},
      {Goal::kanji_by_frequency, "You can write about 1,200 of the 2,136 school kanji."},
      {Goal::kanji_by_grade, "You can write about 1,200 of the 2,136 school kanji, up to grade 6."},
      {std::nullopt, "You can write about 1,200 of the 2,136 school kanji, up to grade 6."}};
  for (const auto& [goal, sentence] : all) EXPECT_EQ(StartWords::found(result, goal).toStdString(), sentence);
  result.grade = 8;
  EXPECT_EQ(StartWords::found(result, Goal::kanji_by_grade),
            QStringLiteral("You can write about 1,200 of the 2,136 school kanji, into secondary school."));
  result.grade.reset();
  result.old_jlpt_level.reset();
  EXPECT_EQ(StartWords::found(result, Goal::kanji_by_grade),
            QStringLiteral("You can write about 1,200 of the 2,136 school kanji, up to grade 1."));
  EXPECT_EQ(StartWords::found(result, Goal::kanji_by_jlpt),
            QStringLiteral("You can write about 1,200 of the 2,136 kanji of the old JLPT, up to level 1."));
}

TEST(StartWords, ACharacterIsAskedForByItsSoundElseByMeaningsAndReadings) {
  install_language(QStringLiteral("en"));
  practice::SessionQuestion question;
  question.readings = {"イチ", "ひと"};
  EXPECT_EQ(StartWords::asked(question), QStringLiteral("イチ、ひと"));
  question.meanings = {"one", "first"};
  EXPECT_EQ(StartWords::asked(question), QStringLiteral("one, first   イチ、ひと"));
  question.readings.clear();
  EXPECT_EQ(StartWords::asked(question), QStringLiteral("one, first"));
  question.sound = kanji::kana_sound(U'ツ');
  question.script = kanji::Script::katakana;
  EXPECT_EQ(StartWords::asked(question), QStringLiteral("katakana: tsu"));
}

}  // namespace
}  // namespace nazori::ui
