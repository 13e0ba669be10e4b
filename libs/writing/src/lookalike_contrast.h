// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "model_inside.h"
#include "nazori/writing/model.h"

namespace nazori::writing {

/// The lookalike that was written instead of `asked`, and the stroke that shows it most.
struct Mistaken {
  char32_t character = 0;
  int stroke = 0;
};

[[nodiscard]] std::optional<Mistaken> mistaken_for(std::span<const Shape> drawn, const Form& asked,
                                                   std::span<const Model> lookalikes);

/// Distance of two forms with the same number of strokes after fitting, stroke by stroke in order: squared
/// deviations of ends and shapes in units of the natural variation. Infinite for another number of strokes.
[[nodiscard]] double distance_of_forms(const Form& a, const Form& b);

}  // namespace nazori::writing
