// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/milestones.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>

#include "nazori/practice/extra_study.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {
namespace {

using std::chrono::days;

constexpr std::size_t kMostLists = 3;
constexpr std::array kSchoolLists{"grade-1", "grade-2", "grade-3",  "grade-4",
                                  "grade-5", "grade-6", "secondary"};

bool is_begun(const study::Cards& cards, char32_t character) {
  const auto known = cards.find(character);
  return known != cards.end() && known->second.introduced.has_value();
}

Milestone measure(std::string id, const std::vector<char32_t>& members, const study::Cards& cards,
                  std::span<const char32_t> coming, const NewPace& pace) {
  Milestone made;
  made.list = std::move(id);
  made.size = static_cast<int>(members.size());
  std::set<char32_t> left;
  for (const char32_t member : members) {
    if (!is_begun(cards, member)) {
      left.insert(member);
      continue;
    }
    ++made.begun;
    const auto strength = study::strength_of(cards.at(member));
    if (strength == study::Strength::young || strength == study::Strength::mature) ++made.learned;
  }
  if (left.empty()) return made;
  std::size_t until_last = 0;
  for (std::size_t i = 0; i < coming.size(); ++i)
    if (left.erase(coming[i]) > 0) until_last = i + 1;
  // A character that does not come by itself is never begun at any pace.
  if (left.empty()) made.days_left = pace.days_for(static_cast<int>(until_last));
  return made;
}

}  // namespace

std::optional<int> NewPace::days_for(int count) const {
  if (count <= 0) return 0;
  if (characters <= 0 || days <= 0) return std::nullopt;
  const std::int64_t needed = (static_cast<std::int64_t>(count) * days + characters - 1) / characters;
  if (needed > kFarthestDays) return std::nullopt;
  return static_cast<int>(needed);
}

NewPace new_pace(std::span<const study::StudyDay> studied, study::Day today) {
  NewPace pace;
  const study::Day first = today - days(kPaceDays - 1);
  const auto begin = std::find_if(studied.begin(), studied.end(),
                                  [](const study::StudyDay& day) { return day.writings > 0; });
  if (begin == studied.end() || begin->day > today) return pace;
  pace.days = static_cast<int>((today - std::max(first, begin->day)).count()) + 1;
  for (const study::StudyDay& day : studied)
    if (day.day >= first && day.day <= today) pace.characters += day.introduced;
  return pace;
}

base::Result<std::vector<Milestone>> milestones(Learner& learner) {
  const auto& store = learner.store();
  std::vector<Milestone> made;
  auto* lists = learner.lists();
  if (lists == nullptr) return made;
  const auto studied = store.study_days();
  if (!studied) return tl::unexpected(studied.error());
  const auto coming = new_characters(learner, SIZE_MAX);
  if (!coming) return tl::unexpected(coming.error());
  const auto pace = new_pace(*studied, store.today());
  const auto measured = [&](std::string id, const std::vector<char32_t>& members) {
    return measure(std::move(id), members, store.cards(), *coming, pace);
  };
  std::optional<Milestone> learned;
  bool has_next = false;
  for (const auto& id : store.settings().new_lists) {
    const auto members = lists->members(id, store);
    if (!members || members->empty()) continue;
    Milestone one = measured(id, *members);
    if (one.learned == one.size) {
      learned = std::move(one);
      continue;
    }
    const bool is_next = !has_next && !coming->empty() &&
                         std::find(members->begin(), members->end(), coming->front()) != members->end();
    if (is_next) {
      made.insert(made.begin(), std::move(one));
      has_next = true;
    } else if (one.begun > 0) {
      made.push_back(std::move(one));
    }
  }
  if (made.size() > kMostLists) made.resize(kMostLists);
  if (made.empty() && learned) made.push_back(*std::move(learned));
  std::vector<char32_t> school;
  bool is_chosen = false;
  const auto& chosen = store.settings().new_lists;
  for (const char* id : kSchoolLists) {
    const auto members = lists->members(id, store);
    if (members) school.insert(school.end(), members->begin(), members->end());
    is_chosen = is_chosen || std::find(chosen.begin(), chosen.end(), id) != chosen.end();
  }
  Milestone all = measured(kSchoolKanji, school);
  if (all.size > 0 && (is_chosen || all.begun > 0)) made.push_back(std::move(all));
  return made;
}

}  // namespace nazori::practice
