// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/study/handwriting.h"
#include "nazori/study/learner_store.h"

namespace nazori::practice {

/// A character that was written from memory once.
struct RecordedWriting {
  std::int64_t entry = 0;  ///< of the log
  char32_t character = 0;
  bool is_right = false;  ///< it was accepted
  bool has_ink = false;

  friend bool operator==(const RecordedWriting&, const RecordedWriting&) = default;
};

/// What was written from memory on some days. It leaves out what was undone, and characters that were only
/// marked as known.
struct WritingRecord {
  study::Day first{};                     ///< of the days
  study::Day last{};                      ///< of the days; `first` for a single day
  std::chrono::milliseconds time{0};      ///< of all writings of these days, practice included
  int study_days = 0;                     ///< days on which something was written from memory
  std::vector<RecordedWriting> writings;  ///< in the order in which they were written
  std::vector<char32_t> fresh;            ///< begun on these days, in the order of their first writing
  /// Written at least once without being accepted: the most often refused first, then as they were written.
  std::vector<char32_t> hard;

  [[nodiscard]] int right() const;  ///< number of writings that were accepted
  /// One writing of each character, in the order of their first writing: the last accepted one with ink, else
  /// the last one with ink, else the last one.
  [[nodiscard]] std::vector<RecordedWriting> best_of_each() const;

  friend bool operator==(const WritingRecord&, const WritingRecord&) = default;
};

/// @param first, last  study days of the learner (study::Calendar), both included.
/// @return the errors of the store.
[[nodiscard]] base::Result<WritingRecord> writing_record(const study::LearnerStore& store, study::Day first,
                                                         study::Day last);

/// The last study day before `today` on which something was written from memory.
/// @return nullopt where there is none; the errors of the store.
[[nodiscard]] base::Result<std::optional<WritingRecord>> last_record_before(const study::LearnerStore& store,
                                                                            study::Day today);

/// A character in the learner's hand.
struct InkedWriting {
  char32_t character = 0;
  bool is_right = false;
  study::Handwriting ink;
};
/// The handwriting of the writings, as they follow; those without ink are left out.
/// @param most  maximum number. @return the errors of the store.
[[nodiscard]] base::Result<std::vector<InkedWriting>> inks_of(const study::LearnerStore& store,
                                                              const std::vector<RecordedWriting>& writings,
                                                              std::size_t most);

/// The week of a day, from Monday to Sunday.
struct DaySpan {
  study::Day first{};
  study::Day last{};

  friend bool operator==(const DaySpan&, const DaySpan&) = default;
};
[[nodiscard]] DaySpan week_of(study::Day day);
/// The calendar month of a day, from its first to its last day.
[[nodiscard]] DaySpan month_of(study::Day day);

}  // namespace nazori::practice
