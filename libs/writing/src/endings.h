// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "alignment.h"
#include "model_inside.h"
#include "nazori/writing/grade.h"

namespace nazori::writing {

/// Missing hooks and unneeded hooks, of strokes matched one to one. Endings that are officially free, or of
/// which the source names two, are never among them.
[[nodiscard]] std::vector<Mistake> ending_mistakes(std::span<const Shape> drawn, const Alignment& alignment,
                                                   const Form& form);

}  // namespace nazori::writing
