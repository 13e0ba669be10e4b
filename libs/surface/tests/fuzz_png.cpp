// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "nazori/surface/height_map.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::surface;
  const auto map = parse_png({data, size});
  if (!map) return 0;
  for (const float height : map->samples())
    if (!(height >= 0.0F && height <= 1.0F)) std::abort();
  // What was read is written and read again without loss.
  if (map->size() <= 256 && parse_png(to_png(*map, PngDepth::bits_16)) != *map) std::abort();
  return 0;
}
