// SPDX-License-Identifier: Apache-2.0
#include "surface_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <mutex>
#include <numbers>

#include "material.h"
#include "nazori/base/bands.h"
#include "projection.h"
#include "relief.h"

namespace nazori::view {
namespace {

constexpr int kShadedSize = 1024;
constexpr int kMaxShadedSize = 2048;
constexpr int kGreyMaxSize = 2048;
/// Ambient and key light; together 1 on the plateau.
constexpr float kAmbient = 0.40F;
constexpr float kKey = 1 - kAmbient;
constexpr glm::vec3 kKeyTint{1.02F, 1.0F, 0.965F};
constexpr glm::vec3 kSkyTint{0.985F, 1.0F, 1.025F};
/// Light between the walls of a groove that sees no sky.
constexpr float kBounce = 0.42F;
/// Grooves are shaded as if they were this much shallower: true shadows would hide their floors.
constexpr float kShadeDepth = 0.55F;
/// Half the width of the shadow's edge, as a slope: the key light is a window, not a point.
constexpr float kShadowSoftness = 0.55F;
/// From this height on the face is drawn as not carved: a thousandth of the depth is not visible.
constexpr float kPlainHeight = 0.9995F;
/// Samples this high cannot be in the shadow of the plateau.
constexpr float kOpenHeight = 0.998F;
constexpr std::array<float, 8> kReachSteps{1, 2, 4, 7, 11, 16, 23, 32};

/// How much of the key light and of the sky reaches each sample of a lattice.
struct Exposure {
  int size = 0;
  std::vector<float> key;
  std::vector<float> sky;
};

/// Runs `work(first, last)` over the rows of a picture on a few threads.
template <class Work>
void in_bands(int rows, const Work& work) {
  const base::Bands bands(rows, 1);
  bands.run([&](int band) { work(bands.first(band), bands.last(band)); });
}

/// Steps from a sample outwards, and how much higher the samples there stand, by their distance.
class Ray {
 public:
  /// @param way  unit length, in samples.  @param distances  in samples, ascending.
  Ray(glm::vec2 way, const std::vector<float>& distances) {
    for (const float t : distances) {
      const glm::vec2 there = glm::vec2(0.5F) + way * t;
      steps_.push_back({static_cast<int>(std::floor(there.x)), static_cast<int>(std::floor(there.y)), 1 / t});
    }
  }
  /// Samples to either side that the first `count` steps need.
  [[nodiscard]] int reach(std::size_t count) const {
    int most = 0;
    for (std::size_t k = 0; k < count; ++k)
      most = std::max({most, std::abs(steps_[k].columns), std::abs(steps_[k].rows)});
    return most;
  }
  /// The steepest rise to any of the first `count` steps, at least 0. Beyond the edge are the samples of the
  /// edge.
  [[nodiscard]] float rise(const Relief& relief, int column, int row, std::size_t count) const {
    const int last = relief.size - 1;
    const float height = relief.at(column, row);
    float most = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Step& step = steps_[k];
      const float there =
          relief.at(std::clamp(column + step.columns, 0, last), std::clamp(row + step.rows, 0, last));
      most = std::max(most, (there - height) * step.nearness);
    }
    return most;
  }
  /// The same for a sample that is at least reach(count) from every edge.
  [[nodiscard]] float rise_inside(const Relief& relief, int column, int row, std::size_t count) const {
    const float* here = relief.heights.data() + static_cast<std::ptrdiff_t>(row) * relief.size + column;
    float most = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Step& step = steps_[k];
      const float there = here[static_cast<std::ptrdiff_t>(step.rows) * relief.size + step.columns];
      most = std::max(most, (there - *here) * step.nearness);
    }
    return most;
  }
  [[nodiscard]] std::size_t count() const { return steps_.size(); }

 private:
  struct Step {
    int columns;
    int rows;
    float nearness;  ///< 1 / distance
  };
  std::vector<Step> steps_;
};

/// Marches to the horizon: once towards the light, and in eight directions for the sky.
Exposure make_exposure(const Relief& relief, const geometry::TabletShape& shape, Hand hand) {
  Exposure exposure;
  exposure.size = relief.size;
  exposure.key.assign(relief.heights.size(), 1.0F);
  exposure.sky.assign(relief.heights.size(), 1.0F);
  const float slope_per_step = static_cast<float>(shape.depth_m / shape.width_m * (relief.size - 1)) *
                               kShadeDepth;  // height 1 over one sample
  const float stride = static_cast<float>(relief.size - 1) / 511.0F;
  const glm::vec3 light = light_direction(hand);
  const glm::vec2 towards = glm::normalize(glm::vec2(light.x, -light.y));
  const float light_slope = light.z / glm::length(glm::vec2(light.x, light.y));
  const float reach =
      slope_per_step / (light_slope - kShadowSoftness * 0.9F);  // of a shadow as deep as a groove
  const auto steps_within = [stride](float farthest) {
    return static_cast<std::size_t>(std::max(0, static_cast<int>((farthest - stride) / (stride * 1.5F)) + 1));
  };
  std::vector<float> light_steps;
  for (std::size_t step = 0; step < steps_within(reach); ++step)
    light_steps.push_back(stride * (1 + 1.5F * static_cast<float>(step)));
  const Ray to_light(towards, light_steps);
  std::vector<float> sky_steps;
  for (const float step : kReachSteps) sky_steps.push_back(step * stride);
  std::vector<Ray> to_sky;
  int margin = to_light.reach(to_light.count());
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * std::numbers::pi / 4;
    to_sky.emplace_back(glm::vec2(std::cos(angle), std::sin(angle)), sky_steps);
    margin = std::max(margin, to_sky.back().reach(sky_steps.size()));
  }
  in_bands(relief.size, [&](int first, int last) {
    for (int row = first; row < last; ++row) {
      for (int column = 0; column < relief.size; ++column) {
        const float height = relief.at(column, row);
        if (height >= kOpenHeight) continue;
        const std::size_t place = static_cast<std::size_t>(row) * static_cast<std::size_t>(relief.size) +
                                  static_cast<std::size_t>(column);
        const int edge_distance = std::min(std::min(column, row), relief.size - 1 - std::max(column, row));
        const bool inside = edge_distance >= margin;
        const auto rise = [&](const Ray& ray, std::size_t count) {
          return inside ? ray.rise_inside(relief, column, row, count) : ray.rise(relief, column, row, count);
        };
        const float blocked = rise(to_light, std::min(steps_within((1 - height) * reach), to_light.count()));
        const float edge = (blocked * slope_per_step - light_slope) / (2 * kShadowSoftness) + 0.5F;
        const float dark = std::clamp(edge, 0.0F, 1.0F);
        exposure.key[place] = 1 - dark * dark * (3 - 2 * dark);
        float open = 0;
        for (const Ray& ray : to_sky) {
          const float slope = rise(ray, ray.count()) * slope_per_step;
          open += 1 / (1 + slope * slope);
        }
        exposure.sky[place] = open / static_cast<float>(to_sky.size());
      }
    }
  });
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
    return table_[static_cast<std::size_t>(held * static_cast<float>(table_.size() - 1))];
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
  return glm::normalize(glm::vec3(hand == Hand::right ? -0.50F : 0.50F, 0.56F, 0.86F));
}

float open_light(glm::vec3 normal, Hand hand) {
  const glm::vec3 light = light_direction(hand);
  // The table reflects light onto the sides.
  return kAmbient * (0.80F + 0.20F * normal.z) + 0.12F * (1 - normal.z) +
         kKey * std::max(glm::dot(normal, light), 0.0F) / light.z;
}

int shaded_size(int map_size) { return std::clamp(map_size, kShadedSize, kMaxShadedSize); }

PlainFace make_plain_face(const Look& look, int samples) {
  PlainFace plain;
  plain.look = look;
  plain.rim = static_cast<int>(std::lround(samples * kRimFraction));
  plain.size = samples + 2 * plain.rim;
  const std::size_t texels = static_cast<std::size_t>(plain.size) * static_cast<std::size_t>(plain.size);
  plain.rgba.resize(texels * 4);
  plain.grain.resize(texels);
  const Material material(look.style, look.theme);
  const GammaCoder& code = gamma_coder();
  const std::uint8_t light = code(1 / kLightRange);
  const float step_m = 0.1F / static_cast<float>(samples - 1);
  in_bands(plain.size, [&](int first, int last) {
    std::size_t out = static_cast<std::size_t>(first) * static_cast<std::size_t>(plain.size) * 4;
    for (int y = first; y < last; ++y) {
      for (int x = 0; x < plain.size; ++x, out += 4) {
        const glm::vec3 point(static_cast<float>(x - plain.rim) * step_m - 0.05F,
                              0.05F - static_cast<float>(y - plain.rim) * step_m, 0);
        const Grain grain = material.grain({point.x, point.y});
        plain.grain[out / 4] = grain;
        const glm::vec3 colour =
            material.reflectance(grain, point, 0) * (kKeyTint * kKey + kSkyTint * kAmbient);
        plain.rgba[out] = code(colour.x);
        plain.rgba[out + 1] = code(colour.y);
        plain.rgba[out + 2] = code(colour.z);
        plain.rgba[out + 3] = light;
      }
    }
  });
  return plain;
}

std::shared_ptr<const PlainFace> shared_plain_face(const Look& look, int samples) {
  static std::mutex making;
  static std::array<std::shared_ptr<const PlainFace>, 2> kept;
  const std::lock_guard lock(making);
  const auto is_it = [&](const auto& face) {
    return face && face->look == look && face->size == samples + 2 * face->rim;
  };
  const auto found = std::find_if(kept.begin(), kept.end(), is_it);
  if (found != kept.end()) {
    std::rotate(kept.begin(), found, found + 1);
  } else {
    kept = {std::make_shared<const PlainFace>(make_plain_face(look, samples)), kept[0]};
  }
  return kept[0];
}

SurfacePicture lit_picture(const surface::HeightMap& map, const geometry::TabletShape& shape,
                           const PlainFace& plain) {
  const int n = plain.size - 2 * plain.rim;
  const Relief relief = resampled(map, n);
  const Relief coarse = halved(relief);
  const Exposure exposure = make_exposure(coarse, shape, plain.look.hand);
  const Interpolation between(n, coarse.size);
  const Material material(plain.look.style, plain.look.theme);
  const GammaCoder& code = gamma_coder();
  const glm::vec3 light = light_direction(plain.look.hand);

  SurfacePicture picture{plain.size, plain.rim, plain.rgba, {}};
  picture.heights.assign(picture.rgba.size() / 4, 255);
  const float step_m = 0.1F / static_cast<float>(n - 1);
  const float depth_m = 0.1F * static_cast<float>(shape.depth_m / shape.width_m);
  const float slope = depth_m / (2 * step_m);
  in_bands(n, [&](int first, int last) {
    for (int row = first; row < last; ++row) {
      std::size_t out = static_cast<std::size_t>(row + plain.rim) * static_cast<std::size_t>(plain.size) +
                        static_cast<std::size_t>(plain.rim);
      for (int column = 0; column < n; ++column, ++out) {
        const float height = relief.at(column, row);
        const float dx =
            relief.at(std::min(column + 1, n - 1), row) - relief.at(std::max(column - 1, 0), row);
        const float dy =
            relief.at(column, std::max(row - 1, 0)) - relief.at(column, std::min(row + 1, n - 1));
        if (height >= kPlainHeight && std::abs(dx) + std::abs(dy) < 1 - kPlainHeight) continue;
        const glm::vec3 normal = glm::normalize(glm::vec3(-dx * slope, -dy * slope, 1));
        const float facing = std::max(glm::dot(normal, light), 0.0F) / light.z;
        const float lit = kKey * between(exposure.key, column, row) * facing;
        const float sky = between(exposure.sky, column, row);
        const float ambient = kAmbient * sky;
        const glm::vec3 point(static_cast<float>(column) * step_m - 0.05F,
                              0.05F - static_cast<float>(row) * step_m, (height - 1) * depth_m);
        const glm::vec3 albedo = material.reflectance(plain.grain[out], point, 1 - height);
        // Light that reaches a deep place was reflected by the walls and has their colour.
        const glm::vec3 bounce = albedo * ((1 - sky) * kBounce);
        const glm::vec3 colour = albedo * (kKeyTint * lit + kSkyTint * ambient + bounce);
        picture.rgba[out * 4] = code(colour.x);
        picture.rgba[out * 4 + 1] = code(colour.y);
        picture.rgba[out * 4 + 2] = code(colour.z);
        picture.rgba[out * 4 + 3] = code((lit + ambient) / kLightRange);
        picture.heights[out] = static_cast<std::uint8_t>(std::lround(height * 255));
      }
    }
  });
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
