// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "alignment.h"
#include "nazori/writing/grade.h"
#include "stroke_comparer.h"

namespace nazori::writing {

/// How one stroke differs from the model once the other strokes alone are laid over the model. A stroke that
/// is twice as long as it should be bends the laying over of all strokes to its own favour; it cannot bend
/// this one. Handwriting stretches and moves whole parts, so each figure is the smaller of two: the plain
/// one, and the one beside what the neighbours do.
struct StandingOut {
  float length_log = 0;  ///< natural logarithm of drawn by model length; the nearer of with and without kicks
  float whole_length_log = 0;  ///< the same with the kicks
  float turn_rad = 0;          ///< by which the stroke is turned, clockwise, -pi..pi
  float offset_x = 0;          ///< glyph units by which the centre is off
  float offset_y = 0;
};

/// A stroke that is so different from the others' scale that it is worth a word.
struct Conspicuous {
  std::size_t link = 0;
  Deviation deviation = Deviation::none;  ///< length, direction or place
  bool is_the_stroke = true;  ///< false: too short to be a stroke that somebody meant to be this one
  StandingOut by;
};

/// The strokes that stand out, the most conspicuous first; each is left out before the others are looked at
/// again. A stroke that was joined or split, or the only one, does not stand out. `tolerance` scales the
/// limits: 1 at normal strictness.
/// @source the limits: what 99 % of the strokes of three sets of real writing keep, docs/writing.md.
[[nodiscard]] std::vector<Conspicuous> conspicuous_strokes(StrokeComparer& strokes,
                                                           std::span<const Link> links, const Affine& map,
                                                           double tolerance);

}  // namespace nazori::writing
