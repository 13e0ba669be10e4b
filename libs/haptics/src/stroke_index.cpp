// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/stroke_index.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nazori::haptics {

StrokeIndex::StrokeIndex(std::span<const StrokePath> strokes, int only) : first_(strokes.size(), -1) {
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    const auto number = static_cast<std::int32_t>(s) + 1;
    if (only != 0 && number != only) continue;
    std::vector<Vec3> points;
    points.reserve(strokes[s].points.size());
    for (const Vec3& p : strokes[s].points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
      if (points.empty() || glm::length(p - points.back()) > 1e-9) points.push_back(p);
    }
    if (points.empty()) continue;
    const auto first = static_cast<std::int32_t>(segments_.size());
    first_[s] = first;
    const std::size_t count = std::max<std::size_t>(1, points.size() - 1);
    double before = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 along = points.size() > 1 ? points[i + 1] - points[i] : Vec3(0);
      const double squared = glm::dot(along, along);
      segments_.push_back({points[i], along, squared > 0 ? 1 / squared : 0, before, std::sqrt(squared),
                           number, first, first + static_cast<std::int32_t>(count) - 1});
      before += std::sqrt(squared);
    }
  }
  for (std::size_t begin = 0; begin < segments_.size();) {
    Cluster c{segments_[begin].from, segments_[begin].from, begin, begin};
    while (c.end < segments_.size() && c.end - begin < kCluster &&
           segments_[c.end].stroke == segments_[begin].stroke) {
      const Segment& s = segments_[c.end++];
      const Vec3 to = s.from + s.along;
      c.low = glm::min(c.low, glm::min(s.from, to));
      c.high = glm::max(c.high, glm::max(s.from, to));
    }
    begin = c.end;
    clusters_.push_back(c);
  }
}

}  // namespace nazori::haptics
