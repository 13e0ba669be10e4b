// SPDX-License-Identifier: Apache-2.0
#include "recordings.h"

#include <system_error>
#include <vector>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"

namespace nazori::speech {
namespace {

/// The kana with their sound marks apart: が as か and U+3099.
std::u32string taken_apart(const std::u32string& kana) {
  std::u32string apart;
  for (const char32_t c : kana) {
    constexpr char32_t kDakuten = 0x3099;
    constexpr char32_t kHandakuten = 0x309A;
    // The plain kana stands one or two before the marked one; ゔ is the exception.
    if (c == U'ゔ')
      apart += {U'う', kDakuten};
    else if (kanji::with_sound_mark(c - 1, kDakuten) == c)
      apart += {c - 1, kDakuten};
    else if (kanji::with_sound_mark(c - 2, kHandakuten) == c)
      apart += {c - 2, kHandakuten};
    else
      apart += c;
  }
  return apart;
}

}  // namespace

std::filesystem::path recording_of(const std::filesystem::path& folder, const std::string& name) {
  if (folder.empty()) return {};
  const auto decoded = base::decode_utf8(name);
  if (!decoded) return {};
  const std::u32string hiragana(*decoded);
  std::u32string katakana = hiragana;
  for (char32_t& c : katakana)
    if (const char32_t other = kanji::in_other_syllabary(c); other != 0) c = other;
  for (const std::u32string& spelling : {hiragana, katakana, taken_apart(hiragana)}) {
    for (const char* ending : kRecordingEndings) {
      std::filesystem::path path = folder / (base::encode_utf8(std::u32string_view(spelling)) + ending);
      std::error_code ignored;
      if (std::filesystem::is_regular_file(path, ignored)) return path;
    }
  }
  return {};
}

}  // namespace nazori::speech
