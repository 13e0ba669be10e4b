// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/learning_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/kana_sound.h"
#include "nazori/study/character_lists.h"

namespace nazori::practice {
namespace {

using base::Errc;
using Characters = std::vector<char32_t>;
using Lists = std::vector<std::string>;
using study::NewOrder;

constexpr std::array<int, 4> kMinutes{5, 10, 20, 40};
constexpr int kSecondary = 7;
constexpr int kFirstReview_days = 7;
constexpr int kLastReview_days = 365;
constexpr std::size_t kMostOwn = 5'000;

bool is_kana(LearningGoal goal) { return goal == LearningGoal::hiragana || goal == LearningGoal::katakana; }

Lists grades(int last) {
  Lists lists;
  for (int grade = 1; grade <= std::min(last, 6); ++grade) lists.push_back(fmt::format("grade-{}", grade));
  if (last >= kSecondary) lists.emplace_back("secondary");
  return lists;
}

Lists jlpt_levels(int last) {
  Lists lists;
  for (int level = 4; level >= std::max(1, last); --level) lists.push_back(fmt::format("old-jlpt-{}", level));
  return lists;
}

/// The built-in lists of a goal; none for the learner's own.
Lists lists_of(LearningGoal goal) {
  switch (goal) {
    case LearningGoal::hiragana:
      return {"hiragana"};
    case LearningGoal::katakana:
      return {"katakana"};
    case LearningGoal::kanji_by_grade:
    case LearningGoal::kanji_by_frequency:
      return grades(kSecondary);
    case LearningGoal::kanji_by_jlpt:
      return jlpt_levels(1);
    case LearningGoal::own_list:
      break;
  }
  return {};
}

NewOrder order_of(LearningGoal goal, NewOrder present) {
  switch (goal) {
    case LearningGoal::hiragana:
    case LearningGoal::katakana:
      // Every other order teaches kana in the order of the table.
      return present == NewOrder::own ? NewOrder::grade : present;
    case LearningGoal::kanji_by_grade:
      return NewOrder::grade;
    case LearningGoal::kanji_by_frequency:
      return NewOrder::frequency;
    case LearningGoal::kanji_by_jlpt:
    case LearningGoal::own_list:
      return NewOrder::own;
  }
  return present;
}

bool is_kana(char32_t one) { return kanji::teaching_rank(one).has_value(); }

/// CJK ideographs and 々, not punctuation, which has strokes in the database, too.
bool is_kanji(char32_t one) {
  return one == U'々' || (one >= 0x3400 && one <= 0x9FFF) || (one >= 0xF900 && one <= 0xFAFF) ||
         (one >= 0x20000 && one <= 0x3FFFF);
}

bool is_own(const std::string& list) { return list.starts_with("list:") || list.starts_with("tag:"); }

base::Result<std::string> free_name(const study::LearnerStore& store, const std::string& wanted) {
  const auto lists = store.lists();
  if (!lists) return tl::unexpected(lists.error());
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(lists->begin(), lists->end(), [&](const auto& one) { return one.name == name; });
  };
  std::string name = wanted;
  for (int number = 2; is_taken(name); ++number) name = fmt::format("{} {}", wanted, number);
  return name;
}

base::Result<Characters> members(Learner& learner, const Lists& lists) {
  Characters all;
  if (learner.lists() == nullptr) return all;
  for (const auto& id : lists) {
    const auto list = learner.lists()->members(id, learner.store());
    if (!list) return tl::unexpected(list.error());
    all.insert(all.end(), list->begin(), list->end());
  }
  return all;
}

Characters sorted(Learner& learner, Characters characters, NewOrder order) {
  if (learner.lists() == nullptr) return characters;
  return study::sort_for_learning(std::move(characters), order,
                                  [&](char32_t one) { return learner.lists()->facts(one); });
}

/// The characters of a text that the learner's database has.
Characters found_in(Learner& learner, std::string_view text, bool with_kana) {
  const auto can_be_studied = [&learner](char32_t one) {
    return learner.lists() != nullptr && learner.lists()->facts(one) != nullptr;
  };
  return with_kana ? kanji_and_kana_in(text, can_be_studied) : characters_in(text, can_be_studied);
}

/// Easiest first.
base::Result<Characters> known_characters(Learner& learner, const LearningAnswers& answers) {
  using Kind = KnownAlready::Kind;
  const KnownAlready& known = *answers.known;
  if (known.kind == Kind::nothing) return Characters();
  if (known.kind == Kind::listed) {
    auto found = found_in(learner, answers.known_text, true);
    if (found.empty()) return base::fail(Errc::bad_argument, "has no kanji or kana", "the text");
    return sorted(learner, std::move(found), NewOrder::grade);
  }
  if (known.kind == Kind::checked) return known.characters;
  auto all = members(learner, {"hiragana", "katakana"});
  if (!all || known.kind == Kind::kana) return all;
  const bool by_grade = known.kind == Kind::up_to_grade;
  auto kanji = members(learner, by_grade ? grades(known.level) : jlpt_levels(known.level));
  if (!kanji) return kanji;
  all->insert(all->end(), kanji->begin(), kanji->end());
  return all;
}

kanji::Script script_of(std::optional<LearningGoal> goal) {
  if (goal == LearningGoal::hiragana) return kanji::Script::hiragana;
  if (goal == LearningGoal::katakana) return kanji::Script::katakana;
  return kanji::Script::other;
}

base::Result<char32_t> first_new(Learner& learner, const study::StudyChoices& choices) {
  if (learner.lists() == nullptr) return char32_t{0};
  auto order = learner.lists()->in_learning_order(choices.settings, learner.store());
  if (!order) return tl::unexpected(order.error());
  // A list that is not saved yet comes first.
  if (choices.list)
    order->insert(order->begin(), choices.list->characters.begin(), choices.list->characters.end());
  std::set<char32_t> known;
  for (const auto& one : choices.known) known.insert(one.character);
  const auto is_next = [&](char32_t one) {
    const auto card = learner.store().card(one);
    return !known.contains(one) && !card.introduced && !card.paused &&
           (!card.postponed_until || *card.postponed_until <= learner.store().today());
  };
  const auto found = std::find_if(order->begin(), order->end(), is_next);
  return found == order->end() ? 0 : *found;
}

}  // namespace

std::span<const int> daily_minutes() { return kMinutes; }

DailyAmount amount_for(int minutes, bool is_kana) {
  constexpr double kKana_s = 60 + 6 * 10;
  constexpr double kKanji_s = 180 + 10 * 24;
  constexpr double kReview_s = 24;
  const double all_s = 60.0 * minutes;
  return {std::max(1, static_cast<int>(std::lround(all_s / (is_kana ? kKana_s : kKanji_s)))),
          static_cast<int>(all_s / kReview_s)};
}

LearningAnswers answers_of(const study::Settings& settings) {
  LearningAnswers answers;
  Lists ready;
  std::copy_if(settings.new_lists.begin(), settings.new_lists.end(), std::back_inserter(ready),
               [](const auto& one) { return !is_own(one); });
  if (ready.empty() && !settings.new_lists.empty()) {
    answers.goal = LearningGoal::own_list;
  } else {
    for (const auto goal : {LearningGoal::hiragana, LearningGoal::katakana, LearningGoal::kanji_by_jlpt})
      if (ready == lists_of(goal)) answers.goal = goal;
    if (ready == grades(kSecondary))
      answers.goal = settings.new_order == NewOrder::frequency ? LearningGoal::kanji_by_frequency
                                                               : LearningGoal::kanji_by_grade;
  }
  for (const int minutes : kMinutes)
    for (const bool kana : {true, false})
      if (amount_for(minutes, kana) == DailyAmount{settings.new_per_day, settings.reviews_per_day})
        answers.minutes = minutes;
  return answers;
}

bool is_new(const study::LearnerStore& store) { return store.cards().empty() && store.last_entry() == 0; }

Characters kanji_and_kana_in(std::string_view text, const std::function<bool(char32_t)>& can_be_studied) {
  Characters found;
  std::set<char32_t> seen;
  const auto decoded = base::decode_utf8(text);
  if (!decoded) return {};
  for (const char32_t one : *decoded)
    if (seen.insert(one).second && (is_kana(one) || is_kanji(one)) && can_be_studied(one))
      found.push_back(one);
  return found;
}

Characters characters_in(std::string_view text, const std::function<bool(char32_t)>& can_be_studied) {
  Characters found = kanji_and_kana_in(text, can_be_studied);
  if (std::any_of(found.begin(), found.end(), is_kanji))
    std::erase_if(found, [](char32_t one) { return is_kana(one); });
  if (found.size() > kMostOwn) found.resize(kMostOwn);
  return found;
}

std::vector<study::KnownCharacter> first_reviews(const Characters& easiest_first, study::Day today,
                                                 int reviews_per_day) {
  std::vector<study::KnownCharacter> known;
  const int a_day = std::max(1, reviews_per_day / 2);
  int place = 0;
  for (auto one = easiest_first.rbegin(); one != easiest_first.rend(); ++one, ++place) {
    const int day = std::min(kLastReview_days, kFirstReview_days + place / a_day);
    known.push_back({*one, today + std::chrono::days(day)});
  }
  return known;
}

base::Result<LearningPlan> plan_learning(Learner& learner, const LearningAnswers& answers) {
  auto& store = learner.store();
  LearningPlan plan;
  auto& settings = plan.choices.settings = store.settings();
  if (answers.goal) {
    Lists lists = lists_of(*answers.goal);
    if (answers.goal == LearningGoal::own_list) {
      study::CustomList list{"", found_in(learner, answers.own_text, false)};
      if (list.characters.empty())
        return base::fail(Errc::bad_argument, "has no characters that can be studied", "the list");
      auto name = free_name(store, answers.list_name);
      if (!name) return tl::unexpected(name.error());
      list.name = *std::move(name);
      lists.push_back("list:" + list.name);
      plan.choices.list = std::move(list);
    }
    for (const auto& one : settings.new_lists)
      if (is_own(one) && std::find(lists.begin(), lists.end(), one) == lists.end()) lists.push_back(one);
    settings.new_lists = std::move(lists);
    settings.new_order = order_of(*answers.goal, settings.new_order);
  }
  if (answers.minutes) {
    const auto goal = answers.goal ? answers.goal : answers_of(settings).goal;
    const DailyAmount amount = amount_for(*answers.minutes, goal && is_kana(*goal));
    settings.new_per_day = amount.new_characters;
    settings.reviews_per_day = amount.reviews;
  }
  if (answers.known) {
    auto known = known_characters(learner, answers);
    if (!known) return tl::unexpected(known.error());
    const bool is_named = answers.known->kind == KnownAlready::Kind::checked ||
                          answers.known->kind == KnownAlready::Kind::listed;
    const auto goal = script_of(answers.goal ? answers.goal : answers_of(settings).goal);
    std::erase_if(*known, [&](char32_t one) {
      const bool is_goal = goal != kanji::Script::other && kanji::script_of(one) == goal;
      return store.card(one).introduced.has_value() || (is_goal && !is_named);
    });
    plan.choices.known = first_reviews(*known, store.today(), settings.reviews_per_day);
  }
  const auto first = first_new(learner, plan.choices);
  if (!first) return tl::unexpected(first.error());
  plan.first = *first;
  return plan;
}

bool take_plan(Learner& learner, const LearningPlan& plan) {
  return learner.report(learner.store().choose(plan.choices));
}

base::Result<Characters> characters_to_check(Learner& learner, const LearningAnswers& answers) {
  const LearningGoal goal = answers.goal.value_or(
      answers_of(learner.store().settings()).goal.value_or(LearningGoal::kanji_by_grade));
  if (goal == LearningGoal::own_list && learner.lists() != nullptr) {
    auto own = found_in(learner, answers.own_text, false);
    if (own.empty()) {
      Lists lists = learner.store().settings().new_lists;
      std::erase_if(lists, [](const auto& one) { return !is_own(one); });
      auto found = members(learner, lists);
      if (!found) return found;
      own = *std::move(found);
    }
    return sorted(learner, std::move(own), NewOrder::grade);
  }
  auto all = members(learner, lists_of(goal));
  if (!all) return all;
  if (goal == LearningGoal::kanji_by_frequency) return sorted(learner, *std::move(all), NewOrder::frequency);
  if (goal == LearningGoal::kanji_by_jlpt) {
    Characters levels;
    for (const auto& level : lists_of(goal)) {
      auto one = members(learner, {level});
      if (!one) return one;
      const auto by_frequency = sorted(learner, *std::move(one), NewOrder::frequency);
      levels.insert(levels.end(), by_frequency.begin(), by_frequency.end());
    }
    return levels;
  }
  return sorted(learner, *std::move(all), NewOrder::grade);
}

}  // namespace nazori::practice
