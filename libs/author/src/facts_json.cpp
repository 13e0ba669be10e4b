// SPDX-License-Identifier: Apache-2.0
#include "facts_json.h"

#include <limits>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/json/json.h"
#include "nazori/json/reader.h"

namespace nazori::author {
namespace {

constexpr int kVersion = 1;
constexpr const char* kVersionName = "nazori_character";

std::vector<std::string> texts_of(json::Reader::Object& object, const char* member) {
  std::vector<std::string> texts;
  if (!object.has(member)) return texts;
  const json::Value* const list = object.array(member);
  if (list == nullptr) return texts;
  for (const json::Value& one : *list) {
    if (!one.is_string()) {
      object.refuse(member, "is not a list of texts");
      return texts;
    }
    texts.push_back(one.get<std::string>());
  }
  return texts;
}

std::optional<char32_t> one_letter(json::Reader::Object& object, const char* member) {
  std::string text;
  object.read(member, text);
  const auto letters = base::decode_utf8(text);
  if (letters && letters->size() == 1) return letters->front();
  object.refuse(member, "is not one letter");
  return std::nullopt;
}

std::vector<int> strokes_of(json::Reader::Object& part) {
  std::vector<int> strokes;
  const json::Value* const list = part.array("strokes");
  if (list == nullptr) return strokes;
  for (const json::Value& one : *list) {
    const bool fits =
        one.is_number_unsigned() && one.get<std::uint64_t>() >= 1 && one.get<std::uint64_t>() <= kMostStrokes;
    if (!fits) {
      part.refuse("strokes", "is not a list of numbers of strokes", "give numbers from 1");
      return strokes;
    }
    strokes.push_back(one.get<int>() - 1);
  }
  return strokes;
}

}  // namespace

std::string to_json(const Facts& facts) {
  json::Value value = json::Value::object();
  value[kVersionName] = kVersion;
  value["name"] = facts.name;
  value["readings"] = facts.readings;
  value["meanings"] = facts.meanings;
  json::Value parts = json::Value::array();
  for (const OwnPart& part : facts.parts) {
    json::Value one = json::Value::object();
    one["name"] = part.name;
    one["strokes"] = json::Value::array();
    for (const int stroke : part.strokes) one["strokes"].push_back(stroke + 1);
    parts.push_back(std::move(one));
  }
  value["parts"] = std::move(parts);
  value["radical"] = facts.radical ? json::Value(*facts.radical) : json::Value();
  // Without the choice a file has the same bytes as before there was one.
  if (facts.instead_of) value["instead_of"] = base::encode_utf8(*facts.instead_of);
  value["licence"] = facts.rights.licence;
  value["author"] = facts.rights.author;
  value["source"] = facts.rights.source;
  return json::to_text(value);
}

base::Result<Facts> parse_facts(std::string_view text) {
  constexpr std::size_t kLongest = std::size_t{1} << 20;
  const auto value = json::parse(text, {.bytes = kLongest, .depth = 8, .members = 100});
  if (!value) return tl::unexpected(value.error());
  json::Reader reader(text);
  auto root = reader.root(*value);
  const auto version = root.whole(kVersionName, 1, std::numeric_limits<std::int32_t>::max());
  if (reader.ok() && version > kVersion)
    return base::fail(base::Errc::schema, "was made by a newer version of this program", {},
                      "update this program");
  Facts facts;
  root.read("name", facts.name);
  facts.readings = texts_of(root, "readings");
  facts.meanings = texts_of(root, "meanings");
  if (root.has("parts")) {
    root.each("parts", [&facts](json::Reader::Object& part) {
      OwnPart one;
      part.read("name", one.name);
      one.strokes = strokes_of(part);
      facts.parts.push_back(std::move(one));
    });
  }
  if (root.has("radical")) facts.radical = static_cast<int>(root.whole("radical", 1, 214));
  if (root.has("instead_of")) facts.instead_of = one_letter(root, "instead_of");
  root.read("licence", facts.rights.licence);
  root.read("author", facts.rights.author);
  root.read("source", facts.rights.source);
  if (!reader.ok()) return tl::unexpected(reader.error());
  return facts;
}

}  // namespace nazori::author
