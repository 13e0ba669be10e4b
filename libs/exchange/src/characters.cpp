// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/characters.h"

#include "nazori/base/utf8.h"
#include "nazori/kanji/character_name.h"

namespace nazori::exchange {
namespace {

Value stroke_json(const kanji::Stroke& stroke, int number) {
  const auto& at = stroke.line.number_position;
  return {{"number", number},
          {"type", stroke.type},
          {"ending", name_of(stroke.line.ending)},
          {"path", stroke.path},
          {"number_position", at ? Value::array({at->x, at->y}) : Value(nullptr)}};
}

Value component_json(const kanji::Component& component) {
  Value strokes = Value::array();
  for (const int index : component.strokes) strokes.push_back(index + 1);
  Value children = Value::array();
  for (const kanji::Component& child : component.children) children.push_back(component_json(child));
  return {{"element", component.element},
          {"original", component.original},
          {"position", component.position},
          {"radical", component.radical},
          {"phon", component.phon},
          {"part", or_null(component.part)},
          {"number", or_null(component.number)},
          {"variant", component.variant},
          {"partial", component.partial},
          {"trad_form", component.trad_form},
          {"radical_form", component.radical_form},
          {"strokes", std::move(strokes)},
          {"children", std::move(children)}};
}

Value radical_json(const std::optional<kanji::Radical>& radical) {
  if (!radical) return nullptr;
  return {{"number", radical->number},
          {"form", radical->form},
          {"variant_forms", radical->variant_forms},
          {"japanese_names", radical->japanese_names},
          {"english_name", radical->english_name},
          {"strokes", radical->strokes}};
}

Value meanings_json(const std::vector<kanji::Meaning>& meanings) {
  Value by_language = Value::object();
  for (const kanji::Meaning& meaning : meanings) {
    Value& texts = by_language[meaning.language];
    if (texts.is_null()) texts = Value::array();
    texts.push_back(meaning.text);
  }
  return by_language;
}

}  // namespace

std::string_view name_of(kanji::StrokeEnding ending) {
  switch (ending) {
    case kanji::StrokeEnding::stop:
      return "stop";
    case kanji::StrokeEnding::hook:
      return "hook";
    case kanji::StrokeEnding::taper:
      return "taper";
    case kanji::StrokeEnding::either:
      return "either";
  }
  return "";
}

Value to_json(const kanji::Character& character, const std::optional<kanji::Radical>& radical,
              std::span<const kanji::Word> words) {
  Value strokes = Value::array();
  for (const kanji::Stroke& stroke : character.strokes) {
    strokes.push_back(stroke_json(stroke, static_cast<int>(strokes.size()) + 1));
  }
  Value orders = Value::array();
  for (const kanji::AlternativeOrder& other : character.alternative_orders) {
    orders.push_back(Value{{"order", other.order}, {"source", other.source}});
  }
  Value codes = Value::array();
  for (const kanji::Code& code : character.entry.codes) {
    codes.push_back(Value{{"system", code.system}, {"value", code.value}});
  }
  Value word_list = Value::array();
  for (const kanji::Word& word : words) {
    word_list.push_back(Value{{"text", word.text},
                              {"reading", word.reading},
                              {"glosses", word.glosses},
                              {"senses", word.senses},
                              {"parts_of_speech", word.parts_of_speech},
                              {"common", word.common}});
  }
  const kanji::DictionaryEntry& entry = character.entry;
  return {
      {"character", base::encode_utf8(character.code_point)},
      {"code_point", kanji::code_point_text(character.code_point)},
      {"variant", character.variant},
      {"own_form", character.own_form ? Value(kanji::code_point_text(*character.own_form)) : Value(nullptr)},
      {"stroke_count", character.strokes.size()},
      {"dictionary_stroke_counts", entry.stroke_counts},
      {"grade", or_null(entry.grade)},
      {"frequency", or_null(entry.frequency)},
      {"old_jlpt_level", or_null(entry.old_jlpt_level)},
      {"radical", radical_json(radical)},
      {"readings", Value{{"on", entry.on_readings}, {"kun", entry.kun_readings}, {"nanori", entry.nanori}}},
      {"meanings", meanings_json(entry.meanings)},
      {"strokes", std::move(strokes)},
      {"alternative_orders", std::move(orders)},
      {"variants", character.variants},
      {"components", component_json(character.components)},
      {"codes", std::move(codes)},
      {"words", std::move(word_list)}};
}

Value to_json(const kanji::Summary& summary) {
  return {{"character", base::encode_utf8(summary.code_point)},
          {"code_point", kanji::code_point_text(summary.code_point)},
          {"meaning", summary.meaning},
          {"reading", summary.reading},
          {"stroke_count", summary.strokes},
          {"grade", or_null(summary.grade)}};
}

}  // namespace nazori::exchange
