// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include "nazori/view/tablet_view.h"

namespace nazori::view {

/// The material of the tablet: the colour of the substance at every point of its volume, so that a groove
/// cuts through the rings of the wood.
class Material {
 public:
  Material(Style style, Theme theme);

  /// Linear reflectance under white light.
  /// @param point_m  in the frame of a tablet 0.1 m wide; other sizes are scaled to it by the caller.
  /// @param carved  how deep below the plateau, 0..1 of the groove's full depth.
  [[nodiscard]] glm::vec3 reflectance(glm::vec3 point_m, float carved) const;

 private:
  [[nodiscard]] glm::vec3 wood(glm::vec3 point_m) const;
  [[nodiscard]] glm::vec3 slate(glm::vec3 point_m, float carved) const;
  Style style_;
  glm::vec3 pale_;   ///< early wood, or the mean of the stone
  glm::vec3 deep_;   ///< late wood, or the stone's dark veins
  glm::vec3 fresh_;  ///< freshly cut stone
};

/// sRGB's transfer function, in both directions, channel by channel. @source IEC 61966-2-1.
[[nodiscard]] glm::vec3 linear_from_srgb(glm::vec3 colour);
[[nodiscard]] float srgb_from_linear(float value);

}  // namespace nazori::view
