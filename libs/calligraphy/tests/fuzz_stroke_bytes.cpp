// SPDX-License-Identifier: Apache-2.0
// The strokes in the file of a sheet: what is read is written to the same bytes.
#include <algorithm>
#include <cstdlib>

#include "../src/stroke_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::calligraphy;
  const auto strokes = parse_strokes({data, size});
  // No strokes are no bytes.
  if (!strokes || strokes->empty()) return 0;
  if (!std::ranges::equal(to_bytes(*strokes), std::span(data, size))) std::abort();
  for (const BrushStroke& stroke : *strokes) static_cast<void>(shape_of(stroke));
  return 0;
}
