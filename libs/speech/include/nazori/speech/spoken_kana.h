// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::speech {

/// A text of kana that can be spoken. UTF-8.
struct SpokenKana {
  std::string name;  ///< hiragana: under this name recordings and the cache keep it
  std::string said;  ///< hiragana that a voice reads; differs from `name` for っ, ゃ and ー alone

  friend bool operator==(const SpokenKana&, const SpokenKana&) = default;
};

/// The longest text that is spoken, in kana.
inline constexpr std::size_t kMostSpokenKana = 60;

/// Prepares a reading for a voice: katakana (also half width) becomes hiragana, a kana and its sound mark one
/// character, and the marks of dictionaries (the dot before okurigana, hyphens, ～) are left out. 、and
/// spaces are kept as a pause. A small kana alone is said by its name, "ちいさい、つ", a long vowel mark
/// alone "のばすおん".
/// @return Errc::bad_argument for a text without kana, with anything else in it, or that is too long.
[[nodiscard]] base::Result<SpokenKana> spoken_kana(std::string_view text);

}  // namespace nazori::speech
