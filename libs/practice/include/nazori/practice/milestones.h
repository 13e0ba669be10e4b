// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/practice/learner.h"
#include "nazori/study/study_days.h"

namespace nazori::practice {

/// How many characters a learner begins in how many days.
struct NewPace {
  int characters = 0;
  int days = 0;

  /// The whole days in which so many characters are begun, at least 1 for one or more; nullopt where none was
  /// begun lately, or it takes more than `kFarthestDays`.
  [[nodiscard]] std::optional<int> days_for(int count) const;

  friend bool operator==(const NewPace&, const NewPace&) = default;
};

/// A pace is measured over so many days, today included.
inline constexpr int kPaceDays = 28;
/// Nothing is foretold beyond this: fifty years.
inline constexpr int kFarthestDays = 18'263;

/// The pace of the last `kPaceDays` days; of fewer, from the first day of study on, for a learner who began
/// later. Days without study count. Characters that were marked as known were not begun.
/// @param studied  LearnerStore::study_days().
[[nodiscard]] NewPace new_pace(std::span<const study::StudyDay> studied, study::Day today);

/// How far the learner is with a list.
struct Milestone {
  std::string list;  ///< id of the list, "grade-3"; kSchoolKanji
  int learned = 0;   ///< characters that are recently learned or well known
  int begun = 0;     ///< characters that were ever studied
  int size = 0;
  /// Days until its last character was begun, at the present pace and in the learning order. nullopt where
  /// all are begun, or the pace or the order does not tell.
  std::optional<int> days_left;

  friend bool operator==(const Milestone&, const Milestone&) = default;
};

/// The id of all school kanji together: grades 1 to 6 and secondary school. It is not an id of a list.
inline constexpr const char* kSchoolKanji = "school-kanji";

/// How far the learner is: first the list of the next new character, then other chosen lists that are begun
/// and not learned yet, in the order of the settings, at most three together; then kSchoolKanji, where kanji
/// of them are chosen or begun. Where all chosen lists are learned, the last of them is named.
/// @return the errors of the store.
[[nodiscard]] base::Result<std::vector<Milestone>> milestones(Learner& learner);

}  // namespace nazori::practice
