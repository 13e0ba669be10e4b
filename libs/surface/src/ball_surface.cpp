// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/ball_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "ball_search.h"
#include "nazori/base/bands.h"

namespace nazori::surface {
namespace {

constexpr double kTolerance_m = 2e-6;  // far below what an encoder resolves
constexpr int kRowsOfThread = 32;      // fewer are not worth a thread

base::Result<void> check(const HeightMap& map, const geometry::TabletShape& shape, double radius_m) {
  if (!map.is_loaded())
    return base::fail(base::Errc::bad_argument, "a surface needs a height map with samples", "map");
  if (!(shape.width_m > 0 && std::isfinite(shape.width_m) && shape.depth_m > 0 &&
        std::isfinite(shape.depth_m)))
    return base::fail(base::Errc::bad_argument, "the tablet has no width or no depth", "shape",
                      "give both in metres, above 0");
  if (!(radius_m >= 0 && radius_m <= shape.width_m / 4))
    return base::fail(base::Errc::bad_argument, "the ball is too large for the tablet", "radius",
                      "give a radius from 0 to a quarter of the width");
  return {};
}

/// The bend of three heights, or of a neighbour's where that is less; 0 where they bend differently. Without
/// branches, so that a row is worked on several samples at a time.
inline float even_bend(float a, float b, float c, float d, float e) {
  const float before = a - 2 * b + c, here = b - 2 * c + d, after = c - 2 * d + e;
  const float up = std::min(std::min(before, here), after), down = std::max(std::max(before, here), after);
  return (up > 0 ? up : 0) + (down < 0 ? down : 0);
}

/// One row of control heights. @param row  five rows of heights, of which `out` is the middle one's.
/// @param padded  room for a row and two samples on each side.
void controls_of_row(const std::array<const float*, 5>& row, std::span<float> padded, std::span<float> out) {
  const std::size_t n = out.size();
  const float *a = row[0], *b = row[1], *c = row[2], *d = row[3], *e = row[4];
  std::copy_n(c, n, padded.begin() + 2);
  padded[0] = padded[1] = c[0];
  padded[n + 2] = padded[n + 3] = c[n - 1];
  const float* p = padded.data();
  for (std::size_t i = 0; i < n; ++i) {
    const float along = even_bend(p[i], p[i + 1], p[i + 2], p[i + 3], p[i + 4]);
    const float down = even_bend(a[i], b[i], c[i], d[i], e[i]);
    const float height = c[i] - (along + down) / 8;
    const float low = height > 0 ? height : 0;
    out[i] = low < 1 ? low : 1;
  }
}

/// Turns heights into control heights in place.
void to_controls(HeightMap& heights) {
  const int size = heights.size();
  const auto n = static_cast<std::size_t>(size);
  const auto row_of = [&](int row) {
    return heights.samples().subspan(static_cast<std::size_t>(std::clamp(row, 0, size - 1)) * n, n);
  };
  // Bands overwrite the rows that their neighbours read, so those rows are copied first.
  constexpr int kReach = 2;
  const base::Bands bands(size, kRowsOfThread);
  std::vector<std::vector<float>> before(static_cast<std::size_t>(bands.count())), after = before;
  for (int band = 0; band < bands.count(); ++band)
    for (int i = 0; i < kReach; ++i) {
      const auto append = [&](std::vector<std::vector<float>>& to, int row) {
        const auto line = row_of(row);
        auto& rows = to[static_cast<std::size_t>(band)];
        rows.insert(rows.end(), line.begin(), line.end());
      };
      append(before, bands.first(band) - kReach + i);
      append(after, bands.last(band) + i);
    }
  bands.run([&](int band) {
    const int first = bands.first(band), last = bands.last(band);
    const std::vector<float>& below = after[static_cast<std::size_t>(band)];
    // The rows above the present one as they were, and that one.
    std::vector<float> kept = std::move(before[static_cast<std::size_t>(band)]);
    kept.resize((kReach + 1) * n);
    std::array<float*, kReach + 1> old{kept.data(), kept.data() + n, kept.data() + 2 * n};
    std::vector<float> padded(n + 2 * kReach);
    for (int row = first; row < last; ++row) {
      const std::span<float> here = row_of(row);
      std::copy(here.begin(), here.end(), old[kReach]);
      const auto under = [&](int by) -> const float* {
        const int at = row + by;
        return at < last ? row_of(at).data() : below.data() + static_cast<std::size_t>(at - last) * n;
      };
      controls_of_row({old[0], old[1], old[2], under(1), under(2)}, padded, here);
      std::rotate(old.begin(), old.begin() + 1, old.end());
    }
  });
}

}  // namespace

base::Result<HeightMap> heights_under_ball(const HeightMap& map, const geometry::TabletShape& shape,
                                           double radius_m) {
  if (auto fine = check(map, shape, radius_m); !fine) return tl::unexpected(std::move(fine.error()));
  auto surface = SmoothSurface::create(map);
  if (!surface) return tl::unexpected(std::move(surface.error()));
  auto made = HeightMap::create(map.size());
  if (!made) return made;
  const int size = map.size();
  const auto n = static_cast<std::size_t>(size);
  const double cell_m = shape.width_m / (size - 1);
  if (radius_m < 1e-3 * cell_m) {  // no surface bends so sharply
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        made->set(column, row, static_cast<float>((*surface)->at(column, row).height));
    return made;
  }
  const BallSearch search(map, **surface, radius_m / cell_m, shape.depth_m / cell_m, kTolerance_m / cell_m);
  const base::Bands bands(size, kRowsOfThread);
  bands.run([&](int band) {
    const int first = bands.first(band), last = bands.last(band);
    search.rows(first, last,
                made->samples().subspan(static_cast<std::size_t>(first) * n,
                                        static_cast<std::size_t>(last - first) * n));
  });
  return made;
}

HeightMap controls_through(const HeightMap& heights) {
  HeightMap made = heights;
  if (made.is_loaded()) to_controls(made);
  return made;
}

base::Result<std::shared_ptr<const SmoothSurface>> surface_for_ball(const HeightMap& map,
                                                                    const geometry::TabletShape& shape,
                                                                    double radius_m) {
  if (radius_m == 0) return SmoothSurface::create(map);
  auto heights = heights_under_ball(map, shape, radius_m);
  if (!heights) return tl::unexpected(std::move(heights.error()));
  to_controls(*heights);
  return SmoothSurface::create(*heights);
}

}  // namespace nazori::surface
