// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "nazori/author/stroke_edits.h"
#include "nazori/carving/groove.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using geometry::kGlyphSide;

constexpr double kDigitWidth = 4.6;
constexpr double kDigitHeight = 6;
constexpr double kStartRadius = 1.5;  ///< of what must stay free around the start of a stroke
constexpr double kGap = 0.4;          ///< between two numbers

/// Distance of a point from a box, 0 inside.
double distance_to(const NumberBox& box, GlyphPoint p) {
  const double dx = std::max({box.left - p.x, p.x - box.right, 0.0});
  const double dy = std::max({box.top - p.y, p.y - box.bottom, 0.0});
  return std::hypot(dx, dy);
}

/// What is in the way of numbers.
class Obstacles {
 public:
  explicit Obstacles(std::span<const OwnStroke> strokes) {
    for (const OwnStroke& stroke : strokes) {
      starts_.push_back(stroke.points.front().at);
      for (const carving::SmoothPoint& p : carving::smooth_line(stroke.points))
        grooves_.push_back({p.at, p.half_width, p.depth});
    }
  }
  void add(const NumberBox& box) { numbers_.push_back(box); }
  [[nodiscard]] bool is_free(const NumberBox& box) const {
    if (box.left < 0 || box.top < 0 || box.right > kGlyphSide || box.bottom > kGlyphSide) return false;
    const auto covers = [&box](GlyphPoint start) { return distance_to(box, start) < kStartRadius; };
    const auto meets = [&box](const NumberBox& other) {
      return box.left < other.right + kGap && other.left < box.right + kGap &&
             box.top < other.bottom + kGap && other.top < box.bottom + kGap;
    };
    return std::ranges::none_of(starts_, covers) && std::ranges::none_of(numbers_, meets);
  }
  [[nodiscard]] bool is_on_groove(const NumberBox& box) const {
    return std::ranges::any_of(grooves_, [&box](const carving::GroovePoint& p) {
      return distance_to(box, p.at) < 0.7 * p.half_width;
    });
  }

 private:
  std::vector<GlyphPoint> starts_;
  std::vector<carving::GroovePoint> grooves_;
  std::vector<NumberBox> numbers_;
};

GlyphPoint usual_place(GlyphPoint start) { return {start.x - 8, start.y - 2}; }

/// The best free place around a start: near it, beside grooves, preferably at its upper left.
std::optional<GlyphPoint> place_around(const Obstacles& obstacles, std::size_t number, GlyphPoint start) {
  constexpr double kRings[] = {5, 6, 7, 8, 9.5, 11, 13, 15, 18};
  constexpr int kDirections = 16;
  constexpr double kOnGroove = 7;  // so much farther away is as good as beside a groove
  std::optional<GlyphPoint> best;
  double least = std::numeric_limits<double>::infinity();
  const NumberBox shape = number_box(number, {0, 0});
  for (const double ring : kRings) {
    for (int i = 0; i < kDirections; ++i) {
      // From the upper left in turns to both sides.
      const int turn = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
      const double angle = (-0.75 + 2.0 * turn / kDirections) * 3.14159265358979323846;
      const GlyphPoint middle = start + GlyphPoint{std::cos(angle), std::sin(angle)} * ring;
      const GlyphPoint at{middle.x - (shape.left + shape.right) / 2,
                          middle.y - (shape.top + shape.bottom) / 2};
      const NumberBox box = number_box(number, at);
      double cost = ring + 0.15 * std::abs(turn);
      if (cost >= least || !obstacles.is_free(box)) continue;
      if (obstacles.is_on_groove(box)) cost += kOnGroove;
      if (cost >= least) continue;
      least = cost;
      best = at;
    }
  }
  return best;
}

/// The free place nearest to a start in the whole picture.
std::optional<GlyphPoint> place_anywhere(const Obstacles& obstacles, std::size_t number, GlyphPoint start) {
  std::optional<GlyphPoint> best;
  double least = std::numeric_limits<double>::infinity();
  for (double y = kDigitHeight; y <= kGlyphSide; y += 1) {
    for (double x = 0; x < kGlyphSide; x += 1) {
      const double away = geometry::distance(GlyphPoint{x, y}, usual_place(start));
      if (away >= least || !obstacles.is_free(number_box(number, {x, y}))) continue;
      least = away;
      best = GlyphPoint{x, y};
    }
  }
  return best;
}

}  // namespace

NumberBox number_box(std::size_t number, GlyphPoint at) {
  const auto digits = static_cast<double>(std::to_string(number).size());
  return {at.x, at.y - kDigitHeight, at.x + kDigitWidth * digits, at.y};
}

std::vector<GlyphPoint> number_places(std::span<const OwnStroke> strokes) {
  Obstacles obstacles(strokes);
  for (std::size_t k = 0; k < strokes.size(); ++k)
    if (strokes[k].number_position) obstacles.add(number_box(k + 1, *strokes[k].number_position));
  std::vector<GlyphPoint> places;
  places.reserve(strokes.size());
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    if (strokes[k].number_position) {
      places.push_back(*strokes[k].number_position);
      continue;
    }
    const GlyphPoint start = strokes[k].points.front().at;
    auto at = place_around(obstacles, k + 1, start);
    if (!at) at = place_anywhere(obstacles, k + 1, start);
    places.push_back(at.value_or(usual_place(start)));
    obstacles.add(number_box(k + 1, places.back()));
  }
  return places;
}

}  // namespace nazori::author
