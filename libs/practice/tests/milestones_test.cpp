// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/milestones.h"

#include <gmock/gmock.h>

#include "nazori/practice/character_choice.h"
#include "session_under_test.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using study::StudyDay;

study::Day at(int day) { return study::Day(days(20'000 + day)); }
StudyDay introduced(int day, int characters) { return {at(day), characters, characters, characters}; }

TEST(NewPace, OfTheLastFourWeeksCountsDaysWithoutStudyToo) {
  const std::vector studied{introduced(0, 50), introduced(73, 8), introduced(90, 3), introduced(100, 3)};
  EXPECT_EQ(new_pace(studied, at(100)), (NewPace{14, 28})) << "the day 27 days ago is the first that counts";
  EXPECT_EQ(new_pace(studied, at(101)), (NewPace{6, 28}));
  EXPECT_EQ(new_pace(studied, at(99)), (NewPace{11, 28})) << "what comes later does not count";
}

TEST(NewPace, OfABeginnerIsMeasuredFromTheFirstDay) {
  EXPECT_EQ(new_pace({}, at(3)), NewPace());
  EXPECT_EQ(new_pace(std::vector{introduced(3, 5)}, at(3)), (NewPace{5, 1}));
  EXPECT_EQ(new_pace(std::vector{introduced(3, 5), introduced(6, 5)}, at(6)), (NewPace{10, 4}));
}

TEST(NewPace, ForetellsWholeDaysRoundedUp) {
  const NewPace half_a_day{14, 28};
  EXPECT_EQ(half_a_day.days_for(0), 0);
  EXPECT_EQ(half_a_day.days_for(1), 2);
  EXPECT_EQ(half_a_day.days_for(20), 40);
  EXPECT_EQ((NewPace{3, 7}).days_for(1), 3) << "2.33 days";
  EXPECT_EQ((NewPace{3, 7}).days_for(3), 7);
  EXPECT_EQ((NewPace{0, 28}).days_for(1), std::nullopt);
  EXPECT_EQ((NewPace{1, 28}).days_for(652), 18'256);
  EXPECT_EQ((NewPace{1, 28}).days_for(653), std::nullopt) << "more than fifty years";
}

class MilestonesTest : public SessionTest {
 protected:
  void choose(std::vector<std::string> lists) {
    auto settings = learner_->store().settings();
    settings.new_lists = std::move(lists);
    settings.new_order = study::NewOrder::own;
    ASSERT_TRUE(learner_->store().change_settings(settings));
    learner_->renew_order();
  }
  void save(const char* name, std::vector<char32_t> characters) {
    ASSERT_TRUE(learner_->store().save_list({name, std::move(characters)}));
  }
  /// Begins a character today; it is recently learned after that, or still being learned.
  void begin(char32_t character, study::Rating rating = study::Rating::easy) {
    study::Writing writing;
    writing.rating = rating;
    writing.result.duration = std::chrono::seconds(9);
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing));
  }
  std::vector<Milestone> now() {
    const auto found = milestones(*learner_);
    EXPECT_TRUE(found);
    return *found;
  }
};

TEST_F(MilestonesTest, OnTheFirstDayNothingIsForetold) {
  save("a", {U'あ', U'い', U'う'});
  choose({"list:a"});
  EXPECT_THAT(now(), testing::ElementsAre(Milestone{"list:a", 0, 0, 3, std::nullopt}));
}

TEST_F(MilestonesTest, AtThePresentPaceAndInTheLearningOrder) {
  save("a", {U'あ', U'い', U'う', U'え', U'お'});
  save("b", {U'か', U'き'});
  choose({"list:a", "list:b"});
  begin(U'あ');
  begin(U'い', study::Rating::good);
  begin(U'か');
  // Three a day: う え お today, き tomorrow.
  const auto found = now();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], (Milestone{"list:a", 1, 2, 5, 1})) << "い is still being learned";
  EXPECT_EQ(found[1], (Milestone{"list:b", 1, 1, 2, 2}));
  clock_.advance(days(5));
  EXPECT_EQ(now()[0].days_left, 6) << "three in six days";
}

TEST_F(MilestonesTest, TheListOfTheNextNewCharacterComesFirstAndLearnedListsLast) {
  save("a", {U'あ', U'い'});
  save("b", {U'い', U'う'});
  save("c", {U'え'});
  choose({"list:c", "list:a", "list:b"});
  begin(U'え');
  begin(U'あ');
  begin(U'い', study::Rating::good);
  const auto found = now();
  ASSERT_EQ(found.size(), 2U) << "c is learned";
  EXPECT_EQ(found[0].list, "list:b") << "う is next";
  EXPECT_EQ(found[1], (Milestone{"list:a", 1, 2, 2, std::nullopt})) << "all are begun";
  choose({"list:c"});
  EXPECT_EQ(now(), (std::vector{Milestone{"list:c", 1, 1, 1, std::nullopt}}));
}

TEST_F(MilestonesTest, AllSchoolKanjiAreTwoThousandOneHundredAndThirtySix) {
  choose({"grade-1", "secondary"});
  begin(U'一');
  const auto found = now();
  ASSERT_EQ(found.size(), 2U) << "secondary school is not begun";
  EXPECT_EQ(found[0].list, "grade-1");
  EXPECT_EQ(found[0].size, 80);
  EXPECT_EQ(found[0].days_left, 79);
  EXPECT_EQ(found[1], (Milestone{kSchoolKanji, 1, 1, 2136, std::nullopt})) << "other grades are not chosen";
}

TEST_F(MilestonesTest, WhatIsMarkedAsKnownIsLearnedButSetsNoPace) {
  save("a", {U'一', U'二', U'三'});
  choose({"list:a"});
  ASSERT_TRUE(mark_known(*learner_, U'一'));
  EXPECT_EQ(now()[0], (Milestone{"list:a", 1, 1, 3, std::nullopt}));
  begin(U'二');
  EXPECT_EQ(now()[0], (Milestone{"list:a", 2, 2, 3, 1}));
}

TEST_F(MilestonesTest, WhatDoesNotComeByItselfIsNotForetold) {
  save("a", {U'一', U'二', U'三'});
  choose({"list:a"});
  begin(U'一');
  ASSERT_TRUE(learner_->store().pause(std::vector<char32_t>{U'三'}));
  EXPECT_EQ(now()[0].days_left, std::nullopt) << "三 is suspended";
}

}  // namespace
}  // namespace nazori::practice
