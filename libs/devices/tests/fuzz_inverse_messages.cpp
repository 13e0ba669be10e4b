// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "../src/inverse_messages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::devices::inverse;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  (void)dialect_for_version(text);
  ServiceState state;
  if (read_state(text, state)) {
    for (std::size_t i = 0; i < state.arm_count; ++i) {
      const auto& position = state.arms[i].position_m;
      if (position && !std::isfinite(position->x + position->y + position->z)) std::abort();
    }
  }
  return 0;
}
