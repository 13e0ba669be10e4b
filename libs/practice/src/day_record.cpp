// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/day_record.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace nazori::practice {

using std::chrono::days;

int WritingRecord::right() const {
  return static_cast<int>(std::count_if(writings.begin(), writings.end(),
                                        [](const RecordedWriting& one) { return one.is_right; }));
}

std::vector<RecordedWriting> WritingRecord::best_of_each() const {
  std::vector<RecordedWriting> best;
  for (const auto& one : writings) {
    const auto known = std::find_if(best.begin(), best.end(), [&one](const RecordedWriting& other) {
      return other.character == one.character;
    });
    const auto worth = [](const RecordedWriting& w) { return w.has_ink ? (w.is_right ? 2 : 1) : 0; };
    if (known == best.end())
      best.push_back(one);
    else if (worth(one) >= worth(*known))
      *known = one;
  }
  return best;
}

base::Result<WritingRecord> writing_record(const study::LearnerStore& store, study::Day first,
                                           study::Day last) {
  WritingRecord record;
  record.first = first;
  record.last = last;
  std::set<char32_t> fresh;
  const auto studied = store.study_days();
  if (!studied) return tl::unexpected(studied.error());
  for (const study::StudyDay& day : *studied) {
    if (day.day < first || day.day > last) continue;
    const auto time = store.time_on(day.day);
    if (!time) return tl::unexpected(time.error());
    record.time += *time;
    const auto introduced = store.introduced_on(day.day);
    if (!introduced) return tl::unexpected(introduced.error());
    fresh.insert(introduced->begin(), introduced->end());
    if (day.reviews > 0) ++record.study_days;
  }
  std::map<char32_t, int> refused;
  const auto all = store.writings_on(first, last);
  if (!all) return tl::unexpected(all.error());
  for (const auto& logged : *all) {
    const auto& entry = logged.entry;
    if (entry.writing.stage != study::Stage::memory) continue;
    const bool is_right = entry.writing.result.accepted;
    record.writings.push_back({entry.id, entry.character, is_right, logged.has_ink});
    if (!is_right) ++refused[entry.character];
  }
  for (const auto& one : record.writings) {
    if (fresh.erase(one.character) > 0) record.fresh.push_back(one.character);
    if (refused.contains(one.character) &&
        std::find(record.hard.begin(), record.hard.end(), one.character) == record.hard.end())
      record.hard.push_back(one.character);
  }
  std::stable_sort(record.hard.begin(), record.hard.end(),
                   [&refused](char32_t a, char32_t b) { return refused[a] > refused[b]; });
  return record;
}

base::Result<std::optional<WritingRecord>> last_record_before(const study::LearnerStore& store,
                                                              study::Day today) {
  const auto studied = store.study_days();
  if (!studied) return tl::unexpected(studied.error());
  const auto day = std::find_if(studied->rbegin(), studied->rend(), [today](const study::StudyDay& one) {
    return one.day < today && one.reviews > 0;
  });
  if (day == studied->rend()) return std::optional<WritingRecord>();
  auto record = writing_record(store, day->day, day->day);
  if (!record) return tl::unexpected(std::move(record.error()));
  return std::optional(*std::move(record));
}

base::Result<std::vector<InkedWriting>> inks_of(const study::LearnerStore& store,
                                                const std::vector<RecordedWriting>& writings,
                                                std::size_t most) {
  std::vector<InkedWriting> inks;
  for (const auto& one : writings) {
    if (inks.size() >= most) break;
    if (!one.has_ink) continue;
    auto ink = store.ink_of(one.entry);
    if (!ink) return tl::unexpected(std::move(ink.error()));
    inks.push_back({one.character, one.is_right, *std::move(ink)});
  }
  return inks;
}

DaySpan week_of(study::Day day) {
  const auto after_monday = std::chrono::weekday(day) - std::chrono::Monday;
  return {day - after_monday, day - after_monday + days(6)};
}

DaySpan month_of(study::Day day) {
  const std::chrono::year_month_day date(day);
  const auto month = date.year() / date.month();
  return {study::Day(month / 1), study::Day(month / std::chrono::last)};
}

}  // namespace nazori::practice
