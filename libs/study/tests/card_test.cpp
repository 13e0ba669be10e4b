// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/card.h"

#include <gtest/gtest.h>

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::hours;

const Day kFirst = *parse_day("2026-01-01");

LogEntry written(int day, Stage stage, Rating rating) {
  LogEntry entry;
  entry.day = kFirst + days(day);
  entry.at = entry.day + hours(9);
  entry.character = U'木';
  entry.strokes = 4;
  entry.writing.stage = stage;
  entry.writing.rating = rating;
  entry.writing.result.accepted = rating != Rating::again;
  return entry;
}

LogEntry about(EntryKind kind) {
  LogEntry entry;
  entry.kind = kind;
  entry.character = U'木';
  return entry;
}

/// A history after reviews, each on its day.
CardHistory reviewed(std::initializer_list<std::pair<int, Rating>> reviews, const Settings& settings = {}) {
  CardHistory history(U'木');
  for (const auto& [day, rating] : reviews) history.apply(written(day, Stage::memory, rating), settings);
  return history;
}

TEST(Card, OfACharacterNeverMetIsEmpty) {
  const CardHistory history(U'木');
  EXPECT_FALSE(history.met());
  Card expected;
  expected.character = U'木';
  EXPECT_EQ(history.card(), expected);
  EXPECT_FALSE(expected.introduced || expected.last_day || expected.due_day || expected.postponed_until);
  EXPECT_FALSE(expected.paused || expected.leech);
  EXPECT_EQ(expected.leech_at, 0);
  EXPECT_EQ(expected.practices, 0);
  EXPECT_EQ(expected.next_stage, Stage::watch);
  EXPECT_EQ(expected.help, 1);
  EXPECT_EQ(Card().character, char32_t{0});
}

TEST(Card, EachKindOfEntryMakesACharacterMet) {
  for (const EntryKind kind : {EntryKind::writing, EntryKind::postpone, EntryKind::pause, EntryKind::resume,
                               EntryKind::reset, EntryKind::leech_met}) {
    CardHistory history(U'木');
    history.apply(about(kind), {});
    EXPECT_TRUE(history.met()) << name_of(kind);
  }
}

TEST(Card, IsDueAfterTheIntervalThatTheLogHolds) {
  CardHistory history(U'木');
  LogEntry entry = written(0, Stage::memory, Rating::easy);
  entry.interval_days = 6;
  history.apply(entry, {});
  EXPECT_EQ(history.card().memory.scheduled_days, 6);
  EXPECT_EQ(history.card().memory.due, entry.at + days(6));
  EXPECT_EQ(history.card().due_day, kFirst + days(6));
  // In its steps it has no due day, whatever the log says.
  CardHistory step(U'木');
  entry.writing.rating = Rating::again;
  step.apply(entry, {});
  EXPECT_FALSE(step.card().due_day);
  EXPECT_EQ(step.card().memory.scheduled_days, 0);
}

TEST(Card, LosesItsDueDayWhenItIsForgotten) {
  const CardHistory history = reviewed({{0, Rating::easy}, {8, Rating::again}});
  EXPECT_FALSE(history.card().due_day);
  EXPECT_EQ(history.card().last_day, kFirst + days(8));
  EXPECT_EQ(history.card().introduced, kFirst);
}

TEST(Card, AReviewEndsAPostponement) {
  CardHistory history = reviewed({{0, Rating::easy}});
  LogEntry later = about(EntryKind::postpone);
  later.until = kFirst + days(20);
  history.apply(later, {});
  EXPECT_EQ(history.card().postponed_until, kFirst + days(20));
  history.apply(written(9, Stage::trace, Rating::good), {});
  EXPECT_EQ(history.card().postponed_until, kFirst + days(20)) << "practice does not";
  history.apply(written(9, Stage::memory, Rating::good), {});
  EXPECT_FALSE(history.card().postponed_until);
}

TEST(Card, APauseHoldsUntilItIsResumed) {
  CardHistory history = reviewed({{0, Rating::easy}});
  history.apply(about(EntryKind::pause), {});
  EXPECT_TRUE(history.card().paused);
  history.apply(written(1, Stage::memory, Rating::good), {});
  EXPECT_TRUE(history.card().paused);
  history.apply(about(EntryKind::reset), {});
  EXPECT_TRUE(history.card().paused) << "new again, and still paused";
  history.apply(about(EntryKind::resume), {});
  EXPECT_FALSE(history.card().paused);
}

TEST(Card, ThatIsResetKeepsNothingOfItsReviews) {
  CardHistory history = reviewed({{0, Rating::easy}, {8, Rating::again}});
  history.apply(written(8, Stage::trace, Rating::good), {});
  EXPECT_EQ(history.card().practices, 1);
  history.apply(about(EntryKind::reset), {});
  Card expected;
  expected.character = U'木';
  EXPECT_EQ(history.card(), expected);
  Settings others;
  others.fsrs.weights[2] = 4;
  history.change_settings(others);
  EXPECT_EQ(history.card(), expected) << "nor do other weights bring them back";
  history.apply(written(10, Stage::memory, Rating::easy), {});
  EXPECT_EQ(history.card().introduced, kFirst + days(10));
  EXPECT_EQ(history.card().memory, Fsrs().next({}, Rating::easy, kFirst + days(10) + hours(9), 0));
}

TEST(Card, IsALeechAfterJustSoManyLapses) {
  Settings settings;
  settings.leech_lapses = 2;
  CardHistory history = reviewed({{0, Rating::easy}, {9, Rating::again}, {10, Rating::easy}}, settings);
  EXPECT_EQ(history.card().memory.lapses, 1);
  EXPECT_FALSE(history.card().leech);
  history.apply(written(30, Stage::memory, Rating::again), settings);
  EXPECT_EQ(history.card().memory.lapses, 2);
  EXPECT_TRUE(history.card().leech);
  // It was relearned: two more lapses are allowed.
  history.apply(about(EntryKind::leech_met), settings);
  EXPECT_FALSE(history.card().leech);
  EXPECT_EQ(history.card().leech_at, 4);
  EXPECT_EQ(history.card().next_stage, Stage::guided);
  for (const int begin : {40, 80}) {
    EXPECT_FALSE(history.card().leech);
    history.apply(written(begin, Stage::memory, Rating::easy), settings);
    history.apply(written(begin + 30, Stage::memory, Rating::again), settings);
  }
  EXPECT_TRUE(history.card().leech);
}

TEST(Card, ALearnersOwnNumberOfLapsesAllowsHalfAsManyMore) {
  for (const auto& [lapses, more] : {std::pair(2, 2), std::pair(5, 2), std::pair(6, 3), std::pair(9, 4)}) {
    Settings settings;
    settings.leech_lapses = lapses;
    CardHistory history = reviewed({{0, Rating::easy}, {9, Rating::again}});
    history.apply(about(EntryKind::leech_met), settings);
    EXPECT_EQ(history.card().leech_at, 1 + more) << lapses;
  }
}

TEST(Card, OnlyForgettingMakesALeech) {
  Settings strict;
  strict.leech_lapses = 2;
  CardHistory history =
      reviewed({{0, Rating::easy}, {9, Rating::again}, {10, Rating::easy}, {30, Rating::again}});
  ASSERT_EQ(history.card().memory.lapses, 2);
  history.apply(written(31, Stage::memory, Rating::hard), strict);
  EXPECT_FALSE(history.card().leech);
}

TEST(Card, WeightsAndStepsChangeTheMemoryOtherSettingsDoNot) {
  const Settings before;
  const auto changes = [&](auto change) {
    Settings after = before;
    change(after);
    return changes_memory(before, after);
  };
  EXPECT_FALSE(changes([](Settings&) {}));
  EXPECT_TRUE(changes([](Settings& s) { s.fsrs.weights[20] = 0.2; }));
  EXPECT_TRUE(changes([](Settings& s) { s.fsrs.short_term_steps = false; }));
  EXPECT_FALSE(changes([](Settings& s) { s.fsrs.desired_retention = 0.8; }));
  EXPECT_FALSE(changes([](Settings& s) { s.fuzz = true; }));
}

TEST(Card, OtherWeightsGoThroughAllReviewsAnew) {
  Settings others;
  others.fsrs.weights[3] = 20;
  CardHistory history =
      reviewed({{0, Rating::easy}, {8, Rating::good}, {8, Rating::hard}, {30, Rating::good}});
  const Card before = history.card();
  history.change_settings(others);
  const CardHistory expected =
      reviewed({{0, Rating::easy}, {8, Rating::good}, {8, Rating::hard}, {30, Rating::good}}, others);
  EXPECT_EQ(history.card().memory.stability, expected.card().memory.stability);
  EXPECT_EQ(history.card().memory.difficulty, expected.card().memory.difficulty);
  EXPECT_EQ(history.card().memory.scheduled_days, before.memory.scheduled_days);
  EXPECT_EQ(history.card().due_day, before.due_day);
  EXPECT_NE(history.card().memory.stability, before.memory.stability);
}

TEST(Card, LearnsByTheLessonOfItsSettings) {
  Settings settings;
  settings.lesson.help_retained = 0.5;
  settings.lesson.help_per_error = 0;
  CardHistory history(U'木');
  LogEntry guided = written(0, Stage::guided, Rating::good);
  guided.writing.result.misses = 1;
  history.apply(guided, settings);
  EXPECT_EQ(history.card().help, 0.5);
  EXPECT_EQ(history.card().next_stage, Stage::guided);
  EXPECT_EQ(history.card().practices, 1);
  EXPECT_EQ(history.card().memory, Memory());
  history.apply(guided, settings);
  EXPECT_EQ(history.card().help, 0.25);
  EXPECT_EQ(history.card().practices, 2);
}

TEST(EntryKinds, AreNamed) {
  for (const EntryKind kind :
       {EntryKind::writing, EntryKind::undo, EntryKind::settings, EntryKind::postpone, EntryKind::pause,
        EntryKind::resume, EntryKind::reset, EntryKind::leech_met, EntryKind::choices, EntryKind::known})
    EXPECT_EQ(entry_kind_named(name_of(kind)), kind);
  EXPECT_FALSE(entry_kind_named("gone"));
  const LogEntry entry;
  EXPECT_EQ(entry.id, 0);
  EXPECT_EQ(entry.action, 0);
  EXPECT_EQ(entry.strokes, 1);
  EXPECT_EQ(entry.character, char32_t{0});
}

TEST(Card, SaysHowFarAwayItsReviewIsInTheUnitOfItsSize) {
  using Unit = ReviewDelay::Unit;
  const Time now = kFirst + hours(9);
  Card card;
  card.memory.phase = Phase::learning;
  const std::pair<std::chrono::seconds, double> kSteps[] = {{std::chrono::seconds(-5), 1},
                                                            {std::chrono::seconds(89), 1},
                                                            {std::chrono::seconds(90), 2},
                                                            {hours(1), 60}};
  for (const auto& [time, minutes] : kSteps) {
    card.memory.due = now + time;
    EXPECT_EQ(review_delay(card, now, kFirst), (ReviewDelay{Unit::minutes, minutes})) << time.count();
  }
  card.memory.phase = Phase::review;
  EXPECT_EQ(review_delay(card, now, kFirst), (ReviewDelay{Unit::days, 1})) << "no day is set";
  const std::pair<int, ReviewDelay> kDays[] = {
      {-3, {Unit::days, 1}},   {0, {Unit::days, 1}},      {2, {Unit::days, 2}},
      {59, {Unit::days, 59}},  {60, {Unit::months, 2}},   {76, {Unit::months, 2}},
      {77, {Unit::months, 3}}, {365, {Unit::months, 12}}, {366, {Unit::years, 366 / 365.25}}};
  for (const auto& [count, delay] : kDays) {
    card.due_day = kFirst + days(count);
    EXPECT_EQ(review_delay(card, now, kFirst), delay) << count;
  }
}

}  // namespace
}  // namespace nazori::study
