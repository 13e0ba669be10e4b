// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/query_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "nazori/base/utf8.h"

namespace nazori::kanji {
namespace {

constexpr int kMostStrokes = 200;
constexpr int kRadicals = 214;
constexpr int kLastGrade = 10;
constexpr int kLastLevel = 4;
constexpr int kMostFrequency = 99'999;
constexpr std::size_t kFourCornerDigits = 4;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

std::optional<int> number(std::string_view text, int least, int most) {
  int value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (!is_digits(text) || read.ec != std::errc() || value < least || value > most) return std::nullopt;
  return value;
}

/// Letters, digits and signs in full width as plain ones, letters as small ones.
std::string plain(std::string_view typed) {
  auto text = base::decode_utf8(typed);
  if (!text) return std::string(typed);
  for (char32_t& c : *text) {
    if (c == U'～' || c == U'〜')
      c = U'-';
    else if (c >= 0xFF01 && c <= 0xFF5E)
      c -= 0xFEE0;
  }
  return base::encode_utf8(std::u32string_view(*text));
}

std::string lowered(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool read_strokes(std::string_view value, Query& query) {
  const std::size_t dash = value.find('-');
  const auto from = number(value.substr(0, dash), 1, kMostStrokes);
  if (!from) return false;
  std::optional<int> to;
  if (dash != std::string_view::npos) {
    to = number(value.substr(dash + 1), *from, kMostStrokes);
    if (!to) return false;
  }
  query.strokes = from;
  query.most_strokes = to;
  return true;
}

bool read_number(std::string_view value, int least, int most, std::optional<int>& into) {
  const auto read = number(value, least, most);
  if (read) into = read;
  return read.has_value();
}

bool read_radical(std::string_view value, Query& query) {
  if (is_digits(value)) return read_number(value, 1, kRadicals, query.radical);
  const auto form = base::decode_utf8(value);
  if (!form || form->size() != 1) return false;
  query.radical_form = value;
  return true;
}

bool read_parts(std::string_view value, Query& query) {
  constexpr std::u32string_view kBetween = U"+,、・";
  const auto parts = base::decode_utf8(value);
  if (!parts || parts->empty()) return false;
  for (const char32_t part : *parts)
    if (kBetween.find(part) == kBetween.npos) query.parts.push_back(base::encode_utf8(part));
  return true;
}

bool read_condition(std::string_view key, std::string_view value, TypedQuery& into) {
  Query& query = into.query;
  const auto is_one_of = [key](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  // A condition whose value is still being typed is none yet.
  if (value.empty())
    return is_one_of({"strokes", "画数", "総画", "radical", "部首",      "parts", "part", "パーツ",
                      "grade",   "学年", "jlpt", "freq",    "frequency", "頻度",  "skip", "corner",
                      "corners", "四角", "list", "リスト",  "tag",       "タグ"});
  if (is_one_of({"strokes", "画数", "総画"})) return read_strokes(value, query);
  if (is_one_of({"radical", "部首"})) return read_radical(value, query);
  if (is_one_of({"parts", "part", "パーツ"})) return read_parts(value, query);
  if (is_one_of({"grade", "学年"})) return read_number(value, 1, kLastGrade, query.grade);
  if (is_one_of({"jlpt"})) return read_number(value, 1, kLastLevel, query.old_jlpt_level);
  if (is_one_of({"freq", "frequency", "頻度"})) return read_number(value, 1, kMostFrequency, query.frequency);
  if (is_one_of({"skip"}) && is_skip(value)) {
    query.skip = value;
    return true;
  }
  if (is_one_of({"corner", "corners", "四角"}) && is_four_corner(value)) {
    query.four_corner = value;
    return true;
  }
  if (is_one_of({"list", "リスト"}) || is_one_of({"tag", "タグ"})) {
    into.lists.push_back((is_one_of({"list", "リスト"}) ? "list:" : "tag:") + std::string(value));
    return true;
  }
  return false;
}

/// Conditions without a name: 6画, 1-2-4, 2429.
bool read_bare(std::string_view word, Query& query) {
  constexpr std::string_view kStrokes = "画";
  if (word.ends_with(kStrokes)) return read_strokes(word.substr(0, word.size() - kStrokes.size()), query);
  if (std::count(word.begin(), word.end(), '-') == 2 && is_digit(word.back()) && is_skip(word)) {
    query.skip = word;
    return true;
  }
  if (std::count_if(word.begin(), word.end(), is_digit) >= static_cast<int>(kFourCornerDigits) &&
      is_four_corner(word)) {
    query.four_corner = word;
    return true;
  }
  return false;
}

/// The words of a line; blanks between quotation marks belong to a word.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words(1);
  bool is_quoted = false;
  constexpr std::string_view kWideBlank = "　";
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_wide = line.substr(i).starts_with(kWideBlank);
    if (line[i] == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && (line[i] == ' ' || line[i] == '\t' || is_wide)) {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += line[i];
    }
    if (is_wide && !is_quoted) i += kWideBlank.size() - 1;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

}  // namespace

bool is_skip(std::string_view text) {
  const std::size_t first = text.find('-');
  if (!number(text.substr(0, first), 1, 4)) return false;
  if (first == std::string_view::npos) return true;
  std::string_view rest = text.substr(first + 1);
  const std::size_t second = rest.find('-');
  const auto is_part = [](std::string_view part) { return number(part, 1, kMostStrokes).has_value(); };
  if (second == std::string_view::npos) return rest.empty() || is_part(rest);
  const std::string_view last = rest.substr(second + 1);
  return is_part(rest.substr(0, second)) && (last.empty() || is_part(last));
}

bool is_four_corner(std::string_view text) {
  const std::size_t dot = text.find('.');
  const std::string_view digits = text.substr(0, dot);
  if (dot == std::string_view::npos) return is_digits(digits) && digits.size() <= kFourCornerDigits + 1;
  const std::string_view last = text.substr(dot + 1);
  return is_digits(digits) && digits.size() == kFourCornerDigits &&
         (last.empty() || (last.size() == 1 && is_digits(last)));
}

std::string with_condition(std::string_view typed, std::string_view key, std::string_view value) {
  std::string out;
  const auto add = [&out](const std::string& word) {
    if (!out.empty()) out += ' ';
    out += word.find_first_of(" \t") == std::string::npos ? word : '"' + word + '"';
  };
  for (const std::string& word : words_of(typed)) {
    const std::string text = plain(word);
    const std::size_t colon = text.find(':');
    const bool is_replaced = colon != std::string::npos && lowered(text.substr(0, colon)) == key;
    if (!is_replaced) add(word);
  }
  if (!value.empty()) add(std::string(key) + ":" + std::string(value));
  return out;
}

TypedQuery read_query(std::string_view typed) {
  TypedQuery out;
  for (const std::string& word : words_of(typed)) {
    const std::string text = plain(word);
    const std::size_t colon = text.find(':');
    const bool is_condition =
        colon == std::string::npos
            ? read_bare(text, out.query)
            : read_condition(lowered(text.substr(0, colon)), std::string_view(text).substr(colon + 1), out);
    if (is_condition) continue;
    if (!out.query.text.empty()) out.query.text += ' ';
    out.query.text += word;
  }
  return out;
}

}  // namespace nazori::kanji
