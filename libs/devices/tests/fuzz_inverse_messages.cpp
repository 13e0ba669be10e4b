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
  (void)key_for_version(text);
  if (const auto state = parse_state(text)) {
    for (const ArmState& arm : state->arms) {
      if (arm.position_m && !std::isfinite(arm.position_m->x + arm.position_m->y + arm.position_m->z))
        std::abort();
    }
  }
  return 0;
}
