// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/tuft_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nazori::brush {
namespace {

constexpr std::array kShaft_m{0.015, 0.0145, 0.013, 0.011, 0.010, 0.0085};
constexpr std::array kHairPerShaft{4.0, 5.0, 6.75};
constexpr double kNumber4Shaft_m = 0.011;

struct HairKind {
  double stiffness_n_m2;  // of a No. 4
  double paper;           // friction, wet
  double keeps_rad;       // wet
};
constexpr std::array kHair{HairKind{1e-4, 0.30, 0.16}, HairKind{2e-4, 0.28, 0.12},
                           HairKind{3e-4, 0.25, 0.06}};

constexpr double kRootPerShaft = 0.40;  // radius of the tuft: it is a little thinner than the shaft
constexpr double kPressedFlat = 0.35;   // height of the middle of the tuft over the paper, of its radius
// Ink is held between the hairs, in about half the length, where the tuft is a cone and half of it is hair.
constexpr double kHeldShare = 0.5 * 0.5 / 3;

}  // namespace

SpineFriction TuftForm::friction(double wetness) const {
  const double w = std::clamp(wetness, 0.0, 1.0);
  const auto mix = [w](double with, double without) { return w * with + (1 - w) * without; };
  SpineFriction made = wet;
  made.paper = mix(wet.paper, dry.paper);
  made.keeps_rad = mix(wet.keeps_rad, dry.keeps_rad);
  made.yield_rad = mix(wet.yield_rad, dry.yield_rad);
  made.inner_share = mix(wet.inner_share, dry.inner_share);
  return made;
}

base::Result<TuftForm> tuft_form(int number, Hair hair, HairLength length) {
  if (number < kThickestBrush || number > kThinnestBrush)
    return base::fail(base::Errc::bad_argument,
                      fmt::format("there is no brush No. {}; brushes have the numbers {} to {}", number,
                                  kThickestBrush, kThinnestBrush),
                      "brush");
  const HairKind& kind = kHair[static_cast<std::size_t>(hair)];
  TuftForm form;
  form.shaft_m = kShaft_m[static_cast<std::size_t>(number - 1)];
  form.hair_m = form.shaft_m * kHairPerShaft[static_cast<std::size_t>(length)];
  form.root_radius_m = kRootPerShaft * form.shaft_m;
  // The number of hairs grows with the cross-section, and loose hairs bend each for itself.
  const double thick = form.shaft_m / kNumber4Shaft_m;
  form.stiffness_n_m2 = kind.stiffness_n_m2 * thick * thick;
  form.holds_m3 = kHeldShare * std::numbers::pi * form.root_radius_m * form.root_radius_m * form.hair_m;
  form.spine.segments = 6;
  form.spine.tip_segment = 0.5;
  form.spine.taper = 0.1;
  form.spine.taper_power = 2;
  form.spine.thickness = kPressedFlat * form.root_radius_m / form.hair_m;
  form.wet.paper = kind.paper;
  form.wet.along_hair = 0.4;
  form.wet.exponent = 2;
  form.wet.yield_rad = 0.15;
  form.wet.keeps_rad = kind.keeps_rad;
  form.wet.inner_share = 0.10;
  form.wet.inner_rad = 0.02;
  form.dry = form.wet;
  form.dry.paper = 1.3 * kind.paper;
  form.dry.keeps_rad = 0.3 * kind.keeps_rad;
  form.dry.yield_rad = 0.25;
  form.dry.inner_share = 0.20;
  return form;
}

}  // namespace nazori::brush
