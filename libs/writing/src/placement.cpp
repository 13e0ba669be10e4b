// SPDX-License-Identifier: Apache-2.0
#include "placement.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {

std::vector<Placement> placements(const Alignment& alignment, std::span<const Shape> model) {
  constexpr float kReach = 24.0F;       // glyph units
  constexpr float kDoubt = 0.6F;        // weight of "no offset" compared with the neighbours
  constexpr float kLengthDoubt = 0.3F;  // weight of "right length" compared with the others
  constexpr float kLong = 30.0F;        // glyph units: shorter strokes say less about the size of the whole
  constexpr float kStrange = 13.0F;     // cost at which a neighbour has a quarter of its weight
  std::vector<Placement> result;
  result.reserve(alignment.links.size());
  for (const auto& own : alignment.links) {
    const auto& here = model[static_cast<std::size_t>(own.model)].whole;
    float weight = kDoubt;
    float x = 0;
    float y = 0;
    float length_weight = kLengthDoubt;
    float length_log = 0;
    for (const auto& other : alignment.links) {
      if (&other == &own) continue;
      const auto& there = model[static_cast<std::size_t>(other.model)].whole;
      const float dx = there.centre_x - here.centre_x;
      const float dy = there.centre_y - here.centre_y;
      const float slip = 1 + other.difference.cost / kStrange;
      const float w = std::exp(-(dx * dx + dy * dy) / (2 * kReach * kReach)) / (slip * slip);
      weight += w;
      x += w * other.difference.offset_x;
      y += w * other.difference.offset_y;
      const float v = std::min(there.length / kLong, 1.0F) / (slip * slip);
      length_weight += v;
      length_log += v * other.difference.length_log;
    }
    result.push_back({own.difference.offset_x - x / weight, own.difference.offset_y - y / weight,
                      own.difference.length_log - length_log / length_weight});
  }
  return result;
}

}  // namespace nazori::writing
