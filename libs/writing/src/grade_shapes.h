// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "alignment.h"
#include "model_inside.h"
#include "nazori/writing/grade.h"
#include "shape.h"

namespace nazori::writing {

/// Ink that was checked, ready to be compared.
struct Prepared {
  std::vector<Shape> drawn;
  std::optional<Affine> box;
};

/// @return the errors of grade().
[[nodiscard]] base::Result<Prepared> prepare(const WrittenCharacter& ink, const GradeOptions& options);

/// Judges strokes against all forms of a model. @param drawn  all strokes, or the first ones of a beginning.
[[nodiscard]] Grade grade_shapes(std::span<const Shape> drawn, const std::optional<Affine>& box,
                                 const ModelInside& model, const GradeOptions& options,
                                 std::span<const Model> lookalikes);

}  // namespace nazori::writing
