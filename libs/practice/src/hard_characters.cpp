// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/hard_characters.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "nazori/practice/study_charts.h"

namespace nazori::practice {

base::Result<std::vector<HardCharacter>> hard_characters(const study::LearnerStore& store, std::size_t most) {
  const study::Day first = store.today() - std::chrono::days(kHardDays - 1);
  const auto failed = store.failed_days(first);
  if (!failed) return tl::unexpected(failed.error());
  std::vector<HardCharacter> hard;
  for (const auto& [character, days] : *failed)
    if (days >= kHardFailures && !store.card(character).paused) hard.push_back({character, days, {}});
  std::stable_sort(hard.begin(), hard.end(), [](const HardCharacter& a, const HardCharacter& b) {
    return a.failed_days > b.failed_days;
  });
  if (hard.size() > most) hard.resize(most);
  for (auto& one : hard) {
    auto trouble = stroke_trouble(store, one.character, first);
    if (!trouble) return tl::unexpected(std::move(trouble.error()));
    one.stroke = *trouble;
  }
  return hard;
}

base::Result<std::optional<StrokeTrouble>> stroke_trouble(const study::LearnerStore& store,
                                                          char32_t character, study::Day first) {
  const auto writings = store.writings_of(character, first, study::kLastDay);
  if (!writings) return tl::unexpected(writings.error());
  std::map<std::pair<int, kanji::MistakeKind>, int> times;
  int written = 0;
  for (const auto& logged : *writings) {
    const auto& entry = logged.entry;
    // The brush makes other mistakes than the stylus.
    if (entry.writing.stage == study::Stage::watch || entry.writing.stage == study::Stage::brush) continue;
    ++written;
    std::set<std::pair<int, kanji::MistakeKind>> once;
    for (const auto& mistake : entry.writing.result.mistakes)
      if (mistake.kind != kanji::MistakeKind::ending) once.emplace(mistake.stroke, mistake.kind);
    for (const auto& key : once) ++times[key];
  }
  std::optional<StrokeTrouble> worst;
  for (const auto& [key, count] : times)
    if (count > 1 && (!worst || count > worst->times))
      worst = StrokeTrouble{key.first, key.second, count, written};
  return worst;
}

StrokeTrouble trouble_of(const study::HardStroke& stroke) {
  const auto kinds = mistakes_by_count(stroke);
  StrokeTrouble trouble{stroke.stroke, kanji::MistakeKind::wrong, stroke.mistakes, stroke.writings};
  if (!kinds.empty()) {
    trouble.kind = kinds.front().first;
    trouble.times = std::min(kinds.front().second, stroke.mistakes);
  }
  return trouble;
}

}  // namespace nazori::practice
