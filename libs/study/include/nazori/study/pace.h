// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "nazori/study/learner_store.h"

namespace nazori::study {

/// How long one learner takes for what a study day asks of one character, all its writings of that day
/// together. Each number is the median of the last 200 such days, once there are `kPaceNeeds` of them, and an
/// assumption until then (docs/study.md gives its reasons).
struct Pace {
  std::chrono::milliseconds recalled{20'000};     ///< a review that succeeded
  std::chrono::milliseconds failed{60'000};       ///< a review that failed, with writing it again
  std::chrono::milliseconds introduced{180'000};  ///< the day a character is met
  int recalled_days = 0;                          ///< seen; as for the other two
  int failed_days = 0;
  int introduced_days = 0;

  friend bool operator==(const Pace&, const Pace&) = default;
};

/// So many days make a number of the learner's own.
inline constexpr int kPaceNeeds = 10;

/// Finds the pace in the log.
class PaceSum {
 public:
  /// Entries in the order of the log, without those that were undone.
  void take(const LogEntry& entry);
  [[nodiscard]] Pace pace() const;

 private:
  enum class Outcome : std::uint8_t { recalled, failed, introduced };
  struct CharacterDay {
    Day day{};
    std::chrono::milliseconds time{0};
    std::optional<Outcome> outcome;
  };
  using Times = std::vector<std::pair<Day, std::chrono::milliseconds>>;
  [[nodiscard]] static const Times& of(const std::map<Outcome, Times>& all, Outcome outcome);
  static void close(const CharacterDay& day, std::map<Outcome, Times>& into);

  std::map<char32_t, CharacterDay> open_;  ///< the last day of each character
  std::map<Outcome, Times> closed_;
};

/// @return as LearnerStore::for_each_entry() says.
[[nodiscard]] base::Result<Pace> pace_of(const LearnerStore& learner);

}  // namespace nazori::study
