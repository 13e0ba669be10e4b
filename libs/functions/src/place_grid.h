// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "nazori/functions/tracing.h"

namespace nazori::functions {

/// Places sorted into squares, so that neighbours are found without looking at all places.
class PlaceGrid {
 public:
  /// @param reach  the largest distance at which is_any_near() looks; more than zero.
  explicit PlaceGrid(double reach) : reach_(reach) {}

  void add(PlatePoint p) { squares_[key(cell(p.u), cell(p.v))].push_back(p); }

  /// Whether a place is nearer than the reach and farther than `beyond`.
  [[nodiscard]] bool is_any_near(PlatePoint p, double beyond = -1) const {
    for (std::int64_t du = -1; du <= 1; ++du) {
      for (std::int64_t dv = -1; dv <= 1; ++dv) {
        const auto square = squares_.find(key(cell(p.u) + du, cell(p.v) + dv));
        if (square == squares_.end()) continue;
        const auto near = [&](const PlatePoint& q) {
          const double d = std::hypot(p.u - q.u, p.v - q.v);
          return d < reach_ && d > beyond;
        };
        if (std::any_of(square->second.begin(), square->second.end(), near)) return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] std::int64_t cell(double c) const {
    return static_cast<std::int64_t>(std::floor(c / reach_));
  }
  static std::uint64_t key(std::int64_t a, std::int64_t b) {
    return static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15ULL ^
           static_cast<std::uint64_t>(b) * 0xC2B2AE3D27D4EB4FULL;
  }

  double reach_;
  std::unordered_map<std::uint64_t, std::vector<PlatePoint>> squares_;
};

}  // namespace nazori::functions
