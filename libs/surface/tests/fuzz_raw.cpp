// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "nazori/surface/height_map.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using nazori::surface::parse_raw;
  const std::span<const std::uint8_t> bytes(data, size);
  const auto inferred = parse_raw(bytes);
  if (inferred && nazori::surface::to_raw(*inferred) != std::vector<std::uint8_t>(data, data + size))
    std::abort();
  if (size > 1) {
    const int side = static_cast<std::int8_t>(data[0]) * 64 + data[1];
    const auto sized = parse_raw(bytes.subspan(2), side);
    if (sized && sized->samples().size() != size - 2) std::abort();
  }
  return 0;
}
