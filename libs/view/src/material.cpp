// SPDX-License-Identifier: Apache-2.0
#include "material.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "palette.h"
#include "rings.h"

namespace nazori::view {
namespace {

float linear_channel(float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); }

}  // namespace

glm::vec3 linear_from_srgb(glm::vec3 colour) {
  return {linear_channel(colour.x), linear_channel(colour.y), linear_channel(colour.z)};
}

float srgb_from_linear(float value) {
  return value <= 0.0031308F ? value * 12.92F : 1.055F * std::pow(value, 1 / 2.4F) - 0.055F;
}

Material::Material(Style style, Theme theme) : style_(style) {
  const bool light = theme == Theme::light;
  if (style == Style::slate) {
    pale_ = linear_from_srgb(light ? from_hex(0x5B646B) : from_hex(0x383D42));
    deep_ = linear_from_srgb(light ? from_hex(0x485057) : from_hex(0x2B2F33));
    fresh_ = linear_from_srgb(light ? from_hex(0x838C92) : from_hex(0x565C61));
  } else {
    pale_ = linear_from_srgb(light ? from_hex(0xF1DFBD) : from_hex(0x735B43));
    deep_ = linear_from_srgb(light ? from_hex(0xDDB989) : from_hex(0x563F2B));
    fresh_ = pale_;
  }
}

Grain Material::grain(glm::vec2 p) const {
  Grain grain;
  if (style_ == Style::slate) {
    grain.cloud = value_noise(p.x * 17, p.y * 17, 22) * 0.6F + value_noise(p.x * 55, p.y * 55, 23) * 0.4F;
    const float grit = value_noise(p.x * 2600, p.y * 2600, 24) - 0.5F;
    const float fine = value_noise(p.x * 900, p.y * 900, 25) - 0.5F;
    const float glint = smooth_step(0.972F, 1.0F, value_noise(p.x * 4100, p.y * 4100, 26));
    grain.detail = 1 + 0.16F * grit + 0.12F * fine + 0.35F * glint;
    return grain;
  }
  const float sway = (value_noise(p.x * 15, p.y * 8, 1) - 0.5F) * 0.0062F +
                     (value_noise(p.x * 55, p.y * 19, 2) - 0.5F) * 0.0012F;
  grain.across_m = p.x - 0.014F + sway;
  const float fibre = value_noise(p.x * 5200, p.y * 130, 6) - 0.5F;
  const float thread = value_noise(p.x * 1900, p.y * 42, 7) - 0.5F;
  grain.cloud = value_noise(p.x * 22, p.y * 12, 8) - 0.5F;
  const float pore = smooth_step(0.90F, 1.0F, value_noise(p.x * 3300, p.y * 210, 9));
  grain.detail = 1 + 0.075F * fibre + 0.055F * thread + 0.05F * grain.cloud - 0.07F * pore;
  return grain;
}

glm::vec3 Material::reflectance(const Grain& grain, glm::vec3 point_m, float carved) const {
  return style_ == Style::slate ? slate(grain, point_m, carved) : wood(grain, point_m);
}

/// A board sawn beside the pith: its rings are circles about an axis below the board that runs along y.
glm::vec3 Material::wood(const Grain& grain, glm::vec3 p) const {
  constexpr float kRing = 0.00215F;
  const float below = p.z + 0.030F + 0.085F * p.y + (tilt_.at(p.y * 11) - 0.5F) * 0.006F;
  const float late = Rings::shared().at(std::sqrt(grain.across_m * grain.across_m + below * below) / kRing);
  const glm::vec3 tone =
      glm::mix(pale_, deep_, std::clamp(late * 1.05F + grain.cloud * 0.18F + 0.04F, 0.0F, 1.0F));
  return tone * grain.detail;
}

/// Cleft stone: faint beds across, fine crystals, paler where it was cut.
glm::vec3 Material::slate(const Grain& grain, glm::vec3 p, float carved) const {
  const float bed = value_noise(p.x * 38 + p.y * 14, p.y * 90 - p.x * 24 + p.z * 300, 21);
  glm::vec3 tone = glm::mix(deep_, pale_, std::clamp(0.25F + 0.5F * grain.cloud + 0.35F * bed, 0.0F, 1.0F));
  tone = glm::mix(tone, fresh_, 0.75F * smooth_step(0.0F, 0.25F, carved));
  return tone * grain.detail;
}

}  // namespace nazori::view
