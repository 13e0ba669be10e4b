// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/sheet.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "blobs.h"
#include "strip.h"

namespace nazori::scan {
namespace {

using Four = std::array<std::size_t, 4>;

double turn(PhotoPoint a, PhotoPoint b, PhotoPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Four discs in the order around a convex quadrilateral, clockwise in the picture. nullopt where they are
/// none, or differ too much in size to be of one page.
std::optional<Four> around(const std::vector<Blob>& blobs, Four four) {
  constexpr double kMostUnlike = 2.2;  // radii, for the perspective
  double least = blobs[four[0]].radius;
  double most = least;
  PhotoPoint middle{0, 0};
  for (const std::size_t i : four) {
    least = std::min(least, blobs[i].radius);
    most = std::max(most, blobs[i].radius);
    middle = middle + blobs[i].centre * 0.25;
  }
  if (most > kMostUnlike * least) return std::nullopt;
  std::sort(four.begin(), four.end(), [&](std::size_t a, std::size_t b) {
    const PhotoPoint p = blobs[a].centre - middle;
    const PhotoPoint q = blobs[b].centre - middle;
    return std::atan2(p.y, p.x) < std::atan2(q.y, q.x);
  });
  for (std::size_t i = 0; i < 4; ++i) {
    const PhotoPoint a = blobs[four[i]].centre;
    const PhotoPoint b = blobs[four[(i + 1) % 4]].centre;
    const PhotoPoint c = blobs[four[(i + 2) % 4]].centre;
    // A page is at least twenty discs wide.
    if (geometry::distance(a, b) < 15 * least || turn(a, b, c) <= 0) return std::nullopt;
  }
  return four;
}

double area_of(const std::vector<Blob>& blobs, const Four& four) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const PhotoPoint a = blobs[four[i]].centre;
    const PhotoPoint b = blobs[four[(i + 1) % 4]].centre;
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

std::vector<Four> quadrilaterals(const std::vector<Blob>& blobs) {
  std::vector<Four> found;
  const std::size_t n = blobs.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c)
        for (std::size_t d = c + 1; d < n; ++d)
          if (const auto four = around(blobs, {a, b, c, d})) found.push_back(*four);
  std::sort(found.begin(), found.end(),
            [&](const Four& p, const Four& q) { return area_of(blobs, p) > area_of(blobs, q); });
  return found;
}

/// The size of a disc tells how large the page is: whether the map agrees with it.
bool fits(const PageMap& map, const std::array<print::PaperPoint, 4>& page, const std::vector<Blob>& blobs,
          const Four& four, std::size_t turned) {
  for (std::size_t i = 0; i < 4; ++i) {
    const PhotoPoint centre = map.at(page[i]);
    const double reach = print::kDisc_mm / 2;
    const PhotoPoint right = map.at({page[i].x + reach, page[i].y}) - centre;
    const PhotoPoint down = map.at({page[i].x, page[i].y + reach}) - centre;
    const double radius = std::sqrt(std::abs(right.x * down.y - right.y * down.x));
    const double ratio = blobs[four[(i + turned) % 4]].radius / std::max(radius, 1e-9);
    if (ratio < 0.7 || ratio > 1.4) return false;
  }
  return true;
}

}  // namespace

PageMap PageMap::through(const std::array<print::PaperPoint, 4>& page,
                         const std::array<PhotoPoint, 4>& photo) {
  Eigen::Matrix<double, 8, 8> a;
  Eigen::Matrix<double, 8, 1> b;
  for (int i = 0; i < 4; ++i) {
    const auto [x, y] = std::pair(page[static_cast<std::size_t>(i)].x, page[static_cast<std::size_t>(i)].y);
    const auto [u, v] = std::pair(photo[static_cast<std::size_t>(i)].x, photo[static_cast<std::size_t>(i)].y);
    a.row(2 * i) << x, y, 1, 0, 0, 0, -u * x, -u * y;
    a.row(2 * i + 1) << 0, 0, 0, x, y, 1, -v * x, -v * y;
    b(2 * i) = u;
    b(2 * i + 1) = v;
  }
  const Eigen::Matrix<double, 8, 1> h = a.fullPivLu().solve(b);
  PageMap map;
  for (int i = 0; i < 8; ++i) map.matrix[static_cast<std::size_t>(i)] = h(i);
  map.matrix[8] = 1;
  return map;
}

PhotoPoint PageMap::at(print::PaperPoint p) const {
  const auto& m = matrix;
  const double w = m[6] * p.x + m[7] * p.y + m[8];
  return {(m[0] * p.x + m[1] * p.y + m[2]) / w, (m[3] * p.x + m[4] * p.y + m[5]) / w};
}

base::Result<std::vector<FoundSheet>> find_sheets(const Photo& photo) {
  const std::vector<Blob> blobs = find_discs(photo);
  std::vector<bool> used(blobs.size());
  std::vector<FoundSheet> found;
  std::optional<base::Error> unreadable;
  const auto try_four = [&](const Four& four) {
    for (const auto& [width, height] : print::page_sizes())
      for (std::size_t turned = 0; turned < 4; ++turned) {
        const auto page = print::disc_centres(width, height);
        std::array<PhotoPoint, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = blobs[four[(i + turned) % 4]].centre;
        const PageMap map = PageMap::through(page, corners);
        if (!fits(map, page, blobs, four, turned)) continue;
        auto mark = read_strip(photo, map, width, height);
        if (!mark) continue;
        if (!*mark) {
          if (!unreadable || mark->error().code == base::Errc::schema) unreadable = mark->error();
          continue;
        }
        // The strip is read alike on pages of almost the same size.
        const auto right = print::disc_centres((*mark)->width_mm, (*mark)->height_mm);
        for (const std::size_t i : four) used[i] = true;
        found.push_back({**mark, PageMap::through(right, corners)});
        return;
      }
  };
  for (const Four& four : quadrilaterals(blobs))
    if (std::none_of(four.begin(), four.end(), [&](std::size_t i) { return used[i]; })) try_four(four);
  if (!found.empty()) return found;
  if (unreadable) return tl::unexpected(*std::move(unreadable));
  return base::fail(base::Errc::not_found, "no sheet with a mark of Nazori was found", {},
                    "photograph the whole page with its four black discs, sharply and in even light");
}

}  // namespace nazori::scan
