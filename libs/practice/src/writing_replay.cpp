// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_replay.h"

#include <algorithm>
#include <utility>

namespace nazori::practice {

void WritingReplay::set(std::vector<HandStroke> strokes, const Tablet& model) {
  strokes_ = std::move(strokes);
  if (model == model_) return;
  model_ = model;
  player_.set_strokes(model->paths(), model->lines());
}

double WritingReplay::duration_s() const {
  const double own_s = strokes_.empty() ? 0.0
                                        : strokes_.back().back().time_s.value_or(0) -
                                              strokes_.front().front().time_s.value_or(0);
  return std::max(own_s, player_.duration_s());
}

std::span<const HandPoint> WritingReplay::written(std::size_t stroke, double time_s) const {
  const HandStroke& all = strokes_[stroke];
  if (time_s < 0) return all;
  const double zero_s = strokes_.front().front().time_s.value_or(0);
  const auto later = std::find_if(all.begin(), all.end(), [&](const HandPoint& point) {
    return point.time_s.value_or(0) - zero_s > time_s;
  });
  return std::span(all).first(static_cast<std::size_t>(later - all.begin()));
}

std::size_t WritingReplay::points_written(double time_s) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < strokes_.size(); ++i) count += written(i, time_s).size();
  return count;
}

geometry::Polyline<geometry::TabletFrame> WritingReplay::model_written(int stroke, double time_s) const {
  return player_.written(stroke, time_s < 0 ? player_.duration_s() : time_s);
}

}  // namespace nazori::practice
