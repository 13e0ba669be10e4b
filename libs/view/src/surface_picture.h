// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "nazori/view/tablet_view.h"

namespace nazori::view {

/// The tablet's face as a picture: colour with its light and shadow already in it, since the light stands
/// still relative to the tablet. Drawing then costs one texture look-up per pixel.
struct SurfacePicture {
  int size = 0;                       ///< texels a side
  int rim = 0;                        ///< texels of rim on every side; the map's lattice spans the rest
  std::vector<std::uint8_t> rgba;     ///< sRGB colour; alpha is the light that falls there, over kLightRange
  std::vector<std::uint8_t> heights;  ///< height of each texel, 255 the plateau
};

/// Alpha 255 stands for this much light (1 is what the plateau gets), gamma-coded like the colours.
inline constexpr float kLightRange = 1.6F;

/// From the tablet to its light; unit length.
[[nodiscard]] glm::vec3 light_direction(Hand hand);

/// Light on a surface that nothing shades, 1 on the plateau. @param normal  unit length, tablet frame.
[[nodiscard]] float open_light(glm::vec3 normal, Hand hand);

/// Wood or slate, lit. Shaded at 1,024 samples a side for maps up to that size, above that at up to 2,048.
/// @param map  loaded.
[[nodiscard]] SurfacePicture lit_picture(const surface::HeightMap& map, const geometry::TabletShape& shape,
                                         Style style, Theme theme, Hand hand);

/// 2005: grey by height, no light, no rim.
[[nodiscard]] SurfacePicture grey_picture(const surface::HeightMap& map);

}  // namespace nazori::view
