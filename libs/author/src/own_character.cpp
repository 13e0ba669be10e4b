// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/own_character.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/own_characters.h"

namespace nazori::author {
namespace {

using base::Errc;

constexpr int kRadicals = 214;

base::Result<void> refuse(std::string what, std::string where, std::string remedy = {}) {
  return base::fail(Errc::bad_argument, std::move(what), std::move(where), std::move(remedy));
}

base::Result<void> check_text(const std::string& text, std::size_t longest, const std::string& where) {
  if (text.size() > longest)
    return refuse("is too long", where, "give at most " + std::to_string(longest) + " bytes");
  const auto letters = base::decode_utf8(text);
  if (!letters) return refuse("is not UTF-8", where);
  const bool has_control =
      std::ranges::any_of(*letters, [](char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); });
  if (has_control) return refuse("has a control character", where, "give one line of text");
  return {};
}

base::Result<void> check_texts(const std::vector<std::string>& texts, const std::string& name) {
  if (texts.size() > kMostTexts)
    return refuse("there are too many", name + "s", "give at most " + std::to_string(kMostTexts));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string where = name + " " + std::to_string(i + 1);
    if (texts[i].empty()) return refuse("is empty", where);
    if (auto fit = check_text(texts[i], kLongestText, where); !fit) return fit;
  }
  return {};
}

/// Whether Unicode could have a character there that a database knows.
bool is_publishable(char32_t c) {
  const bool is_control = c <= 0x20 || (c >= 0x7F && c < 0xA0);
  const bool is_surrogate = c >= 0xD800 && c < 0xE000;
  return !is_control && !is_surrogate && c <= 0x10FFFF && !kanji::is_own(c);
}

/// Whether a point is in the picture or not farther from it than its side. @source KanjiVG's reader.
bool is_near(geometry::GlyphPoint p) {
  const auto fits = [](double v) { return v >= -geometry::kGlyphSide && v <= 2 * geometry::kGlyphSide; };
  return fits(p.x) && fits(p.y);
}

void add_parts(const kanji::Component& component, std::vector<OwnPart>& parts) {
  for (const kanji::Component& child : component.children) {
    if (!child.element.empty() && !child.strokes.empty()) {
      // An element that is written in several pieces is one part.
      const auto same = std::ranges::find_if(parts, [&child](const OwnPart& part) {
        return child.part.value_or(1) > 1 && part.name == child.element;
      });
      if (same != parts.end()) {
        same->strokes.insert(same->strokes.end(), child.strokes.begin(), child.strokes.end());
        std::ranges::sort(same->strokes);
        same->strokes.erase(std::unique(same->strokes.begin(), same->strokes.end()), same->strokes.end());
      } else if (parts.size() < kMostTexts) {
        parts.push_back({child.element, child.strokes});
      }
    }
    add_parts(child, parts);
  }
}

}  // namespace

Rights kanjivg_rights() {
  return {std::string(kKanjiVgLicence), std::string(kKanjiVgAuthor), std::string(kKanjiVgSource)};
}

base::Result<void> validate(const Facts& facts, std::size_t strokes) {
  if (auto fit = check_text(facts.name, kLongestName, "name"); !fit) return fit;
  if (auto fit = check_texts(facts.readings, "reading"); !fit) return fit;
  if (auto fit = check_texts(facts.meanings, "meaning"); !fit) return fit;
  if (facts.parts.size() > kMostTexts)
    return refuse("there are too many", "parts", "give at most " + std::to_string(kMostTexts));
  for (std::size_t i = 0; i < facts.parts.size(); ++i) {
    const OwnPart& part = facts.parts[i];
    const std::string where = "part " + std::to_string(i + 1);
    if (auto fit = check_text(part.name, kLongestName, where); !fit) return fit;
    for (std::size_t k = 0; k < part.strokes.size(); ++k) {
      const int stroke = part.strokes[k];
      if (stroke < 0 || static_cast<std::size_t>(stroke) >= strokes)
        return refuse("names a stroke that is not there", where);
      if (k > 0 && stroke <= part.strokes[k - 1]) return refuse("its strokes are not in order", where);
    }
  }
  if (facts.radical && (*facts.radical < 1 || *facts.radical > kRadicals))
    return refuse("is not one of the classical ones", "radical", "give 1 to 214");
  if (facts.instead_of && !is_publishable(*facts.instead_of))
    return refuse("is no character that could be published", "instead_of", "give one letter, such as 永");
  if (auto fit = check_text(facts.rights.licence, kLongestText, "licence"); !fit) return fit;
  if (auto fit = check_text(facts.rights.author, kLongestText, "author"); !fit) return fit;
  return check_text(facts.rights.source, kLongestText, "source");
}

base::Result<void> validate(const std::vector<OwnStroke>& strokes) {
  if (strokes.size() > kMostStrokes)
    return refuse("there are too many", "strokes", "give at most " + std::to_string(kMostStrokes));
  std::size_t all = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const OwnStroke& stroke = strokes[i];
    const std::string where = "stroke " + std::to_string(i + 1);
    if (stroke.points.empty()) return refuse("has no points", where);
    if (stroke.points.size() > kMostPoints)
      return refuse("has too many points", where, "give at most " + std::to_string(kMostPoints));
    all += stroke.points.size();
    for (std::size_t k = 0; k < stroke.points.size(); ++k) {
      const GroovePoint& p = stroke.points[k];
      const std::string point = where + ", point " + std::to_string(k + 1);
      if (!is_near(p.at)) return refuse("is too far from the picture", point, "give -109 to 218");
      if (!(p.half_width >= 0 && p.half_width <= carving::kWidestHalf))
        return refuse("its half width is out of range", point, "give 0 to 20 glyph units");
      if (!(p.depth >= 0 && p.depth <= 1)) return refuse("its depth is out of range", point, "give 0 to 1");
    }
    if (stroke.ending > kanji::StrokeEnding::either) return refuse("has no ending that is known", where);
    if (stroke.number_position && !is_near(*stroke.number_position))
      return refuse("its number is too far from the picture", where, "give -109 to 218");
  }
  if (all > kMostPointsInAll)
    return refuse("have too many points", "strokes", "give at most " + std::to_string(kMostPointsInAll));
  return {};
}

base::Result<void> validate(const OwnCharacter& character) {
  if (auto fit = validate(character.strokes); !fit) return fit;
  if (auto fit = validate(character.facts, character.strokes.size()); !fit) return fit;
  const HandLayer& hand = character.hand;
  const bool fits = hand.size == 0 ||
                    (hand.size >= surface::HeightMap::kMinSize && hand.size <= surface::HeightMap::kMaxSize);
  const auto side = static_cast<std::size_t>(std::max(hand.size, 0));
  if (!fits || hand.heights.size() != side * side) return refuse("has another number of samples", "hand");
  if (!std::ranges::all_of(hand.heights, [](float h) { return h >= -1 && h <= 1; }))
    return refuse("has a height that is out of range", "hand", "give -1 to 1");
  return {};
}

std::vector<OwnStroke> own_strokes(const std::vector<kanji::StrokeLine>& lines, const carving::Brush& brush) {
  const carving::Brush used = carving::fitted(brush, lines);
  std::vector<OwnStroke> strokes;
  strokes.reserve(lines.size());
  for (const kanji::StrokeLine& line : lines)
    strokes.push_back({carving::groove_of(line, used), line.ending, line.number_position});
  return strokes;
}

OwnCharacter copy_of(const kanji::Character& character, const carving::Brush& brush) {
  OwnCharacter copy;
  copy.strokes = own_strokes(character.lines(), brush);
  Facts& facts = copy.facts;
  facts.name = base::encode_utf8(character.code_point);
  const auto fits = [](const std::vector<std::string>& list, const std::string& text) {
    return list.size() < kMostTexts && !text.empty() && text.size() <= kLongestText;
  };
  for (const auto* list : {&character.entry.on_readings, &character.entry.kun_readings}) {
    for (const std::string& reading : *list)
      if (fits(facts.readings, reading)) facts.readings.push_back(reading);
  }
  for (const kanji::Meaning& meaning : character.entry.meanings)
    if (meaning.language == "en" && fits(facts.meanings, meaning.text))
      facts.meanings.push_back(meaning.text);
  add_parts(character.components, facts.parts);
  facts.radical = character.entry.radical;
  facts.rights = kanjivg_rights();
  return copy;
}

OwnCharacter from_height_map(const surface::HeightMap& map) {
  assert(map.is_loaded());
  OwnCharacter character;
  character.hand.size = map.size();
  character.hand.heights.reserve(map.samples().size());
  for (const float height : map.samples()) character.hand.heights.push_back(height - 1.0F);
  return character;
}

OwnCharacter from_strokes(std::vector<OwnStroke> strokes) {
  OwnCharacter character;
  character.strokes = std::move(strokes);
  return character;
}

}  // namespace nazori::author
