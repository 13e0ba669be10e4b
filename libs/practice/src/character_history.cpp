// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_history.h"

#include <algorithm>
#include <map>
#include <utility>

namespace nazori::practice {

std::vector<HardStroke> hard_strokes(Learner& learner, char32_t character, std::size_t most) {
  const auto writings = learner.store().writings_of(character);
  if (!writings) {
    learner.announce_unread(writings.error());
    return {};
  }
  std::map<int, int> wrong;
  for (const auto& one : *writings) {
    if (one.entry.writing.stage == study::Stage::brush) continue;
    for (const auto& mistake : one.entry.writing.result.mistakes)
      if (mistake.kind != kanji::MistakeKind::ending) ++wrong[mistake.stroke];
  }
  std::vector<HardStroke> worst;
  for (const auto& [stroke, times] : wrong)
    if (times > 1) worst.push_back({stroke, times});
  std::sort(worst.begin(), worst.end(), [](const HardStroke& a, const HardStroke& b) {
    return std::pair(a.times, a.stroke) > std::pair(b.times, b.stroke);
  });
  if (worst.size() > most) worst.resize(most);
  return worst;
}

std::optional<std::vector<EarlierWriting>> earlier_writings(Learner& learner, char32_t character,
                                                            std::size_t most) {
  const auto& store = learner.store();
  const auto writings = store.writings_of(character);
  if (!writings) {
    learner.announce_unread(writings.error());
    return std::nullopt;
  }
  std::vector<EarlierWriting> found;
  for (auto one = writings->rbegin(); one != writings->rend() && found.size() < most; ++one) {
    if (!one->has_ink || one->entry.writing.stage != study::Stage::memory) continue;
    auto ink = store.ink_of(one->entry.id);
    if (ink)
      found.push_back({*std::move(ink), one->entry.day, one->entry.writing.rating});
    else
      learner.announce_unread(ink.error());
  }
  return found;
}

}  // namespace nazori::practice
