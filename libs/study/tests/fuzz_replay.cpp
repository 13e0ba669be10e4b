// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/study/replay.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::study;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto replay = replay_histories(text);
  if (!replay) return 0;
  (void)compare_with_own_numbers(text, *replay);
  const std::string written = to_json(*replay);
  const auto again = replay_histories(written);
  if (!again || to_json(*again) != written) std::abort();
  return 0;
}
