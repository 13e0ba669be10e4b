// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

using study::FaultKind;
using study::Rating;
using testing::ElementsAre;
using testing::IsEmpty;

class CharacterHistory : public SessionTest {
 protected:
  void write_with(std::vector<study::StrokeFault> faults, Rating rating = Rating::good,
                  bool has_ink = false) {
    study::Writing writing;
    writing.rating = rating;
    writing.result.mistakes = std::move(faults);
    const auto ink =
        has_ink ? study::Handwriting{{{study::ink_point({1, 1}, 0, 0), study::ink_point({9, 9}, 10, 0)}}}
                : study::Handwriting{};
    ASSERT_TRUE(learner_->store().add_writing(U'休', 6, writing, ink));
    clock_.advance(std::chrono::days(1));
  }
};

TEST_F(CharacterHistory, NamesTheStrokesThatWentWrongMoreThanOnceTheWorstFirst) {
  EXPECT_THAT(hard_strokes(*learner_, U'休', 3), IsEmpty());
  write_with({{FaultKind::wrong, 1}, {FaultKind::order, 4}, {FaultKind::ending, 5}, {FaultKind::wrong, 0}});
  write_with({{FaultKind::missing, 1}, {FaultKind::order, 4}, {FaultKind::ending, 5}, {FaultKind::wrong, 2}});
  EXPECT_THAT(hard_strokes(*learner_, U'休', 3), ElementsAre(HardStroke{4, 2}, HardStroke{1, 2}))
      << "endings do not count, once is not often";
  write_with({{FaultKind::reversed, 1}, {FaultKind::wrong, 2}, {FaultKind::wrong, 0}});
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
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].rating, Rating::easy);
  EXPECT_EQ(two[1].rating, Rating::good);
  EXPECT_EQ(two[0].day, two[1].day + std::chrono::days(1));
  EXPECT_EQ(two[0].ink.strokes.size(), 1U);
  const auto all = earlier_writings(*learner_, U'休', 9);
  ASSERT_EQ(all.size(), 3U) << "one was saved without its handwriting";
  EXPECT_EQ(all[2].rating, Rating::again);
}

}  // namespace
}  // namespace nazori::practice
