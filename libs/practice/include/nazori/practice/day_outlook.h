// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "nazori/study/day_plan.h"
#include "nazori/study/learner_store.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {

/// What comes next when nothing is due now.
struct DayOutlook {
  enum class Kind : std::uint8_t {
    later_today,       ///< `characters` are due again today, the first at `first`
    limit_reached,     ///< `characters` are due, but the day's limit moves them to tomorrow
    nothing_to_learn,  ///< nothing was ever studied, and no new characters are chosen
    reviews_tomorrow,  ///< of `characters`
    new_tomorrow,      ///< new characters and no reviews
    nothing_tomorrow,
  };
  Kind kind = Kind::nothing_tomorrow;
  int characters = 0;
  study::Time first{};

  friend bool operator==(const DayOutlook&, const DayOutlook&) = default;
};

/// @param plan  of today, with nothing to do now.
[[nodiscard]] DayOutlook outlook_of(const study::LearnerStore& learner, const study::DayPlan& plan);

/// How people greet each other now.
enum class PartOfDay : std::uint8_t {
  morning,    ///< until 12:00
  afternoon,  ///< until 18:00
  evening,    ///< until the study day ends
};
/// By the learner's clock and zone.
[[nodiscard]] PartOfDay part_of_day(const study::LearnerStore& learner);

/// The days in a row up to today; 0 where the history cannot be read.
[[nodiscard]] study::Streak streak_now(const study::LearnerStore& learner);

}  // namespace nazori::practice
