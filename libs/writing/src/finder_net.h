// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ink_field.h"

namespace nazori::writing {

/// Sizes of the net: two layers of 3 x 3 patches, two cells apart, and one that sees all.
inline constexpr std::size_t kNetFirst = 16;
inline constexpr std::size_t kNetSecond = 48;
inline constexpr std::size_t kNetOut = 128;
inline constexpr std::size_t kNetDense = kFieldCells / 4 * (kFieldCells / 4) * kNetSecond + kFieldSums;

/// What the net makes of a field: a direction, of length 1. Drawings of the same character have similar ones.
using Embedding = std::array<float, kNetOut>;

/// Weights of the layers: for each number that comes in, its part in each that goes out; then the constants.
struct NetWeights {
  std::vector<float> first;   // (9 x slants + 1) x kNetFirst
  std::vector<float> second;  // (9 x kNetFirst + 1) x kNetSecond
  std::vector<float> dense;   // (kNetDense + 1) x kNetOut
};

/// Weights from their file: for each layer, the scale of each outgoing number as a little-endian float and
/// then all weights as signed bytes. Nothing where the size is wrong.
[[nodiscard]] NetWeights read_weights(std::span<const unsigned char> bytes);

[[nodiscard]] Embedding embed(const NetWeights& weights, const InkField& field);

/// The trained weights; made at the first call, from any thread.
[[nodiscard]] const NetWeights& trained_weights();

/// Cosine of the angle between them.
[[nodiscard]] float likeness(const Embedding& a, const Embedding& b);

}  // namespace nazori::writing
