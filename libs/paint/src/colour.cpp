// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/colour.h"

#include <algorithm>
#include <cmath>

namespace nazori::paint {
namespace {

constexpr double kSurface = 0.035;  // Saunderson's k1: reflected before the light enters
constexpr double kInner = 0.6;      // k2: reflected back inside

Pigment pigment(std::string name, Bands absorption, Bands scattering, double mobility, double granulation) {
  return {std::move(name), absorption, scattering, mobility, granulation};
}

}  // namespace

std::span<const Pigment> pigments() {
  // Soot hardly scatters. Fine soot of pine looks bluish where it is thin, soot of oil brownish.
  static const std::array all{
      pigment("sumi", {4.2, 4.2, 4.2}, {0.02, 0.02, 0.02}, 0.9, 0.3),
      pigment("sumi-blue", {4.6, 4.2, 3.7}, {0.02, 0.022, 0.03}, 0.9, 0.4),
      pigment("sumi-brown", {3.8, 4.2, 4.8}, {0.03, 0.024, 0.02}, 0.9, 0.2),
      pigment("vermilion", {0.16, 2.2, 3.4}, {1.6, 0.12, 0.05}, 0.4, 0.5),
      pigment("white", {0.01, 0.01, 0.02}, {3, 3, 3}, 0.3, 0.2),
      pigment("quinacridone-rose", {0.22, 1.47, 0.57}, {0.05, 0.003, 0.03}, 0.9, 0.81),
      pigment("indian-red", {0.46, 1.07, 1.50}, {1.28, 0.38, 0.21}, 0.5, 0.40),
      pigment("cadmium-yellow", {0.10, 0.36, 3.45}, {0.97, 0.65, 0.007}, 0.5, 0.81),
      pigment("hookers-green", {1.62, 0.61, 1.64}, {0.01, 0.012, 0.003}, 0.8, 0.41),
      pigment("cerulean-blue", {1.52, 0.32, 0.25}, {0.06, 0.26, 0.40}, 0.6, 0.31),
      pigment("burnt-umber", {0.74, 1.54, 2.10}, {0.09, 0.09, 0.004}, 0.6, 0.90),
      pigment("french-ultramarine", {0.86, 0.86, 0.06}, {0.005, 0.005, 0.09}, 0.7, 0.91),
  };
  return all;
}

base::Result<Pigment> find_pigment(std::string_view name) {
  std::string names;
  for (const Pigment& known : pigments()) {
    if (known.name == name) return known;
    names.append(names.empty() ? "" : ", ").append(known.name);
  }
  return base::fail(base::Errc::not_found, "there is no such pigment", std::string(name),
                    "pigments are " + names);
}

Layer layer_of(double kx, double sx) {
  // b S x; the forms below also hold where a layer does not scatter or is not there.
  const double d = std::sqrt(kx * (kx + 2 * sx));
  constexpr double kThin = 1e-7, kOpaque = 300;
  if (d > kOpaque) return {sx / (kx + sx + d), 0};
  const double sinh_by_d = d < kThin ? 1 : std::sinh(d) / d;
  const double below = (kx + sx) * sinh_by_d + std::cosh(d);
  return {sx * sinh_by_d / below, 1 / below};
}

Layer over(Layer upper, Layer lower) {
  const double echo = 1 - upper.reflected * lower.reflected;
  return {upper.reflected + upper.transmitted * upper.transmitted * lower.reflected / echo,
          upper.transmitted * lower.transmitted / echo};
}

double reflectance_over(Layer layer, double ground) { return over(layer, {ground, 0}).reflected; }

double reflectance_in_closed_form(double kx, double sx, double ground) {
  const double a = 1 + kx / sx;
  const double b = std::sqrt(a * a - 1);
  const double coth = 1 / std::tanh(b * sx);
  return (1 - ground * (a - b * coth)) / (a - ground + b * coth);
}

double reflectance_of_endless(double k_over_s) {
  return 1 + k_over_s - std::sqrt(k_over_s * k_over_s + 2 * k_over_s);
}

double seen_from_inside(double inside) {
  return (1 - kSurface) * (1 - kInner) * inside / (1 - kInner * inside);
}

double inside_from_seen(double seen) { return seen / ((1 - kSurface) * (1 - kInner) + kInner * seen); }

std::uint8_t to_screen(double linear) {
  const double light = std::clamp(linear, 0.0, 1.0);
  const double coded = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(coded * 255));
}

}  // namespace nazori::paint
