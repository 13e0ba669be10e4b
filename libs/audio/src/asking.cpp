// SPDX-License-Identifier: Apache-2.0
#include "asking.h"

#include <algorithm>
#include <span>

#include "nazori/audio/output.h"

namespace nazori::audio {

void ask(void* source, std::uint8_t* bytes, int length) noexcept {
  const std::span<float> stereo(reinterpret_cast<float*>(bytes),
                                static_cast<std::size_t>(length) / sizeof(float));
  std::fill(stereo.begin(), stereo.end(), 0.0F);
  static_cast<Source*>(source)->add_to(stereo);
  for (float& sample : stereo) sample = std::clamp(sample, -1.0F, 1.0F);
}

}  // namespace nazori::audio
