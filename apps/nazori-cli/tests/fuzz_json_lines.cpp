// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "json_lines.h"
#include "nazori/writing/grade.h"

/// Any line is no JSON object, or is refused naming a place in it, or is ink of which check() can be asked.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  const auto request = nazori::cli::Json::parse(line, nullptr, false);
  if (!request.is_object()) return 0;
  const auto ink = nazori::cli::read_ink(request);
  if (!ink) {
    if (ink.error().where.empty()) std::abort();
    return 0;
  }
  if (ink->strokes.size() != request["strokes"].size()) std::abort();
  (void)nazori::writing::check(*ink);
  return 0;
}
