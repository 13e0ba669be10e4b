// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/study/card.h"

namespace nazori::study {

/// The outcome of a study day for one character.
enum class DayOutcome : std::uint8_t {
  recalled = 0,    ///< its first review succeeded
  failed = 1,      ///< its first review failed
  introduced = 2,  ///< the character was new on this day
};

/// All writings of one character on one study day. A character that was marked as known was not written.
struct CharacterDay {
  Day day{};
  std::optional<DayOutcome> outcome;  ///< nullopt: practised, not reviewed
  std::chrono::milliseconds time{0};  ///< all writings together, without those with the brush
  int writings = 0;                   ///< in every stage
  int reviews = 0;                    ///< of these from memory

  friend bool operator==(const CharacterDay&, const CharacterDay&) = default;
};

/// Divides the history of one character into study days. A day ends where an entry of another day follows, or
/// where the character is reset; after that it is new again.
class CharacterDays {
 public:
  /// Entries of one character in the order of the log, without those that were undone. A character that was
  /// marked as known is not new any more, but that makes no study day. A writing with the brush makes a study
  /// day, but introduces nothing. Entries other than writings, resets
  /// and such marks are ignored.
  void take(const LogEntry& entry);
  /// The days so far, in the order of the log. A day may appear twice.
  [[nodiscard]] const std::vector<CharacterDay>& days() const { return days_; }

 private:
  std::vector<CharacterDay> days_;
  bool is_new_ = true;  ///< the next writing introduces the character
};

/// All writings of one study day.
struct StudyDay {
  Day day{};
  int writings = 0;    ///< in every stage
  int reviews = 0;     ///< of these from memory
  int introduced = 0;  ///< characters that were new and took any time

  friend bool operator==(const StudyDay&, const StudyDay&) = default;
};

/// The durations of study days with the same outcome.
struct OutcomeTimes {
  std::vector<std::chrono::milliseconds> newest;  ///< newest day first, within a day by code point
  int days = 0;                                   ///< number of all days with a duration

  friend bool operator==(const OutcomeTimes&, const OutcomeTimes&) = default;
};

}  // namespace nazori::study
