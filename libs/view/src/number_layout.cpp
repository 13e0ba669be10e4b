// SPDX-License-Identifier: Apache-2.0
#include "number_layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <numbers>

namespace nazori::view {
namespace {

constexpr int kRounds = 60;
/// Share of the way back to its wish that a disc is drawn each round.
constexpr double kPull = 0.08;
constexpr int kMostRings = 400;

bool fits(std::span<const glm::dvec2> placed, glm::dvec2 place, double apart) {
  return std::all_of(placed.begin(), placed.end(),
                     [&](glm::dvec2 other) { return glm::distance(other, place) >= apart; });
}

/// The free place nearest to the wish, on rings around it.
glm::dvec2 nearest_free(std::span<const glm::dvec2> placed, glm::dvec2 wish, double apart) {
  if (fits(placed, wish, apart)) return wish;
  for (int ring = 1; ring <= kMostRings; ++ring) {
    const double reach = apart / 6 * ring;
    const int ways = 6 * ring;
    for (int k = 0; k < ways; ++k) {
      const double angle = 2 * std::numbers::pi * k / ways;
      const glm::dvec2 place = wish + glm::dvec2(std::cos(angle), std::sin(angle)) * reach;
      if (fits(placed, place, apart)) return place;
    }
  }
  return wish;
}

}  // namespace

std::vector<glm::dvec2> lay_out_numbers(std::span<const NumberWish> wishes, double radius, double gap) {
  std::vector<glm::dvec2> targets;
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
          // Two discs on one spot part in a direction of their own, always the same.
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
  for (const glm::dvec2 place : places) settled.push_back(nearest_free(settled, place, 2 * radius));
  return settled;
}

}  // namespace nazori::view
