// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/confusables.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <string_view>
#include <utility>

#include "nazori/base/assignment.h"
#include "nazori/base/utf8.h"
#include "nazori/geometry/point.h"
#include "nazori/kanji/kana.h"
#include "nazori/practice/helpful_words.h"
#include "nazori/writing/lookalikes.h"

namespace nazori::practice {
namespace {

constexpr double kDiffers = 7;   ///< glyph units between points of two strokes that are not the same
constexpr double kNearby = 3.5;  ///< closer strokes are the same even if one is longer
constexpr double kLonger = 1.25;
constexpr double kNoCounterpart = 60;
constexpr std::size_t kSamples = 9;
constexpr std::size_t kQuestionsPerCharacter = 3;
constexpr std::string_view kGap = "◯";

using Points = std::vector<geometry::GlyphPoint>;

/// Points at equal distances along a line.
Points sampled(const Points& line) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < line.size(); ++i)
    lengths.push_back(lengths.back() + std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y));
  Points out;
  std::size_t piece = 0;
  for (std::size_t i = 0; i < kSamples && !line.empty(); ++i) {
    const double at = lengths.back() * static_cast<double>(i) / (kSamples - 1);
    while (piece + 2 < line.size() && lengths[piece + 1] < at) ++piece;
    if (line.size() == 1) {
      out.push_back(line[0]);
      continue;
    }
    const double length = lengths[piece + 1] - lengths[piece];
    const double share = length > 0 ? std::clamp((at - lengths[piece]) / length, 0.0, 1.0) : 0;
    out.push_back({line[piece].x + share * (line[piece + 1].x - line[piece].x),
                   line[piece].y + share * (line[piece + 1].y - line[piece].y)});
  }
  return out;
}

double distance(const Points& a, const Points& b) {
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    sum += std::hypot(a[i].x - b[i].x, a[i].y - b[i].y);
  return a.empty() || b.empty() ? kNoCounterpart : sum / static_cast<double>(kSamples);
}

double length(const Points& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return sum;
}

/// Whether two strokes that are each other's counterparts are not the same: elsewhere, or clearly longer.
bool differs(const Points& a, const Points& b, double apart) {
  const auto [shorter, longer] = std::minmax({length(a), length(b)});
  return apart > kDiffers || (apart > kNearby && longer > kLonger * shorter);
}

std::vector<Points> sampled_strokes(const kanji::Character& character) {
  std::vector<Points> out;
  for (const auto& stroke : character.strokes) out.push_back(sampled(stroke.line.points));
  return out;
}

std::string with_gap(std::string word, const std::string& character, std::string_view gap) {
  for (auto at = word.find(character); at != std::string::npos; at = word.find(character, at + gap.size()))
    word.replace(at, character.size(), gap);
  return word;
}

}  // namespace

std::vector<char32_t> confusables_of(const kanji::KanjiDatabase& database, char32_t character,
                                     std::size_t most) {
  std::vector<char32_t> found = confusables_in_table(character);
  const bool is_kanji = kanji::script_of(character) == kanji::Script::other;
  for (const char32_t other : writing::lookalikes_of(character)) {
    // A rare kanji that nobody meets helps nobody; a kana's lookalikes are in the table.
    const auto summary = database.summary(other);
    if (is_kanji && summary && summary->grade && std::find(found.begin(), found.end(), other) == found.end())
      found.push_back(other);
  }
  // Kanji outside the lists of school and names are no help either, unless one of them is asked for.
  const auto own = database.summary(character);
  const bool is_taught = own && own->grade;
  std::erase_if(found, [&](char32_t one) {
    const auto other = database.summary(one);
    return !database.draws(one) || (is_taught && is_kanji && !(other && other->grade));
  });
  if (found.size() > most) found.resize(most);
  return found;
}

StrokeContrast contrast_of(const kanji::Character& first, const kanji::Character& second) {
  const auto a = sampled_strokes(first);
  const auto b = sampled_strokes(second);
  const std::size_t size = std::max(a.size(), b.size());
  std::vector<double> costs(size * size, kNoCounterpart);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      costs[i * size + j] = std::min(distance(a[i], b[j]), kNoCounterpart);
  StrokeContrast out{std::vector<bool>(a.size(), true), std::vector<bool>(b.size(), true)};
  const auto counterpart = base::cheapest_assignment(std::span<const double>(costs), size);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t j = counterpart[i];
    if (j >= b.size() || differs(a[i], b[j], costs[i * size + j])) continue;
    out.first[i] = false;
    out.second[j] = false;
  }
  return out;
}

ConfusableFacts confusable_facts(const kanji::KanjiDatabase& database, char32_t character) {
  ConfusableFacts facts;
  facts.character = character;
  if (const auto found = database.find(character)) {
    for (const auto& meaning : found->entry.meanings)
      if (facts.meaning.empty() && meaning.language == "en") facts.meaning = meaning.text;
    const auto& kun = found->entry.kun_readings;
    const auto& on = found->entry.on_readings;
    facts.reading = !kun.empty() ? kun.front() : !on.empty() ? on.front() : std::string();
    for (auto& word : choose_words(words_that_help(database, *found).words, character, {}))
      facts.words.push_back(std::move(word.word));
  }
  return facts;
}

ConfusableDrill::ConfusableDrill(const std::vector<ConfusableFacts>& characters, unsigned seed) {
  for (const auto& facts : characters) {
    const std::string own = base::encode_utf8(facts.character);
    std::size_t made = 0;
    for (const auto& word : facts.words) {
      if (made == kQuestionsPerCharacter - 1) break;
      const bool has_other = std::any_of(characters.begin(), characters.end(), [&](const auto& other) {
        return other.character != facts.character &&
               word.text.find(base::encode_utf8(other.character)) != std::string::npos;
      });
      // The word must leave something to read beside the gap, and not give the choice away.
      if (has_other || word.text == own || word.text.find(own) == std::string::npos) continue;
      questions_.push_back(
          {facts.character, facts.meaning, facts.reading, with_gap(word.text, own, kGap), word.reading});
      ++made;
    }
    while (made++ < kQuestionsPerCharacter)
      questions_.push_back({facts.character, facts.meaning, facts.reading, {}, {}});
  }
  std::mt19937 random(seed);
  // std::shuffle may differ between libraries; this order is the same everywhere.
  for (std::size_t i = questions_.size(); i > 1; --i) std::swap(questions_[i - 1], questions_[random() % i]);
  first_round_ = questions_.size();
}

const ConfusableQuestion* ConfusableDrill::question() const {
  return at_ < questions_.size() ? &questions_[at_] : nullptr;
}

bool ConfusableDrill::answer(char32_t character) {
  if (at_ >= questions_.size()) return false;
  const ConfusableQuestion asked = questions_[at_];
  const bool is_right = asked.answer == character;
  ++asked_;
  if (is_right) ++right_;
  if (!is_right && at_ < first_round_) questions_.push_back(asked);
  ++at_;
  return is_right;
}

}  // namespace nazori::practice
