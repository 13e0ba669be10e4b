// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/character_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/kana_sound.h"

namespace nazori::study {
namespace {

using base::Errc;

constexpr std::string_view kOldJlpt = "old-jlpt-";
constexpr std::string_view kOwn = "list:";
constexpr std::string_view kTag = "tag:";
constexpr std::size_t kMostCharacters = 20'000;
constexpr int kUnknown = 1 << 20;

std::optional<kanji::List> database_list(std::string_view id) {
  using kanji::List;
  constexpr std::array<std::pair<std::string_view, List>, 11> kLists{{{"grade-1", List::grade_1},
                                                                      {"grade-2", List::grade_2},
                                                                      {"grade-3", List::grade_3},
                                                                      {"grade-4", List::grade_4},
                                                                      {"grade-5", List::grade_5},
                                                                      {"grade-6", List::grade_6},
                                                                      {"secondary", List::secondary},
                                                                      {"jinmeiyou", List::jinmeiyou},
                                                                      {"hiragana", List::hiragana},
                                                                      {"katakana", List::katakana},
                                                                      {"own", List::own}}};
  for (const auto& [name, list] : kLists) {
    if (name == id) return list;
  }
  return std::nullopt;
}

void collect_components(const kanji::Component& node, char32_t whole, std::set<char32_t>& found) {
  for (const std::string* element : {&node.element, &node.original}) {
    const auto decoded = base::decode_utf8(*element);
    if (decoded && decoded->size() == 1 && decoded->front() != whole) found.insert(decoded->front());
  }
  for (const kanji::Component& child : node.children) collect_components(child, whole, found);
}

/// Parts first: each character after those of its components that are also in the list.
std::vector<char32_t> parts_before_wholes(const std::vector<char32_t>& characters,
                                          const std::function<const CharacterFacts*(char32_t)>& facts) {
  const std::set<char32_t> wanted(characters.begin(), characters.end());
  std::set<char32_t> placed;
  std::set<char32_t> being_placed;
  std::vector<char32_t> ordered;
  const std::function<void(char32_t)> place = [&](char32_t character) {
    if (placed.contains(character) || !being_placed.insert(character).second) return;
    if (const CharacterFacts* known = facts(character)) {
      std::vector<char32_t> parts;
      for (const char32_t part : known->components) {
        if (wanted.contains(part)) parts.push_back(part);
      }
      std::stable_sort(parts.begin(), parts.end(), [&](char32_t a, char32_t b) {
        const CharacterFacts* fa = facts(a);
        const CharacterFacts* fb = facts(b);
        return (fa == nullptr ? kUnknown : fa->strokes) < (fb == nullptr ? kUnknown : fb->strokes);
      });
      for (const char32_t part : parts) place(part);
    }
    placed.insert(character);
    ordered.push_back(character);
  };
  for (const char32_t character : characters) place(character);
  return ordered;
}

}  // namespace

std::span<const ReadyList> ready_lists() {
  static const std::vector<ReadyList> kLists = [] {
    std::vector<ReadyList> lists;
    for (int grade = 1; grade <= 6; ++grade) {
      lists.push_back({fmt::format("grade-{}", grade), fmt::format("grade {}", grade)});
    }
    lists.push_back({"secondary", "secondary school"});
    lists.push_back({"jinmeiyou", "for names"});
    lists.push_back({"hiragana", "hiragana"});
    lists.push_back({"katakana", "katakana"});
    for (int level = 4; level >= 1; --level) {
      lists.push_back(
          {fmt::format("{}{}", kOldJlpt, level), fmt::format("old JLPT level {} (before 2010)", level)});
    }
    lists.push_back({"own", "my characters"});
    return lists;
  }();
  return kLists;
}

ListIds list_ids(const LearnerStore& learner) {
  ListIds known;
  for (const auto& ready : ready_lists()) known.ids.push_back(ready.id);
  if (const auto own = learner.lists())
    for (const auto& list : *own) known.ids.push_back("list:" + list.name);
  else
    known.unread = own.error();
  if (const auto tags = learner.tags())
    for (const auto& [tag, characters] : *tags) known.ids.push_back("tag:" + tag);
  else if (!known.unread)
    known.unread = tags.error();
  return known;
}

std::vector<std::string> ListIds::chosen_first(const std::vector<std::string>& chosen) const {
  const auto has = [](const std::vector<std::string>& all, const std::string& id) {
    return std::find(all.begin(), all.end(), id) != all.end();
  };
  std::vector<std::string> ordered;
  for (const auto& id : chosen)
    if ((unread || has(ids, id)) && !has(ordered, id)) ordered.push_back(id);
  for (const auto& id : ids)
    if (!has(ordered, id)) ordered.push_back(id);
  return ordered;
}

const CharacterFacts* CharacterLists::facts(char32_t character) {
  const auto known = facts_.find(character);
  if (known != facts_.end()) return known->second.strokes > 0 ? &known->second : nullptr;
  CharacterFacts facts;
  facts.character = character;
  if (const auto found = database_->find(character)) {
    facts.grade = found->entry.grade;
    facts.frequency = found->entry.frequency;
    facts.old_jlpt_level = found->entry.old_jlpt_level;
    facts.strokes = static_cast<int>(found->strokes.size());
    std::set<char32_t> components;
    collect_components(found->components, character, components);
    facts.components.assign(components.begin(), components.end());
  }
  const CharacterFacts& kept = facts_.emplace(character, std::move(facts)).first->second;
  return kept.strokes > 0 ? &kept : nullptr;
}

const std::vector<char32_t>& CharacterLists::ready(std::string_view id) {
  const auto known = ready_.find(id);
  if (known != ready_.end()) return known->second;
  std::vector<char32_t> members;
  if (const auto list = database_list(id)) {
    for (const kanji::Summary& one : database_->list(*list)) members.push_back(one.code_point);
  } else {
    const int level = id.back() - '0';
    for (const auto* source :
         {"grade-1", "grade-2", "grade-3", "grade-4", "grade-5", "grade-6", "secondary", "jinmeiyou"}) {
      for (const char32_t character : ready(source)) {
        const CharacterFacts* known_facts = facts(character);
        if (known_facts != nullptr && known_facts->old_jlpt_level == level) members.push_back(character);
      }
    }
  }
  return ready_.emplace(id, std::move(members)).first->second;
}

base::Result<std::vector<char32_t>> CharacterLists::members(std::string_view id,
                                                            const LearnerStore& learner) {
  if (id.starts_with(kOwn)) {
    const auto lists = learner.lists();
    if (!lists) return tl::unexpected(lists.error());
    for (const CustomList& list : *lists) {
      if (list.name == id.substr(kOwn.size())) return list.characters;
    }
  } else if (id.starts_with(kTag)) {
    const auto tags = learner.tags();
    if (!tags) return tl::unexpected(tags.error());
    const auto found = tags->find(std::string(id.substr(kTag.size())));
    if (found != tags->end()) return found->second;
  } else {
    const std::span<const ReadyList> lists = ready_lists();
    if (std::any_of(lists.begin(), lists.end(), [&](const ReadyList& one) { return one.id == id; })) {
      return ready(id);
    }
  }
  return base::fail(Errc::not_found, "this list does not exist", std::string(id),
                    "show all lists with: nazori-cli study lists");
}

std::vector<char32_t> sort_for_learning(std::vector<char32_t> characters, NewOrder order,
                                        const std::function<const CharacterFacts*(char32_t)>& facts) {
  const auto frequency = [](const CharacterFacts* one) {
    return one == nullptr ? kUnknown : one->frequency.value_or(kUnknown - 1);
  };
  const auto by = [&](auto key) {
    std::stable_sort(characters.begin(), characters.end(),
                     [&](char32_t a, char32_t b) { return key(facts(a)) < key(facts(b)); });
  };
  const auto by_grade = [&] {
    by([&](const CharacterFacts* one) {
      return std::tuple(one == nullptr ? kUnknown : one->grade.value_or(one->frequency ? 100 : 0),
                        one != nullptr && !one->grade && !one->frequency ? 0 : frequency(one));
    });
  };
  if (order != NewOrder::own) {
    // Kana come first, and in the order in which they are taught; the other orders are about kanji.
    const auto rest = std::stable_partition(characters.begin(), characters.end(), [](char32_t one) {
      return kanji::teaching_rank(one).has_value();
    });
    const std::vector<char32_t> others(rest, characters.end());
    characters.erase(rest, characters.end());
    if (!characters.empty()) {
      const auto first = kanji::script_of(characters.front());
      std::stable_sort(characters.begin(), characters.end(), [&](char32_t a, char32_t b) {
        return std::pair(kanji::script_of(a) != first, *kanji::teaching_rank(a)) <
               std::pair(kanji::script_of(b) != first, *kanji::teaching_rank(b));
      });
      const auto sorted = sort_for_learning(others, order, facts);
      characters.insert(characters.end(), sorted.begin(), sorted.end());
      return characters;
    }
    characters = others;
  }
  switch (order) {
    case NewOrder::own:
      break;
    case NewOrder::grade:
      by_grade();
      break;
    case NewOrder::frequency:
      by(frequency);
      break;
    case NewOrder::strokes:
      by([&](const CharacterFacts* one) {
        return std::tuple(one == nullptr ? kUnknown : one->strokes, frequency(one));
      });
      break;
    case NewOrder::components:
      by_grade();
      return parts_before_wholes(characters, facts);
  }
  return characters;
}

base::Result<std::vector<char32_t>> CharacterLists::in_learning_order(const Settings& settings,
                                                                      const LearnerStore& learner) {
  std::vector<char32_t> all;
  std::set<char32_t> known;
  // The built-in lists of grades are already in the default order, so the characters need not be read.
  bool ready_order = settings.new_order == NewOrder::grade;
  for (const std::string& id : settings.new_lists) {
    ready_order = ready_order && (id.starts_with("grade-") || id == "secondary");
    const auto list = members(id, learner);
    if (!list && list.error().code != Errc::not_found) return tl::unexpected(list.error());
    if (!list) continue;  // a removed list may still be chosen
    for (const char32_t character : *list) {
      if (known.insert(character).second) all.push_back(character);
    }
  }
  if (ready_order && std::is_sorted(settings.new_lists.begin(), settings.new_lists.end())) return all;
  auto sorted = sort_for_learning(std::move(all), settings.new_order,
                                  [this](char32_t character) { return facts(character); });
  if (database_->trouble()) return tl::unexpected(*database_->trouble());
  return sorted;
}

base::Result<std::vector<char32_t>> parse_list(std::string_view text,
                                               const std::function<bool(char32_t)>& known) {
  std::vector<char32_t> characters;
  std::set<char32_t> added;
  int number = 0;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    ++number;
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    line = line.substr(0, line.find('#'));
    const auto decoded = base::decode_utf8(line);
    const std::string where = fmt::format("line {}", number);
    if (!decoded) return base::fail(Errc::parse, "is not UTF-8", where, "save the text as UTF-8");
    for (const char32_t c : *decoded) {
      constexpr std::u32string_view kBetween = U" \t\r,;　、，・";
      if (kBetween.find(c) != std::u32string_view::npos) continue;
      if (!known(c)) {
        const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
        return base::fail(Errc::parse,
                          fmt::format("'{}' (U+{:04X}) cannot be studied",
                                      control ? "?" : base::encode_utf8(c), static_cast<unsigned>(c)),
                          where, "give kanji and kana; a note begins with #");
      }
      if (added.insert(c).second) characters.push_back(c);
      if (characters.size() > kMostCharacters) {
        return base::fail(Errc::parse, "exceeds the maximum length of the list", where,
                          fmt::format("give at most {} characters", kMostCharacters));
      }
    }
  }
  if (characters.empty()) return base::fail(Errc::parse, "contains no characters", "the list");
  return characters;
}

}  // namespace nazori::study
