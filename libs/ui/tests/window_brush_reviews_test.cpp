// SPDX-License-Identifier: Apache-2.0
// Reviews with the brush in the window: from Home to the page Brush, written, rated and saved.
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>

#include "brush_window.h"
#include "nazori/study/learner_store.h"
#include "nazori/study/statistics.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "study/home.h"

namespace nazori::ui {
namespace {

WindowParts* brush_parts = nullptr;

class BrushReviews : public BrushWindow {
 protected:
  BrushReviews() {
    pages_ = {[](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Home>(parts); },
              [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); },
              [](WindowParts& parts) {
                brush_parts = &parts;
                return make_brush(parts);
              }};
    clock_ = [this] { return now_; };
  }
  void SetUp() override {
    begin_with({U'一', U'二'});
    WindowTest::SetUp();
    press(Qt::Key_1, Qt::AltModifier);
  }
  /// A learner who knows these characters well and wants two a day with the brush.
  void begin_with(const std::vector<char32_t>& known) {
    const auto file = std::filesystem::path(folder_.filePath(QStringLiteral("learners")).toStdString()) /
                      "learner" / "learner.db";
    auto store = study::LearnerStore::open(file, study::Access::write, clock_);
    ASSERT_TRUE(store);
    study::Settings settings;
    settings.time_zone = "UTC";
    settings.new_per_day = 0;
    settings.brush_per_day = 2;
    ASSERT_TRUE(store->change_settings(settings));
    study::Writing easy;
    easy.rating = study::Rating::easy;
    for (const int wait : {0, 9}) {
      now_ += std::chrono::days(wait);
      for (const char32_t one : known) ASSERT_TRUE(store->add_writing(one, 1, easy));
    }
    for (const char32_t one : known) ASSERT_EQ(study::strength_of(store->card(one)), study::Strength::mature);
  }
  static practice::BrushSession& session() { return brush_parts->brush_session(); }
  static study::LearnerStore& store() { return brush_parts->learner().store(); }
  /// From Home, without a model.
  void start() {
    ASSERT_TRUE(find("home_brush")->isVisible());
    press(Qt::Key_B);
    ASSERT_NE(the_page->writing(), nullptr);
    ASSERT_TRUE(session().is_running()) << feedback().toStdString();
    wait_for_character();
    key(Qt::Key_1);
    key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  }
  void wait_for_character() {
    wait_until([this] { return !text("brush_review_question").isEmpty(); });
    settle();
  }
  void get_advice() {
    press(Qt::Key_Return);
    wait_until([] { return session().state() == practice::BrushSession::State::advised; });
    settle();
  }

  study::Time now_ = *study::parse_time("2026-03-02T10:00Z");
};

TEST_F(BrushReviews, HomeOffersWhatIsDueAndTheKeyGoesToThePaper) {
  EXPECT_EQ(find<QPushButton>("home_brush")->text(), QStringLiteral("Write with the brush, 2 characters  B"));
  press(Qt::Key_B);
  EXPECT_TRUE(paper()->isVisible());
  EXPECT_TRUE(find("brush_review_bar")->isVisible());
  EXPECT_EQ(text("brush_review_progress"), QStringLiteral("With the brush · 1 of 2"));
  EXPECT_TRUE(session().is_running());
  EXPECT_FALSE(action("brush_good")->isEnabled()) << "nothing was compared yet";
  EXPECT_FALSE(action("brush_ruling")->isEnabled()) << "one character on a sheet";
}

TEST_F(BrushReviews, WithoutAModelTheQuestionDoesNotGiveTheCharacterAway) {
  press(Qt::Key_B);
  wait_for_character();
  // The model lay beneath the first one.
  const QString first = to_text(session().character());
  EXPECT_TRUE(text("brush_review_question").contains(first));
  key(Qt::Key_1);
  press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  wait_for_character();
  const QString second = to_text(session().character());
  EXPECT_NE(second, first);
  EXPECT_FALSE(text("brush_review_question").contains(second)) << text("brush_review_question").toStdString();
  EXPECT_FALSE(text("brush_review_question").isEmpty());
  key(Qt::Key_3);
  EXPECT_TRUE(text("brush_review_question").contains(second)) << "the model beside the paper shows it";
}

TEST_F(BrushReviews, ACharacterIsWrittenComparedRatedAndSavedApartFromMemory) {
  start();
  const char32_t character = session().character();
  const study::Card before = store().card(character);
  write_stroke(0.5);
  EXPECT_EQ(state().strokes, 1);
  const QRectF sheet = paper()->place().rect;
  get_advice();
  EXPECT_EQ(paper()->place().rect, sheet) << "the paper stays where it is";
  EXPECT_TRUE(action("brush_advice")->isChecked());
  EXPECT_TRUE(find("brush_advice_words")->isVisible());
  EXPECT_TRUE(text("brush_review_verdict").contains(QStringLiteral("The advice is not a mark")))
      << text("brush_review_verdict").toStdString();
  EXPECT_TRUE(find("button_brush_good")->isVisible());
  press(Qt::Key_8);
  settle();
  const study::Card after = store().card(character);
  EXPECT_EQ(after.memory, before.memory);
  EXPECT_EQ(after.brush.memory.reps, 1);
  const auto writings = store().writings_of(character);
  ASSERT_TRUE(writings);
  EXPECT_EQ(writings->back().entry.writing.stage, study::Stage::brush);
  EXPECT_EQ(writings->back().entry.writing.rating, study::Rating::hard);
  EXPECT_TRUE(writings->back().has_ink);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("All done with the brush")))
      << feedback().toStdString();  // the other one was skipped
  EXPECT_FALSE(find("brush_review_bar")->isVisible());
  wait_until([this] { return state().strokes == 0; });
  EXPECT_TRUE(action("brush_ruling")->isEnabled());
}

TEST_F(BrushReviews, AnotherStrokeAfterTheAdviceIsComparedAgainBeforeItIsRated) {
  start();
  write_stroke(0.3);
  get_advice();
  write_stroke(0.7);
  EXPECT_EQ(session().state(), practice::BrushSession::State::writing);
  EXPECT_FALSE(find("button_brush_good")->isVisible());
  EXPECT_FALSE(action("brush_good")->isEnabled());
  get_advice();
  EXPECT_TRUE(find("button_brush_good")->isVisible());
}

TEST_F(BrushReviews, NothingIsRatedWhereNothingIsWritten) {
  start();
  press(Qt::Key_Return);
  settle();
  EXPECT_EQ(feedback(), QStringLiteral("Write a character first. Then J gives advice."));
  EXPECT_EQ(session().state(), practice::BrushSession::State::writing);
}

TEST_F(BrushReviews, TheNextCharacterHasANewSheetThatUndoDoesNotTakeAway) {
  press(Qt::Key_B);
  wait_for_character();
  write_stroke(0.5);
  get_advice();
  press(Qt::Key_9);
  wait_until([this] { return state().strokes == 0; });
  settle();
  EXPECT_EQ(session().done(), 1);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Saved: "))) << feedback().toStdString();
  EXPECT_FALSE(action("brush_undo")->isEnabled()) << "that sheet has another character";
  // The review is undone with a key of its own.
  press(Qt::Key_Backspace, Qt::ShiftModifier);
  EXPECT_EQ(session().done(), 0);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Undone: "))) << feedback().toStdString();
}

TEST_F(BrushReviews, EndingBringsTheLearnersOwnModelBack) {
  press(Qt::Key_B);
  wait_for_character();
  press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  settle();
  EXPECT_FALSE(session().is_running());
  EXPECT_FALSE(find("brush_review_bar")->isVisible());
  EXPECT_TRUE(action("brush_model_text")->isEnabled());
  EXPECT_FALSE(action("brush_go_on")->isEnabled());
}

TEST_F(BrushReviews, AnUnsavedSheetIsAskedAboutFirst) {
  press(Qt::Key_3, Qt::AltModifier);
  settle();
  write_stroke(0.5);
  QTimer::singleShot(0, [] {
    for (auto* box : QApplication::topLevelWidgets())
      if (auto* question = qobject_cast<QMessageBox*>(box)) question->reject();
  });
  press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_FALSE(session().is_running());
  EXPECT_EQ(state().strokes, 1);
}

TEST_F(BrushReviews, SwitchedOffTheySayWhereTheyAreSwitchedOn) {
  study::Settings settings = store().settings();
  settings.brush_per_day = 0;
  ASSERT_TRUE(brush_parts->learner().report(store().change_settings(settings)));
  EXPECT_FALSE(find("home_brush")->isVisible());
  press(Qt::Key_3, Qt::AltModifier);
  settle();
  press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Reviews with the brush are off.")))
      << feedback().toStdString();
}

}  // namespace
}  // namespace nazori::ui
