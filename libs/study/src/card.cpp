// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/card.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "named_values.h"

namespace nazori::study {
namespace {

/// Settings of the log are checked before they are written, so creating a scheduler from them cannot fail.
Fsrs scheduler_of(const FsrsSettings& settings) {
  auto fsrs = Fsrs::create(settings);
  assert(fsrs);
  return fsrs ? *std::move(fsrs) : Fsrs();
}

/// Brush and paper are not taken out again after minutes.
Fsrs brush_scheduler_of(FsrsSettings settings) {
  settings.short_term_steps = false;
  return scheduler_of(settings);
}

/// A clock that was set back counts as no time.
int days_since(const std::optional<Day>& last, Day day) {
  return last ? std::max(0, static_cast<int>((day - *last).count())) : 0;
}

ReviewDelay delay_of(double days) {
  using Unit = ReviewDelay::Unit;
  constexpr double kDaysInWords = 60, kDaysInMonth = 30.44, kDaysInYear = 365.25;
  days = std::max(1.0, days);
  if (days < kDaysInWords) return {Unit::days, days};
  if (days < kDaysInYear) return {Unit::months, std::round(days / kDaysInMonth)};
  return {Unit::years, days / kDaysInYear};
}

double days_until(const std::optional<Day>& due, Day today) {
  return due ? static_cast<double>((*due - today).count()) : 1;
}

}  // namespace

std::string_view name_of(EntryKind kind) {
  switch (kind) {
    case EntryKind::writing:
      return "writing";
    case EntryKind::undo:
      return "undo";
    case EntryKind::settings:
      return "settings";
    case EntryKind::postpone:
      return "postpone";
    case EntryKind::pause:
      return "pause";
    case EntryKind::resume:
      return "resume";
    case EntryKind::reset:
      return "reset";
    case EntryKind::leech_met:
      return "leech_met";
    case EntryKind::choices:
      return "choices";
    case EntryKind::known:
      return "known";
  }
  return {};
}

std::optional<EntryKind> entry_kind_named(std::string_view name) { return value_named<EntryKind>(name); }

void CardHistory::review(const LogEntry& entry, Rating rating, std::optional<int> interval_days,
                         const Settings& settings) {
  const Fsrs fsrs = scheduler_of(settings.fsrs);
  const int elapsed_days = days_since(card_.last_day, entry.day);
  card_.memory = fsrs.next(card_.memory, rating, entry.at, elapsed_days);
  answers_.push_back({rating, entry.at, elapsed_days});
  if (card_.memory.phase == Phase::review) {
    if (interval_days) {
      card_.memory.scheduled_days = *interval_days;
      card_.memory.due = entry.at + std::chrono::days(*interval_days);
    }
    card_.due_day = entry.day + std::chrono::days(card_.memory.scheduled_days);
  } else {
    card_.due_day.reset();
  }
  card_.last_day = entry.day;
  card_.postponed_until.reset();
  const int leech_at = card_.leech_at > 0 ? card_.leech_at : settings.leech_lapses;
  if (rating == Rating::again && card_.memory.lapses >= leech_at) card_.leech = true;
}

void CardHistory::review_brush(const LogEntry& entry, const Settings& settings) {
  BrushReviews& brush = card_.brush;
  const int elapsed_days = days_since(brush.last_day, entry.day);
  const Rating rating = entry.writing.rating;
  brush.memory = brush_scheduler_of(settings.fsrs).next(brush.memory, rating, entry.at, elapsed_days);
  brush_answers_.push_back({rating, entry.at, elapsed_days});
  brush.last_day = entry.day;
  brush.due_day = entry.day + std::chrono::days(brush.memory.scheduled_days);
}

void CardHistory::write(const LogEntry& entry, const Settings& settings) {
  if (entry.writing.stage == Stage::brush) return review_brush(entry, settings);
  if (!card_.introduced) card_.introduced = entry.day;
  const Writing& writing = entry.writing;
  Lesson lesson(card_.next_stage, card_.help, settings.lesson);
  lesson.finish(writing.stage, writing.result, std::max(1, entry.strokes));
  card_.next_stage = lesson.next_stage();
  card_.help = lesson.help();
  if (writing.stage == Stage::memory) {
    review(entry, writing.rating, entry.interval_days, settings);
  } else {
    ++card_.practices;
  }
}

void CardHistory::know(const LogEntry& entry, const Settings& settings) {
  if (!card_.introduced) card_.introduced = entry.day;
  card_.paused = false;
  if (card_.leech) relearned(settings);
  card_.next_stage = Stage::memory;
  card_.help = 0;
  std::optional<int> interval_days;
  if (entry.until) interval_days = std::max(1, static_cast<int>((*entry.until - entry.day).count()));
  review(entry, Rating::easy, interval_days, settings);
}

void CardHistory::relearned(const Settings& settings) {
  card_.leech = false;
  card_.leech_at = card_.memory.lapses + std::max(2, settings.leech_lapses / 2);
}

void CardHistory::apply(const LogEntry& entry, const Settings& settings) {
  met_ = true;
  switch (entry.kind) {
    case EntryKind::writing:
      write(entry, settings);
      return;
    case EntryKind::postpone:
      card_.postponed_until = entry.until;
      return;
    case EntryKind::pause:
      card_.paused = true;
      return;
    case EntryKind::resume:
      card_.paused = false;
      return;
    case EntryKind::reset: {
      const char32_t character = card_.character;
      const bool paused = card_.paused;
      card_ = Card{};
      card_.character = character;
      card_.paused = paused;
      answers_.clear();
      brush_answers_.clear();
      return;
    }
    case EntryKind::leech_met:
      relearned(settings);
      card_.next_stage = Stage::guided;
      return;
    case EntryKind::known:
      know(entry, settings);
      return;
    case EntryKind::undo:
    case EntryKind::settings:
    case EntryKind::choices:
      return;
  }
}

ReviewDelay review_delay(const Card& card, Time now, Day today) {
  using Unit = ReviewDelay::Unit;
  if (card.memory.phase != Phase::review) {
    const auto minutes = std::chrono::round<std::chrono::minutes>(card.memory.due - now).count();
    return {Unit::minutes, static_cast<double>(std::max<std::int64_t>(1, minutes))};
  }
  return delay_of(days_until(card.due_day, today));
}

ReviewDelay review_delay(const BrushReviews& brush, Day today) {
  return delay_of(days_until(brush.due_day, today));
}

bool changes_memory(const Settings& before, const Settings& after) {
  return before.fsrs.weights != after.fsrs.weights ||
         before.fsrs.short_term_steps != after.fsrs.short_term_steps;
}

void CardHistory::change_settings(const Settings& settings) {
  const auto again = [](const Fsrs& fsrs, const std::vector<Answer>& answers, Memory& changed) {
    if (answers.empty()) return;
    Memory memory;
    for (const Answer& answer : answers) {
      memory = fsrs.next(memory, answer.rating, answer.at, answer.elapsed_days);
    }
    changed.stability = memory.stability;
    changed.difficulty = memory.difficulty;
  };
  again(scheduler_of(settings.fsrs), answers_, card_.memory);
  again(brush_scheduler_of(settings.fsrs), brush_answers_, card_.brush.memory);
}

}  // namespace nazori::study
