// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "finder_net.h"
#include "known_characters.h"
#include "nazori/writing/recogniser.h"
#include "quick_strokes.h"
#include "shape.h"
#include "stroke_picture.h"

namespace nazori::writing {

/// The drawn strokes in all forms needed for comparison.
struct Drawn {
  std::vector<Shape> shapes;
  QuickDrawing points;
  Picture picture{};
  Embedding embedding{};
  InkPoints ink;
  double extent =
      0;  ///< larger side of the drawing, in glyph units of its writing box; 0 where that is unknown
};

[[nodiscard]] Drawn look_at(const WrittenCharacter& ink);

/// A character worth a closer comparison.
struct Listed {
  std::size_t character = 0;  ///< index
  float likeness = 0;         ///< of its form that the net finds most similar
};

/// Selected by the net, and by three points of each stroke in order, also with one stroke missing or extra;
/// of unfinished drawings by their picture instead of the net. The most similar first.
[[nodiscard]] std::vector<Listed> shortlist(const KnownCharacters& known, const Drawn& drawn,
                                            const RecogniseOptions& options);

}  // namespace nazori::writing
