// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "nazori/view/tablet_view.h"
#include "noise.h"

namespace nazori::view {

/// What the material is like along a line straight down from a point of the face. It takes most of the time
/// of a colour, and is the same for every character.
struct Grain {
  float across_m = 0;  ///< from the axis of the rings, sideways; wood only
  float cloud = 0;     ///< of the broad patches, 0 their mean for wood, 0..1 for stone
  float detail = 1;    ///< factor of fibres and pores, or of crystals
};

/// The material of the tablet: the colour of the substance at every point of its volume, so that a groove
/// cuts through the rings of the wood.
class Material {
 public:
  Material(Style style, Theme theme);

  /// @param point_m  on the face, in the frame of a tablet 0.1 m wide; other sizes are scaled to it by the
  /// caller.
  [[nodiscard]] Grain grain(glm::vec2 point_m) const;

  /// Linear reflectance under white light.
  /// @param grain  of the point's x and y.
  /// @param point_m  in the frame of grain().
  /// @param carved  how deep below the plateau, 0..1 of the groove's full depth.
  [[nodiscard]] glm::vec3 reflectance(const Grain& grain, glm::vec3 point_m, float carved) const;
  /// The same where the grain is not at hand.
  [[nodiscard]] glm::vec3 reflectance(glm::vec3 point_m, float carved) const {
    return reflectance(grain({point_m.x, point_m.y}), point_m, carved);
  }

 private:
  [[nodiscard]] glm::vec3 wood(const Grain& grain, glm::vec3 point_m) const;
  [[nodiscard]] glm::vec3 slate(const Grain& grain, glm::vec3 point_m, float carved) const;
  Style style_;
  glm::vec3 pale_;           ///< early wood, or the mean of the stone
  glm::vec3 deep_;           ///< late wood, or the stone's dark veins
  glm::vec3 fresh_;          ///< freshly cut stone
  NoiseLine tilt_{0.5F, 3};  ///< of the axis of the rings, along the board
};

/// sRGB's transfer function, in both directions, channel by channel. @source IEC 61966-2-1.
[[nodiscard]] glm::vec3 linear_from_srgb(glm::vec3 colour);
[[nodiscard]] float srgb_from_linear(float value);

}  // namespace nazori::view
