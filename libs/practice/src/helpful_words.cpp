// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/helpful_words.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/gloss.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/kun_reading.h"
#include "nazori/kanji/meaning_text.h"

namespace nazori::practice {
namespace {

constexpr int kMostRead = 400;            ///< common words of the commonest characters
constexpr std::size_t kMostDivided = 40;  ///< of these the readings are looked at
constexpr std::size_t kMostMeanings = 3;

// What a word costs. A school year counts as much as two more characters.
constexpr double kBasic = -40, kRare = 40, kAlone = -10, kOwnMeaning = -4;
constexpr double kUnusual = 25, kInKana = 20, kAffix = 8, kUnexplained = 4, kItsReading = -1;
constexpr double kPerOther = 1, kPerGrade = 3, kNoGrade = 25, kPerCharacter = 1.5;
// And beside words that were chosen already.
constexpr double kSameReading = 4, kSameStem = 14, kUnknownKanji = 6;

bool is_kanji(char32_t c) { return kanji::script_of(c) == kanji::Script::other && c != U'々'; }

/// The grades of KANJIDIC2 as years: secondary school is the seventh, names the ninth.
int year_of(const std::optional<int>& grade) {
  constexpr int kSecondary = 7, kNames = 9;
  if (!grade) return kNames + 1;
  if (*grade <= 6) return *grade;
  return *grade == 8 ? kSecondary : kNames;
}

bool is_affix(const std::string& parts_of_speech) {
  const std::string marks = "," + parts_of_speech + ",";
  constexpr std::array<const char*, 5> kAffixes{",suf,", ",pref,", ",n-suf,", ",n-pref,", ",ctr,"};
  return std::any_of(kAffixes.begin(), kAffixes.end(),
                     [&marks](const char* mark) { return marks.find(mark) != std::string::npos; });
}

/// Whether one of the meanings of a character is in the meanings of a word, as whole words.
bool tells_the_meaning(const std::vector<std::string>& glosses, const kanji::DictionaryEntry& entry) {
  for (const auto& meaning : entry.meanings) {
    if (meaning.language != "en") continue;
    const std::string wanted = " " + kanji::fold_meaning(meaning.text) + " ";
    for (const auto& gloss : glosses)
      if ((" " + kanji::fold_gloss(gloss) + " ").find(wanted) != std::string::npos) return true;
  }
  return false;
}

HelpfulWord weigh(const kanji::KanjiDatabase& database, const kanji::Character& character, kanji::Word word) {
  HelpfulWord out;
  const std::u32string text = base::decode_utf8(word.text).value_or(std::u32string());
  const bool is_kana = kanji::script_of(character.code_point) != kanji::Script::other;
  for (const char32_t c : text)
    if (is_kanji(c) && c != character.code_point &&
        std::find(out.others.begin(), out.others.end(), c) == out.others.end())
      out.others.push_back(c);
  out.meanings = kanji::plain_glosses(word, kMostMeanings);
  out.cost = word.basic ? kBasic : word.common ? 0 : kRare;
  if (text.size() == 1) out.cost += kAlone;
  out.cost += kPerCharacter * static_cast<double>(text.size());
  const int year = is_kana ? 1 : year_of(character.entry.grade);
  for (const char32_t c : out.others) {
    const auto other = database.summary(c);
    const auto grade = other ? other->grade : std::nullopt;
    out.cost += grade ? kPerOther + kPerGrade * std::max(0, year_of(grade) - year) : kNoGrade;
  }
  if (!word.glosses.empty()) {
    if (kanji::is_unusual_gloss(word.glosses.front())) out.cost += kUnusual;
    if (kanji::is_usually_kana(word.glosses.front())) out.cost += kInKana;
  }
  if (is_affix(word.parts_of_speech)) out.cost += kAffix;
  if (tells_the_meaning(out.meanings, character.entry)) out.cost += kOwnMeaning;
  out.word = std::move(word);
  return out;
}

bool is_cheaper(const HelpfulWord& a, const HelpfulWord& b) { return a.cost < b.cost; }

const kanji::ReadingPiece* piece_of(const HelpfulWord& word, char32_t character) {
  const auto piece = std::find_if(word.pieces.begin(), word.pieces.end(),
                                  [character](const auto& one) { return one.character == character; });
  return piece == word.pieces.end() ? nullptr : &*piece;
}

std::vector<ReadingUse> uses_of(const std::vector<HelpfulWord>& words, const kanji::Character& character) {
  std::vector<ReadingUse> uses;
  const auto add = [&](const std::string& reading) {
    for (const auto& word : words) {
      const auto* piece = piece_of(word, character.code_point);
      if (piece == nullptr || piece->from != reading || !word.word.common) continue;
      uses.push_back({reading, piece->reading, word});
      return;
    }
  };
  for (const auto& reading : character.entry.on_readings) add(reading);
  for (const auto& reading : character.entry.kun_readings) add(reading);
  return uses;
}

/// The kanji of a word in their order: 休む and 休み have the same.
std::u32string kanji_of(const HelpfulWord& word) {
  std::u32string found;
  for (const char32_t c : base::decode_utf8(word.word.text).value_or(std::u32string()))
    if (is_kanji(c)) found += c;
  return found;
}

/// 木曜 and 木曜日, 休む and お休み; not 行く and 行う.
bool is_nearly(const HelpfulWord& a, const HelpfulWord& b, char32_t character) {
  const std::u32string one = kanji_of(a);
  const std::u32string two = kanji_of(b);
  const auto* first = piece_of(a, character);
  const auto* second = piece_of(b, character);
  const bool sounds_alike = first == nullptr || second == nullptr || first->reading == second->reading;
  if (one == two) return sounds_alike;
  return one.size() > 1 && two.size() > 1 && (one.find(two) != one.npos || two.find(one) != two.npos);
}

}  // namespace

CharacterWords words_that_help(const kanji::KanjiDatabase& database, const kanji::Character& character) {
  CharacterWords out;
  for (auto& word : database.words(character.code_point, kMostRead)) {
    // Words come by their rank: the common ones first.
    if (!word.common && out.words.size() >= kMostHelpfulWords) break;
    out.words.push_back(weigh(database, character, std::move(word)));
  }
  std::stable_sort(out.words.begin(), out.words.end(), is_cheaper);
  if (out.words.size() > kMostDivided) out.words.resize(kMostDivided);
  for (auto& one : out.words) {
    auto pieces = kanji::divide_reading(one.word.text, one.word.reading,
                                        [&database](char32_t c) { return database.readings(c); });
    if (pieces) {
      one.pieces = *std::move(pieces);
      const auto* piece = piece_of(one, character.code_point);
      const auto reading = kanji::split_kun(piece != nullptr ? piece->from : std::string());
      if (one.word.text == base::encode_utf8(character.code_point) + reading.okurigana)
        one.cost += kItsReading;
    }
    if (one.pieces.empty()) one.cost += kUnexplained;
  }
  std::stable_sort(out.words.begin(), out.words.end(), is_cheaper);
  out.uses = uses_of(out.words, character);
  return out;
}

std::vector<HelpfulWord> choose_words(const std::vector<HelpfulWord>& words, char32_t character,
                                      const std::function<bool(char32_t)>& knows, std::size_t most) {
  std::vector<HelpfulWord> chosen;
  std::vector<bool> is_taken(words.size());
  const auto cost_now = [&](const HelpfulWord& word) {
    double cost = word.cost;
    const auto* piece = piece_of(word, character);
    for (const auto& other : chosen) {
      const auto* its = piece_of(other, character);
      if (piece != nullptr && its != nullptr && piece->from == its->from) cost += kSameReading;
      if (is_nearly(word, other, character)) cost += kSameStem;
    }
    if (knows &&
        std::any_of(word.others.begin(), word.others.end(), [&knows](char32_t c) { return !knows(c); }))
      cost += kUnknownKanji;
    return cost;
  };
  while (chosen.size() < std::min(most, words.size())) {
    std::size_t best = words.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (is_taken[i]) continue;
      const double cost = cost_now(words[i]);
      if (cost < least) {
        least = cost;
        best = i;
      }
    }
    is_taken[best] = true;
    chosen.push_back(words[best]);
  }
  return chosen;
}

}  // namespace nazori::practice
