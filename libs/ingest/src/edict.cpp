// SPDX-License-Identifier: Apache-2.0
#include "nazori/ingest/edict.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "tables.h"

namespace nazori::ingest {
namespace {

/// The part-of-speech marks of EDICT's documentation, and the ones that JMdict has added since.
constexpr auto kPartsOfSpeech = [] {
  auto marks = std::to_array<std::string_view>({
      "adj-f",     "adj-i",  "adj-ix", "adj-kari", "adj-ku", "adj-na", "adj-nari", "adj-no", "adj-pn",
      "adj-shiku", "adj-t",  "adj",    "adv",      "adv-to", "aux",    "aux-adj",  "aux-v",  "conj",
      "cop",       "cop-da", "ctr",    "exp",      "int",    "iv",     "n",        "n-adv",  "n-pr",
      "n-pref",    "n-suf",  "n-t",    "num",      "pn",     "pref",   "prt",      "suf",    "unc",
      "v-unspec",  "v1",     "v1-s",   "v2a-s",    "v2b-k",  "v2b-s",  "v2d-k",    "v2d-s",  "v2g-k",
      "v2g-s",     "v2h-k",  "v2h-s",  "v2k-k",    "v2k-s",  "v2m-k",  "v2m-s",    "v2n-s",  "v2r-k",
      "v2r-s",     "v2s-s",  "v2t-k",  "v2t-s",    "v2w-s",  "v2y-k",  "v2y-s",    "v2z-s",  "v4b",
      "v4g",       "v4h",    "v4k",    "v4m",      "v4n",    "v4r",    "v4s",      "v4t",    "v5",
      "v5aru",     "v5b",    "v5g",    "v5k",      "v5k-s",  "v5m",    "v5n",      "v5r",    "v5r-i",
      "v5s",       "v5t",    "v5u",    "v5u-s",    "v5uru",  "vi",     "vk",       "vn",     "vr",
      "vs",        "vs-c",   "vs-i",   "vs-s",     "vt",     "vz",
  });
  std::sort(marks.begin(), marks.end());
  return marks;
}();

bool is_part_of_speech(std::string_view mark) {
  return std::binary_search(kPartsOfSpeech.begin(), kPartsOfSpeech.end(), mark);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool is_sense_number(std::string_view mark) {
  return !mark.empty() && mark.size() <= 3 &&
         std::all_of(mark.begin(), mark.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Removes the marks at the front of a gloss: parts of speech are recorded, a sense number begins a sense,
/// all others are kept.
class GlossReader {
 public:
  explicit GlossReader(EdictEntry& entry) : entry_(entry) {}

  void read(std::string_view gloss) {
    std::string kept;
    bool begins_sense = false;
    gloss = trimmed(gloss);
    while (gloss.starts_with('(')) {
      const std::size_t end = gloss.find(')');
      if (end == std::string_view::npos) break;
      const std::string_view mark = gloss.substr(1, end - 1);
      const auto parts = split(mark, ',');
      if (is_sense_number(mark)) {
        begins_sense = true;
      } else if (std::all_of(parts.begin(), parts.end(), is_part_of_speech)) {
        for (const std::string_view part : parts) note(part);
      } else if (mark == "P") {
        entry_.common = true;
      } else if (is_english(mark)) {
        break;
      } else {
        kept += std::string(gloss.substr(0, end + 1)) + " ";
      }
      gloss = trimmed(gloss.substr(end + 1));
    }
    if (begins_sense || entry_.senses.empty()) {
      if (entry_.senses.empty() || !entry_.senses.back().empty()) entry_.senses.emplace_back();
    }
    const std::string whole = std::string(trimmed(kept + std::string(gloss)));
    if (!gloss.empty()) entry_.senses.back().push_back(whole);
  }

 private:
  /// Marks are single words; a bracket with a space in it is English, and no marks come after it.
  static bool is_english(std::string_view mark) { return mark.find(' ') != std::string_view::npos; }

  void note(std::string_view part) {
    const auto have = split(entry_.parts_of_speech, ',');
    if (std::find(have.begin(), have.end(), part) != have.end()) return;
    if (!entry_.parts_of_speech.empty()) entry_.parts_of_speech += ',';
    entry_.parts_of_speech += part;
  }

  EdictEntry& entry_;
};

}  // namespace

base::Result<EdictEntry> parse_edict_line(std::string_view line) {
  const auto refuse = [](std::string what) { return base::fail(base::Errc::parse, std::move(what)); };
  const std::size_t slash = line.find('/');
  if (slash == std::string_view::npos) return refuse("no '/' before the glosses");
  if (line.size() < slash + 2 || line.back() != '/') return refuse("no '/' after the last gloss");
  const std::string_view head = trimmed(line.substr(0, slash));
  EdictEntry entry;
  const std::size_t bracket = head.find('[');
  entry.text = trimmed(head.substr(0, bracket));
  if (entry.text.empty()) return refuse("no word");
  if (bracket != std::string_view::npos) {
    if (head.back() != ']') return refuse("the reading has no closing bracket");
    entry.reading = trimmed(head.substr(bracket + 1, head.size() - bracket - 2));
    if (entry.reading.empty()) return refuse("the reading is empty");
  }
  GlossReader reader(entry);
  const std::string_view glosses = line.substr(slash + 1, line.size() - slash - 2);
  for (const std::string_view gloss : split(glosses, '/')) reader.read(gloss);
  while (!entry.senses.empty() && entry.senses.back().empty()) entry.senses.pop_back();
  if (entry.senses.empty()) return refuse("no gloss");
  return entry;
}

}  // namespace nazori::ingest
