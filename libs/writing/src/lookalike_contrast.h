// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "model_inside.h"
#include "nazori/writing/model.h"

namespace nazori::writing {

/// Which of the lookalikes was written rather than `asked`, and the stroke that shows it most.
struct Mistaken {
  char32_t character = 0;
  int stroke = 0;
};

[[nodiscard]] std::optional<Mistaken> mistaken_for(std::span<const Shape> drawn, const Form& asked,
                                                   std::span<const Model> lookalikes);

/// How far apart two forms with as many strokes are once laid over each other, stroke by stroke in order:
/// squared deviations of ends and shapes in units of what is natural. Infinite for another number of strokes.
[[nodiscard]] double distance_of_forms(const Form& a, const Form& b);

}  // namespace nazori::writing
