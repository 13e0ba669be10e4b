// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "nazori/geometry/point.h"

namespace nazori::geometry {

/// A point of a stroke as a hand wrote it.
template <class Frame>
struct WrittenPoint {
  Point2<Frame> at;
  std::optional<double> time_s =
      {};  ///< seconds from an arbitrary zero that all strokes of a character share
  std::optional<double> pressure = {};  ///< 0..1
  std::optional<double> lean_rad = {};  ///< angle between the pen and upright

  friend bool operator==(const WrittenPoint&, const WrittenPoint&) = default;
};

/// One stroke as a hand wrote it, from its start to its end.
template <class Frame>
using WrittenStroke = std::vector<WrittenPoint<Frame>>;

/// What a hand wrote, in the order in which it was written.
template <class Frame>
using WrittenStrokes = std::vector<WrittenStroke<Frame>>;

/// The positions of the pen, without times, pressures and lean.
template <class Frame>
[[nodiscard]] Polyline<Frame> line_of(const std::vector<WrittenPoint<Frame>>& stroke) {
  Polyline<Frame> line;
  line.reserve(stroke.size());
  for (const auto& point : stroke) line.push_back(point.at);
  return line;
}

/// A stroke of which only the line is known.
template <class Frame>
[[nodiscard]] WrittenStroke<Frame> written_along(const std::vector<Point2<Frame>>& line) {
  WrittenStroke<Frame> stroke;
  stroke.reserve(line.size());
  for (const auto& at : line) stroke.push_back({at});
  return stroke;
}

/// The stroke in another frame; times, pressures and lean are unchanged. @param to_frame  Point2<From> to
/// Point2<To>.
template <class To, class From, class ToFrame>
[[nodiscard]] WrittenStroke<To> in_frame(const std::vector<WrittenPoint<From>>& stroke,
                                         const ToFrame& to_frame) {
  WrittenStroke<To> out;
  out.reserve(stroke.size());
  for (const auto& point : stroke)
    out.push_back({to_frame(point.at), point.time_s, point.pressure, point.lean_rad});
  return out;
}

}  // namespace nazori::geometry
