// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/base/assignment.h"
#include "nazori/geometry/polyline.h"

namespace nazori::author::test {

using geometry::GlyphPoint;
using GlyphLine = geometry::Polyline<geometry::GlyphFrame>;

inline GlyphLine line_of(const OwnStroke& stroke) {
  GlyphLine line;
  for (const GroovePoint& p : stroke.points) line.push_back(p.at);
  return line;
}

/// Distances between two lines, from each point of one to the other and back, glyph units.
struct LineDistance {
  double mean = 0;
  double most_of_95 = 0;  ///< 95th percentile
  double most = 0;
};

inline LineDistance distance_of(const GlyphLine& a, const GlyphLine& b) {
  std::vector<double> all;
  double sum = 0;
  for (const bool back : {false, true}) {
    const std::span<const GlyphPoint> from(back ? b : a);
    const std::span<const GlyphPoint> to(back ? a : b);
    const auto count = static_cast<std::size_t>(geometry::arc_length(from) / 0.5) + 2;
    double own = 0;
    for (const GlyphPoint p : geometry::resample(from, count)) {
      const double d = geometry::nearest_point(to, p).distance;
      own += d;
      all.push_back(d);
    }
    sum += own / static_cast<double>(count);
  }
  std::sort(all.begin(), all.end());
  return {sum / 2, all[all.size() * 95 / 100], all.back()};
}

/// For each true line the found one that belongs to it, or nothing: together they are closest.
inline std::vector<std::ptrdiff_t> matched(const std::vector<GlyphLine>& truth,
                                           const std::vector<GlyphLine>& found) {
  const std::size_t side = std::max(truth.size(), found.size());
  constexpr double kNone = 20;
  std::vector<double> costs(side * side, kNone);
  for (std::size_t t = 0; t < truth.size(); ++t)
    for (std::size_t f = 0; f < found.size(); ++f)
      costs[t * side + f] = std::min(kNone, distance_of(truth[t], found[f]).mean);
  std::vector<std::ptrdiff_t> out(truth.size(), -1);
  const auto chosen = base::cheapest_assignment<double>(costs, side);
  for (std::size_t t = 0; t < truth.size(); ++t)
    if (chosen[t] < found.size() && costs[t * side + chosen[t]] < kNone)
      out[t] = static_cast<std::ptrdiff_t>(chosen[t]);
  return out;
}

}  // namespace nazori::author::test
