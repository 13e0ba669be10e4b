// SPDX-License-Identifier: Apache-2.0
#include "library.h"

#include <algorithm>
#include <utility>

#include "nazori/base/utf8.h"

namespace nazori::ui {
namespace {

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

}  // namespace

Library::Library(std::filesystem::path path, QObject* parent)
    : QObject(parent), database_(std::make_shared<std::optional<kanji::KanjiDatabase>>()) {
  worker_.post([this, path = std::move(path), database = database_] {
    auto opened_database = kanji::KanjiDatabase::open(path);
    if (!opened_database) {
      worker_.answer([this, error = opened_database.error()] { emit failed(error); });
      return;
    }
    database->emplace(std::move(*opened_database));
    worker_.answer([this, sources = (*database)->sources()] { emit opened(sources); });
  });
}

Library::~Library() = default;

void Library::tell_trouble(const kanji::KanjiDatabase& database) {
  if (!database.trouble() || std::exchange(told_trouble_, true)) return;
  worker_.answer([this, error = *database.trouble()] { emit failed(error); });
}

void Library::request_list(kanji::List which) {
  worker_.post([this, which, ticket = ++newest_list_, database = database_] {
    if (ticket != newest_list_ || !*database) return;
    auto characters = std::make_shared<const std::vector<kanji::Summary>>((*database)->list(which));
    tell_trouble(**database);
    worker_.answer([this, which, ticket, characters] {
      if (ticket == newest_list_) emit listed(which, characters);
    });
  });
}

void Library::request_search(const QString& text) {
  worker_.post([this, text, ticket = ++newest_search_, database = database_] {
    if (ticket != newest_search_ || !*database) return;
    kanji::Query query;
    query.text = text.toStdString();
    auto characters = std::make_shared<const std::vector<kanji::Summary>>((*database)->search(query));
    tell_trouble(**database);
    worker_.answer([this, text, ticket, characters] {
      if (ticket == newest_search_) emit found(text, characters);
    });
  });
}

void Library::request_sheet(char32_t code_point) {
  worker_.post([this, code_point, ticket = ++newest_sheet_, database = database_] {
    if (ticket != newest_sheet_ || !*database) return;
    auto character = (*database)->find(code_point);
    tell_trouble(**database);
    if (!character || character->strokes.empty()) {
      worker_.answer([this, code_point, ticket] {
        if (ticket == newest_sheet_) emit sheet_missing(code_point);
      });
      return;
    }
    auto sheet = std::make_shared<CharacterSheet>();
    sheet->parts = parts_of(**database, *character);
    if (character->entry.radical) sheet->radical = (*database)->radical(*character->entry.radical);
    sheet->words = (*database)->words(code_point, kMaxWords);
    tell_trouble(**database);
    sheet->character = std::move(*character);
    worker_.answer([this, ticket, sheet = std::shared_ptr<const CharacterSheet>(sheet)] {
      if (ticket == newest_sheet_) emit sheet_ready(sheet);
    });
  });
}

}  // namespace nazori::ui
