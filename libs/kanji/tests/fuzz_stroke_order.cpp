// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "nazori/kanji/centre_lines.h"
#include "nazori/kanji/stroke_order.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using nazori::kanji::StrokeOrder;
  for (const int grid : {2, 128, 8192}) {
    const auto order = StrokeOrder::parse({data, size}, grid);
    if (!order) continue;
    // Each content has only one valid encoding, so what was read is written identically. Lines made from it
    // stay on the grid.
    if (order->to_bytes() != std::vector<std::uint8_t>(data, data + size)) std::abort();
    if (!StrokeOrder::parse(StrokeOrder::from_lines(centre_lines(order->to_lines(grid)), grid).to_bytes(),
                            grid))
      std::abort();
  }
  return 0;
}
