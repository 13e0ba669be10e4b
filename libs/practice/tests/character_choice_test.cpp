// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

using testing::ElementsAre;

class CharacterChoice : public SessionTest {
 protected:
  [[nodiscard]] CharacterStanding standing(char32_t character) {
    return standing_of(learner_->store(), character);
  }
};

TEST_F(CharacterChoice, ANewCharacterIsNotStudiedAndDoesNotCome) {
  EXPECT_EQ(standing(U'木').strength, study::Strength::unseen);
  EXPECT_FALSE(standing(U'木').comes_again);
  EXPECT_FALSE(standing(U'木').is_due);
  EXPECT_EQ(standing(U'木').recall, 0);
}

TEST_F(CharacterChoice, AKnownCharacterComesAgainAfterDaysAndCanBeUndone) {
  ASSERT_TRUE(mark_known(*learner_, U'木'));
  const auto now = standing(U'木');
  EXPECT_EQ(now.strength, study::Strength::young);
  EXPECT_TRUE(now.comes_again);
  EXPECT_FALSE(now.is_due);
  ASSERT_TRUE(now.card.due_day);
  EXPECT_GE((*now.card.due_day - now.today).count(), 5);
  EXPECT_GT(now.recall, 0.9);
  clock_.advance(std::chrono::days(60));
  EXPECT_TRUE(standing(U'木').is_due);
  EXPECT_LT(standing(U'木').recall, 0.9);
  ASSERT_TRUE(learner_->store().undo());
  EXPECT_EQ(standing(U'木').strength, study::Strength::unseen);
}

TEST_F(CharacterChoice, ASuspendedCharacterThatIsKnownIsResumed) {
  const char32_t tree = U'木';
  write(tree);
  ASSERT_TRUE(learner_->store().pause(std::span(&tree, 1)));
  EXPECT_EQ(standing(tree).strength, study::Strength::paused);
  EXPECT_FALSE(standing(tree).comes_again);
  ASSERT_TRUE(mark_known(*learner_, tree));
  EXPECT_NE(standing(tree).strength, study::Strength::paused);
  EXPECT_TRUE(standing(tree).comes_again);
}

TEST_F(CharacterChoice, APostponedCharacterIsNotDueBefore) {
  const char32_t tree = U'木';
  ASSERT_TRUE(mark_known(*learner_, tree));
  clock_.advance(std::chrono::days(60));
  ASSERT_TRUE(
      learner_->store().postpone(std::span(&tree, 1), learner_->store().today() + std::chrono::days(1)));
  EXPECT_FALSE(standing(tree).is_due);
}

TEST_F(CharacterChoice, ListsTakeACharacterAtTheirEndOnceAndGiveItUp) {
  EXPECT_TRUE(list_memberships(*learner_, U'木')->empty());
  ASSERT_TRUE(set_in_list(*learner_, "trees", U'木', true));
  ASSERT_TRUE(set_in_list(*learner_, "trees", U'林', true));
  ASSERT_TRUE(set_in_list(*learner_, "trees", U'木', true));
  EXPECT_THAT(learner_->store().lists()->at(0).characters, ElementsAre(U'林', U'木'));
  EXPECT_THAT(*list_memberships(*learner_, U'木'), ElementsAre(ListMembership{"trees", true}));
  EXPECT_THAT(*list_memberships(*learner_, U'森'), ElementsAre(ListMembership{"trees", false}));
  ASSERT_TRUE(set_in_list(*learner_, "trees", U'木', false));
  EXPECT_THAT(learner_->store().lists()->at(0).characters, ElementsAre(U'林'));
  EXPECT_FALSE(set_in_list(*learner_, " bad", U'木', true));
}

TEST_F(CharacterChoice, ASessionMayBeOfChosenCharactersAlone) {
  EXPECT_FALSE(session_->start_with({}));
  ASSERT_TRUE(mark_known(*learner_, U'土'));
  ASSERT_TRUE(session_->start_with({U'土', U'士'}));
  EXPECT_EQ(session_->character(), U'土');
  EXPECT_EQ(session_->stage(), study::Stage::memory) << "it was studied before";
  EXPECT_EQ(session_->total(), 2);
  write(true);
  session_->rate(study::Rating::good);
  EXPECT_EQ(session_->character(), U'士');
  EXPECT_EQ(session_->stage(), study::Stage::watch) << "it is new";
  EXPECT_EQ(session_->done(), 1);
  EXPECT_EQ(session_->total(), 2);
  session_->postpone();
  EXPECT_FALSE(session_->is_running()) << "nothing is left, whatever is due today";
  ASSERT_TRUE(session_->start());
  EXPECT_NE(session_->character(), 0U) << "a usual session is not limited to them";
}

}  // namespace
}  // namespace nazori::practice
