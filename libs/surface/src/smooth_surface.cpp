// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/smooth_surface.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <vector>

#include "nazori/base/bands.h"

namespace nazori::surface {
namespace {

constexpr int kSquaresOfThread = 128;  // rows of squares; fewer are not worth a thread

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last;
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
      squares_((static_cast<std::size_t>(map.size()) + 2 + kSide - 1) / kSide),
      samples_(static_cast<float*>(::operator new[](kLine* squares_* squares_, std::align_val_t{kLine}))) {
  const auto n = static_cast<std::size_t>(size_);
  const base::Bands bands(static_cast<int>(squares_), kSquaresOfThread);
  bands.run([&](int band) {
    std::vector<float> line(squares_ * kSide);
    const auto first = kSide * static_cast<std::size_t>(bands.first(band)),
               last = kSide * static_cast<std::size_t>(bands.last(band));
    for (std::size_t row = first; row < last; ++row) {
      const float* from = map.samples().data() + std::clamp<std::size_t>(row, 1, n) * n - n;
      std::memcpy(line.data() + 1, from, n * sizeof(float));
      line[0] = from[0];
      std::fill(line.begin() + 1 + static_cast<std::ptrdiff_t>(n), line.end(), from[n - 1]);
      for (std::size_t i = 0; i < squares_; ++i)
        std::memcpy(samples_.get() + row_at(row) + i * kSide * kSide, line.data() + i * kSide,
                    kSide * sizeof(float));
    }
  });
}

}  // namespace nazori::surface
