// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions::test {

/// The plot of a text that must be readable.
inline Plot read(const std::string& text) {
  auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  return plot ? *plot : Plot{};
}

/// A text that cannot be read.
struct Mistake {
  const char* typed;
  SyntaxFault fault;
  int column;
};

/// Each is refused with its fault and its column, and has words in both languages.
inline void expect_refused(std::span<const Mistake> mistakes) {
  for (const Mistake& m : mistakes) {
    const auto plot = parse(m.typed);
    EXPECT_FALSE(plot) << m.typed;
    if (plot) continue;
    EXPECT_EQ(plot.error().fault, m.fault) << m.typed << ": " << plot.error().to_error().what;
    EXPECT_EQ(plot.error().column, m.column) << m.typed;
    for (const Language language : {Language::english, Language::japanese}) {
      EXPECT_FALSE(in_words(plot.error(), language).message.empty()) << m.typed;
      EXPECT_FALSE(in_words(plot.error(), language).expected.empty()) << m.typed;
    }
  }
}

}  // namespace nazori::functions::test
