// SPDX-License-Identifier: Apache-2.0
#include "surface_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "material.h"
#include "projection.h"
#include "relief.h"

namespace nazori::view {
namespace {

constexpr int kShadedSize = 1024;
constexpr int kMaxShadedSize = 2048;
constexpr int kGreyMaxSize = 2048;
/// Ambient and key light; together 1 on the plateau.
constexpr float kAmbient = 0.36F;
constexpr float kKey = 1 - kAmbient;
/// Half the width of the shadow's edge, as a slope: the key light is a window, not a point.
constexpr float kShadowSoftness = 0.55F;
/// Nothing this high can be shaded by a plateau that is no higher.
constexpr float kOpenHeight = 0.998F;
constexpr std::array<float, 8> kReachSteps{1, 2, 4, 7, 11, 16, 23, 32};

/// How much of the key light and of the sky reaches each sample of a lattice.
struct Exposure {
  int size = 0;
  std::vector<float> key;
  std::vector<float> sky;
};

float sample_clamped(const Relief& relief, float column, float row) {
  const int last = relief.size - 1;
  return relief.at(std::clamp(static_cast<int>(column + 0.5F), 0, last),
                   std::clamp(static_cast<int>(row + 0.5F), 0, last));
}

/// Marches to the horizon: once towards the light, and eight ways for the sky.
Exposure make_exposure(const Relief& relief, const geometry::TabletShape& shape, Hand hand) {
  Exposure exposure;
  exposure.size = relief.size;
  exposure.key.assign(relief.heights.size(), 1.0F);
  exposure.sky.assign(relief.heights.size(), 1.0F);
  const float slope_per_step =
      static_cast<float>(shape.depth_m / shape.width_m * (relief.size - 1));  // height 1 over one sample
  const float stride = static_cast<float>(relief.size - 1) / 511.0F;
  const glm::vec3 light = light_direction(hand);
  const glm::vec2 towards = glm::normalize(glm::vec2(light.x, -light.y));
  const float light_slope = light.z / glm::length(glm::vec2(light.x, light.y));
  std::array<glm::vec2, 8> ways{};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double angle = (static_cast<double>(i) + 0.5) * std::numbers::pi / 4;
    ways[i] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
  }
  for (int row = 0; row < relief.size; ++row) {
    for (int column = 0; column < relief.size; ++column) {
      const float height = relief.at(column, row);
      if (height >= kOpenHeight) continue;
      const std::size_t place = static_cast<std::size_t>(row) * static_cast<std::size_t>(relief.size) +
                                static_cast<std::size_t>(column);
      const glm::vec2 here(column, row);
      float blocked = 0;
      const float farthest = (1 - height) * slope_per_step / (light_slope - kShadowSoftness * 0.9F);
      for (float t = stride; t <= farthest; t += stride * 1.5F) {
        const glm::vec2 there = here + towards * t;
        blocked = std::max(blocked, (sample_clamped(relief, there.x, there.y) - height) / t);
      }
      const float edge = (blocked * slope_per_step - light_slope) / (2 * kShadowSoftness) + 0.5F;
      const float dark = std::clamp(edge, 0.0F, 1.0F);
      exposure.key[place] = 1 - dark * dark * (3 - 2 * dark);
      float open = 0;
      for (const glm::vec2 way : ways) {
        float horizon = 0;
        for (const float step : kReachSteps) {
          const float t = step * stride;
          const glm::vec2 there = here + way * t;
          horizon = std::max(horizon, (sample_clamped(relief, there.x, there.y) - height) / t);
        }
        const float slope = horizon * slope_per_step;
        open += 1 / (1 + slope * slope);
      }
      exposure.sky[place] = open / static_cast<float>(ways.size());
    }
  }
  return exposure;
}

/// Between the samples of a coarser lattice that spans the same square.
class Interpolation {
 public:
  Interpolation(int fine, int coarse)
      : coarse_(coarse), step_(static_cast<float>(coarse - 1) / static_cast<float>(fine - 1)) {}
  [[nodiscard]] float operator()(const std::vector<float>& values, int column, int row) const {
    const float x = static_cast<float>(column) * step_;
    const float y = static_cast<float>(row) * step_;
    const int i = std::min(static_cast<int>(x), coarse_ - 2);
    const int j = std::min(static_cast<int>(y), coarse_ - 2);
    const float u = x - static_cast<float>(i);
    const float v = y - static_cast<float>(j);
    const float* top = values.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(coarse_) + i;
    const float* low = top + coarse_;
    return (top[0] * (1 - u) + top[1] * u) * (1 - v) + (low[0] * (1 - u) + low[1] * u) * v;
  }

 private:
  int coarse_;
  float step_;
};

/// 8-bit sRGB of linear values 0..1 through a table.
class GammaCoder {
 public:
  GammaCoder() {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const float value = static_cast<float>(i) / static_cast<float>(table_.size() - 1);
      table_[i] = static_cast<std::uint8_t>(std::lround(srgb_from_linear(value) * 255));
    }
  }
  [[nodiscard]] std::uint8_t operator()(float linear) const {
    const float held = std::clamp(linear, 0.0F, 1.0F);
    return table_[static_cast<std::size_t>(held * static_cast<float>(table_.size() - 1) + 0.5F)];
  }

 private:
  std::array<std::uint8_t, 8192> table_{};
};

const GammaCoder& gamma_coder() {
  static const GammaCoder coder;
  return coder;
}

Relief halved(const Relief& relief) {
  Relief half;
  half.size = relief.size / 2;
  half.heights.reserve(static_cast<std::size_t>(half.size) * static_cast<std::size_t>(half.size));
  const Interpolation between(half.size, relief.size);
  for (int row = 0; row < half.size; ++row)
    for (int column = 0; column < half.size; ++column)
      half.heights.push_back(between(relief.heights, column, row));
  return half;
}

}  // namespace

glm::vec3 light_direction(Hand hand) {
  return glm::normalize(glm::vec3(hand == Hand::right ? -0.52F : 0.52F, 0.60F, 0.80F));
}

float open_light(glm::vec3 normal, Hand hand) {
  const glm::vec3 light = light_direction(hand);
  return kAmbient * (0.5F + 0.5F * normal.z) + kKey * std::max(glm::dot(normal, light), 0.0F) / light.z;
}

SurfacePicture lit_picture(const surface::HeightMap& map, const geometry::TabletShape& shape, Style style,
                           Theme theme, Hand hand) {
  const Relief relief = resampled(map, std::clamp(map.size(), kShadedSize, kMaxShadedSize));
  const int n = relief.size;
  const Relief coarse = halved(relief);
  const Exposure exposure = make_exposure(coarse, shape, hand);
  const Interpolation between(n, coarse.size);
  const Material material(style, theme);
  const GammaCoder& code = gamma_coder();
  const glm::vec3 light = light_direction(hand);

  SurfacePicture picture;
  picture.rim = static_cast<int>(std::lround(n * kRimFraction));
  picture.size = n + 2 * picture.rim;
  const auto texels = static_cast<std::size_t>(picture.size) * static_cast<std::size_t>(picture.size);
  picture.rgba.resize(texels * 4);
  picture.heights.resize(texels);
  const float step_m = 0.1F / static_cast<float>(n - 1);
  const float depth_m = 0.1F * static_cast<float>(shape.depth_m / shape.width_m);
  const float slope = depth_m / (2 * step_m);
  std::size_t out = 0;
  for (int y = 0; y < picture.size; ++y) {
    const int row = std::clamp(y - picture.rim, 0, n - 1);
    for (int x = 0; x < picture.size; ++x, ++out) {
      const int column = std::clamp(x - picture.rim, 0, n - 1);
      const bool on_rim = column != x - picture.rim || row != y - picture.rim;
      const float height = on_rim ? 1.0F : relief.at(column, row);
      const glm::vec3 point(static_cast<float>(x - picture.rim) * step_m - 0.05F,
                            0.05F - static_cast<float>(y - picture.rim) * step_m, (height - 1) * depth_m);
      float key = 1;
      float sky = 1;
      float facing = light.z;
      if (!on_rim) {
        const float dx =
            relief.at(std::min(column + 1, n - 1), row) - relief.at(std::max(column - 1, 0), row);
        const float dy =
            relief.at(column, std::max(row - 1, 0)) - relief.at(column, std::min(row + 1, n - 1));
        if (dx != 0 || dy != 0) {
          const glm::vec3 normal = glm::normalize(glm::vec3(-dx * slope, -dy * slope, 1));
          facing = std::max(glm::dot(normal, light), 0.0F);
        }
        if (height < kOpenHeight) {
          key = between(exposure.key, column, row);
          sky = between(exposure.sky, column, row);
        }
      }
      const float lit = kKey * key * facing / light.z;
      const float ambient = kAmbient * sky;
      const glm::vec3 albedo = material.reflectance(point, 1 - height);
      // Light that reaches a deep place has bounced off the walls and taken their colour.
      const glm::vec3 bounce = albedo * (kAmbient * (1 - sky) * 0.55F);
      const glm::vec3 colour =
          albedo * (glm::vec3(1.02F, 1.0F, 0.965F) * lit + glm::vec3(0.965F, 1.0F, 1.06F) * ambient + bounce);
      picture.rgba[out * 4] = code(colour.x);
      picture.rgba[out * 4 + 1] = code(colour.y);
      picture.rgba[out * 4 + 2] = code(colour.z);
      picture.rgba[out * 4 + 3] = code((lit + ambient) / kLightRange);
      picture.heights[out] = static_cast<std::uint8_t>(std::lround(height * 255));
    }
  }
  return picture;
}

SurfacePicture grey_picture(const surface::HeightMap& map) {
  const Relief relief = resampled(map, std::min(map.size(), kGreyMaxSize));
  SurfacePicture picture;
  picture.size = relief.size;
  picture.rgba.reserve(relief.heights.size() * 4);
  picture.heights.reserve(relief.heights.size());
  for (const float height : relief.heights) {
    const auto grey = static_cast<std::uint8_t>(std::lround(height * 255));
    picture.rgba.insert(picture.rgba.end(), {grey, grey, grey, 255});
    picture.heights.push_back(grey);
  }
  return picture;
}

}  // namespace nazori::view
