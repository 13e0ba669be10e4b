// SPDX-License-Identifier: Apache-2.0
#include "search_text.h"

#include <algorithm>

#include "nazori/base/utf8.h"

namespace nazori::kanji {
namespace {

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

}  // namespace

bool is_searched_kana(char32_t c) {
  return (c >= 0x3041 && c <= 0x309F) || (c >= 0x30A0 && c <= 0x30FF) || (c >= 0xFF66 && c <= 0xFF9F);
}

std::string after_all_that_begin_with(std::string_view key) { return std::string(key) + "\xFF"; }

SearchText search_text_of(std::string_view text) {
  SearchText out;
  out.typed = trimmed(base::decode_utf8(text).value_or(std::u32string()));
  out.narrow = narrowed(out.typed);
  out.is_kana = std::all_of(out.narrow.begin(), out.narrow.end(),
                            [](char32_t c) { return is_searched_kana(c) || c == U'.' || c == U'-'; });
  out.is_latin = std::all_of(out.narrow.begin(), out.narrow.end(), is_latin_letter);
  return out;
}

}  // namespace nazori::kanji
