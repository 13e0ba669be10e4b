// SPDX-License-Identifier: Apache-2.0
#include "../src/interval_choice.h"

#include <gtest/gtest.h>

#include <map>

namespace nazori::study {
namespace {

using std::chrono::days;

const Day kToday = *parse_day("2026-03-01");

/// Adds `count` characters due after `interval` days, numbered after the existing ones.
void add(Cards& cards, int interval, int count, void (*change)(Card&) = nullptr) {
  for (int i = 0; i < count; ++i) {
    Card card;
    card.character = U'亜' + static_cast<char32_t>(cards.size());
    card.due_day = kToday + days(interval);
    if (change != nullptr) change(card);
    cards[card.character] = card;
  }
}

std::optional<int> balanced(const Cards& cards) {
  Settings settings;
  settings.load_balance = true;
  Memory after;
  after.phase = Phase::review;
  after.scheduled_days = 10;  // may become 8 to 12
  return choose_interval(Fsrs(), settings, cards, U'休', after, 3, kToday);
}

TEST(IntervalChoice, TheDayWithTheLeastLoadIsTaken) {
  Cards cards;
  for (const int interval : {8, 9, 10, 11}) add(cards, interval, 2);
  add(cards, 12, 1);
  EXPECT_EQ(balanced(cards), 12);
  add(cards, 12, 2);
  EXPECT_EQ(balanced(cards), std::nullopt) << "all alike: it stays";
}

TEST(IntervalChoice, OfDaysAlikeTheNearestIsTakenThenTheEarlier) {
  Cards cards;
  add(cards, 10, 1);
  EXPECT_EQ(balanced(cards), 9);
  add(cards, 9, 1);
  EXPECT_EQ(balanced(cards), 11);
  add(cards, 11, 1);
  EXPECT_EQ(balanced(cards), 8);
}

TEST(IntervalChoice, WhatDoesNotComeIsNoLoad) {
  const auto leech = [](Card& card) { card.leech = true; };
  const auto paused = [](Card& card) { card.paused = true; };
  const auto without_day = [](Card& card) { card.due_day.reset(); };
  for (void (*const change)(Card&) : {+leech, +paused, +without_day}) {
    Cards cards;
    for (const int interval : {8, 9, 10, 11}) add(cards, interval, 1);
    add(cards, 12, 5, change);
    EXPECT_EQ(balanced(cards), 12);
  }
}

TEST(IntervalChoice, TheCharacterItselfIsNoLoad) {
  Cards cards;
  for (const int interval : {8, 9, 11, 12}) add(cards, interval, 1);
  Card own;
  own.character = U'休';
  own.due_day = kToday + days(10);
  cards[own.character] = own;
  EXPECT_EQ(balanced(cards), std::nullopt);
}

TEST(IntervalChoice, WithoutTheSettingsOrOutsideOfReviewsNothingMoves) {
  Cards cards;
  add(cards, 10, 3);
  Memory after;
  after.phase = Phase::review;
  after.scheduled_days = 10;
  EXPECT_EQ(choose_interval(Fsrs(), Settings(), cards, U'休', after, 3, kToday), std::nullopt);
  Settings settings;
  settings.load_balance = true;
  after.phase = Phase::relearning;
  EXPECT_EQ(choose_interval(Fsrs(), settings, cards, U'休', after, 3, kToday), std::nullopt);
  after.phase = Phase::review;
  after.scheduled_days = 2;  // too short to move
  EXPECT_EQ(choose_interval(Fsrs(), settings, cards, U'休', after, 1, kToday), std::nullopt);
}

TEST(IntervalChoice, ByChanceEveryDayOfTheRangeIsTakenAboutAsOften) {
  Settings settings;
  settings.fuzz = true;
  std::map<int, int> counts;
  constexpr int kReviews = 5'000;
  for (int i = 0; i < kReviews; ++i) {
    Memory after;
    after.phase = Phase::review;
    after.scheduled_days = 10;
    after.reps = i % 50;
    const auto chosen =
        choose_interval(Fsrs(), settings, {}, U'一' + static_cast<char32_t>(i / 50), after, 3, kToday);
    ++counts[chosen.value_or(10)];
  }
  ASSERT_EQ(counts.size(), 5U);
  for (const auto& [interval, times] : counts) {
    EXPECT_GE(interval, 8);
    EXPECT_LE(interval, 12);
    EXPECT_NEAR(times, kReviews / 5, 5 * 30) << interval;  // five standard deviations
  }
}

TEST(IntervalChoice, EachDayOfTheRangeCountsAndNoOther) {
  for (int free = 8; free <= 12; ++free) {
    Cards cards;
    for (int interval = 1; interval <= 30; ++interval)
      if (interval != free && interval != 7 && interval != 13) add(cards, interval, 1);
    EXPECT_EQ(balanced(cards).value_or(10), free);
  }
}

TEST(IntervalChoice, WhatWasMovedBeyondTheLongestIntervalStays) {
  FsrsSettings longest;
  longest.maximum_interval_days = 5;
  Settings settings;
  settings.load_balance = true;
  settings.fuzz = true;
  Memory after;
  after.phase = Phase::review;
  after.scheduled_days = 6;  // a day more, so that good and hard differ
  EXPECT_EQ(choose_interval(*Fsrs::create(longest), settings, {}, U'休', after, 3, kToday), std::nullopt);
  after.scheduled_days = 5;
  Cards cards;
  add(cards, 5, 1);
  EXPECT_EQ(choose_interval(*Fsrs::create(longest), settings, cards, U'休', after, 3, kToday), 4);
}

TEST(IntervalChoice, BalanceGoesBeforeChance) {
  Settings settings;
  settings.load_balance = true;
  settings.fuzz = true;
  Memory after;
  after.phase = Phase::review;
  after.scheduled_days = 10;
  for (char32_t c = U'一'; c < U'一' + 20; ++c)
    EXPECT_EQ(choose_interval(Fsrs(), settings, {}, c, after, 3, kToday), std::nullopt);
}

TEST(IntervalChoice, ChanceDependsOnTheReviewOnly) {
  // splitmix64 of the character and the number of reviews, by its published recurrence.
  const auto mixed = [](std::uint64_t seed) {
    std::uint64_t z = seed + 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  };
  // The first numbers of the published program for the seed 0.
  ASSERT_EQ(mixed(0), 0xE220A8397B1DCDAFULL);
  Settings settings;
  settings.fuzz = true;
  for (int reps = 0; reps < 200; ++reps) {
    Memory after;
    after.phase = Phase::review;
    after.scheduled_days = 10;
    after.reps = reps;
    const auto place = mixed((std::uint64_t{U'休'} << 32) ^ static_cast<std::uint64_t>(reps)) >> 11;
    const int expected = 8 + static_cast<int>(static_cast<double>(place) / 9007199254740992.0 * 5);
    EXPECT_EQ(choose_interval(Fsrs(), settings, {}, U'休', after, 3, kToday).value_or(10), expected);
  }
}

}  // namespace
}  // namespace nazori::study
