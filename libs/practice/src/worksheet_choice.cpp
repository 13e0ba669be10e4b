// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/worksheet_choice.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "nazori/author/collection.h"
#include "nazori/base/utf8.h"
#include "nazori/practice/extra_study.h"
#include "nazori/practice/list_members.h"

namespace nazori::practice {
namespace {

constexpr int kMostPrintedWords = 3;
constexpr std::array<std::string_view, 5> kSources{"shown", "list", "due", "difficult", "text"};
constexpr std::array<std::string_view, 2> kLanguages{"en", "ja"};

struct Flag {
  const char* key;
  bool print::SheetSettings::*value;
};
constexpr std::array kFlags{
    Flag{"whole_page", &print::SheetSettings::whole_page}, Flag{"vertical", &print::SheetSettings::vertical},
    Flag{"steps", &print::SheetSettings::steps},           Flag{"numbers", &print::SheetSettings::numbers},
    Flag{"arrows", &print::SheetSettings::arrows},         Flag{"facts", &print::SheetSettings::facts},
    Flag{"answers", &print::SheetSettings::answers},       Flag{"booklet", &print::SheetSettings::booklet},
    Flag{"name_line", &print::SheetSettings::name_line},
};

bool is_kanji(char32_t c) {
  return (c >= 0x3400 && c <= 0x9FFF) || (c >= 0xF900 && c <= 0xFAFF) || (c >= 0x20000 && c <= 0x3FFFF) ||
         c == U'々';
}

template <class Characters>
std::vector<char32_t> each_once(const Characters& characters) {
  std::vector<char32_t> all;
  std::set<char32_t> seen;
  for (const char32_t c : characters)
    if (seen.insert(c).second) all.push_back(c);
  return all;
}

/// Who made the form of a character. One that cannot be read any more is printed without a name.
std::optional<print::MadeForm> made_form(const author::Collection& collection,
                                         const kanji::Character& character) {
  const auto kept = author::kept_form_of(character);
  if (!kept) return std::nullopt;
  const auto facts = collection.facts(*kept);
  if (!facts) return print::MadeForm();
  return print::MadeForm{facts->name, facts->rights.author, facts->rights.licence,
                         facts->rights.source == author::kKanjiVgSource};
}

}  // namespace

WorksheetChoice load_choice(const base::Settings& settings, WorksheetChoice choice) {
  choice.source = base::named_setting(settings, "source", kSources, choice.source);
  if (settings.contains("list")) choice.list = base::text_setting(settings, "list");
  if (settings.contains("text")) choice.text = base::text_setting(settings, "text");
  auto& sheet = choice.sheet;
  sheet.layout = base::named_setting(settings, "layout", print::kLayoutNames, sheet.layout);
  sheet.paper = base::named_setting(settings, "paper", print::kPaperNames, sheet.paper);
  sheet.guide = base::named_setting(settings, "guide", print::kGuideNames, sheet.guide);
  sheet.language = base::named_setting(settings, "language", kLanguages, sheet.language);
  sheet.cell_mm = base::number_setting(settings, "cell_mm", sheet.cell_mm, print::kSmallestCell_mm,
                                       print::kLargestCell_mm);
  sheet.rows = static_cast<int>(base::number_setting(settings, "rows", sheet.rows, 0, print::kMostRows));
  sheet.copies =
      static_cast<int>(base::number_setting(settings, "copies", sheet.copies, 0, print::kMostRows));
  const int per_sheet = static_cast<int>(base::number_setting(
      settings, "per_sheet", sheet.per_sheet, print::kPerSheet.front(), print::kPerSheet.back()));
  if (std::find(print::kPerSheet.begin(), print::kPerSheet.end(), per_sheet) != print::kPerSheet.end())
    sheet.per_sheet = per_sheet;
  for (const Flag& flag : kFlags)
    sheet.*flag.value = base::flag_setting(settings, flag.key, sheet.*flag.value);
  if (settings.contains("title")) sheet.title = base::text_setting(settings, "title");
  return choice;
}

void save_choice(base::Settings& settings, const WorksheetChoice& choice) {
  const auto name = [](const auto& names, auto value) {
    return std::string(names[static_cast<std::size_t>(value)]);
  };
  settings["source"] = name(kSources, choice.source);
  settings["list"] = choice.list;
  settings["text"] = choice.text;
  const auto& sheet = choice.sheet;
  settings["layout"] = name(print::kLayoutNames, sheet.layout);
  settings["paper"] = name(print::kPaperNames, sheet.paper);
  settings["guide"] = name(print::kGuideNames, sheet.guide);
  settings["language"] = name(kLanguages, sheet.language);
  base::set_number(settings, "cell_mm", sheet.cell_mm);
  base::set_number(settings, "rows", sheet.rows);
  base::set_number(settings, "copies", sheet.copies);
  base::set_number(settings, "per_sheet", sheet.per_sheet);
  for (const Flag& flag : kFlags) base::set_flag(settings, flag.key, sheet.*flag.value);
  settings["title"] = sheet.title;
}

std::vector<char32_t> characters_of_text(std::string_view text, const std::function<bool(char32_t)>& draws) {
  std::vector<char32_t> kanji;
  std::vector<char32_t> others;
  for (const char32_t c : each_once(base::decode_utf8(text).value_or(U""))) {
    if (c > U' ' && c != U'\u3000') (is_kanji(c) ? kanji : others).push_back(c);
  }
  auto& chosen = kanji.empty() ? others : kanji;
  std::erase_if(chosen, [&draws](char32_t c) { return !draws(c); });
  return std::move(chosen);
}

base::Result<std::vector<char32_t>> chosen_characters(const WorksheetChoice& choice, Learner& learner) {
  switch (choice.source) {
    case WorksheetSource::shown:
      return choice.shown == 0 ? std::vector<char32_t>() : std::vector<char32_t>{choice.shown};
    case WorksheetSource::list:
      return list_members(choice.list, learner.lists(), learner.store());
    case WorksheetSource::due:
    case WorksheetSource::difficult: {
      const auto plan = learner.plan();
      if (!plan) return tl::unexpected(plan.error());
      if (choice.source == WorksheetSource::difficult) return plan->leeches;
      auto reviews = reviews_now(learner.store(), *plan);
      if (!reviews) return tl::unexpected(std::move(reviews.error()));
      return each_once(reviews->characters);
    }
    case WorksheetSource::text:
      break;
  }
  return std::vector<char32_t>();
}

SheetCharacters sheet_characters(const kanji::KanjiDatabase& database,
                                 std::span<const kanji::CharacterName> names,
                                 const print::SheetSettings& sheet, const std::filesystem::path& own) {
  const author::Collection collection(own);
  const bool wants_words = sheet.facts || sheet.layout == print::Layout::quiz;
  SheetCharacters all;
  for (const kanji::CharacterName& name : names) {
    auto character = database.find(name.code_point, name.variant);
    if (!character) {
      all.missing.push_back(name);
      continue;
    }
    all.found.push_back({*std::move(character), wants_words
                                                    ? database.words(name.code_point, kMostPrintedWords)
                                                    : std::vector<kanji::Word>()});
    all.found.back().made = made_form(collection, all.found.back().character);
  }
  return all;
}

}  // namespace nazori::practice
