// SPDX-License-Identifier: Apache-2.0
#include "exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>

#include "nazori/base/bands.h"
#include "surface_picture.h"

namespace nazori::view {
namespace {

/// Half the width of the shadow's edge, as a slope: the key light is a window, not a point.
constexpr float kShadowSoftness = 0.55F;
/// Samples this high cannot be in the shadow of the plateau.
constexpr float kOpenHeight = 0.998F;
constexpr int kSkyRays = 8;
constexpr std::array<float, 8> kReachSteps{1, 2, 4, 7, 11, 16, 23, 32};

Relief halved(const Relief& relief) {
  Relief half;
  half.size = relief.size / 2;
  const auto n = static_cast<std::size_t>(half.size);
  half.heights.reserve(n * n);
  const float step = static_cast<float>(relief.size - 1) / static_cast<float>(half.size - 1);
  for (int row = 0; row < half.size; ++row) {
    const float y = static_cast<float>(row) * step;
    const int j = std::min(static_cast<int>(y), relief.size - 2);
    const float v = y - static_cast<float>(j);
    for (int column = 0; column < half.size; ++column) {
      const float x = static_cast<float>(column) * step;
      const int i = std::min(static_cast<int>(x), relief.size - 2);
      const float u = x - static_cast<float>(i);
      const float top = relief.at(i, j) * (1 - u) + relief.at(i + 1, j) * u;
      const float low = relief.at(i, j + 1) * (1 - u) + relief.at(i + 1, j + 1) * u;
      half.heights.push_back(top * (1 - v) + low * v);
    }
  }
  return half;
}

/// Steps from a sample outwards, and how much higher the samples there stand, by their distance.
class Ray {
 public:
  /// @param way  unit length, in samples.  @param distances  in samples, ascending.
  Ray(glm::vec2 way, const std::vector<float>& distances) {
    for (const float t : distances) {
      const glm::vec2 there = glm::vec2(0.5F) + way * t;
      steps_.push_back({static_cast<int>(std::floor(there.x)), static_cast<int>(std::floor(there.y)), 1 / t});
      reach_ = std::max({reach_, std::abs(steps_.back().columns), std::abs(steps_.back().rows)});
    }
  }
  /// Samples to either side that the steps need.
  [[nodiscard]] int reach() const { return reach_; }
  [[nodiscard]] std::size_t count() const { return steps_.size(); }

  /// For samples of a row side by side, the steepest rise to any of the first `steps` steps, at least 0.
  /// @param column  of the first sample.  @param rises  one for each sample.
  /// All samples are at least reach() from every edge.
  void rises_inside(const Relief& relief, int column, int row, std::size_t steps, std::vector<float>& rises,
                    std::size_t samples) const {
    const float* here = relief.heights.data() + static_cast<std::ptrdiff_t>(row) * relief.size + column;
    std::fill_n(rises.begin(), samples, 0.0F);
    for (std::size_t k = 0; k < steps; ++k) {
      const Step& step = steps_[k];
      const float* there = here + static_cast<std::ptrdiff_t>(step.rows) * relief.size + step.columns;
      float* most = rises.data();
      for (std::size_t i = 0; i < samples; ++i) {
        const float rise = (there[i] - here[i]) * step.nearness;
        most[i] = rise > most[i] ? rise : most[i];
      }
    }
  }
  /// The same for one sample anywhere. Beyond the edge are the samples of the edge.
  [[nodiscard]] float rise(const Relief& relief, int column, int row, std::size_t steps) const {
    const int last = relief.size - 1;
    const float height = relief.at(column, row);
    float most = 0;
    for (std::size_t k = 0; k < steps; ++k) {
      const Step& step = steps_[k];
      const float there =
          relief.at(std::clamp(column + step.columns, 0, last), std::clamp(row + step.rows, 0, last));
      most = std::max(most, (there - height) * step.nearness);
    }
    return most;
  }

 private:
  struct Step {
    int columns;
    int rows;
    float nearness;  ///< 1 / distance
  };
  std::vector<Step> steps_;
  int reach_ = 0;
};

/// The light and the sky around a relief.
class Horizon {
 public:
  Horizon(const Relief& relief, const geometry::TabletShape& shape, Hand hand)
      : relief_(relief),
        stride_(static_cast<float>(relief.size - 1) / 511.0F),
        slope_(static_cast<float>(shape.depth_m / shape.width_m * (relief.size - 1)) * kShadeDepth) {
    const glm::vec3 light = light_direction(hand);
    light_slope_ = light.z / glm::length(glm::vec2(light.x, light.y));
    shadow_ = slope_ / (light_slope_ - kShadowSoftness * 0.9F);
    std::vector<float> distances;
    for (std::size_t step = 0; step < steps_within(shadow_); ++step)
      distances.push_back(stride_ * (1 + kLightStep * static_cast<float>(step)));
    rays_.emplace_back(glm::normalize(glm::vec2(light.x, -light.y)), distances);
    distances.clear();
    for (const float step : kReachSteps) distances.push_back(step * stride_);
    for (int i = 0; i < kSkyRays; ++i) {
      const double angle = (i + 0.5) * 2 * std::numbers::pi / kSkyRays;
      rays_.emplace_back(glm::vec2(std::cos(angle), std::sin(angle)), distances);
    }
    for (const Ray& ray : rays_) margin_ = std::max(margin_, ray.reach());
  }

  /// Finds what reaches one row. @param samples  of the row; those on the plateau stay as they are.
  void expose(int row, Exposed* samples) {
    const int n = relief_.size;
    const bool inside = row >= margin_ && row < n - margin_;
    for (int first = 0; first < n; ++first) {
      float lowest = relief_.at(first, row);
      if (lowest >= kOpenHeight) continue;
      int end = first + 1;
      for (; end < n && relief_.at(end, row) < kOpenHeight; ++end)
        lowest = std::min(lowest, relief_.at(end, row));
      const int from = inside ? std::clamp(margin_, first, end) : end;
      const int to = inside ? std::clamp(n - margin_, from, end) : end;
      for (int column = first; column < from; ++column) samples[column] = exposed(column, row);
      expose_inside(row, from, to, lowest, samples);
      for (int column = to; column < end; ++column) samples[column] = exposed(column, row);
      first = end;
    }
  }

 private:
  static constexpr float kLightStep = 1.5F;

  [[nodiscard]] std::size_t steps_within(float farthest) const {
    return static_cast<std::size_t>(
        std::max(0, static_cast<int>((farthest - stride_) / (stride_ * kLightStep)) + 1));
  }
  /// Steps towards the light that a sample of this height needs: beyond them the plateau shades it no more.
  [[nodiscard]] std::size_t steps_to_light(float height) const {
    return std::min(steps_within((1 - height) * shadow_), rays_.front().count());
  }
  [[nodiscard]] float key(float rise) const {
    const float edge = (rise * slope_ - light_slope_) / (2 * kShadowSoftness) + 0.5F;
    const float dark = std::clamp(edge, 0.0F, 1.0F);
    return 1 - dark * dark * (3 - 2 * dark);
  }
  /// The part of the sky that one of its rays stands for.
  [[nodiscard]] float sky(float rise) const {
    const float slope = rise * slope_;
    return 1 / (1 + slope * slope) / kSkyRays;
  }

  [[nodiscard]] Exposed exposed(int column, int row) const {
    const Ray& to_light = rays_.front();
    Exposed light{key(to_light.rise(relief_, column, row, steps_to_light(relief_.at(column, row)))), 0};
    for (std::size_t i = 1; i < rays_.size(); ++i)
      light.sky += sky(rays_[i].rise(relief_, column, row, rays_[i].count()));
    return light;
  }

  /// The same for samples side by side, all farther from the edges than the rays reach.
  void expose_inside(int row, int first, int end, float lowest, Exposed* samples) {
    const auto count = static_cast<std::size_t>(end - first);
    if (count == 0) return;
    rises_.resize(std::max(rises_.size(), count));
    open_.assign(count, 0.0F);
    for (std::size_t i = 1; i < rays_.size(); ++i) {
      rays_[i].rises_inside(relief_, first, row, rays_[i].count(), rises_, count);
      for (std::size_t k = 0; k < count; ++k) open_[k] += sky(rises_[k]);
    }
    rays_.front().rises_inside(relief_, first, row, steps_to_light(lowest), rises_, count);
    for (std::size_t k = 0; k < count; ++k)
      samples[static_cast<std::size_t>(first) + k] = {key(rises_[k]), open_[k]};
  }

  const Relief& relief_;
  float stride_;           ///< samples for each 511th of the side
  float slope_;            ///< of a rise by 1 over one sample
  float light_slope_ = 0;  ///< of the light above the plateau
  float shadow_ = 0;       ///< samples that the shadow of a full depth reaches
  std::vector<Ray> rays_;  ///< to the light, then to the sky
  int margin_ = 0;
  std::vector<float> rises_;
  std::vector<float> open_;
};

}  // namespace

Exposure make_exposure(const Relief& fine, const geometry::TabletShape& shape, Hand hand) {
  const Relief relief = halved(fine);
  Exposure exposure{relief.size, std::vector<Exposed>(relief.heights.size())};
  const base::Bands bands(relief.size, 1);
  bands.run([&](int band) {
    Horizon horizon(relief, shape, hand);
    for (int row = bands.first(band); row < bands.last(band); ++row)
      horizon.expose(row, exposure.samples.data() + static_cast<std::ptrdiff_t>(row) * relief.size);
  });
  return exposure;
}

ExposureRow::ExposureRow(const Exposure& exposure, int fine)
    : exposure_(exposure), line_(static_cast<std::size_t>(exposure.size)) {
  const float step = static_cast<float>(exposure.size - 1) / static_cast<float>(fine - 1);
  for (int i = 0; i < fine; ++i) {
    const float x = static_cast<float>(i) * step;
    const int sample = std::min(static_cast<int>(x), exposure.size - 2);
    places_.push_back({sample, x - static_cast<float>(sample)});
  }
}

void ExposureRow::set_row(int row) {
  const Place& place = places_[static_cast<std::size_t>(row)];
  const Exposed* top = exposure_.samples.data() + static_cast<std::ptrdiff_t>(place.sample) * exposure_.size;
  const Exposed* low = top + exposure_.size;
  for (std::size_t i = 0; i < line_.size(); ++i) {
    line_[i] = {top[i].key + (low[i].key - top[i].key) * place.beyond,
                top[i].sky + (low[i].sky - top[i].sky) * place.beyond};
  }
}

}  // namespace nazori::view
