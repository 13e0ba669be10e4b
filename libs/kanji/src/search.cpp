// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "kanji_database_inside.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/meaning_text.h"
#include "nazori/kanji/romaji.h"
#include "search_text.h"

namespace nazori::kanji {
namespace {

/// How well an answer matches, best first.
enum Tier : std::uint8_t { itself, whole, part, name, beginning, none };

/// The best fit of a character, and by which key it was found.
struct Fit {
  Tier tier = Tier::none;
  Reason reason = Reason::condition;
  std::string key;
};

/// The best fits of all characters, by place.
class Fits {
 public:
  explicit Fits(std::size_t characters) : fits_(characters) {}
  void offer(std::size_t place, Tier tier, Reason reason, std::string_view key) {
    if (place >= fits_.size() || tier >= fits_[place].tier) return;
    fits_[place] = {tier, reason, std::string(key)};
  }
  [[nodiscard]] const Fit& at(std::size_t place) const { return fits_[place]; }
  /// Ranks from the best tier to the worst, each tier with the commonest first.
  [[nodiscard]] std::vector<std::size_t> ordered() const {
    std::array<std::vector<std::size_t>, Tier::none> tiers;
    for (std::size_t place = 0; place < fits_.size(); ++place) {
      if (fits_[place].tier < Tier::none) tiers[fits_[place].tier].push_back(place);
    }
    std::vector<std::size_t> out;
    for (const auto& places : tiers) out.insert(out.end(), places.begin(), places.end());
    return out;
  }

 private:
  std::vector<Fit> fits_;
};

Tier tier_of(int fit) {
  switch (static_cast<KeyFit>(fit)) {
    case KeyFit::whole:
      return Tier::whole;
    case KeyFit::part:
      return Tier::part;
    case KeyFit::name:
      return Tier::name;
  }
  return Tier::beginning;
}

/// @param best  of what is still being typed, everything is only a beginning.
void offer_readings(SQLite::Statement& keys, std::string_view reading, Fits& fits, Tier best = Tier::itself) {
  if (reading.empty()) return;
  Rewound row(keys);
  row->bind(1, std::string(reading));
  row->bind(2, after_all_that_begin_with(reading));
  while (row->executeStep()) {
    const std::string_view key = row->getColumn(0).getText();
    const Tier tier = key.size() == reading.size() ? tier_of(row.number(2)) : Tier::beginning;
    const Reason reason = static_cast<KeyFit>(row.number(2)) == KeyFit::name ? Reason::name : Reason::reading;
    fits.offer(static_cast<std::size_t>(row.number(1)), std::max(tier, best), reason, key);
  }
}

void offer_meanings(SQLite::Statement& keys, std::string_view phrase, Fits& fits) {
  if (phrase.empty()) return;
  Rewound row(keys);
  row->bind(1, std::string(phrase));
  row->bind(2, after_all_that_begin_with(phrase));
  while (row->executeStep()) {
    const std::string_view key = row->getColumn(0).getText();
    Tier tier = Tier::beginning;
    if (key.size() == phrase.size()) {
      tier = tier_of(row.number(2));
    } else if (key[phrase.size()] == ' ') {
      tier = Tier::name;
    }
    fits.offer(static_cast<std::size_t>(row.number(1)), tier, Reason::meaning, key);
  }
}

/// Whether an own character is somebody's form of a character: that is its only part.
bool is_form_of(const Character& own, char32_t character) {
  const auto& parts = own.components.children;
  return parts.size() == 1 && parts.front().strokes.size() == own.strokes.size() &&
         parts.front().element == base::encode_utf8(character);
}

/// "2429.0" for "24290".
std::string with_dot(std::string code) {
  constexpr std::size_t kDigits = 4;
  if (code.size() > kDigits && code[kDigits] != '.') code.insert(code.begin() + kDigits, '.');
  return code;
}

}  // namespace

/// The characters that meet the conditions other than the text.
class KanjiDatabase::Inside::Conditions {
 public:
  Conditions(Inside& database, const Query& query) : database_(database), query_(query) {
    if (!query.skip.empty()) {
      // A part of a code that is not its last is complete: 1-2 is not the beginning of 1-25-1.
      const bool is_whole = std::count(query.skip.begin(), query.skip.end(), '-') == 2;
      const bool is_open = query.skip.back() == '-';
      require_code("skip", query.skip + (is_whole || is_open ? "" : "-"), is_whole && !is_open);
    }
    if (!query.four_corner.empty()) require_code("four_corner", with_dot(query.four_corner), false);
    for (const std::string& part : query.parts) require_part(part);
    if (query.among) narrow({query.among->begin(), query.among->end()});
    radical_ = query.radical;
    if (!query.radical_form.empty()) {
      const auto number = database.radical_of_form(query.radical_form);
      // No character has the radical 0.
      radical_ = number && (!query.radical || query.radical == number) ? *number : -1;
    }
  }

  [[nodiscard]] bool allow(std::size_t place) const {
    const RosterEntry& e = database_.roster()[place];
    const int least = query_.strokes.value_or(0);
    const int most = query_.most_strokes.value_or(least);
    const auto within = [&](int count) { return count >= least && count <= most; };
    return (!query_.drawn_only || e.drawn > 0) && (!query_.grade || e.grade == *query_.grade) &&
           (!query_.strokes || within(e.drawn) || within(e.counted)) &&
           (!radical_ || e.radical == *radical_) &&
           (!query_.old_jlpt_level || e.old_jlpt == *query_.old_jlpt_level) &&
           (!query_.frequency || (e.frequency > 0 && e.frequency <= *query_.frequency)) &&
           (!only_ || only_->contains(e.code_point));
  }

 private:
  using Set = std::unordered_set<char32_t>;
  void narrow(Set with) {
    if (only_) std::erase_if(with, [this](char32_t c) { return !only_->contains(c); });
    only_ = std::move(with);
  }
  void require_code(const char* system, const std::string& begin, bool is_whole) {
    Set found;
    Rewound row(database_.codes_of);
    row->bind(1, system);
    row->bind(2, begin);
    row->bind(3, is_whole ? begin : after_all_that_begin_with(begin));
    while (row->executeStep()) found.insert(static_cast<char32_t>(row->getColumn(0).getInt64()));
    narrow(std::move(found));
  }
  void require_part(const std::string& part) {
    Set found;
    Rewound row(database_.elements);
    row->bind(1, part);
    row->bind(2, static_cast<int>(database_.roster().size()));
    while (row->executeStep()) {
      const auto place = static_cast<std::size_t>(row.number(0));
      if (place < database_.roster().size()) found.insert(database_.roster()[place].code_point);
    }
    if (const auto self = base::decode_utf8(part); self && self->size() == 1) found.insert(self->front());
    narrow(std::move(found));
  }

  Inside& database_;
  const Query& query_;
  std::optional<Set> only_;
  std::optional<int> radical_;
};

std::string KanjiDatabase::Inside::matching_reading(char32_t code_point, std::string_view key) {
  Rewound row(readings);
  row->bind(1, static_cast<std::int64_t>(code_point));
  while (row->executeStep()) {
    std::string text = row.text(1);
    if (fold_reading(text) == key || fold_reading(text.substr(0, text.find('.'))) == key) return text;
  }
  return std::string(key);
}

std::string KanjiDatabase::Inside::matching_meaning(char32_t code_point, std::string_view key) {
  Rewound row(meanings);
  row->bind(1, static_cast<std::int64_t>(code_point));
  while (row->executeStep()) {
    if (row.text(0) != "en") continue;
    std::string text = row.text(1);
    const std::string folded = fold_meaning(text);
    if (folded == key || (folded.ends_with(key) && folded[folded.size() - key.size() - 1] == ' '))
      return text;
  }
  return std::string(key);
}

std::vector<Match> KanjiDatabase::Inside::find_matches(const Query& query, bool explained) {
  if (!base::decode_utf8(query.text) || query.limit < 1) return {};
  const SearchText text = search_text_of(query.text);
  const Conditions conditions(*this, query);
  Fits fits(roster().size());
  std::vector<std::size_t> places;
  if (text.narrow.empty()) {
    for (std::size_t place = 0; place < roster().size(); ++place) places.push_back(place);
  } else if (!text.is_kana && !text.is_latin) {
    // Kana between kanji are okurigana: 休み finds 休.
    for (const char32_t c : text.narrow) {
      const auto place = is_searched_kana(c) ? std::nullopt : place_of(c);
      if (!place || std::find(places.begin(), places.end(), *place) != places.end()) continue;
      fits.offer(*place, Tier::itself, Reason::itself, {});
      places.push_back(*place);
      for (std::size_t i = 0; i < own.size(); ++i) {
        if (!is_form_of(own[i], c)) continue;
        fits.offer(first_own() + i, Tier::itself, Reason::itself, {});
        places.push_back(first_own() + i);
      }
    }
  } else {
    if (text.narrow.size() == 1) {
      const auto exactly = place_of(text.typed[0]);
      const auto place = exactly ? exactly : place_of(text.narrow[0]);
      if (place) fits.offer(*place, Tier::itself, Reason::itself, {});
    }
    const std::string spelled = base::encode_utf8(std::u32string_view(text.narrow));
    if (text.is_kana) {
      offer_readings(reading_keys, fold_reading(spelled), fits);
    } else {
      const auto complete = romaji_to_hiragana(spelled);
      for (const std::string& reading : complete) offer_readings(reading_keys, reading, fits);
      for (const std::string& start : romaji_beginnings(spelled)) {
        if (std::find(complete.begin(), complete.end(), start) != complete.end()) continue;
        offer_readings(reading_keys, start, fits, Tier::beginning);
      }
      offer_meanings(meaning_keys, fold_meaning(spelled), fits);
    }
    places = fits.ordered();
  }

  std::vector<Match> out;
  for (const std::size_t place : places) {
    if (!conditions.allow(place)) continue;
    const Fit& fit = fits.at(place);
    Match match{summary(place), fit.reason, {}, fit.tier <= Tier::part};
    if (explained) {
      const char32_t code_point = match.summary.code_point;
      if (fit.reason == Reason::reading || fit.reason == Reason::name)
        match.text = matching_reading(code_point, fit.key);
      if (fit.reason == Reason::meaning) match.text = matching_meaning(code_point, fit.key);
    }
    out.push_back(std::move(match));
    if (out.size() == static_cast<std::size_t>(query.limit)) break;
  }
  return out;
}

std::vector<Match> KanjiDatabase::matches(const Query& query) const {
  return inside_->answer_or<std::vector<Match>>({}, [&] { return inside_->find_matches(query, true); });
}

std::vector<Summary> KanjiDatabase::search(const Query& query) const {
  return inside_->answer_or<std::vector<Summary>>({}, [&] {
    std::vector<Summary> out;
    for (Match& match : inside_->find_matches(query, false)) out.push_back(std::move(match.summary));
    return out;
  });
}

}  // namespace nazori::kanji
