// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/pace.h"

#include <algorithm>

namespace nazori::study {
namespace {

constexpr int kLastDays = 200;

/// The median of the newest days, or the assumption.
base::Result<void> look(const LearnerStore& learner, DayOutcome outcome, std::chrono::milliseconds& time,
                        int& days) {
  auto times = learner.newest_times(outcome, kLastDays);
  if (!times) return tl::unexpected(std::move(times.error()));
  days = times->days;
  if (days < kPaceNeeds) return {};
  auto& newest = times->newest;
  const auto middle = newest.begin() + static_cast<std::ptrdiff_t>(newest.size() / 2);
  std::nth_element(newest.begin(), middle, newest.end());
  time = *middle;
  return {};
}

}  // namespace

base::Result<Pace> pace_of(const LearnerStore& learner) {
  Pace pace;
  if (auto fine = look(learner, DayOutcome::recalled, pace.recalled, pace.recalled_days); !fine)
    return tl::unexpected(std::move(fine.error()));
  if (auto fine = look(learner, DayOutcome::failed, pace.failed, pace.failed_days); !fine)
    return tl::unexpected(std::move(fine.error()));
  if (auto fine = look(learner, DayOutcome::introduced, pace.introduced, pace.introduced_days); !fine)
    return tl::unexpected(std::move(fine.error()));
  return pace;
}

}  // namespace nazori::study
