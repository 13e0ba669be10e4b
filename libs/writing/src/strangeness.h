// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "judgement.h"

namespace nazori::writing {

/// How many numbers describe a stroke to the trees: 37 that are measured, 3 times 8 points, and 18 that place
/// it among the other strokes of the hand.
inline constexpr std::size_t kStrokeFeatures = 37 + 3 * 8 * 2 + 18;
using StrokeFeatures = std::array<float, kStrokeFeatures>;

/// What is known of each stroke of a writing: how it differs from the model's, how rough the other strokes of
/// the same hand are, and both shapes. training/train_stroke_trees.py reads them in this order.
/// @param of_model  how many strokes the model has
/// @param map  that lays the drawing over the model
[[nodiscard]] std::vector<StrokeFeatures> stroke_features(std::span<const JudgedStroke> strokes,
                                                          std::size_t of_model, const Affine& map = {});

/// How strange a stroke is: 1 at the limit of normal strictness. It is what decision trees have learned from
/// real strokes and strange ones in their places. Any thread.
/// @param used_freedom  that of the judged stroke
[[nodiscard]] double strangeness(const StrokeFeatures& stroke, double used_freedom);

}  // namespace nazori::writing
