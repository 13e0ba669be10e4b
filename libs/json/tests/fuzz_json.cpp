// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/json/reader.h"

/// Any bytes are a value that is written and read again as the same, or are refused naming a place.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace json = nazori::json;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto value = json::parse(text);
  if (!value) {
    if (value.error().what.empty() || value.error().where.empty()) std::abort();
    return 0;
  }
  for (const auto& written : {json::to_line(*value), json::to_text(*value)}) {
    const auto again = json::parse(written);
    if (!again || json::to_line(*again) != json::to_line(*value)) std::abort();
  }
  json::Reader reader(text);
  json::Reader::Object root = reader.root(*value);
  (void)root.text("a");
  (void)root.whole("b", 0, 7);
  (void)root.number("c", 0, 1);
  root.each("d", [](json::Reader::Object& one) { (void)one.numbers("e", 3); });
  if (!reader.ok() && reader.error().where.empty()) std::abort();
  return 0;
}
