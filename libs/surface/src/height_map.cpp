// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/height_map.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

namespace nazori::surface {
namespace {

float held(float height) { return std::isfinite(height) ? std::clamp(height, 0.0F, 1.0F) : 1.0F; }

}  // namespace

HeightMap::HeightMap(int size, float height)
    : size_(size), samples_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), height) {}

base::Result<HeightMap> HeightMap::create(int size, float height) {
  if (size < kMinSize || size > kMaxSize) {
    return base::fail(base::Errc::bad_argument,
                      "a height map cannot have " + std::to_string(size) + " samples a side", "size",
                      "give " + std::to_string(kMinSize) + " to " + std::to_string(kMaxSize));
  }
  try {
    return HeightMap(size, held(height));
  } catch (const std::bad_alloc&) {
    return base::fail(base::Errc::io, "there is not enough memory for the samples", "size",
                      "give a smaller size");
  }
}

void HeightMap::unload() {
  size_ = 0;
  samples_ = {};
}

void HeightMap::set(int column, int row, float height) { samples_[index(column, row)] = held(height); }

}  // namespace nazori::surface
