// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "nazori/practice/chart.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {

/// The look of a strength in the grid of characters. The lightness of the fill alone shows how well a
/// character is known.
struct StrengthLook {
  Colour fill;
  Colour text;
  char32_t sign = 0;    ///< ◔ ◑ ● ! ‖; 0: none, not studied
  bool dashed = false;  ///< the edge is dashed: not studied or suspended
};
[[nodiscard]] StrengthLook look_of(study::Strength strength);

/// The length of the bar on a tile, 0..1; 0: no bar.
[[nodiscard]] double bar_of(study::Strength strength);

/// The characters of a list with their states; a character without statistics is `unseen`.
[[nodiscard]] std::vector<study::CharacterState> states_of(std::span<const char32_t> characters,
                                                           const study::Statistics& statistics);

/// The number of characters of each strength, the best known first; strengths without characters are left
/// out.
[[nodiscard]] std::vector<std::pair<study::Strength, int>> count_by_strength(
    std::span<const study::CharacterState> states);

}  // namespace nazori::practice
