// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/functions/plot.h"

// Any bytes are read or refused, and what was read can be written. Written and read again it is the same but
// for numbers beyond 15 digits, so that is left to the tests.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace f = nazori::functions;
  const auto plot = f::parse({reinterpret_cast<const char*>(data), size});
  if (!plot) {
    if (plot.error().column < 1 || plot.error().message.empty() || plot.error().expected.empty())
      std::abort();
    return 0;
  }
  (void)f::in_words(*plot, f::Language::english);
  (void)f::in_words(*plot, f::Language::japanese);
  (void)f::parse(f::canonical(*plot));
  return 0;
}
