// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/practice/learner.h"
#include "nazori/study/learner_store.h"

namespace nazori::practice {

/// What a learner would like to write.
enum class LearningGoal : std::uint8_t {
  hiragana,
  katakana,
  kanji_by_grade,
  kanji_by_jlpt,       ///< the levels before 2010, easiest first
  kanji_by_frequency,  ///< commonest in newspapers first
  own_list,
};

/// What a learner can write already.
struct KnownAlready {
  enum class Kind : std::uint8_t {
    nothing,
    kana,         ///< hiragana and katakana
    up_to_grade,  ///< kana, and the kanji of the grades up to `level`: 1..6; 7: of secondary school, too
    up_to_jlpt,   ///< kana, and the kanji of the old levels from 4 down to `level`: 4..1
    checked,      ///< what a PlacementCheck found: `characters`
    listed,       ///< every kanji and kana of LearningAnswers::known_text
  };
  Kind kind = Kind::nothing;
  int level = 0;
  std::vector<char32_t> characters;

  friend bool operator==(const KnownAlready&, const KnownAlready&) = default;
};

/// Answers to the three questions of the first start. An answer that is missing changes nothing.
struct LearningAnswers {
  std::optional<LearningGoal> goal;
  std::string own_text;   ///< of LearningGoal::own_list: any text with the characters
  std::string list_name;  ///< of the list that is made of it; a number is added where it is taken
  std::optional<KnownAlready> known;
  std::string known_text;      ///< of KnownAlready::Kind::listed: any text or list
  std::optional<int> minutes;  ///< a day

  friend bool operator==(const LearningAnswers&, const LearningAnswers&) = default;
};

/// The minutes a day that can be chosen.
[[nodiscard]] std::span<const int> daily_minutes();

/// How much is done a day.
struct DailyAmount {
  int new_characters = 1;
  int reviews = 1;

  friend bool operator==(const DailyAmount&, const DailyAmount&) = default;
};
/// What takes about so many minutes a day. A new kanji of each day takes 180 s to learn, and ten reviews of
/// 24 s a day for those that were new before; a kana 60 s and six reviews of 10 s (docs/study.md, First
/// start). Reviews alone never take longer than the minutes.
[[nodiscard]] DailyAmount amount_for(int minutes, bool is_kana);

/// The answers that lead to these settings, as far as they can be told.
[[nodiscard]] LearningAnswers answers_of(const study::Settings& settings);

/// Whether a learner never studied nor chose anything.
[[nodiscard]] bool is_new(const study::LearnerStore& store);

/// The characters of a text that can be studied, each once: its kanji; its kana if it has no kanji.
/// @param can_be_studied  whether a character has strokes.
[[nodiscard]] std::vector<char32_t> characters_in(std::string_view text,
                                                  const std::function<bool(char32_t)>& can_be_studied);
/// The same with its kana, whether it has kanji or not.
[[nodiscard]] std::vector<char32_t> kanji_and_kana_in(std::string_view text,
                                                      const std::function<bool(char32_t)>& can_be_studied);

/// The days on which known characters are first reviewed: from the seventh day on, the hardest first, on
/// each day half of the reviews that fit into it, so that they do not all come at once.
[[nodiscard]] std::vector<study::KnownCharacter> first_reviews(const std::vector<char32_t>& easiest_first,
                                                               study::Day today, int reviews_per_day);

/// What answers come to, before it is saved.
struct LearningPlan {
  study::StudyChoices choices;
  char32_t first = 0;  ///< the first new character; 0: nothing new is left
};
/// Nothing that was studied already is marked as known, nor is any kana of the syllabary that is the goal,
/// unless a check or the learner named it. Known characters are reviewed on the days of first_reviews(). The
/// learner's own lists and tags stay chosen.
/// @return Errc::bad_argument for an own list or a known text without characters; the errors of the
/// learner's lists.
[[nodiscard]] base::Result<LearningPlan> plan_learning(Learner& learner, const LearningAnswers& answers);

/// Saves a plan as one action with one undo, or nothing. @return whether it was saved; why not is announced
/// by the learner.
bool take_plan(Learner& learner, const LearningPlan& plan);

/// The characters a check goes through for a goal, easiest first: kana in the order of the table, kanji by
/// level and frequency. @return the errors of the learner's lists.
[[nodiscard]] base::Result<std::vector<char32_t>> characters_to_check(Learner& learner,
                                                                      const LearningAnswers& answers);

}  // namespace nazori::practice
