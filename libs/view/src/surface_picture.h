// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "material.h"
#include "nazori/view/tablet_view.h"

namespace nazori::view {

/// The settings of the tablet's look, apart from the camera.
struct Look {
  Style style = Style::wood;
  Theme theme = Theme::light;
  Hand hand = Hand::right;
  friend bool operator==(const Look&, const Look&) = default;
};

/// The tablet's face as a picture: colour with its light and shadow already in it, because the light is fixed
/// relative to the tablet. Drawing then costs one texture look-up per pixel.
struct SurfacePicture {
  int size = 0;                       ///< texels a side
  int rim = 0;                        ///< texels of rim on every side; the map's lattice spans the rest
  std::vector<std::uint8_t> rgba;     ///< sRGB colour; alpha is the light that falls there, over kLightRange
  std::vector<std::uint8_t> heights;  ///< height of each texel, 255 the plateau
};

/// Alpha 255 stands for this much light (1 is what the plateau gets), gamma-coded like the colours.
inline constexpr float kLightRange = 1.6F;

/// Direction from the tablet to its light; unit length.
[[nodiscard]] glm::vec3 light_direction(Hand hand);

/// Light on a surface that nothing shades, 1 on the plateau. @param normal  unit length, tablet frame.
[[nodiscard]] float open_light(glm::vec3 normal, Hand hand);

/// A Grain in half of its memory: a face keeps a million.
class KeptGrain {
 public:
  KeptGrain() = default;
  /// @param x_m  of the point, in the frame of MaterialRow.
  KeptGrain(const Grain& grain, float x_m)
      : sway_(kept((grain.across_m - x_m) / kSway_m)),
        cloud_(kept(grain.cloud / 2)),
        detail_(kept(grain.detail / 2)) {}
  [[nodiscard]] Grain at(float x_m) const {
    return {x_m + value(sway_) * kSway_m, value(cloud_) * 2, value(detail_) * 2};
  }

 private:
  /// The rings' axis lies this far aside at most, and so does what sways around it.
  static constexpr float kSway_m = 0.02F;
  [[nodiscard]] static std::int16_t kept(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32767));
  }
  [[nodiscard]] static float value(std::int16_t kept) { return static_cast<float>(kept) / 32767; }
  std::int16_t sway_ = 0;
  std::int16_t cloud_ = 0;
  std::int16_t detail_ = 0;
};

/// The face before anything is carved: costly to make, and the same for every character.
struct PlainFace {
  Look look;
  int size = 0;  ///< texels a side, rim included
  int rim = 0;
  std::vector<std::uint8_t> rgba;
  std::vector<KeptGrain> grain;  ///< below each texel, rim included
};

/// Samples a side at which a map is shaded: 1,024 for maps up to that size, above that up to 2,048.
[[nodiscard]] int shaded_size(int map_size);

/// @param samples  a side, without the rim.
[[nodiscard]] PlainFace make_plain_face(const Look& look, int samples);

/// The same, shared by all views of the program; the last two are cached. Any thread.
[[nodiscard]] std::shared_ptr<const PlainFace> shared_plain_face(const Look& look, int samples);

/// Wood or slate with its light, and shadow in the grooves. Only the carved part is computed.
/// @param map  loaded.  @param plain  of shaded_size(map.size()) samples.
[[nodiscard]] SurfacePicture lit_picture(const surface::HeightMap& map, const geometry::TabletShape& shape,
                                         const PlainFace& plain);

/// The classic look: grey by height, no light, no rim.
[[nodiscard]] SurfacePicture grey_picture(const surface::HeightMap& map);

}  // namespace nazori::view
