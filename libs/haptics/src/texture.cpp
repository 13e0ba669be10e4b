// SPDX-License-Identifier: Apache-2.0
#include "texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace nazori::haptics {
namespace {

/// Pseudo-random value in -1..1 for a corner of the lattice.
double corner(std::int64_t i, std::int64_t j) noexcept {
  auto h = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15U ^
           static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fU;
  h = (h ^ (h >> 31U)) * 0xbf58476d1ce4e5b9U;
  h = (h ^ (h >> 29U)) * 0x94d049bb133111ebU;
  return static_cast<double>((h ^ (h >> 32U)) >> 11U) * 0x1p-52 - 1;
}

struct Slope {
  double x, y;
};

/// Gradient of value noise, with respect to the lattice's own coordinates; each part at most 3.75.
Slope noise_slope(double u, double v) noexcept {
  const double fu = std::floor(u), fv = std::floor(v);
  const auto i = static_cast<std::int64_t>(fu), j = static_cast<std::int64_t>(fv);
  const double a = corner(i, j), b = corner(i + 1, j), c = corner(i, j + 1), d = corner(i + 1, j + 1);
  const double x = u - fu, y = v - fv;
  // Quintic blend: no step in the second derivative from cell to cell.
  const auto blend = [](double t) { return t * t * t * (t * (6 * t - 15) + 10); };
  const auto rise = [](double t) { return 30 * t * t * (t * (t - 2) + 1); };
  const double bx = blend(x), by = blend(y), twist = a - b - c + d;
  return {rise(x) * (b - a + by * twist), rise(y) * (c - a + bx * twist)};
}

}  // namespace

Vec3 texture_slope(Texture texture, double x_m, double y_m) noexcept {
  constexpr double kPer = 1 / (3.75 * 1.4142135623730951);  // of the largest slope of one noise
  Slope slope{0, 0};
  switch (texture) {
    case Texture::none:
      return Vec3(0);
    case Texture::paper:
      slope = noise_slope(x_m / 0.0004, y_m / 0.0004);
      break;
    case Texture::wood: {
      // One height field stretched along the grain: its slope along it is smaller by the same ratio.
      const Slope grain = noise_slope(x_m / 0.012, y_m / 0.0006);
      slope = {grain.x * (0.0006 / 0.012), grain.y};
      break;
    }
    case Texture::stone: {
      const Slope coarse = noise_slope(x_m / 0.0014, y_m / 0.0014);
      const Slope grit = noise_slope(x_m / 0.0005 + 37.5, y_m / 0.0005 - 11.25);
      slope = {0.6 * coarse.x + 0.4 * grit.x, 0.6 * coarse.y + 0.4 * grit.y};
      break;
    }
  }
  constexpr double kScale = kSteepestTexture * kPer;
  return {kScale * slope.x, kScale * slope.y, 0};
}

Vec3 textured(const Vec3& force_n, const Vec3& normal, const Vec3& proxy_m, Texture texture,
              double roughness) noexcept {
  if (texture == Texture::none || !(roughness > 0)) return force_n;
  const double push = glm::dot(force_n, normal);
  if (push <= 0) return force_n;
  const Vec3 slope = roughness * texture_slope(texture, proxy_m.x, proxy_m.y);
  const Vec3 bumped = glm::normalize(normal - (slope - glm::dot(slope, normal) * normal));
  return force_n + push * (bumped - normal);
}

}  // namespace nazori::haptics
