// SPDX-License-Identifier: Apache-2.0
// Which letters a text defines. This is known before the text is split into names: "ax" is a*x only where a
// is defined.
#include <algorithm>

#include "tokens.h"

namespace nazori::functions {
namespace {

constexpr std::u32string_view kTaken = U"xyztre";  // variables, and e

bool is_sign(char32_t c) { return c == U'<' || c == U'>' || c == U'≤' || c == U'≥'; }

/// One part of the text without its spaces.
void scan(std::u32string_view part, DefinedLetters& found) {
  if (part.size() < 3) return;
  const auto at = [part](std::size_t i) { return i < part.size() ? part[i] : U'\0'; };
  if (can_be_defined(at(0)) && at(1) == U'=') {
    found.parameters += at(0);
    return;
  }
  const bool long_name = part.substr(2, 5) == U"theta";
  const std::size_t close = long_name ? 7 : 3;
  const bool has_variable = long_name || at(2) == U'x' || at(2) == U't' || at(2) == U'θ';
  if (can_be_defined(at(0)) && at(1) == U'(' && has_variable && at(close) == U')' && at(close + 1) == U'=') {
    found.functions += at(0);
    return;
  }
  // 0 <= a <= 3
  for (std::size_t i = 1; i + 1 < part.size(); ++i) {
    const bool after_sign = is_sign(at(i - 1)) || (at(i - 1) == U'=' && i > 1 && is_sign(at(i - 2)));
    if (after_sign && can_be_defined(at(i)) && is_sign(at(i + 1))) found.parameters += at(i);
  }
}

}  // namespace

bool can_be_defined(char32_t c) {
  return c >= U'a' && c <= U'z' && kTaken.find(c) == std::u32string_view::npos;
}

DefinedLetters defined_letters(std::u32string_view text) {
  DefinedLetters found;
  std::u32string part;
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char32_t c = i < text.size() ? text[i] : U';';
    if (c == U'(' || c == U'[' || c == U'{') ++depth;
    if (c == U')' || c == U']' || c == U'}') depth = std::max(0, depth - 1);
    if (i == text.size() || (c == U';' && depth == 0)) {
      scan(part, found);
      if (part.find(U'~') != std::u32string::npos) found.models.emplace_back(start, i);
      start = i + 1;
      part.clear();
    } else if (c != U' ' && c != U'\t' && c != 0x3000) {
      part += c;
    }
  }
  return found;
}

}  // namespace nazori::functions
