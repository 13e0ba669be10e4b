// SPDX-License-Identifier: Apache-2.0
// Reviews on the page for the brush: the question, the sheet for it, the advice and the ratings.
#include <QFontInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "brush_page_under_test.h"
#include "nazori/studio/brush/brush_review_bar.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

using State = practice::BrushSession::State;
using test::sentence;

class ReviewsWithTheBrush : public test::BrushPageTest {
 protected:
  ReviewsWithTheBrush() {
    wait_until([this] { return !page_->awaits_models() && !paper().model().empty(); });
    said_.clear();
  }
  [[nodiscard]] practice::BrushSession& session() { return parts_.brush_session(); }
  [[nodiscard]] study::LearnerStore& store() { return parts_.learner().store(); }
  /// The learner knows 一 and 二 well, and wants so many a day with the brush.
  void know(int a_day = 2) {
    auto settings = store().settings();
    settings.time_zone = "UTC";
    settings.new_per_day = 0;
    settings.brush_per_day = a_day;
    ASSERT_TRUE(store().change_settings(settings));
    study::Writing easy;
    easy.rating = study::Rating::easy;
    for (const int wait : {0, 9}) {
      now_ += std::chrono::days(wait);
      for (const char32_t one : {U'一', U'二'}) ASSERT_TRUE(store().add_writing(one, 1, easy));
    }
  }
  /// Begins with a place of the model.
  void start(ModelPlace place = ModelPlace::none) {
    know();
    emit panel().place_chosen(place);
    by(actions().review);
    ASSERT_TRUE(session().is_running()) << all_said().toStdString();
    wait_for_character();
  }
  void wait_for_character() {
    wait_until([this] { return !question().isEmpty() && !paper().model().empty(); });
    settle();
  }
  void get_advice() {
    actions().go_on->trigger();
    wait_until([this] { return session().state() == State::advised; });
    settle();
  }
  [[nodiscard]] QString question() const { return find<QLabel>("brush_review_question").text(); }
  [[nodiscard]] QString progress() const { return find<QLabel>("brush_review_progress").text(); }
  [[nodiscard]] bool is_hidden(const char* name) const { return find<QWidget>(name).isHidden(); }
  [[nodiscard]] std::vector<geometry::PaperPoint> model_ends() const {
    std::vector<geometry::PaperPoint> ends;
    for (const auto& stroke : paper().model()) {
      ends.push_back(stroke.points.front());
      ends.push_back(stroke.points.back());
    }
    return ends;
  }
  /// Writes over the model.
  void write_well() {
    const auto ends = model_ends();
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) write(ends[i], ends[i + 1]);
  }
};

TEST_F(ReviewsWithTheBrush, AreOffUntilTheLearnerWantsThem) {
  know(0);
  EXPECT_EQ(by(actions().review),
            sentence("Reviews with the brush are off. Choose how many you want a day at Home, "
                     "in Study settings, Daily goal."));
  EXPECT_EQ(kind_, Feedback::hint);
  EXPECT_FALSE(session().is_running());
  EXPECT_TRUE(find<QWidget>("brush_review_bar").isHidden());
}

TEST_F(ReviewsWithTheBrush, BeginWithANewSheetForOneCharacterAndAMediumBrush) {
  emit panel().ruling_chosen(4);
  emit panel().text_typed(sentence("三三"));
  emit panel().hair_chosen(brush::Hair::goat);
  settle();
  know();
  int focused = focused_;
  const QString said = by(actions().review);
  EXPECT_FALSE(said.contains(sentence("New sheet"))) << said.toStdString();
  EXPECT_EQ(focused_, focused + 1);
  wait_for_character();
  EXPECT_FALSE(is_hidden("brush_review_bar"));
  EXPECT_EQ(progress(), sentence("With the brush · 1 of 2"));
  EXPECT_EQ(session().total(), 2);
  EXPECT_EQ(state().brush, (calligraphy::BrushChoice{calligraphy::BrushSize::medium, brush::Hair::goat}));
  EXPECT_EQ(paper().model().size(), session().character() == U'一' ? 1U : 2U);
  EXPECT_FALSE(find<QWidget>("brush_ruling_box").isEnabled());
  EXPECT_FALSE(find<QLineEdit>("brush_text").isEnabled());
  const auto& a = actions();
  for (auto* action : {a.next_ruling, a.model_text, a.next_model, a.previous_model, a.watch})
    EXPECT_FALSE(action->isEnabled()) << action->objectName().toStdString();
  for (auto* action : {a.go_on, a.skip, a.end})
    EXPECT_TRUE(action->isEnabled()) << action->objectName().toStdString();
  for (auto* action : a.rate) EXPECT_FALSE(action->isEnabled()) << "nothing was compared yet";
  EXPECT_TRUE(is_hidden("brush_review_verdict"));
  EXPECT_FALSE(is_hidden("button_brush_go_on"));
  focused = focused_;
  by(actions().review);
  EXPECT_EQ(focused_, focused + 1) << "they go on";
  EXPECT_EQ(session().done(), 0);
  // The learner's own model comes back at the end.
  by(actions().end);
  EXPECT_FALSE(session().is_running());
  EXPECT_TRUE(is_hidden("brush_review_bar"));
  EXPECT_EQ(state().brush, (calligraphy::BrushChoice{calligraphy::BrushSize::small, brush::Hair::goat}));
  EXPECT_TRUE(find<QWidget>("brush_ruling_box").isEnabled());
  EXPECT_EQ(find<QLabel>("model_words").text(), sentence("Model beneath: 三三三三."));
  EXPECT_TRUE(a.watch->isEnabled());
  EXPECT_FALSE(a.skip->isEnabled());
  EXPECT_FALSE(all_said().contains(sentence("New sheet"))) << all_said().toStdString();
}

TEST_F(ReviewsWithTheBrush, FromAnotherPageTheyComeToThisOne) {
  know();
  int wanted = 0;
  QObject::connect(page_.get(), &Page::wants_to_be_entered, &window_, [&wanted] { ++wanted; });
  emit parts_.review_with_brush();
  EXPECT_EQ(wanted, 0) << "it is shown";
  EXPECT_TRUE(session().is_running());
  session().end();
  page_->leave();
  emit parts_.review_with_brush();
  EXPECT_EQ(wanted, 1);
  settle();
}

TEST_F(ReviewsWithTheBrush, WithoutAModelTheQuestionDoesNotGiveTheCharacterAway) {
  start();
  const QString first = to_text(session().character());
  EXPECT_FALSE(question().contains(first)) << question().toStdString();
  EXPECT_EQ(question(),
            BrushReviewBar::question_words(*parts_.learner().database()->find(session().character()), true));
  by(actions().model_beside);
  EXPECT_TRUE(question().startsWith(first + sentence(" · "))) << question().toStdString();
  by(actions().skip);
  wait_for_character();
  EXPECT_NE(to_text(session().character()), first);
  EXPECT_EQ(session().total(), 1);
  EXPECT_EQ(progress(), sentence("With the brush · 1 of 1"));
}

TEST_F(ReviewsWithTheBrush, WhatIsWrittenIsComparedThenRated) {
  start();
  EXPECT_EQ(by(actions().go_on), sentence("Write a character first. Then J gives advice."));
  EXPECT_EQ(session().state(), State::writing);
  const char32_t character = session().character();
  write_well();
  const auto& bar = find<QWidget>("brush_review_bar");
  const int before = bar.heightForWidth(1000);
  get_advice();
  EXPECT_EQ(bar.heightForWidth(1000), before) << "the paper below stays where it is";
  EXPECT_TRUE(actions().advice->isChecked());
  for (auto* action : actions().rate) EXPECT_TRUE(action->isEnabled());
  EXPECT_FALSE(is_hidden("brush_review_verdict"));
  EXPECT_TRUE(is_hidden("button_brush_go_on"));
  EXPECT_TRUE(session().result().accepted);
  EXPECT_EQ(find<QLabel>("brush_review_verdict").text(),
            sentence("The advice is not a mark: you rate your writing. Suggested: Good."));
  auto& good = find<QPushButton>("button_brush_good");
  EXPECT_TRUE(good.text().startsWith(sentence("9  Good  "))) << good.text().toStdString();
  EXPECT_TRUE(good.text().endsWith(sentence("  ⏎")));
  EXPECT_EQ(good.property("role").toString(), sentence("primary"));
  EXPECT_TRUE(good.accessibleName().endsWith(sentence(", suggested")));
  for (const auto& [name, start] :
       {std::pair("button_brush_again", "7  Again  "), std::pair("button_brush_hard", "8  Hard  "),
        std::pair("button_brush_easy", "0  Easy  ")}) {
    auto& other = find<QPushButton>(name);
    EXPECT_TRUE(other.text().startsWith(sentence(start))) << other.text().toStdString();
    EXPECT_FALSE(other.text().contains(sentence("⏎")));
    EXPECT_EQ(other.property("role").toString(), sentence("rating"));
    EXPECT_FALSE(other.accessibleName().contains(sentence("suggested")));
    EXPECT_TRUE(other.accessibleName().contains(sentence(": ")));
  }
  // A stroke more is compared again.
  write({-0.03, -0.03}, {0.03, -0.03});
  EXPECT_EQ(session().state(), State::writing);
  EXPECT_FALSE(actions().rate[0]->isEnabled());
  get_advice();
  const QString said = by(actions().rate[1]);
  EXPECT_TRUE(said.startsWith(sentence("Saved: "))) << said.toStdString();
  const auto writings = store().writings_of(character);
  ASSERT_TRUE(writings);
  EXPECT_EQ(writings->back().entry.writing.stage, study::Stage::brush);
  EXPECT_EQ(writings->back().entry.writing.rating, study::Rating::hard);
  wait_for_character();
  EXPECT_EQ(state().strokes, 0);
  EXPECT_EQ(progress(), sentence("With the brush · 2 of 2"));
  EXPECT_FALSE(actions().undo->isEnabled()) << "that sheet has another character";
  EXPECT_TRUE(by(actions().undo_rating).startsWith(sentence("Undone: "))) << all_said().toStdString();
  EXPECT_EQ(session().character(), character);
  EXPECT_EQ(progress(), sentence("With the brush · 1 of 2"));
}

TEST_F(ReviewsWithTheBrush, AWrongCharacterIsSuggestedForAgainAndTheKeyAcceptsIt) {
  start();
  write({0, 0.03}, {0, -0.03});
  write({0.01, 0.03}, {0.01, -0.03});
  write({0.02, 0.03}, {0.02, -0.03});
  const char32_t character = session().character();
  get_advice();
  EXPECT_FALSE(session().result().accepted);
  EXPECT_EQ(find<QLabel>("brush_review_verdict").text(),
            sentence("Not all strokes are those of the character. The advice is not a mark: you rate your "
                     "writing. Suggested: Again."));
  EXPECT_TRUE(find<QPushButton>("button_brush_again").text().endsWith(sentence("  ⏎")));
  actions().go_on->trigger();
  settle();
  EXPECT_EQ(store().writings_of(character)->back().entry.writing.rating, study::Rating::again);
}

TEST_F(ReviewsWithTheBrush, StrokesAreCountedForTheTimeThatTheCharacterTook) {
  start();
  const char32_t character = session().character();
  write_well();
  get_advice();
  actions().rate[2]->trigger();
  settle();
  EXPECT_GT(store().writings_of(character)->back().entry.writing.result.duration.count(), 0);
}

TEST_F(ReviewsWithTheBrush, AnUnsavedSheetIsAskedAboutFirst) {
  know();
  write();
  answer("unsaved_sheet_box", "Go back");
  by(actions().review);
  EXPECT_FALSE(session().is_running());
  answer("unsaved_sheet_box", "Save…");
  choose_file(file("one.nzs"));
  by(actions().review);
  EXPECT_FALSE(session().is_running()) << "it is being saved";
  EXPECT_EQ(said_.back(), sentence("Saved one.nzs."));
  write();
  answer("unsaved_sheet_box", "Do not save");
  by(actions().review);
  EXPECT_TRUE(session().is_running());
}

TEST_F(ReviewsWithTheBrush, InALowWindowThePaperHasTheRoomOfTheToolsUntilTheyEndOrTheToolsAreOpened) {
  know();
  const int em = QFontInfo(window_.font()).pixelSize();
  const auto resize = [this](int width, int height) {
    window_.resize(width, height);
    page_->instead_of_tablet()->resize(width, height);
  };
  const auto review = [this] {
    by(actions().review);
    wait_for_character();
  };
  resize(50 * em, 13 * em);
  review();
  EXPECT_TRUE(panel().isHidden());
  EXPECT_FALSE(actions().tools->isChecked());
  EXPECT_FALSE(question().contains(sentence(", "))) << "one meaning: " << question().toStdString();
  EXPECT_FALSE(question().contains(sentence("、"))) << "one reading: " << question().toStdString();
  EXPECT_EQ(find<QPushButton>("button_brush_skip").text(), sentence("Skip"));
  by(actions().end);
  EXPECT_FALSE(panel().isHidden());
  EXPECT_TRUE(actions().tools->isChecked());

  review();
  actions().tools->trigger();
  EXPECT_FALSE(panel().isHidden()) << "the learner opens them";
  by(actions().end);
  EXPECT_FALSE(panel().isHidden());

  actions().tools->trigger();
  review();
  by(actions().end);
  EXPECT_TRUE(panel().isHidden()) << "the learner had closed them before";
  actions().tools->trigger();

  resize(100 * em, 80 * em);
  review();
  EXPECT_FALSE(panel().isHidden()) << "there is room for both";
  EXPECT_EQ(find<QPushButton>("button_brush_skip").text(), sentence("Skip  Ctrl+Shift+P"));
  EXPECT_TRUE(question().contains(sentence(", ")));
}

TEST(QuestionOfAReview, AsksBySoundOrMeaningAndReadingsOrElseByTheNumberOfStrokes) {
  test::speak_english();
  kanji::Character one;
  one.code_point = U'木';
  one.strokes.resize(4);
  EXPECT_EQ(BrushReviewBar::question_words(one, false), sentence("木"));
  EXPECT_EQ(BrushReviewBar::question_words(one, true), sentence("a character with 4 strokes"));
}

}  // namespace
}  // namespace nazori::ui
