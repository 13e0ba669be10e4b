// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "nazori/speech/sound.h"

/// Any bytes are either refused or give samples within -1..1 that last no longer than allowed.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto sound = nazori::speech::decode_sound({data, size});
  if (!sound) return 0;
  if (sound->samples.empty() || sound->rate_hz <= 0 || sound->duration_s() > nazori::speech::kMostSound_s)
    std::abort();
  for (const float x : sound->samples)
    if (!(std::abs(x) <= 1)) std::abort();
  return 0;
}
