// SPDX-License-Identifier: Apache-2.0
#include "reduced.h"

#include <cstddef>
#include <cstdint>

namespace nazori::scan {

Photo reduced(const Photo& photo, int factor) {
  if (factor == 1) return photo;
  Photo small;
  small.width = photo.width / factor;
  small.height = photo.height / factor;
  small.grey.reserve(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      unsigned sum = 0;
      for (int v = 0; v < factor; ++v)
        for (int u = 0; u < factor; ++u) sum += photo.at(x * factor + u, y * factor + v);
      small.grey.push_back(static_cast<std::uint8_t>(sum / static_cast<unsigned>(factor * factor)));
    }
  return small;
}

}  // namespace nazori::scan
