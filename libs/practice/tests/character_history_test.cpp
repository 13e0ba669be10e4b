// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

using kanji::MistakeKind;
using study::Rating;
using testing::ElementsAre;
using testing::IsEmpty;

class CharacterHistory : public SessionTest {
 protected:
  void write_with(std::vector<study::StrokeMistake> mistakes, Rating rating = Rating::good,
                  bool has_ink = false) {
    study::Writing writing;
    writing.rating = rating;
    writing.result.mistakes = std::move(mistakes);
    study::Handwriting ink;
    if (has_ink) ink = {{{{1, 1}, 0.0}, {{9, 9}, 0.01}}};
    ASSERT_TRUE(learner_->store().add_writing(U'休', 6, writing, ink));
    clock_.advance(std::chrono::days(1));
  }
};

TEST_F(CharacterHistory, NamesTheStrokesThatWentWrongMoreThanOnceTheWorstFirst) {
  EXPECT_THAT(hard_strokes(*learner_, U'休', 3), IsEmpty());
  write_with(
      {{MistakeKind::wrong, 1}, {MistakeKind::order, 4}, {MistakeKind::ending, 5}, {MistakeKind::wrong, 0}});
  write_with({{MistakeKind::missing, 1},
              {MistakeKind::order, 4},
              {MistakeKind::ending, 5},
              {MistakeKind::wrong, 2}});
  EXPECT_THAT(hard_strokes(*learner_, U'休', 3), ElementsAre(HardStroke{4, 2}, HardStroke{1, 2}))
      << "endings do not count, once is not often";
  write_with({{MistakeKind::reversed, 1}, {MistakeKind::wrong, 2}, {MistakeKind::wrong, 0}});
  EXPECT_THAT(hard_strokes(*learner_, U'休', 3),
              ElementsAre(HardStroke{1, 3}, HardStroke{4, 2}, HardStroke{2, 2}));
  EXPECT_THAT(hard_strokes(*learner_, U'休', 1), ElementsAre(HardStroke{1, 3}));
  EXPECT_THAT(hard_strokes(*learner_, U'一', 3), IsEmpty()) << "another character";
}

TEST_F(CharacterHistory, ShowsTheNewestWritingsThatWereSaved) {
  write_with({}, Rating::again, true);
  write_with({}, Rating::hard, false);
  write_with({}, Rating::good, true);
  write_with({}, Rating::easy, true);
  const auto two = earlier_writings(*learner_, U'休', 2);
  ASSERT_TRUE(two && two->size() == 2U);
  EXPECT_EQ((*two)[0].rating, Rating::easy);
  EXPECT_EQ((*two)[1].rating, Rating::good);
  EXPECT_EQ((*two)[0].day, (*two)[1].day + std::chrono::days(1));
  EXPECT_EQ((*two)[0].ink.size(), 1U);
  const auto all = earlier_writings(*learner_, U'休', 9);
  ASSERT_TRUE(all && all->size() == 3U) << "one was saved without its handwriting";
  EXPECT_EQ((*all)[2].rating, Rating::again);
}

}  // namespace
}  // namespace nazori::practice
