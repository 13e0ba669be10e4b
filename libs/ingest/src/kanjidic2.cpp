// SPDX-License-Identifier: Apache-2.0
#include "kanjidic2.h"

#include <pugixml.hpp>
#include <string_view>
#include <utility>

#include "nazori/base/utf8.h"

namespace nazori::ingest {
namespace {

std::optional<int> number_in(const pugi::xml_node& node) {
  if (!node) return std::nullopt;
  return node.text().as_int();
}

/// The code with the additional information of KANJIDIC2: the volume and page of Morohashi, the kind of a
/// wrong SKIP.
kanji::Code code_of(const pugi::xml_node& node, const char* type) {
  kanji::Code out{node.attribute(type).value(), node.text().get()};
  const std::string_view volume = node.attribute("m_vol").value();
  const std::string_view page = node.attribute("m_page").value();
  if (!volume.empty()) out.value += " (vol. " + std::string(volume) + ", p. " + std::string(page) + ")";
  if (const std::string_view wrong = node.attribute("skip_misclass").value(); !wrong.empty()) {
    out.system += "_misclass_" + std::string(wrong);
  }
  return out;
}

void add_readings_and_meanings(const pugi::xml_node& part, kanji::DictionaryEntry& entry) {
  std::vector<kanji::Meaning> other_languages;
  for (const pugi::xml_node& group : part.children("rmgroup")) {
    for (const pugi::xml_node& reading : group.children("reading")) {
      const std::string_view type = reading.attribute("r_type").value();
      if (type == "ja_on") entry.on_readings.emplace_back(reading.text().get());
      if (type == "ja_kun") entry.kun_readings.emplace_back(reading.text().get());
    }
    for (const pugi::xml_node& meaning : group.children("meaning")) {
      const std::string_view language = meaning.attribute("m_lang").value();
      if (language.empty() || language == "en") {
        entry.meanings.push_back({"en", meaning.text().get()});
      } else {
        other_languages.push_back({std::string(language), meaning.text().get()});
      }
    }
  }
  for (kanji::Meaning& meaning : other_languages) entry.meanings.push_back(std::move(meaning));
  for (const pugi::xml_node& name : part.children("nanori")) entry.nanori.emplace_back(name.text().get());
}

kanji::DictionaryEntry entry_of(const pugi::xml_node& character) {
  kanji::DictionaryEntry entry;
  const pugi::xml_node misc = character.child("misc");
  entry.grade = number_in(misc.child("grade"));
  entry.frequency = number_in(misc.child("freq"));
  entry.old_jlpt_level = number_in(misc.child("jlpt"));
  for (const pugi::xml_node& count : misc.children("stroke_count")) {
    entry.stroke_counts.push_back(count.text().as_int());
  }
  for (const pugi::xml_node& value : character.child("radical").children("rad_value")) {
    const std::string_view type = value.attribute("rad_type").value();
    if (type == "classical") entry.radical = value.text().as_int();
    if (type == "nelson_c") entry.codes.push_back({"radical_nelson_c", value.text().get()});
  }
  for (const pugi::xml_node& code : character.child("codepoint").children("cp_value")) {
    if (std::string_view(code.attribute("cp_type").value()) != "ucs") {
      entry.codes.push_back(code_of(code, "cp_type"));
    }
  }
  for (const pugi::xml_node& code : character.child("query_code").children("q_code")) {
    entry.codes.push_back(code_of(code, "qc_type"));
  }
  for (const pugi::xml_node& code : character.child("dic_number").children("dic_ref")) {
    entry.codes.push_back(code_of(code, "dr_type"));
  }
  add_readings_and_meanings(character.child("reading_meaning"), entry);
  return entry;
}

}  // namespace

base::Result<Kanjidic2> parse_kanjidic2(std::string xml) {
  pugi::xml_document document;
  const auto status =
      document.load_buffer_inplace(xml.data(), xml.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!status) {
    return base::fail(base::Errc::parse, std::string("is not XML: ") + status.description() + " at byte " +
                                             std::to_string(status.offset));
  }
  const pugi::xml_node root = document.child("kanjidic2");
  Kanjidic2 out;
  out.version = root.child("header").child("date_of_creation").text().get();
  for (const pugi::xml_node& character : root.children("character")) {
    const std::string_view literal = character.child("literal").text().get();
    const auto decoded = base::decode_utf8(literal);
    if (!decoded || decoded->size() != 1) {
      return base::fail(base::Errc::parse,
                        "a literal is not one character: \"" + std::string(literal) + "\"");
    }
    if (!out.entries.emplace(decoded->front(), entry_of(character)).second) {
      return base::fail(base::Errc::parse, "describes " + std::string(literal) + " twice");
    }
  }
  if (out.entries.empty()) return base::fail(base::Errc::parse, "has no characters");
  return out;
}

}  // namespace nazori::ingest
