// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::paint {

/// A value for red, green and blue light each. Reflectances are linear, 0 (black) to 1.
using Bands = std::array<double, 3>;

/// A colour as a screen takes it: sRGB, 8 bits.
struct ScreenColour {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const ScreenColour&, const ScreenColour&) = default;
};

/// What a pigment does to light and how it goes with the water.
struct Pigment {
  std::string name = "sumi";
  Bands absorption{};      ///< K of one kOne of it, 0..100
  Bands scattering{};      ///< S of one kOne of it, 0..100
  double mobility = 1;     ///< speed beside that of the water, 0..1
  double granulation = 0;  ///< how much of the paper's granulation acts on it, 0..1

  friend bool operator==(const Pigment&, const Pigment&) = default;
};

/// The pigments that Nazori knows: sumi from blue to brown, vermilion, and pigments for painting.
/// @source K and S of quinacridone rose to French ultramarine: C. Curtis et al., Computer-Generated
/// Watercolor, SIGGRAPH 1997, figure 5. Sumi, vermilion and white were chosen by eye.
[[nodiscard]] std::span<const Pigment> pigments();
/// @return Errc::not_found with the names.
[[nodiscard]] base::Result<Pigment> find_pigment(std::string_view name);

/// A layer of paint over nothing: what it reflects and what it lets through, 0..1 each.
struct Layer {
  double reflected = 0;
  double transmitted = 1;
};

/// The layer of Kubelka and Munk. @param kx,sx  absorption and scattering times thickness, >= 0.
[[nodiscard]] Layer layer_of(double kx, double sx);
/// One layer over another one. @source Kubelka 1948: R1 + T1^2 R2 / (1 - R1 R2), T1 T2 / (1 - R1 R2).
[[nodiscard]] Layer over(Layer upper, Layer lower);
/// What a layer over a ground reflects, inside the paint.
[[nodiscard]] double reflectance_over(Layer layer, double ground);
/// What a layer over a ground reflects, in closed form: (1 - Rg (a - b coth bSx)) / (a - Rg + b coth bSx).
/// @param sx  > 0. The test compares it with reflectance_over(). @source Kubelka 1948.
[[nodiscard]] double reflectance_in_closed_form(double kx, double sx, double ground);
/// What an endless layer reflects: 1 + K/S - sqrt((K/S)^2 + 2 K/S).
[[nodiscard]] double reflectance_of_endless(double k_over_s);

/// Reflection at the boundary between paint and air. @source J. L. Saunderson 1942; k1 = 0.035, k2 = 0.6.
[[nodiscard]] double seen_from_inside(double inside);
/// The inverse of seen_from_inside().
[[nodiscard]] double inside_from_seen(double seen);

/// The screen's value for linear light; below 0 counts as 0, above 1 as 1. @source IEC 61966-2-1.
[[nodiscard]] std::uint8_t to_screen(double linear);

}  // namespace nazori::paint
