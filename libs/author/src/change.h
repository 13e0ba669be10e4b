// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nazori/author/character_editor.h"

namespace nazori::author {

/// Strokes [first, first + count) are replaced by those that are held.
struct StrokesChange {
  std::size_t first = 0;
  std::size_t count = 0;
  std::vector<OwnStroke> held;
  friend bool operator==(const StrokesChange&, const StrokesChange&) = default;
};

/// The samples of a box of the hand's layer.
struct PatchChange {
  carving::GridBox box;
  int size = 0;                ///< of the layer
  std::vector<float> heights;  ///< row by row; empty: the whole layer becomes untouched
  friend bool operator==(const PatchChange&, const PatchChange&) = default;
};

/// One change of a character: what is not there at present. To do it and to undo it is the same: what is held
/// here and what is in the character change places.
struct Change {
  using Strokes = StrokesChange;
  using Patch = PatchChange;

  EditKind kind = EditKind::none;
  std::size_t stroke = 0;  ///< what is dragged
  std::size_t point = 0;
  std::optional<Strokes> strokes = {};
  std::optional<Facts> facts = {};
  std::optional<Patch> patch = {};
  std::optional<HandLayer> layer = {};  ///< the whole layer
  friend bool operator==(const Change&, const Change&) = default;
};

/// Memory of a change, about [bytes].
[[nodiscard]] std::size_t bytes_of(const Change& change);

/// Exchanges what a change holds and what is in the character. @param size  of the map. @return the samples
/// that changed.
carving::GridBox exchange(Change& change, OwnCharacter& character, int size);

}  // namespace nazori::author
