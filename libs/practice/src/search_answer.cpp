// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/search_answer.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/gloss.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/meaning_text.h"
#include "nazori/practice/list_members.h"

namespace nazori::practice {
namespace {

constexpr std::size_t kMostMeanings = 3;

/// The first kanji of a word that has strokes, else its first other character that has.
std::optional<char32_t> first_shown(const kanji::KanjiDatabase& database, const std::string& word) {
  std::optional<char32_t> shown;
  for (const char32_t c : base::decode_utf8(word).value_or(std::u32string())) {
    if (!database.draws(c)) continue;
    if (kanji::script_of(c) == kanji::Script::other) return c;
    if (!shown) shown = c;
  }
  return shown;
}

/// The first meanings of a word, before them the one that was searched for.
std::vector<std::string> meanings_of(const kanji::WordMatch& match, const std::string& text) {
  auto meanings = kanji::plain_glosses(match.word, match.word.glosses.size());
  if (match.by_meaning) {
    const std::string wanted = " " + kanji::fold_gloss(text);
    std::stable_partition(meanings.begin(), meanings.end(), [&wanted](const std::string& meaning) {
      return (" " + kanji::fold_gloss(meaning)).find(wanted) != std::string::npos;
    });
  }
  if (meanings.size() > kMostMeanings) meanings.resize(kMostMeanings);
  return meanings;
}

/// Whether the query is its text alone.
bool is_text_alone(const kanji::Query& query) {
  kanji::Query text;
  text.text = query.text;
  return query == text && !query.text.empty();
}

}  // namespace

SearchAnswer search_answer(const kanji::KanjiDatabase& database, const kanji::TypedQuery& typed,
                           const std::optional<std::vector<char32_t>>& among) {
  kanji::Query query = typed.query;
  query.among = among;
  SearchAnswer answer;
  std::vector<SearchRow> later;
  for (auto& match : database.matches(query)) {
    const bool is_first = match.whole || match.reason == kanji::Reason::itself;
    (is_first ? answer.rows : later)
        .push_back({std::move(match.summary), match.reason, std::move(match.text), {}});
    ++answer.characters;
  }
  if (is_text_alone(query)) {
    std::size_t at = answer.rows.size();
    // A typed word comes before its characters, a single character before the words that it is.
    const auto typed_characters = base::decode_utf8(query.text);
    if (!answer.rows.empty() && answer.rows.front().reason == kanji::Reason::itself && typed_characters &&
        typed_characters->size() > 1)
      at = 0;
    for (const auto& match : database.search_words(query.text, kMostFoundWords)) {
      const auto shown = first_shown(database, match.word.text);
      const auto character = shown ? database.summary(*shown) : std::nullopt;
      if (!character) continue;
      SearchRow row{*character,
                    match.by_meaning ? kanji::Reason::meaning : kanji::Reason::reading,
                    {},
                    FoundWord{match.word.text, match.word.reading, meanings_of(match, query.text)}};
      if (match.whole)
        answer.rows.insert(answer.rows.begin() + static_cast<std::ptrdiff_t>(at++), std::move(row));
      else
        answer.rows.push_back(std::move(row));
    }
  }
  answer.rows.insert(answer.rows.end(), std::make_move_iterator(later.begin()),
                     std::make_move_iterator(later.end()));
  return answer;
}

base::Result<std::optional<std::vector<char32_t>>> members_of(const kanji::TypedQuery& typed,
                                                              Learner& learner) {
  std::optional<std::vector<char32_t>> among;
  for (const auto& list : typed.lists) {
    auto members = list_members(list, learner.lists(), learner.store());
    if (!members) return tl::unexpected(members.error());
    if (among)
      std::erase_if(*members, [&among](char32_t one) {
        return std::find(among->begin(), among->end(), one) == among->end();
      });
    among = *std::move(members);
  }
  return among;
}

}  // namespace nazori::practice
