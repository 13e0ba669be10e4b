// SPDX-License-Identifier: Apache-2.0
#include "interval_choice.h"

#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <vector>

namespace nazori::study {
namespace {

/// A pseudo-random number 0..1 that depends only on the review. @source splitmix64, S. Vigna, public domain.
double scattered(std::uint64_t seed) {
  seed += 0x9E3779B97F4A7C15ULL;
  seed = (seed ^ (seed >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  seed = (seed ^ (seed >> 27U)) * 0x94D049BB133111EBULL;
  seed ^= seed >> 31U;
  return static_cast<double>(seed >> 11U) / 9007199254740992.0;
}

int least_loaded(const DayRange& range, int wanted, const Cards& cards, char32_t character, Day day) {
  std::vector<int> load(static_cast<std::size_t>(range.last - range.first + 1), 0);
  for (const auto& [other, card] : cards) {
    if (other == character || !card.due_day || card.paused || card.leech) continue;
    const auto offset = (*card.due_day - day).count();
    if (offset >= range.first && offset <= range.last) ++load[static_cast<std::size_t>(offset - range.first)];
  }
  int best = wanted;
  auto rank_of = [&](int interval) {
    return std::tuple(load[static_cast<std::size_t>(interval - range.first)], std::abs(interval - wanted),
                      interval);
  };
  for (int interval = range.first; interval <= range.last; ++interval) {
    if (rank_of(interval) < rank_of(best)) best = interval;
  }
  return best;
}

}  // namespace

std::optional<int> choose_interval(const Fsrs& fsrs, const Settings& settings, const Cards& cards,
                                   char32_t character, const Memory& after, int elapsed_days, Day day) {
  if ((!settings.fuzz && !settings.load_balance) || after.phase != Phase::review) return std::nullopt;
  const int wanted = after.scheduled_days;
  const DayRange range = fsrs.fuzz_range(wanted, elapsed_days);
  if (range.first >= range.last || wanted < range.first || wanted > range.last) return std::nullopt;
  int chosen = wanted;
  if (settings.load_balance) {
    chosen = least_loaded(range, wanted, cards, character, day);
  } else {
    const std::uint64_t seed = (static_cast<std::uint64_t>(character) << 32U) ^
                               static_cast<std::uint64_t>(static_cast<std::uint32_t>(after.reps));
    chosen = range.first + static_cast<int>(scattered(seed) * (range.last - range.first + 1));
  }
  return chosen == wanted ? std::nullopt : std::optional(chosen);
}

}  // namespace nazori::study
