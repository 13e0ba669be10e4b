// SPDX-License-Identifier: Apache-2.0
#include "rings.h"

#include <cmath>

#include "noise.h"

namespace nazori::view {

const Rings& Rings::shared() {
  static const Rings rings;
  return rings;
}

Rings::Rings() {
  const int count = kCount * static_cast<int>(kSteps);
  values_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) values_.push_back(late_wood(static_cast<float>(i) / kSteps));
}

float Rings::late_wood(float radius) {
  const float pace = radius + (value_noise(radius * 0.37F, 7.5F, 4) - 0.5F) * 1.3F;
  const float ring = pace - std::floor(pace);
  const float strength = 0.40F + 0.60F * value_noise(std::floor(pace) * 0.71F, 3.5F, 5);
  const float rising = ring * ring * (0.30F + 0.70F * ring * ring * ring);
  return rising * (1 - smooth_step(0.93F, 1.0F, ring)) * strength;
}

}  // namespace nazori::view
