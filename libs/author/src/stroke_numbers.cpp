// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/stroke_numbers.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace nazori::author {
namespace {

/// Takes one number from the front of a text. @return 0-based; nothing where it is not one of `count`.
std::optional<int> take_number(std::string_view& text, std::size_t count) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 1 || static_cast<std::size_t>(number) > count) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number - 1;
}

void skip(std::string_view& text, std::string_view letters) {
  text.remove_prefix(std::min(text.find_first_not_of(letters), text.size()));
}

}  // namespace

std::string stroke_numbers_text(std::span<const int> strokes) {
  std::string text;
  for (std::size_t i = 0; i < strokes.size();) {
    std::size_t last = i;
    while (last + 1 < strokes.size() && strokes[last + 1] == strokes[last] + 1) ++last;
    // Two neighbours are clearer as two numbers.
    if (last == i + 1) last = i;
    if (!text.empty()) text += ", ";
    text += std::to_string(strokes[i] + 1);
    if (last > i) text += "-" + std::to_string(strokes[last] + 1);
    i = last + 1;
  }
  return text;
}

base::Result<std::vector<int>> parse_stroke_numbers(std::string_view text, std::size_t count) {
  const auto refuse = [count] {
    return base::fail(base::Errc::bad_argument, "does not name strokes of this character", "strokes",
                      "give numbers from 1 to " + std::to_string(count) + ", as \"1, 2\" or \"1-3\"");
  };
  std::vector<int> strokes;
  for (skip(text, ", "); !text.empty(); skip(text, ", ")) {
    const auto first = take_number(text, count);
    if (!first) return refuse();
    auto last = first;
    auto rest = text;
    skip(rest, " ");
    if (rest.starts_with('-')) {
      rest.remove_prefix(1);
      skip(rest, " ");
      text = rest;
      last = take_number(text, count);
      if (!last || *last < *first) return refuse();
    }
    for (int stroke = *first; stroke <= *last; ++stroke) strokes.push_back(stroke);
  }
  std::ranges::sort(strokes);
  strokes.erase(std::unique(strokes.begin(), strokes.end()), strokes.end());
  return strokes;
}

}  // namespace nazori::author
