// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/search_keys.h"

#include <algorithm>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/meaning_text.h"
#include "nazori/kanji/romaji.h"

namespace nazori::kanji {
namespace {

void collect_elements(const Component& group, std::set<std::string>& elements) {
  for (const Component& child : group.children) {
    if (!child.element.empty()) elements.insert(child.element);
    if (!child.original.empty()) elements.insert(child.original);
    collect_elements(child, elements);
  }
}

}  // namespace

void offer_key(SearchKeys& keys, std::string key, KeyFit fit) {
  if (key.empty()) return;
  const auto [at, is_new] = keys.emplace(std::move(key), fit);
  if (!is_new) at->second = std::min(at->second, fit);
}

SearchKeys reading_keys(const DictionaryEntry& entry) {
  SearchKeys keys;
  for (const std::string& on : entry.on_readings) offer_key(keys, fold_reading(on), KeyFit::whole);
  for (const std::string& kun : entry.kun_readings) {
    offer_key(keys, fold_reading(kun), KeyFit::whole);
    if (const auto dot = kun.find('.'); dot != std::string::npos)
      offer_key(keys, fold_reading(kun.substr(0, dot)), KeyFit::part);
  }
  for (const std::string& name : entry.nanori) offer_key(keys, fold_reading(name), KeyFit::name);
  return keys;
}

SearchKeys meaning_keys(const DictionaryEntry& entry) {
  SearchKeys keys;
  KeyFit fit = KeyFit::whole;
  for (const auto& [language, text] : entry.meanings) {
    if (language != "en") continue;
    std::string phrase = fold_meaning(text);
    offer_key(keys, phrase, fit);
    // Each word of a meaning can be found by its beginning: the key is the meaning from that word on.
    for (std::size_t gap = phrase.find(' '); gap != std::string::npos; gap = phrase.find(' ')) {
      phrase.erase(0, gap + 1);
      offer_key(keys, phrase, KeyFit::name);
    }
    fit = KeyFit::part;
  }
  return keys;
}

std::set<std::string> element_keys(char32_t character, const Component& components) {
  std::set<std::string> elements;
  collect_elements(components, elements);
  elements.erase(base::encode_utf8(character));
  return elements;
}

std::string first_meaning(const DictionaryEntry& entry) {
  return entry.meanings.empty() || entry.meanings.front().language != "en" ? "" : entry.meanings.front().text;
}

std::string first_reading(const DictionaryEntry& entry) {
  if (!entry.kun_readings.empty()) return entry.kun_readings.front();
  return entry.on_readings.empty() ? "" : entry.on_readings.front();
}

}  // namespace nazori::kanji
