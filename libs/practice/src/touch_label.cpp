// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "nazori/kanji/character_name.h"
#include "nazori/model/kana_braille.h"
#include "nazori/practice/touch_file.h"

namespace nazori::practice {
namespace {

using Cells = std::vector<model::BrailleCell>;

constexpr std::size_t kMostMeanings = 40;  // cells: one line
constexpr std::size_t kMostReadings = 80;

/// Texts with two blanks between them, as many as there are cells for.
Cells joined(Cells line, std::span<const Cells> parts, std::size_t most) {
  for (const Cells& part : parts) {
    if (part.empty() || line.size() + 2 + part.size() > most) continue;
    if (!line.empty()) line.insert(line.end(), 2, model::BrailleCell{0});
    line.insert(line.end(), part.begin(), part.end());
  }
  return line;
}

Cells count_of(std::size_t strokes) {
  return model::kana_braille(std::to_string(strokes) + "かく").value_or(Cells());
}

}  // namespace

TouchLabel touch_label(const std::string& name, std::size_t strokes) {
  TouchLabel label;
  if (auto kana = model::kana_braille(name); kana && !kana->empty())
    label.lines.push_back(*std::move(kana));
  else
    label.meanings.push_back(name);
  if (strokes > 0) label.lines.push_back(count_of(strokes));
  return label;
}

TouchLabel touch_label(const kanji::Character& character) {
  TouchLabel label;
  for (const kanji::Meaning& meaning : character.entry.meanings)
    if (meaning.language == "en") label.meanings.push_back(meaning.text);
  // A kana is its own name.
  if (auto name = model::kana_braille(kanji::name_of(character).text()); name && !name->empty())
    label.lines.push_back(*std::move(name));
  label.lines.push_back(count_of(character.strokes.size()));
  const auto add_readings = [&label](const char* kind, const std::vector<std::string>& readings) {
    std::vector<Cells> parts;
    for (const std::string& reading : readings) {
      Cells cells = model::reading_braille(reading).value_or(Cells());
      if (std::find(parts.begin(), parts.end(), cells) == parts.end()) parts.push_back(std::move(cells));
    }
    const Cells name = model::kana_braille(kind).value_or(Cells());
    Cells line = joined(name, parts, kMostReadings);
    if (line.size() > name.size()) label.lines.push_back(std::move(line));
  };
  add_readings("おん", character.entry.on_readings);
  add_readings("くん", character.entry.kun_readings);
  return label;
}

base::Result<std::vector<Cells>> braille_lines(const TouchLabel& label, model::EnglishBraille english) {
  std::vector<Cells> meanings;
  for (const std::string& meaning : label.meanings) {
    auto cells = model::english_braille(meaning, english);
    if (!cells) return tl::unexpected(std::move(cells.error()));
    if (*cells) meanings.push_back(**std::move(cells));
  }
  std::vector<Cells> lines;
  if (Cells line = joined({}, meanings, kMostMeanings); !line.empty()) lines.push_back(std::move(line));
  lines.insert(lines.end(), label.lines.begin(), label.lines.end());
  return lines;
}

}  // namespace nazori::practice
