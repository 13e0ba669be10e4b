// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <random>
#include <vector>

#include "nazori/study/statistics.h"
#include "usual_ratings.h"

namespace nazori::study {
namespace {

using std::chrono::days;

constexpr int kDays = 365;

/// Gives the same numbers on every computer, which the distributions of the standard library do not
/// guarantee.
double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

double seconds_of(std::chrono::milliseconds time) { return std::chrono::duration<double>(time).count(); }

}  // namespace

base::Result<Workload> expected_workload(const FsrsSettings& settings, int new_per_day, const Pace& pace) {
  if (new_per_day < 0 || new_per_day > 100) {
    return base::fail(base::Errc::bad_argument, fmt::format("{} is out of range", new_per_day),
                      "new characters a day", "give 0 to 100");
  }
  const auto fsrs = Fsrs::create(settings);
  if (!fsrs) return tl::unexpected(fsrs.error());
  std::mt19937 random(1);
  std::vector<std::vector<Memory>> due(kDays);
  std::vector<Memory> beyond;
  const Time start{};
  int reviews = 0;
  double seconds = 0;
  // Steps of minutes are done on the same day, until the card gets an interval of days; the pace includes
  // their time.
  const auto schedule = [&](Memory memory, int day) {
    for (int steps = 0; memory.phase != Phase::review && steps < 10; ++steps) {
      memory = fsrs->next(memory, uniform(random) < 0.9 ? Rating::good : Rating::again, start + days(day), 0);
      if (day >= kDays / 2) ++reviews;
    }
    const int next = day + std::max(1, memory.scheduled_days);
    (next < kDays ? due[static_cast<std::size_t>(next)] : beyond).push_back(memory);
  };
  for (int day = 0; day < kDays; ++day) {
    const bool counts = day >= kDays / 2;
    for (Memory memory : std::exchange(due[static_cast<std::size_t>(day)], {})) {
      const int elapsed = day - static_cast<int>((*memory.last_review - start) / days(1));
      const double chance = fsrs->retrievability(memory.stability, elapsed);
      const double dice = uniform(random);
      const Rating rating = next_rating(chance, dice, uniform(random));
      if (counts) {
        ++reviews;
        seconds += seconds_of(rating == Rating::again ? pace.failed : pace.recalled);
      }
      schedule(fsrs->next(memory, rating, start + days(day), elapsed), day);
    }
    for (int i = 0; i < new_per_day; ++i) {
      if (counts) seconds += seconds_of(pace.introduced);
      schedule(fsrs->next({}, first_rating(uniform(random)), start + days(day), 0), day);
    }
  }
  Workload workload;
  constexpr int kCounted = kDays - kDays / 2;
  workload.reviews_per_day = static_cast<double>(reviews) / kCounted;
  workload.minutes_per_day = seconds / 60 / kCounted;
  for (const Memory& memory : beyond) {
    const int elapsed = kDays - static_cast<int>((*memory.last_review - start) / days(1));
    workload.known += fsrs->retrievability(memory.stability, elapsed);
  }
  return workload;
}

}  // namespace nazori::study
