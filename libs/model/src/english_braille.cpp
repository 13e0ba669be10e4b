// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/english_braille.h"

#include <fmt/format.h>
#include <liblouis/liblouis.h>

#include <algorithm>
#include <mutex>
#include <string>

#include "nazori/base/utf8.h"

namespace nazori::model {
namespace {

constexpr const char* kTable = "en-ueb-g2.ctb";
constexpr std::size_t kMostCellsPerLetter = 12;
constexpr widechar kFirstPattern = 0x2800;
constexpr widechar kMostDots = 63;

bool is_latin(char32_t c) {
  return (c >= 0x20 && c < 0x7F) || (c >= 0xA1 && c <= 0x17F) || (c >= 0x2013 && c <= 0x201D) || c == 0x2026;
}

base::Result<std::optional<std::vector<BrailleCell>>> contracted(std::u32string_view text) {
  std::vector<widechar> letters(text.begin(), text.end());
  std::vector<widechar> patterns(letters.size() * kMostCellsPerLetter + 1);
  int length = static_cast<int>(letters.size());
  int cells = static_cast<int>(patterns.size());
  {
    // The library keeps its tables in variables that all threads share.
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    lou_setLogLevel(LOU_LOG_OFF);
    if (lou_translateString(kTable, letters.data(), &length, patterns.data(), &cells, nullptr, nullptr,
                            dotsIO | ucBrl) == 0) {
      return base::fail(base::Errc::not_found, "there is no table for contracted braille", kTable,
                        "install liblouis-data, or take uncontracted braille");
    }
  }
  std::vector<BrailleCell> made;
  for (int i = 0; i < cells; ++i) {
    const widechar pattern = patterns[static_cast<std::size_t>(i)];
    if (pattern < kFirstPattern || pattern > kFirstPattern + kMostDots) return std::nullopt;
    made.push_back(static_cast<BrailleCell>(pattern - kFirstPattern));
  }
  return made;
}

}  // namespace

base::Result<std::optional<std::vector<BrailleCell>>> english_braille(std::string_view text,
                                                                      EnglishBraille how) {
  if (text.size() > kLongestBrailleText) {
    return base::fail(base::Errc::bad_argument, fmt::format("a text of {} bytes is too long", text.size()),
                      "braille", fmt::format("give {} bytes at most", kLongestBrailleText));
  }
  if (how == EnglishBraille::uncontracted) {
    std::string small(text);
    for (char& c : small)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return braille_cells(small);
  }
  const auto letters = base::decode_utf8(text);
  if (!letters || !std::all_of(letters->begin(), letters->end(), is_latin)) return std::nullopt;
  if (letters->empty()) return std::vector<BrailleCell>();
  return contracted(*letters);
}

}  // namespace nazori::model
