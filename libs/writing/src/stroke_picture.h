// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace nazori::writing {

/// A histogram of line slants by position: 8 x 8 cells, 4 slants. It does not depend on the order or
/// direction of strokes or on where the pen was lifted.
/// @source the directional features of F. Kimura et al., "Modified quadratic discriminant functions and the
/// application to Chinese character recognition", IEEE PAMI 9 (1987), here from lines instead of pixels.
inline constexpr std::size_t kPictureCells = 8;
inline constexpr std::size_t kPictureSlants = 4;
using Picture = std::array<float, kPictureCells * kPictureCells * kPictureSlants>;

/// The points of a stroke, x and y alternating.
using FlatLine = std::span<const float>;

/// Picture of the strokes, of length 1 (all zero for strokes without length). Position, size and, within
/// limits, aspect are normalised.
[[nodiscard]] Picture make_picture(std::span<const FlatLine> strokes);

[[nodiscard]] float likeness(const Picture& a, const Picture& b);

}  // namespace nazori::writing
