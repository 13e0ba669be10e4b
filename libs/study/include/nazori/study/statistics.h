// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/study/learner_store.h"
#include "nazori/study/pace.h"

namespace nazori::study {

/// The activity of one study day.
struct DayActivity {
  Day day{};
  int reviews = 0;     ///< from memory
  int practices = 0;   ///< in other stages
  int introduced = 0;  ///< characters introduced
  std::chrono::milliseconds time{0};

  friend bool operator==(const DayActivity&, const DayActivity&) = default;
};

/// The number of reviews, how many were recalled, and how many were predicted to be. Only reviews after at
/// least one day count.
struct Retention {
  int reviews = 0;
  int recalled = 0;
  double predicted = 0;  ///< mean probability that FSRS predicted for them; 0 without reviews
  [[nodiscard]] double actual() const { return reviews == 0 ? 0 : static_cast<double>(recalled) / reviews; }

  friend bool operator==(const Retention&, const Retention&) = default;
};

/// The retention of one study day (or of a period: periods.h).
struct DayRetention {
  Day day{};
  Retention retention;

  friend bool operator==(const DayRetention&, const DayRetention&) = default;
};

/// Days in a row with study. One day off in any seven does not break it.
struct Streak {
  int days = 0;  ///< days with study, up to today; today need not be done yet
  int longest = 0;
  bool today_done = false;
  bool day_off_used = false;  ///< within the last seven days: another one would break the streak

  friend bool operator==(const Streak&, const Streak&) = default;
};

/// How well a character is learned.
enum class Strength : std::uint8_t {
  unseen,    ///< not studied
  learning,  ///< begun, or in its (re)learning steps
  young,     ///< stability under 21 days
  mature,    ///< stability of 21 days and more
  leech,     ///< set apart
  paused,
};
[[nodiscard]] std::string_view name_of(Strength strength);
[[nodiscard]] Strength strength_of(const Card& card);

/// The state of a character in the grid of characters.
struct CharacterState {
  char32_t character = 0;
  Strength strength = Strength::unseen;
  double retrievability = 0;  ///< now, 0..1

  friend bool operator==(const CharacterState&, const CharacterState&) = default;
};

/// A stroke that goes wrong.
struct HardStroke {
  char32_t character = 0;
  int stroke = 0;    ///< from 0
  int mistakes = 0;  ///< number of writings in which it went wrong
  int writings = 0;  ///< of the character
  std::map<kanji::MistakeKind, int> kinds;

  friend bool operator==(const HardStroke&, const HardStroke&) = default;
};

/// Pen motion of one study day: means over its writings with ink.
struct DayMotion {
  Day day{};
  int writings = 0;
  double speed = 0;       ///< glyph units a second
  double smoothness = 0;  ///< spectral arc length, closer to 0 is smoother

  friend bool operator==(const DayMotion&, const DayMotion&) = default;
};

/// Reviews that will become due.
struct DayForecast {
  Day day{};
  int reviews = 0;  ///< today: with everything overdue

  friend bool operator==(const DayForecast&, const DayForecast&) = default;
};

inline constexpr int kForecastDays = 30;

/// All data of the statistics page.
struct Statistics {
  Day today{};
  std::vector<DayActivity> days;      ///< days with study, oldest first
  std::vector<DayForecast> forecast;  ///< today and the 29 days after it
  Retention retention;                ///< all time
  Retention last_30_days;
  std::vector<DayRetention> retention_days;  ///< days with reviews that count, oldest first
  Streak streak;
  std::vector<CharacterState> characters;  ///< all characters ever studied, by code point
  std::vector<HardStroke>
      hard_strokes;  ///< the most frequent first, at most 100; with mistakes in two writings or more
  std::vector<DayMotion> motion;  ///< oldest first
  Pace pace;
  int reviews = 0;
  std::chrono::milliseconds time{0};
};

/// Computes the statistics in one pass over the log.
/// @return Errc::cancelled where `progress` stops it.
[[nodiscard]] base::Result<Statistics> statistics_of(const LearnerStore& learner,
                                                     const base::Progress& progress = {});

/// The streak of days with study. `days` ascending. @param today may be missing from them.
[[nodiscard]] Streak streak_of(const std::vector<Day>& days, Day today);

/// What studying will take.
struct Workload {
  double reviews_per_day = 0;  ///< mean over the second half of the time
  double minutes_per_day = 0;
  double known = 0;  ///< expected number of characters recalled at its end

  friend bool operator==(const Workload&, const Workload&) = default;
};

/// The workload of a desired retention: simulates a year with `new_per_day` new characters and the
/// probabilities of FSRS (always with the same random numbers). Takes a few milliseconds.
/// @param settings  the desired retention is one of them. @param pace  the time for each kind of work.
/// @return Errc::bad_argument as Fsrs::create(), or for new_per_day outside 0..100.
[[nodiscard]] base::Result<Workload> expected_workload(const FsrsSettings& settings, int new_per_day,
                                                       const Pace& pace = {});

}  // namespace nazori::study
