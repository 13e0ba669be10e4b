// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/extra_study.h"

#include <gmock/gmock.h>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using study::Rating;
using testing::ElementsAre;
using testing::IsEmpty;

class ExtraStudy : public SessionTest {
 protected:
  ExtraStudy() { learn_from({U'一', U'二', U'三', U'四', U'五', U'六', U'七', U'八'}); }
  void review(char32_t character, Rating rating = Rating::easy) {
    study::Writing writing;
    writing.rating = rating;
    writing.result.duration = std::chrono::seconds(9);
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing));
  }
  std::vector<char32_t> next(std::size_t most) { return *new_characters(*learner_, most); }
};

TEST_F(ExtraStudy, FiveMoreComeInTheLearningOrderBeyondTheLimitOfTheDay) {
  EXPECT_THAT(next(5), ElementsAre(U'一', U'二', U'三', U'四', U'五'));
  review(U'一');
  review(U'三');
  ASSERT_TRUE(learner_->store().pause(std::vector<char32_t>{U'四'}));
  ASSERT_TRUE(learner_->store().postpone(std::vector<char32_t>{U'五'}, learner_->store().today() + days(1)));
  EXPECT_THAT(next(5), ElementsAre(U'二', U'六', U'七', U'八'));
  EXPECT_THAT(next(0), IsEmpty());
  ASSERT_TRUE(session_->start_with(next(2)));
  EXPECT_EQ(session_->task().character, U'二');
  EXPECT_EQ(session_->task().kind, study::TaskKind::fresh);
}

TEST_F(ExtraStudy, ReviewsAheadAreTheNextToBecomeDue) {
  const auto& store = learner_->store();
  review(U'一');
  clock_.advance(days(1));
  review(U'二');
  review(U'三');
  review(U'四', Rating::good);  // in its steps
  EXPECT_THAT(reviews_ahead(store, 10), ElementsAre(U'一', U'三', U'二')) << "of one day, by code point";
  EXPECT_THAT(reviews_ahead(store, 1), ElementsAre(U'一'));
  ASSERT_TRUE(learner_->store().pause(std::vector<char32_t>{U'三'}));
  ASSERT_TRUE(learner_->store().postpone(std::vector<char32_t>{U'二'}, store.today() + days(1)));
  EXPECT_THAT(reviews_ahead(store, 10), ElementsAre(U'一'));
  clock_.advance(*store.card(U'一').due_day - store.today());
  EXPECT_THAT(reviews_ahead(store, 10), ElementsAre(U'二')) << "一 is due";
}

TEST_F(ExtraStudy, OnlyTheReviewsOfAPlanTakeLessTime) {
  review(U'一');
  clock_.advance(*learner_->store().card(U'一').due_day - learner_->store().today());
  const auto plan = learner_->plan();
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->count(study::TaskKind::fresh), 2);
  const auto reviews = reviews_now(learner_->store(), *plan);
  ASSERT_TRUE(reviews);
  EXPECT_THAT(reviews->characters, ElementsAre(U'一'));
  EXPECT_EQ(reviews->estimate, plan->estimate - std::chrono::minutes(6)) << "two new ones of three minutes";
  EXPECT_EQ(practice_time(2), std::chrono::minutes(2));
}

}  // namespace
}  // namespace nazori::practice
