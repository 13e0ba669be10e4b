// SPDX-License-Identifier: Apache-2.0
#include "number_layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

namespace nazori::view {
namespace {

constexpr int kRounds = 60;
/// Share of the distance to its preferred position that a disc moves in each round.
constexpr double kPull = 0.08;
constexpr int kMostRings = 400;

/// Discs with a final position, indexed by position.
class Placed {
 public:
  explicit Placed(double apart) : apart_(apart) {}

  void add(glm::dvec2 place) { cells_[{cell_of(place.x), cell_of(place.y)}].push_back(place); }

  /// Whether a disc there overlaps none.
  [[nodiscard]] bool fits(glm::dvec2 place) const {
    for (std::int64_t x = cell_of(place.x) - 1; x <= cell_of(place.x) + 1; ++x) {
      for (std::int64_t y = cell_of(place.y) - 1; y <= cell_of(place.y) + 1; ++y) {
        const auto cell = cells_.find({x, y});
        if (cell == cells_.end()) continue;
        for (const glm::dvec2 other : cell->second)
          if (glm::distance(other, place) < apart_) return false;
      }
    }
    return true;
  }

 private:
  [[nodiscard]] std::int64_t cell_of(double coordinate) const {
    return static_cast<std::int64_t>(std::floor(coordinate / apart_));
  }

  double apart_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<glm::dvec2>> cells_;
};

/// The free position nearest to the preferred one, on rings around it.
glm::dvec2 nearest_free(const Placed& placed, glm::dvec2 wish, double apart) {
  if (placed.fits(wish)) return wish;
  for (int ring = 1; ring <= kMostRings; ++ring) {
    const double reach = apart / 6 * ring;
    const int ways = 6 * ring;
    for (int k = 0; k < ways; ++k) {
      const double angle = 2 * std::numbers::pi * k / ways;
      const glm::dvec2 place = wish + glm::dvec2(std::cos(angle), std::sin(angle)) * reach;
      if (placed.fits(place)) return place;
    }
  }
  return wish;
}

}  // namespace

std::vector<glm::dvec2> lay_out_numbers(std::span<const NumberWish> wishes, double radius, double gap) {
  std::vector<glm::dvec2> targets;
  targets.reserve(wishes.size());
  for (const NumberWish& wish : wishes) targets.push_back(wish.start + wish.side * (radius + gap));
  std::vector<glm::dvec2> places = targets;
  const double apart = 2 * radius + gap / 2;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        glm::dvec2 between = places[j] - places[i];
        double distance = glm::length(between);
        if (distance >= apart) continue;
        if (distance < 1e-9) {
          // Two discs on one spot are separated in a direction that is always the same for them.
          const double angle = 2.399963 * static_cast<double>(i * 31 + j);
          between = {std::cos(angle), std::sin(angle)};
          distance = 1;
        }
        const glm::dvec2 push = between / distance * ((apart - glm::distance(places[i], places[j])) / 2);
        places[i] -= push;
        places[j] += push;
      }
    }
    if (round + 10 >= kRounds) continue;
    for (std::size_t i = 0; i < places.size(); ++i) places[i] += (targets[i] - places[i]) * kPull;
  }
  std::vector<glm::dvec2> settled;
  settled.reserve(places.size());
  Placed placed(2 * radius);
  for (const glm::dvec2 place : places) {
    settled.push_back(nearest_free(placed, place, 2 * radius));
    placed.add(settled.back());
  }
  return settled;
}

}  // namespace nazori::view
