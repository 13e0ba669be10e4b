// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/word_reading.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/kun_reading.h"
#include "nazori/kanji/romaji.h"

namespace nazori::kanji {
namespace {

constexpr char32_t kVoiced = U'\x3099';
constexpr char32_t kHalfVoiced = U'\x309A';
constexpr std::size_t kLongest = 40;  ///< characters of a word; longer ones are phrases

/// A way to read a character, and how far it is from the dictionary's reading.
struct Way {
  std::u32string sound;
  std::string from;
  int changes = 0;
};

std::u32string hiragana_of(std::string_view text) {
  return base::decode_utf8(to_hiragana(text)).value_or(std::u32string());
}

void offer(std::vector<Way>& ways, Way way) {
  if (way.sound.empty()) return;
  const auto known =
      std::find_if(ways.begin(), ways.end(), [&way](const Way& other) { return other.sound == way.sound; });
  if (known == ways.end())
    ways.push_back(std::move(way));
  else if (way.changes < known->changes)
    *known = std::move(way);
}

/// The continuative form of a verb's ending: む gives み, ける gives け.
std::u32string continuative(std::u32string ending) {
  constexpr std::u32string_view kU = U"うくぐすつぬぶむる";
  constexpr std::u32string_view kI = U"いきぎしちにびみり";
  if (ending.size() > 1 && ending.back() == U'る') {
    ending.pop_back();
    return ending;
  }
  const std::size_t row = ending.empty() ? kU.npos : kU.find(ending.back());
  if (row == kU.npos) return {};
  ending.back() = kI[row];
  return ending;
}

std::vector<Way> dictionary_ways(const std::vector<std::string>& readings) {
  std::vector<Way> ways;
  for (const std::string& text : readings) {
    const KunReading split = split_kun(text);
    const std::u32string stem = hiragana_of(split.stem);
    offer(ways, {stem, text, 0});
    if (split.okurigana.empty()) continue;
    const std::u32string ending = hiragana_of(split.okurigana);
    offer(ways, {stem + ending, text, 1});
    if (const auto form = continuative(ending); !form.empty()) offer(ways, {stem + form, text, 1});
  }
  return ways;
}

/// Adds the changes of sound that a reading has inside a word.
std::vector<Way> ways_within(const std::vector<Way>& plain, bool is_first, bool is_last) {
  constexpr std::u32string_view kShortened = U"くつちき";
  std::vector<Way> ways = plain;
  if (!is_first) {
    for (const Way& way : plain) {
      for (const char32_t mark : {kVoiced, kHalfVoiced}) {
        const char32_t first = with_sound_mark(way.sound.front(), mark);
        if (first == 0) continue;
        Way changed{way.sound, way.from, way.changes + 1};
        changed.sound.front() = first;
        offer(ways, std::move(changed));
      }
    }
  }
  if (!is_last) {
    const std::vector<Way> so_far = ways;
    for (const Way& way : so_far) {
      if (way.sound.size() < 2 || kShortened.find(way.sound.back()) == kShortened.npos) continue;
      Way changed{way.sound, way.from, way.changes + 1};
      changed.sound.back() = U'っ';
      offer(ways, std::move(changed));
    }
  }
  return ways;
}

bool is_kana(char32_t c) {
  const Script script = script_of(c);
  return script == Script::hiragana || script == Script::katakana;
}

/// Tries every way of every character, and keeps the pieces with the fewest changes.
class Division {
 public:
  Division(std::u32string word, std::u32string sound, const ReadingsOf& readings_of)
      : word_(std::move(word)), sound_(std::move(sound)) {
    for (std::size_t i = 0; i < word_.size(); ++i) {
      const char32_t c = word_[i] == U'々' && i > 0 ? word_[i - 1] : word_[i];
      ways_.push_back(is_kana(c)
                          ? std::vector<Way>()
                          : ways_within(dictionary_ways(readings_of(c)), i == 0, i + 1 == word_.size()));
    }
    // A place that was reached with no more changes need not be tried again.
    reached_.assign((word_.size() + 1) * (sound_.size() + 1), kAlive);
  }

  [[nodiscard]] std::optional<std::vector<ReadingPiece>> best() {
    go_on(0, 0, 0);
    if (best_changes_ == kAlive) return std::nullopt;
    return best_;
  }

 private:
  static constexpr int kAlive = std::numeric_limits<int>::max();

  void go_on(std::size_t at, std::size_t heard, int changes) {
    int& fewest = reached_[at * (sound_.size() + 1) + heard];
    if (changes >= best_changes_ || changes >= fewest) return;
    fewest = changes;
    if (at == word_.size()) {
      if (heard != sound_.size()) return;
      best_changes_ = changes;
      best_ = pieces_;
      return;
    }
    const char32_t c = word_[at];
    if (is_kana(c)) {
      const std::u32string kana = hiragana_of(base::encode_utf8(c));
      if (heard >= sound_.size() || kana.size() != 1 || sound_[heard] != kana[0]) return;
      pieces_.push_back({c, base::encode_utf8(c), {}});
      go_on(at + 1, heard + 1, changes);
      pieces_.pop_back();
      return;
    }
    for (const Way& way : ways_[at]) {
      if (sound_.compare(heard, way.sound.size(), way.sound) != 0) continue;
      pieces_.push_back({c, base::encode_utf8(std::u32string_view(way.sound)), way.from});
      go_on(at + 1, heard + way.sound.size(), changes + way.changes);
      pieces_.pop_back();
    }
  }

  std::u32string word_;
  std::u32string sound_;
  std::vector<std::vector<Way>> ways_;
  std::vector<int> reached_;  ///< for each place in word and sound, the fewest changes it was reached with
  std::vector<ReadingPiece> pieces_;
  std::vector<ReadingPiece> best_;
  int best_changes_ = kAlive;
};

}  // namespace

std::optional<std::vector<ReadingPiece>> divide_reading(std::string_view word, std::string_view reading,
                                                        const ReadingsOf& readings_of) {
  auto text = base::decode_utf8(word);
  if (!text || text->empty() || text->size() > kLongest) return std::nullopt;
  return Division(std::move(*text), hiragana_of(reading), readings_of).best();
}

}  // namespace nazori::kanji
