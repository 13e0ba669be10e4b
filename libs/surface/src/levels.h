// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nazori::surface {

/// The nearest of the levels 0..`top` to a height in [0, 1]. Not lround, because a call for each sample would
/// take longer than all other writing.
[[nodiscard]] inline unsigned level_of(float height, float top) {
  return static_cast<unsigned>(height * top + 0.5F);  // NOLINT(bugprone-incorrect-roundings)
}

}  // namespace nazori::surface
