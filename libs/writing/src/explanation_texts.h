// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "nazori/writing/explanation.h"

namespace nazori::writing {

/// The sentences, each with {0}, {1} ... for stroke numbers, characters or amounts.
enum class Text : std::uint8_t {
  right,
  right_other_order,
  right_other_form,
  order,
  comes_first,
  starts_top,
  starts_bottom,
  starts_left,
  starts_right,
  missing,
  one_missing,
  extra,
  joined,
  split,
  wrong_shape,
  wrong_direction,
  too_long,
  too_short,
  too_far_left,
  too_far_right,
  too_high,
  too_low,
  other_character,
  kick_missing,
  kick_needless,
  paused,
  hesitant,
  not_stopped,
  not_swept,
  kick_held,
  heavy_end,
  light_end,
  pace,
  points_for_strokes,
  points_for_order,
  points_for_direction,
  points_for_shape,
  points_for_place,
};

[[nodiscard]] std::string_view text(Text which, Language language);

}  // namespace nazori::writing
