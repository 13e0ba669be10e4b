// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "distance_map.h"
#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/scan/picture.h"
#include "nazori/surface/height_map.h"

namespace nazori::author {

/// Samples a side of every ink map.
inline constexpr int kInkSide = 512;
inline constexpr double kInkPerUnit = (kInkSide - 1) / geometry::kGlyphSide;
/// Paper on each side of the ink of a picture in its larger direction [glyph units].
inline constexpr double kInkMargin = 8;

/// Where the glyph box lies in the picture from which its ink comes.
struct PicturePlace {
  double left = 0;  ///< of the box [pixels]; centres of pixels are at whole numbers
  double top = 0;
  double pixels_per_unit = 1;
};

/// Ink or grooves in the glyph box: samples on the corners of a lattice from edge to edge, as in a height map
/// of kInkSide samples.
struct InkMap {
  std::vector<std::uint8_t> ink;  ///< 0 or 1; at least one is 1
  std::vector<float> level;  ///< how dark or deep, in parts of the least that counts as ink: 1 is the outline
  std::vector<float> depth;  ///< of the groove, fraction of the tablet's depth; 1 in ink of a picture
  DistanceMap distance;      ///< of `ink`
  bool is_groove = false;    ///< from a height map: depth says where the centre line is
  PicturePlace place = {};   ///< of a picture

  [[nodiscard]] std::size_t index(int x, int y) const { return distance.index(x, y); }
};

/// The value between samples; outside of the box that of its edge.
[[nodiscard]] float between(const std::vector<float>& values, geometry::GridPoint at);

/// Each value the mean of its neighbours, weighted by a bell of this standard deviation in samples.
void blur(std::vector<float>& values, int width, int height, double sigma);

/// The groove of a height map.
/// @return Errc::bad_argument without a map, without a groove, and where nearly all is groove.
[[nodiscard]] base::Result<InkMap> ink_of(const surface::HeightMap& map);

/// The ink of a picture in uneven light, its larger side fitted into the glyph box.
/// @return Errc::bad_argument for a picture without ink and one with nothing but ink.
[[nodiscard]] base::Result<InkMap> ink_of(const scan::Photo& photo);

}  // namespace nazori::author
