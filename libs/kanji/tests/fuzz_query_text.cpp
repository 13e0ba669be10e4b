// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/kanji/query_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view typed(reinterpret_cast<const char*>(data), size);
  const auto read = nazori::kanji::read_query(typed);
  // What is left as text has no conditions in it, unless quotation marks joined other words.
  if (typed.find('"') == std::string_view::npos) {
    const auto again = nazori::kanji::read_query(read.query.text);
    nazori::kanji::TypedQuery text_alone;
    text_alone.query.text = read.query.text;
    if (again != text_alone) std::abort();
  }
  return 0;
}
