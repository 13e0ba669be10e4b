// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/hard_characters.h"

#include <gmock/gmock.h>

#include "learner_under_test.h"

namespace nazori::practice {
namespace {

using kanji::MistakeKind;
using std::chrono::days;
using study::Rating;
using Mistakes = std::vector<study::StrokeMistake>;

class HardCharacters : public LearnerTest {
 protected:
  HardCharacters() {
    for (const char32_t character : {U'一', U'二', U'三', U'四'}) write(character, true);
    clock_.advance(days(1));
  }
  void write(char32_t character, bool right, const Mistakes& mistakes = {},
             study::Stage stage = study::Stage::memory) {
    study::Writing writing;
    writing.stage = stage;
    writing.rating = right ? Rating::good : Rating::again;
    writing.result.accepted = right;
    writing.result.duration = std::chrono::seconds(5);
    writing.result.mistakes = mistakes;
    ASSERT_TRUE(learner_->store().add_writing(character, 4, writing));
    clock_.advance(std::chrono::minutes(1));
  }
  std::vector<HardCharacter> hard(std::size_t most = 10) { return *hard_characters(learner_->store(), most); }
  std::optional<StrokeTrouble> trouble(char32_t character) {
    return *stroke_trouble(learner_->store(), character, study::Day());
  }
};

TEST_F(HardCharacters, TheFirstReviewOfTwoDaysMustFail) {
  write(U'一', false);
  write(U'一', false);
  write(U'二', true);
  write(U'二', false);
  clock_.advance(days(1));
  EXPECT_TRUE(hard().empty());
  write(U'一', false);
  write(U'二', false);
  ASSERT_EQ(hard().size(), 1U);
  EXPECT_EQ(hard()[0], (HardCharacter{U'一', 2, std::nullopt}));
  ASSERT_TRUE(learner_->store().undo());
  ASSERT_TRUE(learner_->store().undo());
  EXPECT_TRUE(hard().empty()) << "what was undone did not fail";
}

TEST_F(HardCharacters, TheMostOftenFailedComesFirstAndEquallyOftenFailedOnesByCodePoint) {
  for (int day = 0; day < 3; ++day) {
    if (day < 2) write(U'三', false);
    if (day < 2) write(U'一', false);
    write(U'四', false);
    clock_.advance(days(1));
  }
  std::vector<char32_t> order;
  for (const auto& one : hard()) order.push_back(one.character);
  EXPECT_THAT(order, testing::ElementsAre(U'四', U'一', U'三'));
  EXPECT_EQ(hard(1).size(), 1U);
  ASSERT_TRUE(learner_->store().pause(std::vector<char32_t>{U'四'}));
  EXPECT_EQ(hard(1)[0].character, U'一') << "a suspended character rests";
}

TEST_F(HardCharacters, AfterFourWeeksTheyAreForgiven) {
  write(U'一', false);
  clock_.advance(days(1));
  write(U'一', false);
  clock_.advance(days(kHardDays - 2));
  EXPECT_EQ(hard().size(), 1U);
  clock_.advance(days(1));
  EXPECT_TRUE(hard().empty());
}

TEST_F(HardCharacters, TheHardestStrokeIsTheOneWithTheMostFrequentMistake) {
  write(U'四', false, {{MistakeKind::missing, 2}, {MistakeKind::missing, 2}, {MistakeKind::order, 0}});
  EXPECT_EQ(trouble(U'四'), std::nullopt) << "once is not often";
  write(U'四', false, {{MistakeKind::missing, 2}, {MistakeKind::reversed, 1}, {MistakeKind::ending, 3}});
  write(U'四', true, {{MistakeKind::reversed, 1}, {MistakeKind::ending, 3}});
  write(U'四', true, {{MistakeKind::ending, 3}});
  // Twice each; of equals the earlier stroke. Endings are advice.
  EXPECT_EQ(trouble(U'四'), (StrokeTrouble{1, MistakeKind::reversed, 2, 5}));
  write(U'四', false, {{MistakeKind::missing, 2}}, study::Stage::guided);
  EXPECT_EQ(trouble(U'四'), (StrokeTrouble{2, MistakeKind::missing, 3, 6}));
  write(U'四', true, {}, study::Stage::watch);
  EXPECT_EQ(trouble(U'四')->writings, 6) << "watching is no writing";
}

TEST(StrokeTroubleOfStatistics, IsTheKindThatIsMostFrequent) {
  study::HardStroke stroke{U'休', 2, 6, 28, {{MistakeKind::missing, 4}, {MistakeKind::order, 3}}};
  EXPECT_EQ(trouble_of(stroke), (StrokeTrouble{2, MistakeKind::missing, 4, 28}));
  stroke.kinds = {{MistakeKind::wrong, 9}};
  EXPECT_EQ(trouble_of(stroke).times, 6) << "twice in one writing is one writing";
}

}  // namespace
}  // namespace nazori::practice
