// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/functions/plot_document.h"

// Any bytes are read or refused; what was read survives being written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace f = nazori::functions;
  const auto document = f::parse_document({reinterpret_cast<const char*>(data), size});
  if (!document) {
    if (document.error().what.empty() || document.error().where.empty()) std::abort();
    return 0;
  }
  const auto again = f::parse_document(f::to_json(*document));
  if (!again || again->expression != document->expression || !(again->window == document->window))
    std::abort();
  return 0;
}
