// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kanji_database_inside.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/meaning_text.h"
#include "nazori/kanji/romaji.h"

namespace nazori::kanji {
namespace {

/// How well an answer matches, best first.
enum Tier : std::uint8_t { itself, whole, part, name, beginning, none };

/// The best tier of each character, by place.
class Fits {
 public:
  explicit Fits(std::size_t characters) : tiers_(characters, Tier::none) {}
  void offer(std::size_t place, Tier tier) {
    if (place < tiers_.size() && tier < tiers_[place]) tiers_[place] = tier;
  }
  /// Ranks from the best tier to the worst, each tier with the commonest first.
  [[nodiscard]] std::vector<std::size_t> ordered() const {
    std::vector<std::size_t> out;
    for (int tier = Tier::itself; tier < Tier::none; ++tier) {
      for (std::size_t place = 0; place < tiers_.size(); ++place) {
        if (tiers_[place] == tier) out.push_back(place);
      }
    }
    return out;
  }

 private:
  std::vector<Tier> tiers_;
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

/// Greater than every text that begins with `key`: no text contains the byte FF.
std::string after_all_that_begin_with(std::string_view key) { return std::string(key) + "\xFF"; }

bool is_kana(char32_t c) {
  return (c >= 0x3041 && c <= 0x309F) || (c >= 0x30A0 && c <= 0x30FF) || (c >= 0xFF66 && c <= 0xFF9F);
}
bool is_latin_letter(char32_t c) { return c < 0x250 || c == U'’'; }
bool is_space(char32_t c) { return c == U' ' || c == U'　' || c == U'\t' || c == U'\n' || c == U'\r'; }

std::u32string trimmed(std::u32string text) {
  while (!text.empty() && is_space(text.back())) text.pop_back();
  text.erase(text.begin(), std::find_if(text.begin(), text.end(), [](char32_t c) { return !is_space(c); }));
  return text;
}

/// Full-width letters and digits as plain ones.
std::u32string narrowed(std::u32string text) {
  for (char32_t& c : text) {
    if (c >= 0xFF01 && c <= 0xFF5E) c -= 0xFEE0;
  }
  return text;
}

void offer_readings(SQLite::Statement& keys, std::string_view reading, Fits& fits) {
  if (reading.empty()) return;
  Rewound row(keys);
  row->bind(1, std::string(reading));
  row->bind(2, after_all_that_begin_with(reading));
  while (row->executeStep()) {
    const bool same = row->getColumn(0).size() == static_cast<int>(reading.size());
    fits.offer(static_cast<std::size_t>(row.number(1)), same ? tier_of(row.number(2)) : Tier::beginning);
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
    fits.offer(static_cast<std::size_t>(row.number(1)), tier);
  }
}

}  // namespace

std::vector<Summary> KanjiDatabase::search(const Query& query) const {
  return inside_->answer_or<std::vector<Summary>>({}, [&]() -> std::vector<Summary> {
    const auto decoded = base::decode_utf8(query.text);
    if (!decoded || query.limit < 1) return {};
    const std::u32string typed = trimmed(*decoded);
    const std::u32string text = narrowed(typed);
    const auto& roster = inside_->roster();

    const auto allowed = [&](std::size_t place) {
      const RosterEntry& e = roster[place];
      return (!query.drawn_only || e.drawn > 0) && (!query.grade || e.grade == *query.grade) &&
             (!query.strokes || e.drawn == *query.strokes || e.counted == *query.strokes) &&
             (!query.radical || e.radical == *query.radical);
    };

    std::vector<std::size_t> places;
    const bool kana = std::all_of(text.begin(), text.end(),
                                  [](char32_t c) { return is_kana(c) || c == U'.' || c == U'-'; });
    const bool latin = std::all_of(text.begin(), text.end(), is_latin_letter);
    if (text.empty()) {
      for (std::size_t place = 0; place < roster.size(); ++place) places.push_back(place);
    } else if (!kana && !latin) {
      // Kana between kanji are okurigana: 休み finds 休.
      for (const char32_t c : text) {
        const auto place = is_kana(c) ? std::nullopt : inside_->place_of(c);
        if (place && std::find(places.begin(), places.end(), *place) == places.end())
          places.push_back(*place);
      }
    } else {
      Fits fits(roster.size());
      if (text.size() == 1) {
        const auto exactly = inside_->place_of(typed[0]);
        const auto place = exactly ? exactly : inside_->place_of(text[0]);
        if (place) fits.offer(*place, Tier::itself);
      }
      const std::string spelled = base::encode_utf8(std::u32string_view(text));
      if (kana) {
        offer_readings(inside_->reading_keys, fold_reading(spelled), fits);
      } else {
        const auto complete = romaji_to_hiragana(spelled);
        for (const std::string& reading : complete) offer_readings(inside_->reading_keys, reading, fits);
        for (const std::string& start : romaji_beginnings(spelled)) {
          if (std::find(complete.begin(), complete.end(), start) != complete.end()) continue;
          // The text typed so far is only the beginning of these.
          Fits sooner(roster.size());
          offer_readings(inside_->reading_keys, start, sooner);
          for (const std::size_t place : sooner.ordered()) fits.offer(place, Tier::beginning);
        }
        offer_meanings(inside_->meaning_keys, fold_meaning(spelled), fits);
      }
      places = fits.ordered();
    }

    std::vector<Summary> out;
    for (const std::size_t place : places) {
      if (!allowed(place)) continue;
      out.push_back(inside_->summary(place));
      if (out.size() == static_cast<std::size_t>(query.limit)) break;
    }
    return out;
  });
}

}  // namespace nazori::kanji
