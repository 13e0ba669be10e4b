// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_library.h"

#include <algorithm>
#include <utility>

#include "nazori/base/latest.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kana_sound.h"

namespace nazori::practice {
namespace {

/// Words that are read for a kana; nouns among them are asked for.
constexpr int kMostHeard = 400;

std::optional<char32_t> single(const std::string& text) {
  const auto points = base::decode_utf8(text);
  if (!points || points->size() != 1) return std::nullopt;
  return points->front();
}

void collect(const kanji::Component& node, std::vector<Part>& parts) {
  for (const auto& child : node.children) {
    if (!child.element.empty()) {
      const bool known = std::any_of(parts.begin(), parts.end(),
                                     [&child](const Part& part) { return part.element == child.element; });
      if (!known) parts.push_back({child.element, 0, child.original, {}});
    }
    collect(child, parts);
  }
}

std::string first_english(const kanji::DictionaryEntry& entry) {
  for (const auto& meaning : entry.meanings)
    if (meaning.language == "en") return meaning.text;
  return {};
}

std::vector<Part> parts_of(const kanji::KanjiDatabase& database, const kanji::Character& character) {
  std::vector<Part> parts;
  collect(character.components, parts);
  std::erase_if(parts,
                [&character](const Part& part) { return single(part.element) == character.code_point; });
  for (auto& part : parts) {
    for (const auto& text : {part.element, part.original}) {
      const auto code_point = single(text);
      if (!code_point) continue;
      const auto target = database.find(*code_point);
      if (!target) continue;
      if (part.target == 0 && !target->strokes.empty()) part.target = *code_point;
      if (part.meaning.empty()) part.meaning = first_english(target->entry);
    }
  }
  return parts;
}

/// The result of a query, and the damage of the database that was found during it.
template <class Found>
struct Answer {
  Found found;
  std::optional<base::Error> trouble;
};

using Sheet = std::shared_ptr<const CharacterSheet>;

struct SearchRequest {
  std::string typed;
  std::optional<std::vector<char32_t>> among;
};

struct Searched {
  std::string typed;
  std::shared_ptr<const SearchAnswer> answer;
};

struct TablesRequest {};
using Tables = std::shared_ptr<const CharacterTables>;

Tables tables_of(const kanji::KanjiDatabase& database, const TablesRequest& /*request*/) {
  return std::make_shared<const CharacterTables>(
      CharacterTables{kanji::PartPicker(database.parts(CharacterTables::kFewestUses)), database.radicals()});
}

using Facts = std::vector<ConfusableFacts>;

Facts drill_of(const kanji::KanjiDatabase& database, const std::vector<char32_t>& characters) {
  Facts facts;
  for (const char32_t one : characters) facts.push_back(confusable_facts(database, one));
  return facts;
}

struct ListAnswer {
  kanji::List which;
  Summaries characters;
};

struct SheetAnswer {
  char32_t code_point;
  Sheet sheet;  ///< null: no strokes
};

using Characters = std::vector<kanji::Character>;

Characters characters_of(const kanji::KanjiDatabase& database, const std::vector<char32_t>& code_points) {
  Characters found;
  for (const char32_t one : code_points)
    if (auto character = database.find(one); character && !character->strokes.empty())
      found.push_back(std::move(*character));
  return found;
}

Summaries shared(std::vector<kanji::Summary> characters) {
  return std::make_shared<const std::vector<kanji::Summary>>(std::move(characters));
}

Sheet sheet_of(const kanji::KanjiDatabase& database, char32_t code_point) {
  auto character = database.find(code_point);
  if (!character || character->strokes.empty()) return nullptr;
  auto sheet = std::make_shared<CharacterSheet>();
  sheet->parts = parts_of(database, *character);
  if (character->entry.radical) sheet->radical = database.radical(*character->entry.radical);
  sheet->words = database.words(code_point, CharacterLibrary::kMaxWords);
  sheet->helpful = words_that_help(database, *character);
  for (const char32_t other : confusables_of(database, code_point))
    if (auto drawn = database.find(other)) sheet->confusables.push_back(*std::move(drawn));
  const auto draws = [&database](char32_t one) { return database.draws(one); };
  if (kanji::kana_sound(code_point))
    sheet->dictation =
        kana_words(database.words_heard_with(code_point, static_cast<int>(kMostDictated), kMostHeard),
                   code_point, draws);
  else
    sheet->dictation = dictation_words(sheet->words, code_point, draws);
  sheet->character = std::move(*character);
  return sheet;
}

}  // namespace

struct CharacterLibrary::Inside {
  Inside(CharacterLibrary& owner, base::Inbox& inbox, CharacterSource source);

  /// Runs `find` if the database is open; otherwise there is no answer.
  template <class Request, class Found, class Find, class Answered>
  [[nodiscard]] auto latest(Find find, Answered answered) {
    using Answered_ = std::optional<Answer<Found>>;
    return std::make_unique<base::Latest<Request, Answered_>>(
        background,
        [book = book, find](const Request& request, const auto&) -> Answered_ {
          // Before it was opened, or where that failed, `failed` has said so.
          if (book->database() == nullptr || !book->look()) return std::nullopt;
          Answer<Found> answer{find(*book->database(), request), {}};
          answer.trouble = book->database()->trouble();
          return answer;
        },
        [this, answered](Answered_ answer) {
          if (!answer) return;
          // Reported first, so that nothing found is not mistaken for the answer.
          if (answer->trouble && !std::exchange(has_reported_trouble, true)) owner.failed(*answer->trouble);
          answered(answer->found);
        });
  }

  CharacterLibrary& owner;
  bool has_reported_trouble = false;
  std::shared_ptr<CharacterBook> book;  ///< used by the background thread only
  std::shared_ptr<base::Background> background;
  std::unique_ptr<base::Latest<kanji::List, std::optional<Answer<ListAnswer>>>> lists;
  std::unique_ptr<base::Latest<SearchRequest, std::optional<Answer<Searched>>>> searches;
  std::unique_ptr<base::Latest<TablesRequest, std::optional<Answer<Tables>>>> tables;
  std::unique_ptr<base::Latest<std::vector<char32_t>, std::optional<Answer<Facts>>>> drills;
  std::unique_ptr<base::Latest<char32_t, std::optional<Answer<SheetAnswer>>>> sheets;
  std::unique_ptr<base::Latest<std::vector<char32_t>, std::optional<Answer<Characters>>>> characters;
};

CharacterLibrary::Inside::Inside(CharacterLibrary& library, base::Inbox& inbox, CharacterSource source)
    : owner(library),
      book(std::make_shared<CharacterBook>(std::move(source))),
      background(std::make_shared<base::Background>("library", inbox)) {
  using kanji::KanjiDatabase;
  lists = latest<kanji::List, ListAnswer>(
      [](const KanjiDatabase& from, kanji::List which) {
        return ListAnswer{which, shared(from.list(which))};
      },
      [this](const ListAnswer& answer) { owner.listed(answer.which, answer.characters); });
  searches = latest<SearchRequest, Searched>(
      [](const KanjiDatabase& from, const SearchRequest& request) {
        return Searched{request.typed, std::make_shared<const SearchAnswer>(search_answer(
                                           from, kanji::read_query(request.typed), request.among))};
      },
      [this](const Searched& searched) { owner.found(searched.typed, searched.answer); });
  tables =
      latest<TablesRequest, Tables>(tables_of, [this](const Tables& answer) { owner.tables_ready(answer); });
  drills = latest<std::vector<char32_t>, Facts>(drill_of,
                                                [this](const Facts& answer) { owner.drill_ready(answer); });
  sheets = latest<char32_t, SheetAnswer>(
      [](const KanjiDatabase& from, char32_t code_point) {
        return SheetAnswer{code_point, sheet_of(from, code_point)};
      },
      [this](const SheetAnswer& answer) {
        if (answer.sheet)
          owner.sheet_ready(answer.sheet);
        else
          owner.sheet_missing(answer.code_point);
      });
  characters = latest<std::vector<char32_t>, Characters>(
      characters_of, [this](const Characters& answer) { owner.characters_ready(answer); });
}

CharacterLibrary::CharacterLibrary(base::Inbox& inbox, CharacterSource source)
    : inside_(std::make_unique<Inside>(*this, inbox, std::move(source))) {
  base::Background& background = *inside_->background;
  background.post([this, &background, book = inside_->book] {
    if (const auto anew = book->look(); !anew) {
      background.answer([this, error = anew.error()] { failed(error); });
      return;
    }
    background.answer([this, sources = book->database()->sources()] { opened(sources); });
  });
}

CharacterLibrary::~CharacterLibrary() = default;

void CharacterLibrary::request_list(kanji::List which) { inside_->lists->request(which); }

void CharacterLibrary::request_search(const std::string& typed, std::optional<std::vector<char32_t>> among) {
  inside_->searches->request({typed, std::move(among)});
}

void CharacterLibrary::request_tables() { inside_->tables->request({}); }

void CharacterLibrary::request_drill(std::vector<char32_t> characters) {
  inside_->drills->request(std::move(characters));
}

void CharacterLibrary::request_sheet(char32_t code_point) { inside_->sheets->request(code_point); }

void CharacterLibrary::request_characters(std::vector<char32_t> code_points) {
  inside_->characters->request(std::move(code_points));
}

}  // namespace nazori::practice
