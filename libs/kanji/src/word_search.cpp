// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "kanji_database_inside.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/meaning_text.h"
#include "nazori/kanji/romaji.h"
#include "search_text.h"

namespace nazori::kanji {
namespace {

/// How well a word matches, best first.
enum Tier : std::uint8_t { whole, other_gloss, within_gloss, beginning };

struct Fit {
  Tier tier = Tier::beginning;
  bool by_meaning = false;
};
using Fits = std::map<std::int64_t, Fit>;

void offer(Fits& fits, std::int64_t word, Fit fit) {
  const auto [at, is_new] = fits.emplace(word, fit);
  if (!is_new && fit.tier < at->second.tier) at->second = fit;
}

/// Beginnings shorter than this many bytes begin too many words to be of use: one kana, two letters.
constexpr std::size_t kShortestKana = 6, kShortestLetters = 3;

}  // namespace

/// @param last_common  id of the last common word: only these are found by their beginning.
void KanjiDatabase::Inside::offer_words(std::string_view key, bool is_complete, std::int64_t last_common,
                                        const std::function<void(std::int64_t, bool)>& take) {
  if (key.empty()) return;
  if (is_complete) {
    Rewound row(words_of_key);
    row->bind(1, std::string(key));
    while (row->executeStep()) take(row->getColumn(0).getInt64(), true);
  }
  if (key.size() < kShortestKana) return;
  Rewound row(words_after_key);
  row->bind(1, std::string(key));
  row->bind(2, after_all_that_begin_with(key));
  row->bind(3, last_common);
  while (row->executeStep()) take(row->getColumn(0).getInt64(), false);
}

std::vector<WordMatch> KanjiDatabase::search_words(std::string_view typed, int limit) const {
  return inside_->answer_or<std::vector<WordMatch>>({}, [&] {
    std::vector<WordMatch> out;
    const SearchText text = search_text_of(typed);
    if (text.narrow.empty() || limit < 1) return out;
    const std::string spelled = base::encode_utf8(std::u32string_view(text.narrow));
    const std::int64_t last_common = inside_->last_common_word();
    Fits fits;
    const auto take = [&fits](std::int64_t word, bool is_whole) {
      offer(fits, word, {is_whole ? Tier::whole : Tier::beginning, false});
    };
    if (text.is_kana) {
      inside_->offer_words(fold_reading(spelled), true, last_common, take);
    } else if (!text.is_latin) {
      inside_->offer_words(spelled, true, last_common, take);
    } else {
      const auto complete = romaji_to_hiragana(spelled);
      for (const std::string& reading : complete) inside_->offer_words(reading, true, last_common, take);
      for (const std::string& start : romaji_beginnings(spelled)) {
        if (std::find(complete.begin(), complete.end(), start) == complete.end())
          inside_->offer_words(start, false, last_common, take);
      }
      const std::string phrase = fold_gloss(spelled);
      if (phrase.size() >= kShortestLetters) {
        Rewound row(inside_->words_of_meaning);
        row->bind(1, phrase);
        row->bind(2, after_all_that_begin_with(phrase));
        while (row->executeStep()) {
          const std::string_view key = row->getColumn(0).getText();
          Tier tier = Tier::beginning;
          if (key.size() == phrase.size()) {
            const auto fit = static_cast<KeyFit>(row.number(2));
            tier = fit == KeyFit::whole  ? Tier::whole
                   : fit == KeyFit::part ? Tier::other_gloss
                                         : Tier::within_gloss;
          } else if (key[phrase.size()] == ' ') {
            tier = Tier::within_gloss;
          }
          offer(fits, row->getColumn(1).getInt64(), {tier, true});
        }
      }
    }
    std::vector<std::pair<std::int64_t, Fit>> ordered(fits.begin(), fits.end());
    const auto count = std::min(ordered.size(), static_cast<std::size_t>(limit));
    std::partial_sort(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(count), ordered.end(),
                      [](const auto& a, const auto& b) {
                        return std::tie(a.second.tier, a.first) < std::tie(b.second.tier, b.first);
                      });
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [id, fit] = ordered[i];
      Rewound row(inside_->word);
      row->bind(1, id);
      if (row->executeStep())
        out.push_back({Inside::read_word(row), fit.by_meaning,
                       fit.tier == Tier::whole || fit.tier == Tier::other_gloss});
    }
    return out;
  });
}

}  // namespace nazori::kanji
