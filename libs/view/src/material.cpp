// SPDX-License-Identifier: Apache-2.0
#include "material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <span>

#include "palette.h"
#include "rings.h"

namespace nazori::view {
namespace {

float linear_channel(float c) { return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F); }

/// A value noise over the face: its waves a metre in both directions.
struct Wave {
  float across;
  float along;
  std::uint32_t seed;
};
constexpr std::array<Wave, 6> kWoodWaves{
    {{15, 8, 1}, {55, 19, 2}, {5200, 130, 6}, {1900, 42, 7}, {22, 12, 8}, {3300, 210, 9}}};
constexpr std::array<Wave, 5> kSlateWaves{
    {{17, 17, 22}, {55, 55, 23}, {2600, 2600, 24}, {900, 900, 25}, {4100, 4100, 26}}};

std::span<const Wave> waves_of(Style style) {
  if (style == Style::slate) return kSlateWaves;
  return kWoodWaves;
}

/// @param noise  noise(k) is the value of wave k at the point.
template <class Noise>
Grain grain_of(Style style, float x_m, const Noise& noise) {
  Grain grain;
  if (style == Style::slate) {
    grain.cloud = noise(0) * 0.6F + noise(1) * 0.4F;
    const float grit = noise(2) - 0.5F;
    const float fine = noise(3) - 0.5F;
    const float glint = smooth_step(0.972F, 1.0F, noise(4));
    grain.detail = 1 + 0.16F * grit + 0.12F * fine + 0.35F * glint;
    return grain;
  }
  const float sway = (noise(0) - 0.5F) * 0.0062F + (noise(1) - 0.5F) * 0.0012F;
  grain.across_m = x_m - 0.014F + sway;
  const float fibre = noise(2) - 0.5F;
  const float thread = noise(3) - 0.5F;
  grain.cloud = noise(4) - 0.5F;
  const float pore = smooth_step(0.90F, 1.0F, noise(5));
  grain.detail = 1 + 0.075F * fibre + 0.055F * thread + 0.05F * grain.cloud - 0.07F * pore;
  return grain;
}

}  // namespace

MaterialRow::MaterialRow(std::size_t most)
    : x_m(most),
      z_m(most),
      carved(most),
      across(most),
      cloud(most),
      detail(most),
      red(most),
      green(most),
      blue(most) {}

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
  const auto waves = waves_of(style_);
  return grain_of(style_, p.x, [&](std::size_t k) {
    return value_noise(p.x * waves[k].across, p.y * waves[k].along, waves[k].seed);
  });
}

GrainLine::GrainLine(Style style, float low_m, float high_m) : style_(style) {
  for (const Wave& wave : waves_of(style))
    lines_.emplace_back(0.0F, wave.seed, low_m * wave.across, high_m * wave.across);
}

void GrainLine::set_y(float y_m) {
  const auto waves = waves_of(style_);
  for (std::size_t k = 0; k < lines_.size(); ++k) lines_[k].set_y(y_m * waves[k].along);
}

Grain GrainLine::at(float x_m) const {
  const auto waves = waves_of(style_);
  return grain_of(style_, x_m, [&](std::size_t k) { return lines_[k].at(x_m * waves[k].across); });
}

glm::vec3 Material::reflectance(glm::vec3 point_m, float carved) const {
  MaterialRow row(1);
  row.y_m = point_m.y;
  row.count = 1;
  row.x_m[0] = point_m.x;
  row.z_m[0] = point_m.z;
  row.carved[0] = carved;
  row.set_grain(0, grain({point_m.x, point_m.y}));
  colour(row);
  return {row.red[0], row.green[0], row.blue[0]};
}

void Material::colour(MaterialRow& row) const {
  style_ == Style::slate ? colour_slate(row) : colour_wood(row);
}

/// A board sawn beside the pith: its rings are circles about an axis below the board that runs along y.
void Material::colour_wood(MaterialRow& row) const {
  constexpr float kRing = 0.00215F;
  const float axis = 0.030F + 0.085F * row.y_m + (tilt_.at(row.y_m * 11) - 0.5F) * 0.006F;
  // Loops of one kind of work each: the compiler turns all but the one with the table into vectors.
  float* share = row.green.data();
  for (std::size_t i = 0; i < row.count; ++i) {
    const float below = row.z_m[i] + axis;
    share[i] = std::sqrt(row.across[i] * row.across[i] + below * below) * (1 / kRing);
  }
  const Rings& rings = Rings::shared();
  for (std::size_t i = 0; i < row.count; ++i) share[i] = rings.at(share[i]);
  for (std::size_t i = 0; i < row.count; ++i) {
    const float late = std::clamp(share[i] * 1.05F + row.cloud[i] * 0.18F + 0.04F, 0.0F, 1.0F);
    row.red[i] = (pale_.x + (deep_.x - pale_.x) * late) * row.detail[i];
    row.blue[i] = (pale_.z + (deep_.z - pale_.z) * late) * row.detail[i];
    row.green[i] = (pale_.y + (deep_.y - pale_.y) * late) * row.detail[i];
  }
}

/// Cleft stone: faint beds across, fine crystals, paler where it was cut.
void Material::colour_slate(MaterialRow& row) const {
  const float y = row.y_m;
  for (std::size_t i = 0; i < row.count; ++i) {
    const float x = row.x_m[i];
    const float bed = value_noise(x * 38 + y * 14, y * 90 - x * 24 + row.z_m[i] * 300, 21);
    const float pale = std::clamp(0.25F + 0.5F * row.cloud[i] + 0.35F * bed, 0.0F, 1.0F);
    glm::vec3 tone = glm::mix(deep_, pale_, pale);
    tone = glm::mix(tone, fresh_, 0.75F * smooth_step(0.0F, 0.25F, row.carved[i])) * row.detail[i];
    row.red[i] = tone.x;
    row.green[i] = tone.y;
    row.blue[i] = tone.z;
  }
}

}  // namespace nazori::view
