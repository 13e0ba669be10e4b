// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "nazori/view/tablet_view.h"

namespace nazori::view {

/// An sRGB colour, each channel 0..1.
using Colour = glm::vec3;

/// "0xB5301F" as a colour.
[[nodiscard]] constexpr Colour from_hex(std::uint32_t rgb) {
  return {static_cast<float>((rgb >> 16) & 0xFF) / 255.0F, static_cast<float>((rgb >> 8) & 0xFF) / 255.0F,
          static_cast<float>(rgb & 0xFF) / 255.0F};
}

/// Every colour of a picture that is not a material.
struct Palette {
  Colour background;
  float shadow;        ///< darkness of the board's shadow on the table, 0..1
  Colour ink;          ///< a finished stroke, without lighting
  Colour current_ink;  ///< the current stroke's
  float ink_gloss;     ///< how much the light shines back from wet ink
  Colour stroke;       ///< centre line and arrowheads
  Colour current_stroke;
  Colour stroke_edge;  ///< thin outline that keeps lines and heads apart from the ground
  Colour disc;         ///< behind a stroke number
  Colour disc_edge;
  Colour number;
  Colour current_disc;
  Colour current_number;
  Colour device;  ///< the faint device point and its thread
};

/// Colours of writing by verdict; each at least 3 : 1 against the face of the tablet, its sign at least 4.5 :
/// 1 against the sign's ground.
struct WritingColours {
  Colour unjudged;
  Colour nearly;
  Colour wrong;
  Colour shown;
  Colour ground_of_sign;
};

[[nodiscard]] const WritingColours& writing_colours(Style style, Theme theme);

[[nodiscard]] const Palette& palette(Style style, Theme theme);

}  // namespace nazori::view
