// SPDX-License-Identifier: Apache-2.0
// Any bytes as the file of a photograph, and as its pixels.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "nazori/scan/picture.h"
#include "nazori/scan/sheet.h"

/// What the libraries that draw letters keep until the program ends.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:libfontconfig\nleak:libpango\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::scan;
  const auto photo = parse_photo(std::span(data, size));
  if (photo && photo->grey.size() < 1'000'000) (void)find_sheets(*photo);
  if (size < 64) return 0;
  Photo pixels{128, 128, {}};
  for (std::size_t i = 0; i < 128U * 128U; ++i) pixels.grey.push_back(data[i / 16 % size]);
  (void)find_sheets(pixels);
  return 0;
}
