// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "nazori/surface/height_map.h"

namespace {

/// Corrects the checksums of all chunks, so that the code that reads their content is tested, too.
void repair_checksums(std::vector<std::uint8_t>& png) {
  constexpr std::size_t kSignature = 8;
  std::size_t at = kSignature;
  while (at + 12 <= png.size()) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8U | png[at + i];
    if (length > png.size() - at - 12) return;
    const auto sum = static_cast<std::uint32_t>(crc32(0, png.data() + at + 4, static_cast<uInt>(length + 4)));
    for (std::size_t i = 0; i < 4; ++i)
      png[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    at += 12 + length;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::surface;
  std::vector<std::uint8_t> bytes(data, data + size);
  repair_checksums(bytes);
  const auto map = parse_png(bytes);
  if (!map) return 0;
  for (const float height : map->samples())
    if (!(height >= 0.0F && height <= 1.0F)) std::abort();
  // What was read is written and read again without loss.
  if (map->size() <= 256 && parse_png(to_png(*map, PngDepth::bits_16)) != *map) std::abort();
  return 0;
}
