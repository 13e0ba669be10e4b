// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/study/card.h"

namespace nazori::study {

/// How a study day went for one character.
enum class DayOutcome : std::uint8_t {
  recalled = 0,    ///< its first review succeeded
  failed = 1,      ///< its first review failed
  introduced = 2,  ///< the character was new on this day
};

/// All writings of one character on one study day.
struct CharacterDay {
  Day day{};
  std::optional<DayOutcome> outcome;  ///< nullopt: practised, not reviewed
  std::chrono::milliseconds time{0};  ///< all writings together
  int writings = 0;                   ///< in every stage
  int reviews = 0;                    ///< of these from memory

  friend bool operator==(const CharacterDay&, const CharacterDay&) = default;
};

/// Divides the history of one character into study days. A day ends where an entry of another day follows, or
/// where the character starts over; after that it is new again.
class CharacterDays {
 public:
  /// Entries of one character in the order of the log, without those that were undone. Entries other than
  /// writings and resets are passed over.
  void take(const LogEntry& entry);
  /// The days so far, in the order of the log. A day may come twice.
  [[nodiscard]] const std::vector<CharacterDay>& days() const { return days_; }

 private:
  std::vector<CharacterDay> days_;
  bool is_new_ = true;  ///< the next writing introduces the character
};

/// All writings of one study day.
struct StudyDay {
  Day day{};
  int writings = 0;  ///< in every stage
  int reviews = 0;   ///< of these from memory

  friend bool operator==(const StudyDay&, const StudyDay&) = default;
};

/// What the study days of one outcome took.
struct OutcomeTimes {
  std::vector<std::chrono::milliseconds> newest;  ///< newest day first; of one day by code point
  int days = 0;                                   ///< all that took any time

  friend bool operator==(const OutcomeTimes&, const OutcomeTimes&) = default;
};

}  // namespace nazori::study
