// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/study_days.h"

namespace nazori::study {

void CharacterDays::take(const LogEntry& entry) {
  if (entry.kind == EntryKind::reset) {
    is_new_ = true;
    return;
  }
  if (entry.kind == EntryKind::known) is_new_ = false;
  if (entry.kind != EntryKind::writing) return;
  const bool with_brush = entry.writing.stage == Stage::brush;
  const bool was_new = is_new_ && !with_brush;
  is_new_ = is_new_ && with_brush;
  if (was_new) {
    days_.push_back({entry.day, DayOutcome::introduced});
  } else if (days_.empty() || days_.back().day != entry.day) {
    days_.push_back({entry.day, std::nullopt});
  }
  CharacterDay& today = days_.back();
  ++today.writings;
  // The pace foretells how long the day's reviews take; the brush is not among them.
  if (with_brush) return;
  today.time += entry.writing.result.duration;
  if (entry.writing.stage != Stage::memory) return;
  ++today.reviews;
  if (!today.outcome)
    today.outcome = entry.writing.rating == Rating::again ? DayOutcome::failed : DayOutcome::recalled;
}

}  // namespace nazori::study
