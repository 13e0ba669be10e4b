// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/study/character_lists.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto known = [](char32_t c) { return c >= 0x3041 && c <= 0x9FFF; };
  const auto list = nazori::study::parse_list({reinterpret_cast<const char*>(data), size}, known);
  if (!list) return 0;
  // The characters alone are also a valid list, the same one.
  const std::u32string plain(list->begin(), list->end());
  if (nazori::study::parse_list(nazori::base::encode_utf8(plain), known) != list) std::abort();
  return 0;
}
