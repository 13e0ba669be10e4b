// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "nazori/geometry/polyline.h"
#include "nazori/model/plate.h"

namespace nazori::model {

struct Box {
  double left;
  double bottom;
  double right;
  double top;

  [[nodiscard]] Box wider(double by) const { return {left - by, bottom - by, right + by, top + by}; }
  [[nodiscard]] bool meets(const Box& o) const {
    return left < o.right && o.left < right && bottom < o.top && o.bottom < top;
  }
};

/// What is raised already: points of lines with a foot around each, and boxes of labels.
class Occupied {
 public:
  void add_line(std::span<const PlatePoint> line, double foot) {
    const double length = geometry::arc_length(line);
    const auto count = static_cast<std::size_t>(length / 0.5) + 2;
    for (const PlatePoint p : geometry::resample(line, count)) add_point(p, foot);
  }
  void add_point(PlatePoint p, double foot) {
    boxes_.push_back({p.x - foot, p.y - foot, p.x + foot, p.y + foot});
  }
  void add_box(const Box& box) { boxes_.push_back(box); }
  [[nodiscard]] bool has_room(const Box& box) const {
    return std::none_of(boxes_.begin(), boxes_.end(), [&](const Box& o) { return o.meets(box); });
  }

 private:
  std::vector<Box> boxes_;
};

}  // namespace nazori::model
