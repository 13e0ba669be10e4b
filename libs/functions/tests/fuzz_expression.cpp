// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/functions/plot.h"

// Any bytes are parsed or refused; a parsed expression is unchanged after being written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace f = nazori::functions;
  const auto plot = f::parse({reinterpret_cast<const char*>(data), size});
  if (!plot) {
    for (const auto language : {f::Language::english, f::Language::japanese}) {
      const auto words = f::in_words(plot.error(), language);
      if (plot.error().column < 1 || words.message.empty() || words.expected.empty()) std::abort();
    }
    return 0;
  }
  (void)f::in_words(*plot, f::Language::english);
  (void)f::in_words(*plot, f::Language::japanese);
  const std::string text = f::canonical(*plot);
  if (text.size() > 10'000) return 0;
  const auto again = f::parse(text);
  // Parentheses added for clarity may exceed the limit of nesting.
  if (again && f::canonical(*again) != text) std::abort();
  return 0;
}
