// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/plate.h"

namespace nazori::model {

/// The closed lines around all that lies lower than a height, read linearly between the samples. Around a low
/// area they run counter-clockwise, around a high area inside it clockwise. Beyond the plate nothing is low.
/// @param height_mm  above the table.
[[nodiscard]] std::vector<PlateLine> contours(const Plate& plate, double height_mm);

/// Number of layers in a file for a laser.
inline constexpr int kFewestLayers = 1;
inline constexpr int kMostLayers = 64;

/// A drawing for a laser, in its true size in millimetres: SVG with one layer for each step of depth, and a
/// layer with the outline and the holes as red lines to cut. Each layer has the area that lies at least as
/// deep as the middle of its step, in a grey that is darker the deeper it is. Burning the layers one after
/// another, each one step deep, gives the relief to within half a step; so does burning the picture by its
/// grey.
/// @param name  of the drawing.
/// @return Errc::bad_argument for a number of layers out of range, or a plate without a groove.
[[nodiscard]] base::Result<std::string> to_laser_svg(const Plate& plate, int layers, std::string_view name);

}  // namespace nazori::model
