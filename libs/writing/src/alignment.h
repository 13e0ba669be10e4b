// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "shape.h"
#include "stroke_difference.h"

namespace nazori::writing {

class StrokeComparer;

/// A drawn stroke (or two) and the model stroke (or two) that it is matched with.
struct Link {
  int drawn = 0;        ///< first drawn stroke
  int drawn_count = 1;  ///< 2: the model stroke was written in two pieces
  int model = 0;        ///< first model stroke
  int model_count = 1;  ///< 2: two strokes were written without lifting the pen
  StrokeDifference difference;
};

/// Which drawn stroke is which of the model.
struct Alignment {
  std::vector<Link> links;   ///< by drawn stroke
  std::vector<int> missing;  ///< model strokes without a drawn one
  std::vector<int> extra;    ///< drawn strokes without a model
  Affine map;                ///< ink to glyph frame
  float cost = 0;            ///< of the whole explanation; lower is likelier
};

/// How much of the model is expected.
enum class Extent {
  whole,      ///< all of the model was to be written
  beginning,  ///< the character is still being written: strokes after the last drawn one are not missing
};

struct AlignmentInput {
  std::span<const Shape> drawn;  ///< ink frame
  std::span<const Shape> model;  ///< glyph frame
  std::span<const Shape> pairs;  ///< of the model: strokes k and k + 1 joined, at k; empty: not considered
  std::optional<Affine> box;     ///< writing box to glyph frame
  Extent extent = Extent::whole;
};

/// The likeliest explanation of the drawn strokes; at least one drawn and one model stroke.
[[nodiscard]] Alignment align(const AlignmentInput& input);
[[nodiscard]] Alignment align(StrokeComparer& strokes, const std::optional<Affine>& box, Extent extent);
/// Each drawn stroke is the model's with the same number. @pre as many drawn strokes as the model's.
[[nodiscard]] Alignment align_in_order(StrokeComparer& strokes, const std::optional<Affine>& box);
/// Whether one of the strokes, taken in their order, is certainly wrong. @pre as many drawn strokes as the
/// model's.
[[nodiscard]] bool is_one_wrong_in_order(StrokeComparer& strokes, const std::optional<Affine>& box);
/// A faster approximation, for comparing many models: one starting point, two rounds. Models that cost far
/// more than `hopeless` after the first round are not examined again.
[[nodiscard]] Alignment align_roughly(const AlignmentInput& input, float hopeless);

}  // namespace nazori::writing
