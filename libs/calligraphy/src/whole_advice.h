// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/calligraphy/advice.h"

namespace nazori::calligraphy {

/// A character beside its model, stroke by stroke.
struct WholePairs {
  RuledSquare square;
  std::vector<ModelStroke> model;
  std::vector<const BrushStroke*> written = {};  ///< one for each stroke of the model; null: missing
};

/// Adds what is about the whole character: widths, coverage, centre of gravity, size, gaps.
void add_whole_advice(const WholePairs& pairs, const SheetInk& ink, const AdviceOptions& options,
                      CharacterAdvice& result);

/// The middle of a stroke: half of its length.
[[nodiscard]] geometry::PaperPoint middle_of(const BrushStroke& stroke);
[[nodiscard]] geometry::PaperPoint middle_of(const ModelStroke& stroke);

/// From which side of which stroke a gap is measured: the strokes of the model that lie beside each other.
struct Neighbours {
  int first = 0, second = 0;    ///< of the model, from 0
  geometry::PaperPoint across;  ///< unit vector from the first to the second, across both
};
[[nodiscard]] std::vector<Neighbours> neighbours_in(const std::vector<ModelStroke>& model, double side_m);

}  // namespace nazori::calligraphy
