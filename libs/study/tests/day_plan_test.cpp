// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/day_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "learner_fixture.h"
#include "nazori/study/character_lists.h"
#include "nazori/study/pace.h"
#include "nazori/study/profiles.h"
#include "nazori/study/statistics.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;
using test::MovedClock;
using test::must;
using test::review;
using test::TemporaryFolder;
using test::use_zone;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<char32_t> kOrder{U'一', U'二', U'三', U'四', U'五', U'六', U'七', U'八', U'九', U'十'};

struct Learner {
  MovedClock clock{"2026-01-01T09:00:00Z"};
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  Learner() { use_zone(store, "UTC"); }
  void settings(const std::function<void(Settings&)>& change) {
    Settings settings = store.settings();
    change(settings);
    ASSERT_TRUE(store.change_settings(settings));
  }
  void write(char32_t c, Rating rating) { (void)must(store.add_writing(c, 4, review(rating))); }
  [[nodiscard]] DayPlan plan() const { return must(plan_day(store, kOrder)); }
};

std::u32string characters(const std::vector<StudyTask>& tasks) {
  std::u32string all;
  for (const StudyTask& task : tasks) all += task.character;
  return all;
}

TEST(DayPlan, AFirstDayHoldsTheFirstNewCharacters) {
  const Learner learner;
  const DayPlan plan = learner.plan();
  EXPECT_EQ(characters(plan.now), U"一二三四五");
  EXPECT_EQ(plan.now[0].stage, Stage::watch);
  EXPECT_EQ(plan.estimate, minutes(15));
}

TEST(DayPlan, TheLimitOfNewCharactersCountsThoseMetToday) {
  Learner learner;
  learner.write(U'一', Rating::easy);
  learner.write(U'二', Rating::easy);
  EXPECT_EQ(characters(learner.plan().now), U"三四五");
  EXPECT_EQ(learner.plan().new_done, 2);
  // 02:00 at night is still the same study day, 05:00 is not.
  learner.clock.set("2026-01-02T02:00:00Z");
  EXPECT_EQ(learner.plan().count(TaskKind::fresh), 3);
  learner.clock.set("2026-01-02T05:00:00Z");
  EXPECT_EQ(characters(learner.plan().now), U"三四五六七");
}

TEST(DayPlan, StepsComeWhenTheirMinuteHasCome) {
  Learner learner;
  learner.settings([](Settings& s) { s.new_per_day = 1; });
  learner.write(U'一', Rating::again);
  // Nothing else to do: the step that is nearly due comes early.
  EXPECT_EQ(characters(learner.plan().now), U"一");
  learner.settings([](Settings& s) { s.new_per_day = 2; });
  EXPECT_EQ(characters(learner.plan().now), U"二");
  EXPECT_EQ(characters(learner.plan().later_today), U"一");
  learner.clock.advance(minutes(1));
  EXPECT_EQ(characters(learner.plan().now), U"一二");
  EXPECT_EQ(learner.plan().now[0].kind, TaskKind::step);
}

TEST(DayPlan, ReviewsAreDueFromTheBeginningOfTheirDay) {
  Learner learner;
  learner.settings([](Settings& s) { s.new_per_day = 0; });
  learner.write(U'一', Rating::easy);  // 09:00, eight days
  learner.clock.set("2026-01-09T03:59:00Z");
  EXPECT_TRUE(learner.plan().now.empty());
  learner.clock.set("2026-01-09T04:00:00Z");
  EXPECT_EQ(characters(learner.plan().now), U"一");
  EXPECT_NEAR(learner.plan().now[0].retrievability, 0.9, 0.005);
}

TEST(DayPlan, WhatIsPausedPostponedOrSetApartDoesNotCome) {
  Learner learner;
  learner.settings([](Settings& s) { s.new_per_day = 0; });
  for (const char32_t c : {U'一', U'二', U'三'}) learner.write(c, Rating::easy);
  learner.clock.advance(days(8));
  const std::array one{U'一'};
  const std::array two{U'二'};
  ASSERT_TRUE(learner.store.pause(one));
  ASSERT_TRUE(learner.store.postpone(two, learner.store.today() + days(2)));
  EXPECT_EQ(characters(learner.plan().now), U"三");
  learner.clock.advance(days(2));
  ASSERT_TRUE(learner.store.resume(one));
  EXPECT_EQ(learner.plan().count(TaskKind::review), 3);
}

/// 200 characters learned in ten days, then an absence.
Learner away(int days_away) {
  Learner learner;
  learner.settings([](Settings& s) {
    s.new_per_day = 20;
    s.reviews_per_day = 40;
  });
  for (int i = 0; i < 200; ++i) {
    learner.write(U'亜' + static_cast<char32_t>(i), i % 3 == 0 ? Rating::good : Rating::easy);
    if (i % 3 == 0) learner.write(U'亜' + static_cast<char32_t>(i), Rating::good);
    if (i % 20 == 19) learner.clock.advance(days(1));
  }
  learner.clock.advance(days(days_away));
  return learner;
}

TEST(DayPlan, AfterAMonthAwayAGentlePlanWaitsNotAWall) {
  Learner learner = away(30);
  DayPlan plan = learner.plan();
  ASSERT_TRUE(plan.gentle);
  EXPECT_EQ(plan.gentle->overdue, 200);
  EXPECT_EQ(plan.count(TaskKind::review), 20);  // half of the limit on the first day
  EXPECT_EQ(plan.count(TaskKind::fresh), 0);
  EXPECT_EQ(plan.held_back, 180);
  for (std::size_t i = 1; i < plan.now.size(); ++i) {
    EXPECT_GE(plan.now[i - 1].retrievability, plan.now[i].retrievability);
  }
  // The plan is correct: studied as planned, the backlog ends on its last day, with no day over the limit.
  const Day last = plan.gentle->last_day;
  EXPECT_GT(plan.gentle->days, 3);
  int studied = 0;
  for (; plan.gentle && studied < 60; ++studied) {
    EXPECT_LE(plan.count(TaskKind::review), 40);
    for (const StudyTask& task : plan.now) learner.write(task.character, Rating::easy);
    learner.clock.advance(days(1));
    plan = learner.plan();
  }
  EXPECT_LE(std::abs((learner.store.today() - last).count()), 2) << studied;
}

TEST(DayPlan, TheGentlePlanCountsWhatFallsDueMeanwhile) {
  // 100 characters fall due while the learner is away, 60 better known ones a week after the return.
  Learner learner;
  learner.settings([](Settings& s) { s.reviews_per_day = 20; });
  for (char32_t c = U'亜'; c < U'亜' + 60; ++c) learner.write(c, Rating::easy);
  learner.clock.advance(days(8));
  for (char32_t c = U'亜'; c < U'亜' + 60; ++c) learner.write(c, Rating::good);
  for (char32_t c = U'一'; c < U'一' + 100; ++c) learner.write(c, Rating::easy);
  const Day comes = *learner.store.card(U'亜').due_day;
  learner.clock.advance(comes - days(5) - learner.store.today());
  DayPlan plan = learner.plan();
  ASSERT_TRUE(plan.gentle);
  EXPECT_EQ(plan.gentle->overdue, 100);
  // 10, 15 and 18, then 20 a day: 17 are left when the 60 come on the sixth day, of which 20 a day are done.
  const std::array days_of{10, 15, 18, 20, 20, 20, 20, 20, 17};
  EXPECT_EQ(std::accumulate(days_of.begin(), days_of.end(), 0), 160);
  EXPECT_EQ(plan.gentle->days, static_cast<int>(days_of.size()));
  EXPECT_EQ(plan.gentle->last_day, learner.store.today() + days(8));
  for (std::size_t i = 0; i < days_of.size(); ++i) {
    // The last day has no more than its limit, so no plan is needed.
    EXPECT_EQ(plan.gentle.has_value(), i + 1 < days_of.size()) << i;
    EXPECT_EQ(plan.count(TaskKind::review), days_of.at(i));
    for (const StudyTask& task : plan.now) learner.write(task.character, Rating::easy);
    learner.clock.advance(days(1));
    plan = learner.plan();
  }
  EXPECT_EQ(plan.count(TaskKind::review), 0);
}

TEST(DayPlan, PracticeDuringTheAbsenceIsNoReview) {
  Learner learner = away(30);
  Writing practice = review(Rating::good);
  practice.stage = Stage::trace;
  (void)must(learner.store.add_writing(U'龍', 16, practice));
  learner.clock.advance(days(1));
  EXPECT_EQ(learner.plan().count(TaskKind::review), 20) << "still the first day back";
}

TEST(DayPlan, UnfinishedStepsOfEarlierDaysObeyTheLimit) {
  Learner learner;
  learner.settings([](Settings& s) {
    s.new_per_day = 60;
    s.reviews_per_day = 25;
  });
  // Sixty characters, all left in their learning steps.
  for (char32_t c = U'亜'; c < U'亜' + 60; ++c) learner.write(c, Rating::again);
  learner.clock.advance(minutes(2));
  EXPECT_EQ(learner.plan().count(TaskKind::step), 60) << "today's own work always comes";
  EXPECT_EQ(learner.plan().held_back, 0);

  learner.clock.advance(days(3));
  DayPlan plan = learner.plan();
  EXPECT_EQ(plan.count(TaskKind::step), 25);
  EXPECT_EQ(plan.held_back, 35);
  EXPECT_EQ(plan.count(TaskKind::fresh), 0);
  ASSERT_TRUE(plan.gentle);
  EXPECT_EQ(plan.gentle->overdue, 60);
  EXPECT_EQ(plan.gentle->per_day, 25);
  EXPECT_EQ(plan.gentle->days, 3);
  EXPECT_EQ(plan.estimate, 25 * Pace().recalled);

  // Reviews done today count; a step that follows from them comes nevertheless.
  learner.write(plan.now[0].character, Rating::good);
  learner.write(plan.now[1].character, Rating::easy);
  plan = learner.plan();
  EXPECT_EQ(plan.reviews_done, 2);
  EXPECT_EQ(plan.count(TaskKind::step), 23);
  EXPECT_EQ(plan.later_today.size(), 1U);
  learner.clock.advance(minutes(11));
  EXPECT_EQ(learner.plan().count(TaskKind::step), 24);
  EXPECT_EQ(learner.plan().held_back, 35);
}

TEST(DayPlan, UnfinishedStepsAndReviewsShareTheLimitTheBestKnownFirst) {
  Learner learner;
  learner.settings([](Settings& s) {
    s.new_per_day = 0;
    s.reviews_per_day = 6;
  });
  for (char32_t c = U'亜'; c < U'亜' + 5; ++c) learner.write(c, Rating::easy);
  for (char32_t c = U'亜' + 5; c < U'亜' + 10; ++c) learner.write(c, Rating::again);
  learner.clock.advance(days(8));
  // Seven days without a review halve the limit.
  DayPlan plan = learner.plan();
  EXPECT_EQ(plan.now.size(), 3U);
  EXPECT_EQ(plan.held_back, 7);
  EXPECT_EQ(plan.count(TaskKind::review), 3) << "they are known better";
  learner.settings([](Settings& s) { s.reviews_per_day = 14; });
  plan = learner.plan();
  ASSERT_EQ(plan.now.size(), 7U);
  EXPECT_EQ(plan.count(TaskKind::review), 5);
  EXPECT_EQ(plan.now[0].kind, TaskKind::step) << "steps stand before reviews";
  EXPECT_EQ(plan.now[2].kind, TaskKind::review);
}

TEST(DayPlan, AStepThatFallsDueAfterMidnightIsOfToday) {
  Learner learner;
  learner.settings([](Settings& s) {
    s.new_per_day = 0;
    s.reviews_per_day = 1;
  });
  learner.clock.set("2026-01-02T03:59:30Z");  // the study day begins at 04:00
  for (const char32_t c : {U'一', U'二', U'三'}) learner.write(c, Rating::again);
  learner.clock.set("2026-01-02T04:05:00Z");
  EXPECT_EQ(learner.plan().count(TaskKind::step), 3);
  EXPECT_EQ(learner.plan().held_back, 0);
  learner.clock.set("2026-01-03T04:00:00Z");
  EXPECT_EQ(learner.plan().count(TaskKind::step), 1);
  EXPECT_EQ(learner.plan().held_back, 2);
}

TEST(DayPlan, ADayMissedIsNoReturn) {
  Learner learner = away(2);
  EXPECT_EQ(learner.plan().count(TaskKind::review),
            std::min(40, learner.plan().count(TaskKind::review) + learner.plan().held_back));
}

TEST(Streak, ADayOffInSevenIsForgiven) {
  const auto day = [](int n) { return *parse_day("2026-01-01") + days(n); };
  const auto streak = [&](std::initializer_list<int> studied, int today) {
    std::vector<Day> all;
    for (const int n : studied) all.push_back(day(n));
    return streak_of(all, day(today));
  };
  EXPECT_EQ(streak({}, 5).days, 0);
  EXPECT_EQ(streak({1, 2, 3}, 3), (Streak{3, 3, true, false}));
  EXPECT_EQ(streak({1, 2, 3}, 4), (Streak{3, 3, false, false}));
  EXPECT_EQ(streak({1, 2, 3}, 5), (Streak{3, 3, false, true}));
  EXPECT_EQ(streak({1, 2, 3}, 6).days, 0);
  EXPECT_EQ(streak({1, 2, 4, 5}, 5), (Streak{4, 4, true, true}));
  EXPECT_EQ(streak({1, 2, 4, 6}, 6).days, 1);
  EXPECT_EQ(streak({1, 2, 4, 5, 6, 7, 8, 9, 11}, 11), (Streak{9, 9, true, true}));
}

TEST(Statistics, AddUpWhatWasDone) {
  Learner learner;
  learner.write(U'一', Rating::easy);
  Writing trace = review(Rating::good);
  trace.stage = Stage::trace;
  (void)must(learner.store.add_writing(U'二', 2, trace, test::some_ink()));
  learner.clock.advance(days(8));
  learner.write(U'一', Rating::hard);  // mistakes: wrong at the third stroke, ending at the first
  learner.clock.advance(days(1));
  learner.write(U'一', Rating::again);
  learner.write(U'三', Rating::easy);
  (void)must(learner.store.undo());
  const Statistics statistics = must(statistics_of(learner.store));
  ASSERT_EQ(statistics.days.size(), 3U);
  EXPECT_EQ(statistics.days[0],
            (DayActivity{*parse_day("2026-01-01"), 1, 1, 2, 2 * std::chrono::milliseconds(12'345)}));
  EXPECT_EQ(statistics.reviews, 3);
  EXPECT_EQ(statistics.retention.reviews, 2);
  EXPECT_EQ(statistics.retention.recalled, 1);
  EXPECT_NEAR(statistics.retention.predicted, (0.9024733 + Fsrs().retrievability(26.70418346, 1)) / 2, 1e-6);
  ASSERT_EQ(statistics.hard_strokes.size(), 2U);
  EXPECT_EQ(statistics.hard_strokes[1].stroke, 2);
  EXPECT_EQ(statistics.hard_strokes[1].kinds.at(kanji::MistakeKind::wrong), 2);
  EXPECT_EQ(statistics.hard_strokes[1].writings, 3);
  ASSERT_EQ(statistics.motion.size(), 1U);
  EXPECT_GT(statistics.motion[0].speed, 0);
  EXPECT_EQ(statistics.characters.size(), 2U);
  EXPECT_EQ(statistics.forecast.size(), 30U);
  EXPECT_EQ(statistics.forecast[0].reviews, 1);
}

TEST(Workload, MoreRetentionCostsMoreReviews) {
  FsrsSettings settings;
  double last = 0;
  for (const double wanted : {0.80, 0.85, 0.90, 0.95, 0.97}) {
    settings.desired_retention = wanted;
    const Workload workload = must(expected_workload(settings, 5));
    EXPECT_GT(workload.reviews_per_day, last) << wanted;
    last = workload.reviews_per_day;
    EXPECT_GT(workload.known, 1000);
    EXPECT_LT(workload.known, 1825);
  }
  EXPECT_EQ(must(expected_workload(settings, 0)).reviews_per_day, 0);
  EXPECT_FALSE(expected_workload(settings, -1));
}

TEST(LearningOrder, PutsPartsBeforeWholes) {
  const std::map<char32_t, CharacterFacts> facts{{U'林', {U'林', 1, 656, 3, 8, {U'木'}}},
                                                 {U'森', {U'森', 1, 609, 3, 12, {U'木', U'林'}}},
                                                 {U'木', {U'木', 1, 317, 4, 4, {}}},
                                                 {U'一', {U'一', 1, 2, 4, 1, {}}},
                                                 {U'休', {U'休', 1, 642, 4, 6, {U'木', U'人'}}},
                                                 {U'丁', {U'丁', 3, 1312, 1, 2, {U'一'}}}};
  const auto find = [&](char32_t c) {
    const auto found = facts.find(c);
    return found == facts.end() ? nullptr : &found->second;
  };
  const std::vector<char32_t> all{U'森', U'丁', U'休', U'林', U'木', U'一'};
  const auto order = [&](NewOrder by) {
    const auto sorted = sort_for_learning(all, by, find);
    return std::u32string(sorted.begin(), sorted.end());
  };
  EXPECT_EQ(order(NewOrder::own), U"森丁休林木一");
  EXPECT_EQ(order(NewOrder::frequency), U"一木森休林丁");
  EXPECT_EQ(order(NewOrder::grade), U"一木森休林丁");
  EXPECT_EQ(order(NewOrder::strokes), U"一丁木休林森");
  EXPECT_EQ(order(NewOrder::components), U"一木林森休丁");
}

TEST(CharacterLists, HoldWhatTheDatabaseSays) {
  const auto database = must(kanji::KanjiDatabase::open(must(kanji::KanjiDatabase::locate())));
  const Learner learner;
  CharacterLists lists(database);
  const auto count = [&](const char* id) { return must(lists.members(id, learner.store)).size(); };
  // 80, 160, 200, 202, 193, 191: the kyouiku kanji since 2020; 103 and 181: the old JLPT levels 4 and 3.
  EXPECT_EQ(count("grade-1"), 80U);
  EXPECT_EQ(count("grade-6"), 191U);
  EXPECT_EQ(count("old-jlpt-4"), 103U);
  EXPECT_EQ(count("old-jlpt-3"), 181U);
  EXPECT_FALSE(lists.members("grade-7", learner.store));
  const auto order = must(lists.in_learning_order(learner.store.settings(), learner.store));
  EXPECT_EQ(order.size(), 2136U);
  EXPECT_EQ(lists.facts(order[79])->grade, 1);
  EXPECT_EQ(lists.facts(order[80])->grade, 2);
  // A removed list is ignored.
  Settings settings = learner.store.settings();
  settings.new_lists = {"list:gone", "grade-1", "tag:gone"};
  EXPECT_EQ(must(lists.in_learning_order(settings, learner.store)).size(), 80U);
}

TEST(ListText, IsReadWithItsNotes) {
  const auto known = [](char32_t c) { return c >= 0x3041; };
  EXPECT_THAT(must(parse_list("\xEF\xBB\xBF休 木, 林 # trees\n\n森、休\r\nあ", known)),
              ElementsAre(U'休', U'木', U'林', U'森', U'あ'));
  EXPECT_THAT(base::to_line(parse_list("休\n木x", known).error()),
              testing::AllOf(HasSubstr("line 2"), HasSubstr("'x'")));
  EXPECT_THAT(base::to_line(parse_list("休\n\xFF", known).error()), HasSubstr("line 2"));
  EXPECT_THAT(base::to_line(parse_list("# nothing\n", known).error()), HasSubstr("no character"));
}

TEST(Profiles, AreFoldersThatAreMovedNotDeleted) {
  const TemporaryFolder folder;
  const auto root = folder / "learners";
  EXPECT_TRUE(profiles(root).empty());
  for (const char* name : {"Mari", "健太"})
    (void)must(LearnerStore::open(must(learner_file(root, name)), Access::write));
  EXPECT_THAT(profiles(root), ElementsAre("Mari", "健太"));
  ASSERT_TRUE(rename_profile(root, "Mari", "Marie"));
  EXPECT_FALSE(rename_profile(root, "Marie", "健太"));
  {
    const LearnerStore held = must(LearnerStore::open(must(learner_file(root, "健太")), Access::write));
    EXPECT_EQ(remove_profile(root, "健太").error().code, base::Errc::in_use);
  }
  EXPECT_TRUE(std::filesystem::exists(must(remove_profile(root, "健太")) / "learner.db"));
  EXPECT_THAT(profiles(root), ElementsAre("Marie"));
  for (const char* name : {"", "..", "a/b", ".hidden", "two\nlines"}) {
    EXPECT_FALSE(learner_file(root, name)) << name;
  }
}

}  // namespace
}  // namespace nazori::study
