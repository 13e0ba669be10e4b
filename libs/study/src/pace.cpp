// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/pace.h"

#include <algorithm>

namespace nazori::study {
namespace {

constexpr std::size_t kLastDays = 200;

/// The median of the newest, or what was assumed.
std::chrono::milliseconds usual(std::vector<std::pair<Day, std::chrono::milliseconds>> times,
                                std::chrono::milliseconds assumed) {
  if (times.size() < kPaceNeeds) return assumed;
  std::stable_sort(times.begin(), times.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  times.resize(std::min(times.size(), kLastDays));
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end(),
                   [](const auto& a, const auto& b) { return a.second < b.second; });
  return middle->second;
}

}  // namespace

const PaceSum::Times& PaceSum::of(const std::map<Outcome, Times>& all, Outcome outcome) {
  static const Times none;
  const auto found = all.find(outcome);
  return found == all.end() ? none : found->second;
}

void PaceSum::close(const CharacterDay& day, std::map<Outcome, Times>& into) {
  if (day.outcome && day.time.count() > 0) into[*day.outcome].emplace_back(day.day, day.time);
}

void PaceSum::take(const LogEntry& entry) {
  if (entry.kind == EntryKind::reset) {
    const auto found = open_.find(entry.character);
    if (found == open_.end()) return;
    close(found->second, closed_);
    open_.erase(found);
    return;
  }
  if (entry.kind != EntryKind::writing) return;
  const auto [place, is_new] = open_.try_emplace(entry.character);
  CharacterDay& now = place->second;
  if (is_new) {
    now = {entry.day, std::chrono::milliseconds(0), Outcome::introduced};
  } else if (now.day != entry.day) {
    close(now, closed_);
    now = {entry.day, std::chrono::milliseconds(0), std::nullopt};
  }
  now.time += entry.writing.result.duration;
  if (!now.outcome && entry.writing.stage == Stage::memory)
    now.outcome = entry.writing.rating == Rating::again ? Outcome::failed : Outcome::recalled;
}

Pace PaceSum::pace() const {
  std::map<Outcome, Times> all = closed_;
  for (const auto& [character, day] : open_) close(day, all);
  Pace pace;
  const auto look = [&](Outcome outcome, std::chrono::milliseconds& time, int& days) {
    const Times& times = of(all, outcome);
    time = usual(times, time);
    days = static_cast<int>(times.size());
  };
  look(Outcome::recalled, pace.recalled, pace.recalled_days);
  look(Outcome::failed, pace.failed, pace.failed_days);
  look(Outcome::introduced, pace.introduced, pace.introduced_days);
  return pace;
}

base::Result<Pace> pace_of(const LearnerStore& learner) {
  PaceSum sum;
  auto read = learner.for_each_entry(true, [&](const LearnerStore::LoggedEntry& logged) {
    sum.take(logged.entry);
    return true;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  return sum.pace();
}

}  // namespace nazori::study
