// SPDX-License-Identifier: Apache-2.0
#include "stroke_endings.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/geometry/polyline.h"
#include "tables.h"

namespace nazori::ingest {
namespace {

using kanji::StrokeEnding;
using Line = geometry::Polyline<geometry::GlyphFrame>;

StrokeEnding ending_named(std::string_view name) {
  if (name == "hook" || name == "h") return StrokeEnding::hook;
  if (name == "taper" || name == "t") return StrokeEnding::taper;
  if (name == "either" || name == "e") return StrokeEnding::either;
  assert(name == "stop" || name == "s");
  return StrokeEnding::stop;
}

std::u32string decoded(std::string_view text) { return base::decode_utf8(text).value_or(std::u32string()); }

/// Whether one of the groups around stroke `index`, from the root on, is `element`.
bool is_inside(const kanji::Component& group, int index, std::string_view element) {
  if (!std::binary_search(group.strokes.begin(), group.strokes.end(), index)) return false;
  if (group.element == element || group.original == element) return true;
  return std::any_of(group.children.begin(), group.children.end(),
                     [&](const kanji::Component& child) { return is_inside(child, index, element); });
}

/// A kana is written like its large or voiceless form, then the marks.
struct KanaForm {
  char32_t plain;
  std::size_t marks;  ///< strokes of the voicing mark
};
KanaForm plain_form(char32_t c) {
  constexpr std::u32string_view kVoiced =
      U"がぎぐげござじずぜぞだぢづでどばびぶべぼガギグゲゴザジズゼゾダヂヅデドバビブベボ";
  constexpr std::u32string_view kHalfVoiced = U"ぱぴぷぺぽパピプペポ";
  constexpr std::u32string_view kSmall = U"ぁぃぅぇぉっゃゅょゎァィゥェォッャュョヮ";
  if (kVoiced.find(c) != std::u32string_view::npos) return {c - 1, 2};
  if (kHalfVoiced.find(c) != std::u32string_view::npos) return {c - 2, 1};
  if (kSmall.find(c) != std::u32string_view::npos) return {c + 1, 0};
  switch (c) {
    case U'ゔ':
      return {U'う', 2};
    case U'ヴ':
      return {U'ウ', 2};
    case U'ヷ':
      return {U'ワ', 2};
    case U'ヸ':
      return {U'ヰ', 2};
    case U'ヹ':
      return {U'ヱ', 2};
    case U'ヺ':
      return {U'ヲ', 2};
    case U'ゕ':
      return {U'か', 0};
    case U'ゖ':
      return {U'け', 0};
    case U'ヵ':
      return {U'カ', 0};
    case U'ヶ':
      return {U'ケ', 0};
    default:
      return {c, 0};
  }
}

}  // namespace

bool ends_in_a_hook(const Line& line) {
  if (line.size() < 2) return false;
  const std::span<const geometry::GlyphPoint> points(line);
  const double whole = geometry::arc_length(points);
  const double reach = std::min(20.0, 0.5 * whole);
  constexpr double kTip = 1.5;
  const auto tip = line.back() - geometry::point_at(points, whole - std::min(kTip, reach / 2));
  constexpr double kStep = 0.5;
  for (int i = 0; kTip + i * kStep < reach; ++i) {
    const double before = kTip + i * kStep;
    const auto along =
        geometry::point_at(points, whole - before) - geometry::point_at(points, whole - before - 1);
    const double size = geometry::length(tip) * geometry::length(along);
    if (size > 0 && geometry::dot(tip, along) < size * std::cos(std::numbers::pi / 3)) return true;
  }
  return false;
}

StrokeEndings::StrokeEndings() {
  for (const auto& row : table_rows(stroke_endings_table())) {
    assert(row.size() == 4);
    Rule rule;
    rule.ending = ending_named(row[2]);
    for (const std::string_view condition : split(row[1], ' ')) {
      const std::string_view value = condition.substr(std::min(condition.find(':') + 1, condition.size()));
      if (condition.starts_with("in:")) {
        for (const std::string_view element : split(value, ',')) rule.in.emplace_back(element);
      } else if (condition.starts_with("char:")) {
        rule.characters = decoded(value);
      } else if (condition.starts_with("shorter:")) {
        std::from_chars(value.data(), value.data() + value.size(), rule.shorter_than);
      } else if (condition == "hooked") {
        rule.hooked = true;
      } else if (condition == "last-free") {
        rule.last_free = true;
      } else {
        assert(condition.empty());
      }
    }
    rules_[std::string(row[0])].push_back(std::move(rule));
  }
  for (const auto& row : table_rows(kana_endings_table())) {
    assert(row.size() == 2);
    auto& endings = kana_[decoded(row[0]).at(0)];
    for (std::size_t i = 0; i < row[1].size(); ++i) endings.push_back(ending_named(row[1].substr(i, 1)));
  }
}

bool StrokeEndings::fits(const Rule& rule, const DrawnForm& form, std::size_t stroke) const {
  const Line& line = form.strokes[stroke].line.points;
  if (!rule.characters.empty() && rule.characters.find(form.code_point) == std::u32string::npos) return false;
  if (rule.shorter_than > 0 &&
      geometry::arc_length(std::span<const geometry::GlyphPoint>(line)) >= rule.shorter_than) {
    return false;
  }
  if (rule.hooked && !ends_in_a_hook(line)) return false;
  if (rule.last_free) {
    if (stroke + 1 != form.strokes.size()) return false;
    for (std::size_t other = 0; other < stroke; ++other) {
      for (const geometry::GlyphPoint p : form.strokes[other].line.points) {
        if (p.y >= line.back().y) return false;
      }
    }
  }
  return rule.in.empty() || std::any_of(rule.in.begin(), rule.in.end(), [&](const std::string& element) {
           return is_inside(form.components, static_cast<int>(stroke), element);
         });
}

StrokeEnding StrokeEndings::ending_of(const DrawnForm& form, std::size_t stroke) const {
  const std::string_view type = form.strokes[stroke].type;
  // The whole type, then the part before the bar, then its bare shape.
  const std::string_view first = type.substr(0, type.find('/'));
  constexpr std::size_t kBytesOfShape = 3;
  for (const std::string_view key : {type, first, first.substr(0, kBytesOfShape)}) {
    const auto rules = rules_.find(key);
    if (rules == rules_.end()) continue;
    for (const Rule& rule : rules->second) {
      if (fits(rule, form, stroke)) return rule.ending;
    }
  }
  return StrokeEnding::stop;
}

void StrokeEndings::assign(DrawnForm& form) const {
  const auto [plain, marks] = plain_form(form.code_point);
  const auto kana = kana_.find(plain);
  if (kana != kana_.end() && form.strokes.size() == kana->second.size() + marks) {
    for (std::size_t i = 0; i < form.strokes.size(); ++i) {
      form.strokes[i].line.ending = i < kana->second.size() ? kana->second[i] : StrokeEnding::stop;
    }
    return;
  }
  for (std::size_t i = 0; i < form.strokes.size(); ++i) form.strokes[i].line.ending = ending_of(form, i);
}

}  // namespace nazori::ingest
