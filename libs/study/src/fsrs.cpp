// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/fsrs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "named_values.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::minutes;

constexpr double kShortestStability = 0.001;
constexpr double kLongestStability = 36'500;
constexpr int kMinutesOfDay = 24 * 60;

/// Halves are rounded up, as in the reference programs.
double round_half_up(double value) { return std::floor(value + 0.5); }
double round_8(double value) { return round_half_up(value * 1e8) / 1e8; }
double clamp_stability(double value) { return std::clamp(value, kShortestStability, kLongestStability); }
int number_of(Rating rating) { return static_cast<int>(rating); }

base::Result<void> check_steps(std::span<const minutes> steps, const char* name) {
  constexpr std::size_t kMost = 20;
  const bool fits = steps.size() <= kMost && std::all_of(steps.begin(), steps.end(), [](minutes step) {
                      return step.count() >= 1 && step.count() <= 100 * kMinutesOfDay;
                    });
  if (fits) return {};
  return base::fail(base::Errc::bad_argument, "contains a step that is not a valid time", name,
                    "give at most 20 steps of 1 minute to 100 days");
}

/// Keeps the two weights of same-day reviews so small that several relearning steps cannot leave more than
/// was there before the lapse, and the third so large that the gain within one day converges.
void keep_same_day_weights_sound(FsrsSettings& settings) {
  FsrsWeights& w = settings.weights;
  if (settings.short_term_steps) w[19] = std::max(w[19], 0.01);
  const auto steps = static_cast<double>(settings.relearning_steps.size());
  if (steps <= 1) return;
  const double room = -(std::log(w[11]) + std::log(std::pow(2, w[13]) - 1) + w[14] * 0.3) / steps;
  const double most = std::clamp(round_8(std::sqrt(std::max(room, 0.0))), 0.01, 2.0);
  w[17] = std::min(w[17], most);
  w[18] = std::min(w[18], most);
}

}  // namespace

std::vector<minutes> FsrsSettings::default_learning_steps() { return {minutes(1), minutes(10)}; }
std::vector<minutes> FsrsSettings::default_relearning_steps() { return {minutes(10)}; }

Fsrs::Fsrs() : Fsrs(FsrsSettings{}) {}

Fsrs::Fsrs(FsrsSettings settings) : settings_(std::move(settings)) {
  decay_ = -settings_.weights.back();
  factor_ = round_8(std::exp(std::log(0.9) / decay_) - 1);
  interval_modifier_ = round_8((std::pow(settings_.desired_retention, 1 / decay_) - 1) / factor_);
}

base::Result<Fsrs> Fsrs::create(FsrsSettings settings) {
  if (!(settings.desired_retention >= kLowestRetention && settings.desired_retention <= kHighestRetention)) {
    return base::fail(base::Errc::bad_argument, fmt::format("{} is out of range", settings.desired_retention),
                      "desired retention", "give 0.80 to 0.97");
  }
  if (settings.maximum_interval_days < 1 || settings.maximum_interval_days > 36'500) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("{} is not a valid maximum interval", settings.maximum_interval_days),
                      "longest interval", "give 1 to 36500 days");
  }
  if (auto fine = check_steps(settings.learning_steps, "learning steps"); !fine) {
    return tl::unexpected(std::move(fine.error()));
  }
  if (auto fine = check_steps(settings.relearning_steps, "relearning steps"); !fine) {
    return tl::unexpected(std::move(fine.error()));
  }
  auto weights = weights_from(settings.weights);
  if (!weights) return tl::unexpected(std::move(weights.error()));
  settings.weights = *weights;
  keep_same_day_weights_sound(settings);
  return Fsrs(std::move(settings));
}

double Fsrs::retrievability(double stability, double elapsed_days) const {
  if (stability <= 0) return 0;
  return round_8(std::pow(1 + factor_ * std::max(0.0, elapsed_days) / stability, decay_));
}

int Fsrs::interval_days(double stability) const {
  const double days = std::max(1.0, round_half_up(stability * interval_modifier_));
  return static_cast<int>(std::min(days, static_cast<double>(settings_.maximum_interval_days)));
}

DayRange Fsrs::fuzz_range(int interval_days, int elapsed_days) const {
  if (interval_days < 2.5) return {interval_days, interval_days};
  struct Part {
    double from, to, share;
  };
  constexpr std::array<Part, 3> kParts{{{2.5, 7, 0.15}, {7, 20, 0.1}, {20, 1e9, 0.05}}};
  double delta = 1;
  for (const Part& part : kParts) {
    delta += part.share * std::max(std::min<double>(interval_days, part.to) - part.from, 0.0);
  }
  const double interval = std::min(interval_days, settings_.maximum_interval_days);
  DayRange range;
  range.first = std::max(2, static_cast<int>(round_half_up(interval - delta)));
  range.last = std::min(static_cast<int>(round_half_up(interval + delta)), settings_.maximum_interval_days);
  if (interval > elapsed_days) range.first = std::max(range.first, elapsed_days + 1);
  range.first = std::min(range.first, range.last);
  return range;
}

double Fsrs::initial_difficulty(Rating rating) const {
  const FsrsWeights& w = settings_.weights;
  return round_8(w[4] - std::exp((number_of(rating) - 1) * w[5]) + 1);
}

double Fsrs::next_difficulty(double difficulty, Rating rating) const {
  const FsrsWeights& w = settings_.weights;
  const double delta = -w[6] * (number_of(rating) - 3);
  const double damped = difficulty + round_8(delta * (10 - difficulty) / 9);
  const double reverted = round_8(w[7] * initial_difficulty(Rating::easy) + (1 - w[7]) * damped);
  return std::clamp(reverted, 1.0, 10.0);
}

double Fsrs::recalled(const Memory& memory, double retrievability, Rating rating) const {
  const FsrsWeights& w = settings_.weights;
  const double hard = rating == Rating::hard ? w[15] : 1;
  const double easy = rating == Rating::easy ? w[16] : 1;
  const double growth = std::exp(w[8]) * (11 - memory.difficulty) * std::pow(memory.stability, -w[9]) *
                        (std::exp((1 - retrievability) * w[10]) - 1) * hard * easy;
  return round_8(clamp_stability(memory.stability * (1 + growth)));
}

double Fsrs::forgotten(const Memory& memory, double retrievability) const {
  const FsrsWeights& w = settings_.weights;
  const double after_lapse = round_8(clamp_stability(w[11] * std::pow(memory.difficulty, -w[12]) *
                                                     (std::pow(memory.stability + 1, w[13]) - 1) *
                                                     std::exp((1 - retrievability) * w[14])));
  // After forgetting, the stability is at most that after a lapse and one relearning step.
  const double exponent = settings_.short_term_steps ? w[17] * w[18] : 0;
  const double most = round_8(memory.stability / std::exp(exponent));
  return std::min(std::max(most, kShortestStability), after_lapse);
}

double Fsrs::same_day(double stability, Rating rating) const {
  const FsrsWeights& w = settings_.weights;
  const double change = std::pow(stability, -w[19]) * std::exp(w[17] * (number_of(rating) - 3 + w[18]));
  const double kept = rating == Rating::again ? change : std::max(change, 1.0);
  return round_8(clamp_stability(stability * kept));
}

Fsrs::StabilityAndDifficulty Fsrs::after(const Memory& memory, Rating rating, int elapsed_days) const {
  if (memory.phase == Phase::fresh) {
    const auto place = static_cast<std::size_t>(number_of(rating) - 1);
    return {std::max(settings_.weights[place], 0.1), std::clamp(initial_difficulty(rating), 1.0, 10.0)};
  }
  const double difficulty = next_difficulty(memory.difficulty, rating);
  if (elapsed_days == 0 && settings_.short_term_steps) {
    return {same_day(memory.stability, rating), difficulty};
  }
  const double chance = retrievability(memory.stability, elapsed_days);
  if (rating == Rating::again) return {forgotten(memory, chance), difficulty};
  return {recalled(memory, chance, rating), difficulty};
}

/// Minutes until the next (re)learning step, 0 after the last step.
int Fsrs::step_minutes(const Memory& before, Rating rating, int& next_step) const {
  const bool relearning = before.phase == Phase::relearning || before.phase == Phase::review;
  const std::vector<minutes>& steps = relearning ? settings_.relearning_steps : settings_.learning_steps;
  const auto count = static_cast<int>(steps.size());
  const auto length = [&](int step) {
    return static_cast<int>(steps[static_cast<std::size_t>(step)].count());
  };
  next_step = 0;
  if (count == 0 || before.step >= count) return 0;
  switch (rating) {
    case Rating::again:
      return length(0);
    case Rating::hard:
      next_step = before.step;
      return static_cast<int>(round_half_up(count == 1 ? length(0) * 1.5 : (length(0) + length(1)) / 2.0));
    case Rating::good:
      if (before.step + 1 >= count) return 0;
      next_step = before.step + 1;
      return length(next_step);
    case Rating::easy:
      return 0;
  }
  return 0;
}

/// Sets phase, step, interval and due for a card that is in its steps or just enters them.
void Fsrs::set_step(Memory& memory, const Memory& before, Rating rating, Time now) const {
  int next_step = 0;
  const int wait = step_minutes(before, rating, next_step);
  memory.step = next_step;
  if (wait > 0 && wait < kMinutesOfDay) {
    memory.phase = before.phase == Phase::review || before.phase == Phase::relearning ? Phase::relearning
                                                                                      : Phase::learning;
    memory.scheduled_days = 0;
    memory.due = now + minutes(wait);
    return;
  }
  memory.phase = Phase::review;
  if (wait > 0) {
    memory.scheduled_days = wait / kMinutesOfDay;
    memory.due = now + minutes(wait);
    return;
  }
  memory.scheduled_days = interval_days(memory.stability);
  memory.due = now + days(memory.scheduled_days);
}

/// Interval after a recall in the phase `review`: hard < good < easy, whatever the stabilities are.
int Fsrs::review_interval(const Memory& before, Rating rating, int elapsed_days) const {
  const auto raw = [&](Rating one) { return interval_days(after(before, one, elapsed_days).stability); };
  const int hard = std::min(raw(Rating::hard), raw(Rating::good));
  const int good = std::max(raw(Rating::good), hard + 1);
  if (rating == Rating::hard) return hard;
  if (rating == Rating::good) return good;
  return std::max(raw(Rating::easy), good + 1);
}

/// Interval without any steps: again < hard < good < easy.
int Fsrs::day_interval(const Memory& before, Rating rating, int elapsed_days) const {
  const auto raw = [&](Rating one) { return interval_days(after(before, one, elapsed_days).stability); };
  const int again = std::min(raw(Rating::again), raw(Rating::hard));
  const int hard = std::max(raw(Rating::hard), again + 1);
  const int good = std::max(raw(Rating::good), hard + 1);
  switch (rating) {
    case Rating::again:
      return again;
    case Rating::hard:
      return hard;
    case Rating::good:
      return good;
    case Rating::easy:
      return std::max(raw(Rating::easy), good + 1);
  }
  return again;
}

Memory Fsrs::next(const Memory& memory, Rating rating, Time now, int elapsed_days) const {
  assert(elapsed_days >= 0);
  const StabilityAndDifficulty changed = after(memory, rating, elapsed_days);
  Memory result = memory;
  result.stability = changed.stability;
  result.difficulty = changed.difficulty;
  result.last_review = now;
  ++result.reps;
  if (memory.phase == Phase::review && rating == Rating::again) ++result.lapses;
  const bool in_days = !settings_.short_term_steps;
  // Without steps every Again but the first answer is a lapse, also for a card begun with steps.
  if (in_days && rating == Rating::again &&
      (memory.phase == Phase::learning || memory.phase == Phase::relearning)) {
    ++result.lapses;
  }
  if (in_days || (memory.phase == Phase::review && rating != Rating::again)) {
    result.phase = Phase::review;
    result.step = 0;
    result.scheduled_days =
        in_days ? day_interval(memory, rating, elapsed_days) : review_interval(memory, rating, elapsed_days);
    result.due = now + days(result.scheduled_days);
    return result;
  }
  set_step(result, memory, rating, now);
  return result;
}

std::string_view name_of(Rating rating) {
  switch (rating) {
    case Rating::again:
      return "again";
    case Rating::hard:
      return "hard";
    case Rating::good:
      return "good";
    case Rating::easy:
      return "easy";
  }
  return {};
}

std::string_view name_of(Phase phase) {
  switch (phase) {
    case Phase::fresh:
      return "new";
    case Phase::learning:
      return "learning";
    case Phase::review:
      return "review";
    case Phase::relearning:
      return "relearning";
  }
  return {};
}

std::optional<Rating> rating_named(std::string_view name) { return value_named<Rating>(name); }

std::optional<Phase> phase_named(std::string_view name) { return value_named<Phase>(name); }

}  // namespace nazori::study
