// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/base/result.h"
#include "nazori/writing/model.h"
#include "nazori/writing/written_character.h"

namespace nazori::writing {

/// How ink compares with a model where only the ink is known: a photograph shows neither order and direction
/// of strokes, nor where one ends and the next begins.
struct InkShape {
  std::vector<double> covered;  ///< for each stroke of the model the share of it where ink lies, 0..1
  double missing = 0;           ///< share of the model's whole length without ink
  double extra = 0;             ///< share of the ink's length that lies on no stroke of the model
  double size = 1;              ///< ratio of the larger side of the ink to the model's, in the box
  double offset_x = 0;  ///< distance of the ink's middle to the right of the model's, in sides of the box
  double offset_y = 0;  ///< the same, down
  double lean_rad = 0;  ///< by which the ink as a whole is turned, clockwise
};

/// Compares ink with the model in its box, each form of the model, and returns the most similar. Ink within a
/// twelfth of the character's size and of a similar slant covers; before that the ink is laid over the model.
/// Thread-safe.
/// @pre ink.box
/// @return the errors of check(ink); Errc::bad_argument without a box.
[[nodiscard]] base::Result<InkShape> compare_ink(const WrittenCharacter& ink, const Model& model);

}  // namespace nazori::writing
