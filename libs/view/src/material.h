// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

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

/// Points of the material in one row of the face, and their colour. Each vector has a value for each point.
/// All points are in the frame of a tablet 0.1 m wide; other sizes are scaled to it by the caller.
struct MaterialRow {
  explicit MaterialRow(std::size_t most);

  float y_m = 0;
  std::size_t count = 0;  ///< points in use
  std::vector<float> x_m;
  std::vector<float> z_m;     ///< 0 on the plateau, negative below
  std::vector<float> carved;  ///< how deep below the plateau, 0..1 of the groove's full depth
  std::vector<float> across;  ///< of the Grain of the point, as the next two
  std::vector<float> cloud;
  std::vector<float> detail;
  std::vector<float> red;  ///< linear reflectance under white light, as the next two
  std::vector<float> green;
  std::vector<float> blue;

  void set_grain(std::size_t point, const Grain& grain) {
    across[point] = grain.across_m;
    cloud[point] = grain.cloud;
    detail[point] = grain.detail;
  }
};

/// The material of the tablet: the colour of the substance at every point of its volume, so that a groove
/// cuts through the rings of the wood.
class Material {
 public:
  Material(Style style, Theme theme);

  /// @param point_m  on the face, in the frame of MaterialRow.
  [[nodiscard]] Grain grain(glm::vec2 point_m) const;

  /// Fills red, green and blue from the rest.
  void colour(MaterialRow& row) const;
  /// The same for one point.
  [[nodiscard]] glm::vec3 reflectance(glm::vec3 point_m, float carved) const;

 private:
  void colour_wood(MaterialRow& row) const;
  void colour_slate(MaterialRow& row) const;
  Style style_;
  glm::vec3 pale_;           ///< early wood, or the mean of the stone
  glm::vec3 deep_;           ///< late wood, or the stone's dark veins
  glm::vec3 fresh_;          ///< freshly cut stone
  NoiseLine tilt_{0.5F, 3};  ///< of the axis of the rings, along the board
};

/// Material::grain along rows of the face, for a quarter of the time.
class GrainLine {
 public:
  /// @param low_m,high_m  the ends of the rows, in x.
  GrainLine(Style style, float low_m, float high_m);
  void set_y(float y_m);
  [[nodiscard]] Grain at(float x_m) const;

 private:
  Style style_;
  std::vector<NoiseLine> lines_;
};

/// sRGB's transfer function, in both directions, channel by channel. @source IEC 61966-2-1.
[[nodiscard]] glm::vec3 linear_from_srgb(glm::vec3 colour);
[[nodiscard]] float srgb_from_linear(float value);

}  // namespace nazori::view
