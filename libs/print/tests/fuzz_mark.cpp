// SPDX-License-Identifier: Apache-2.0
// Any bytes as the mark of a sheet: read as they are, and as the content of a mark whose checks are right.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "nazori/print/sheet_mark.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::print;
  for (const bool sealed : {false, true}) {
    const std::span<const std::uint8_t> bytes(data, size);
    const auto mark = sealed ? read_mark(sealed_mark(bytes)) : read_mark(bytes);
    if (!mark) continue;
    if (boxes_of(*mark).size() > 1'000'000) std::abort();
    // What was read can be written, and is then the same.
    const auto written = mark_bytes(*mark, kMostMarkBytes);
    if (!written) continue;
    const auto again = read_mark(*written);
    if (!again || *again != *mark) std::abort();
  }
  return 0;
}
