// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/study/time.h"

namespace nazori::study {

/// How well a character was recalled.
enum class Rating : std::uint8_t { again = 1, hard = 2, good = 3, easy = 4 };
inline constexpr std::array kRatings{Rating::again, Rating::hard, Rating::good, Rating::easy};

/// Where a card stands.
enum class Phase : std::uint8_t {
  fresh = 0,       ///< never reviewed ("new")
  learning = 1,    ///< in the steps of minutes before the first interval of days
  review = 2,      ///< comes back after days
  relearning = 3,  ///< forgotten, in the steps of minutes again
};

/// "again", "hard", "good", "easy".
[[nodiscard]] std::string_view name_of(Rating rating);
/// "new", "learning", "review", "relearning".
[[nodiscard]] std::string_view name_of(Phase phase);
[[nodiscard]] std::optional<Rating> rating_named(std::string_view name);
[[nodiscard]] std::optional<Phase> phase_named(std::string_view name);

/// The state of memory of one card. A default one was never reviewed.
struct Memory {
  Phase phase = Phase::fresh;
  double stability = 0;    ///< days until the probability of recall has fallen to 0.9; 0 while fresh
  double difficulty = 0;   ///< 1 easy .. 10 hard; 0 while fresh
  int step = 0;            ///< which (re)learning step comes next, from 0
  int scheduled_days = 0;  ///< last interval; 0 within (re)learning steps
  int reps = 0;            ///< reviews so far
  int lapses = 0;          ///< times it was forgotten in the phase `review`
  Time due{};
  std::optional<Time> last_review;

  friend bool operator==(const Memory&, const Memory&) = default;
};

/// The 21 weights of FSRS-6.
using FsrsWeights = std::array<double, 21>;

/// The published default weights.
/// @source open-spaced-repetition, FSRS-6 (The Algorithm, 2025); the same in ts-fsrs 5.4.2 and Anki 25.02.
inline constexpr FsrsWeights kDefaultWeights{0.212,  1.2931, 2.3065, 8.2956, 6.4133, 0.8334, 3.0194,
                                             0.001,  1.8722, 0.1666, 0.796,  1.4835, 0.0614, 0.2629,
                                             1.6483, 0.6014, 1.8729, 0.5425, 0.0912, 0.0658, 0.1542};

/// How to schedule.
struct FsrsSettings {
  FsrsWeights weights = kDefaultWeights;
  double desired_retention = 0.9;  ///< kLowestRetention..kHighestRetention
  bool short_term_steps = true;    ///< false: days only, from the first review on
  std::vector<std::chrono::minutes> learning_steps = default_learning_steps();
  std::vector<std::chrono::minutes> relearning_steps = default_relearning_steps();
  int maximum_interval_days = 36'500;  ///< 1..36500

  [[nodiscard]] static std::vector<std::chrono::minutes> default_learning_steps();    ///< 1 and 10 minutes
  [[nodiscard]] static std::vector<std::chrono::minutes> default_relearning_steps();  ///< 10 minutes

  friend bool operator==(const FsrsSettings&, const FsrsSettings&) = default;
};

inline constexpr double kLowestRetention = 0.80;
inline constexpr double kHighestRetention = 0.97;

/// Weights from numbers: 21 of FSRS-6, or 19 of FSRS-5 or 17 of FSRS-4.5, which are converted to FSRS-6. Each
/// is limited to the range of the optimiser.
/// @return Errc::bad_argument for another count or a number that is not finite.
[[nodiscard]] base::Result<FsrsWeights> weights_from(std::span<const double> numbers);
/// The same from text: numbers separated by commas, spaces, line breaks or brackets, as Anki shows them.
[[nodiscard]] base::Result<FsrsWeights> parse_weights(std::string_view text);

/// Range of whole days within which an interval may be moved.
struct DayRange {
  int first = 1;
  int last = 1;
  friend bool operator==(const DayRange&, const DayRange&) = default;
};

/// The free spaced repetition scheduler, version 6: a model of memory with three variables (stability,
/// difficulty, retrievability) and the intervals that follow from it. Immutable; thread-safe. Numbers are
/// rounded to 8 decimals after each step, as in the reference programs.
/// @source J. Ye, "The Algorithm" (FSRS-6), open-spaced-repetition; ts-fsrs 5.4.2 for steps and rounding.
class Fsrs {
 public:
  /// @return Errc::bad_argument that names the setting which is out of range.
  [[nodiscard]] static base::Result<Fsrs> create(FsrsSettings settings);
  /// The default settings.
  Fsrs();

  /// The memory after a review.
  /// @param elapsed_days  days since the last review, >= 0, counted by the caller (dates in UTC give the
  ///   results of other programs; study days match what a learner sees); ignored while fresh.
  [[nodiscard]] Memory next(const Memory& memory, Rating rating, Time now, int elapsed_days) const;

  /// The probability that a character with this stability is recalled after this many days: 0..1.
  [[nodiscard]] double retrievability(double stability, double elapsed_days) const;

  /// Days until that probability has fallen to the desired retention; 1..maximum_interval_days.
  [[nodiscard]] int interval_days(double stability) const;

  /// The range within which an interval may be moved without harm: 15 % of its part over 2.5 days, 10 % over
  /// 7, 5 % over 20, and one day; never below 2 days nor to a past day. Intervals under 2.5 days are not
  /// moved.
  [[nodiscard]] DayRange fuzz_range(int interval_days, int elapsed_days) const;

  [[nodiscard]] const FsrsSettings& settings() const { return settings_; }

 private:
  explicit Fsrs(FsrsSettings settings);
  struct StabilityAndDifficulty {
    double stability;
    double difficulty;
  };
  [[nodiscard]] StabilityAndDifficulty after(const Memory& memory, Rating rating, int elapsed_days) const;
  [[nodiscard]] double recalled(const Memory& memory, double retrievability, Rating rating) const;
  [[nodiscard]] double forgotten(const Memory& memory, double retrievability) const;
  [[nodiscard]] double same_day(double stability, Rating rating) const;
  [[nodiscard]] double initial_difficulty(Rating rating) const;
  [[nodiscard]] double next_difficulty(double difficulty, Rating rating) const;
  [[nodiscard]] int step_minutes(const Memory& before, Rating rating, int& next_step) const;
  void set_step(Memory& memory, const Memory& before, Rating rating, Time now) const;
  [[nodiscard]] int review_interval(const Memory& before, Rating rating, int elapsed_days) const;
  [[nodiscard]] int day_interval(const Memory& before, Rating rating, int elapsed_days) const;

  FsrsSettings settings_;
  double decay_ = 0;
  double factor_ = 0;
  double interval_modifier_ = 0;
};

}  // namespace nazori::study
