// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

namespace nazori::writing::training {

struct Spot {
  float x = 0, y = 0;
};
using Line = std::vector<Spot>;
using Lines = std::vector<Line>;  // the strokes of a character, glyph units

/// The line as `count` points at equal steps.
[[nodiscard]] Line resampled(const Line& line, int count);

/// As somebody may draw it who copies the character: strokes moved, turned, bent, longer or shorter, without
/// their hooks, joined, missing or one too many, and the whole slanted, stretched and bent.
/// @param wildness 0 as printed; 1 a careless hand
[[nodiscard]] Lines distorted(const Lines& model, float wildness, std::mt19937& random);

}  // namespace nazori::writing::training
