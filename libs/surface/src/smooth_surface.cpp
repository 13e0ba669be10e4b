// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/smooth_surface.h"

#include <atomic>
#include <cstring>

namespace nazori::surface {
namespace {

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

base::Result<std::shared_ptr<const SmoothSurface>> SmoothSurface::create(const HeightMap& map) {
  if (!map.is_loaded())
    return base::fail(base::Errc::bad_argument, "a surface needs a height map with samples", "map");
  return std::shared_ptr<const SmoothSurface>(new SmoothSurface(map));
}

SmoothSurface::SmoothSurface(const HeightMap& map)
    : serial_(next_serial()),
      size_(map.size()),
      stride_(static_cast<std::size_t>(map.size()) + 2),
      samples_(std::make_unique_for_overwrite<float[]>(stride_ * stride_)) {
  const std::size_t n = stride_ - 2;
  const float* from = map.samples().data();
  for (std::size_t row = 0; row < n; ++row) {
    float* to = samples_.get() + (row + 1) * stride_;
    std::memcpy(to + 1, from + row * n, n * sizeof(float));
    to[0] = to[1];
    to[n + 1] = to[n];
  }
  std::memcpy(samples_.get(), samples_.get() + stride_, stride_ * sizeof(float));
  std::memcpy(samples_.get() + (n + 1) * stride_, samples_.get() + n * stride_, stride_ * sizeof(float));
}

}  // namespace nazori::surface
