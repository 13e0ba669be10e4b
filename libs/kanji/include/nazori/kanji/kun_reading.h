// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace nazori::kanji {

/// A kun reading as KANJIDIC2 writes it, split into its parts: "やす.む" is the stem やす, which the kanji
/// stands for, and the okurigana む, which follows it in kana. A hyphen marks a reading used only at the end
/// or the beginning of a word. UTF-8.
struct KunReading {
  std::string stem;
  std::string okurigana;
  bool as_suffix = false;
  bool as_prefix = false;

  friend bool operator==(const KunReading&, const KunReading&) = default;
};

/// Splits a reading of DictionaryEntry::kun_readings; a text without marks is all stem.
[[nodiscard]] KunReading split_kun(std::string_view reading);

/// "やす・む", with a wave dash ～ in place of the hyphen.
[[nodiscard]] std::string kun_text(const KunReading& reading);

}  // namespace nazori::kanji
