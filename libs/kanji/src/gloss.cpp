// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/gloss.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

namespace nazori::kanji {
namespace {

constexpr auto kUnusual = std::to_array<std::string_view>(
    {"arch", "obs", "obsc", "rare", "ok", "oK", "ik", "iK", "io", "X", "vulg", "dated", "derog", "sens"});

/// The marks that are no part of speech: of use and spelling, of fields, of dialects.
constexpr auto kMarks = [] {
  auto marks = std::to_array<std::string_view>({
      "MA",      "Shinto",  "X",      "abbr",   "anat",    "arch",  "archit", "astron", "ateji",  "baseb",
      "biol",    "bot",     "bus",    "chem",   "chn",     "col",   "comp",   "dated",  "derog",  "econ",
      "eK",      "ek",      "engr",   "euph",   "fam",     "fem",   "finc",   "food",   "geol",   "geom",
      "gikun",   "gram",    "hanaf",  "hist",   "hon",     "hum",   "iK",     "id",     "ik",     "io",
      "iv",      "joc",     "law",    "ling",   "litf",    "m-sl",  "mahj",   "male",   "math",   "med",
      "mil",     "music",   "net-sl", "oK",     "obs",     "obsc",  "oik",    "ok",     "on-mim", "phil",
      "physics", "physiol", "poet",   "pol",    "proverb", "quote", "rare",   "sens",   "shogi",  "sl",
      "sports",  "sumo",    "surg",   "tradem", "uK",      "uk",    "vulg",   "yoji",   "zool",   "P",
      "Buddh",   "Christn",
  });
  std::sort(marks.begin(), marks.end());
  return marks;
}();

/// Dialects end in 'b:' ("ksb:"); other marks are in the list, also several of them with commas.
bool is_mark(std::string_view bracket) {
  while (true) {
    const std::size_t comma = bracket.find(',');
    const std::string_view one = bracket.substr(0, comma);
    const bool is_dialect = one.ends_with("b:") || one == "kyu:";
    const bool is_number =
        !one.empty() && std::all_of(one.begin(), one.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!is_dialect && !is_number && !std::binary_search(kMarks.begin(), kMarks.end(), one)) return false;
    if (comma == std::string_view::npos) return true;
    bracket.remove_prefix(comma + 1);
  }
}

/// Takes the marks off the front of a gloss, one after another.
std::string_view without_marks(std::string_view gloss, const std::function<void(std::string_view)>& take) {
  const auto skip_blanks = [&gloss] {
    while (!gloss.empty() && gloss.front() == ' ') gloss.remove_prefix(1);
  };
  skip_blanks();
  while (gloss.starts_with('(')) {
    const std::size_t end = gloss.find(')');
    if (end == std::string_view::npos) break;
    const std::string_view mark = gloss.substr(1, end - 1);
    if (!is_mark(mark)) break;
    take(mark);
    gloss.remove_prefix(end + 1);
    skip_blanks();
  }
  return gloss;
}

bool has_mark(std::string_view gloss, const std::function<bool(std::string_view)>& wanted) {
  bool found = false;
  (void)without_marks(gloss, [&](std::string_view mark) { found = found || wanted(mark); });
  return found;
}

}  // namespace

std::string plain_gloss(std::string_view gloss) {
  return std::string(without_marks(gloss, [](std::string_view) {}));
}

bool is_unusual_gloss(std::string_view gloss) {
  return has_mark(gloss, [](std::string_view mark) {
    return std::find(kUnusual.begin(), kUnusual.end(), mark) != kUnusual.end();
  });
}

bool is_usually_kana(std::string_view gloss) {
  return has_mark(gloss, [](std::string_view mark) { return mark == "uk"; });
}

std::vector<std::string> plain_glosses(const Word& word, std::size_t most) {
  // The marks of a sense stand before its first gloss.
  const auto sense_of = [&word](std::size_t i) { return i < word.senses.size() ? word.senses[i] : 1; };
  std::vector<bool> is_unusual(word.glosses.size());
  for (std::size_t i = 0; i < word.glosses.size(); ++i) {
    const bool continues = i > 0 && sense_of(i) == sense_of(i - 1);
    is_unusual[i] = (continues && is_unusual[i - 1]) || is_unusual_gloss(word.glosses[i]);
  }
  const bool has_usual = std::find(is_unusual.begin(), is_unusual.end(), false) != is_unusual.end();
  std::vector<std::string> plain;
  for (std::size_t i = 0; i < word.glosses.size() && plain.size() < most; ++i) {
    if (has_usual && is_unusual[i]) continue;
    std::string text = plain_gloss(word.glosses[i]);
    if (!text.empty() && std::find(plain.begin(), plain.end(), text) == plain.end())
      plain.push_back(std::move(text));
  }
  return plain;
}

}  // namespace nazori::kanji
