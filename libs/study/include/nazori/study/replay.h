// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/study/fsrs.h"

namespace nazori::study {

/// The version of the form that to_json() writes; files without a version are of this one, newer ones are
/// refused.
inline constexpr int kReplayVersion = 1;

/// One review of a history, and what followed from it.
struct ReplayStep {
  Time at;
  Rating rating = Rating::good;
  std::optional<double> retrievability_before;  ///< nullopt at the first review
  Memory after;
};

/// The history of one card.
struct ReplayCase {
  double desired_retention = 0.9;
  bool short_term_steps = true;
  std::vector<ReplayStep> steps;
};

/// Histories in the form that `study replay` reads and writes: docs/file-formats.md.
struct Replay {
  FsrsWeights weights = kDefaultWeights;
  std::vector<ReplayCase> cases;
};

/// The largest differences between the numbers that came with histories and those computed here.
struct ReplayDifferences {
  int steps = 0;         ///< steps that had numbers of their own
  double stability = 0;  ///< days
  double difficulty = 0;
  double retrievability = 0;
  int scheduled_days = 0;
  double due_s = 0;  ///< seconds
  int states = 0;    ///< steps whose phase, reps or lapses differ
  std::string
      first;  ///< the first step that differs at the 8th decimal or in any other way: "case 3, step 2"
};

/// Reads histories (times and ratings; everything else in a step is passed over) and schedules each anew with
/// FSRS-6, days counted as dates in UTC.
/// @return Errc::parse with line and reason; Errc::cancelled.
[[nodiscard]] base::Result<Replay> replay_histories(std::string_view json,
                                                    const base::Progress& progress = {});

/// The same form, with the numbers computed here.
[[nodiscard]] std::string to_json(const Replay& replay);

/// Compares with the numbers in `json`, the text `replay` was read from.
[[nodiscard]] base::Result<ReplayDifferences> compare_with_own_numbers(std::string_view json,
                                                                       const Replay& replay);

}  // namespace nazori::study
