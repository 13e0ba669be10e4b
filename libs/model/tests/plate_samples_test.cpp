// SPDX-License-Identifier: Apache-2.0
// Every sample of a plate against the definition of what is laid on it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "nazori/geometry/polyline.h"
#include "test_plates.h"

namespace nazori::model {
namespace {

constexpr double kThickness_mm = 3;

void expect_samples(const Plate& plate, const std::function<double(PlatePoint)>& height, double within) {
  for (int row = 0; row < plate.rows(); ++row)
    for (int column = 0; column < plate.columns(); ++column) {
      const PlatePoint p{column * plate.step_mm(), row * plate.step_mm()};
      ASSERT_NEAR(plate.at(column, row), kThickness_mm + height(p), within) << p.x << " " << p.y;
    }
}

/// The height of a line at a place: (1 - x^2)^2 of its height, one half at half of its width.
double line_height(const PlateLine& line, const RaisedLine& profile, LineEnd end, PlatePoint p) {
  const double radius = profile.width_mm / 2 / std::sqrt(1 - std::sqrt(0.5));
  const double total = geometry::arc_length(std::span<const PlatePoint>(line));
  const double sinking = std::min(8.0, 0.4 * total);
  double highest = 0;
  // Each segment in fine parts.
  double before = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PlatePoint way = line[i + 1] - line[i];
    const double length = geometry::length(way);
    const double t =
        length > 0 ? std::clamp(geometry::dot(p - line[i], way) / (length * length), 0.0, 1.0) : 0.0;
    const double x = geometry::distance(line[i] + way * t, p) / radius;
    const double left = total - before - t * length;
    const double share = end == LineEnd::sinks && left < sinking ? (1 + 2 * left / sinking) / 3 : 1;
    if (x < 1) highest = std::max(highest, share * profile.height_mm * std::pow(1 - x * x, 2));
    before += length;
  }
  return highest;
}

TEST(PlateSamples, OfALineHaveItsProfileAroundAllItsSegments) {
  const RaisedLine profile{0.9, 1.3};
  for (const LineEnd end : {LineEnd::full, LineEnd::sinks})
    for (const PlateLine& line : {PlateLine{{4, 3}, {9, 12}, {17, 10}, {12, 4}},
                                  {{17, 10}, {4, 9.4}},
                                  {{-2, 7}, {10, 16}, {24, 5}},
                                  {{10, -3}, {11, 20}}}) {
      Plate plate = Plate::create(20, 14, 0.25, kThickness_mm).value();
      plate.add_line(line, profile, end);
      expect_samples(
          plate, [&](PlatePoint p) { return line_height(line, profile, end, p); }, 1e-5);
    }
}

TEST(PlateSamples, OfADotAreThoseOfASphereAroundIt) {
  // Also at the edges, of which it has what is on the plate.
  for (const PlatePoint centre :
       {PlatePoint{5.1, 4.3}, {0.3, 7.8}, {9.7, 0.2}, {-0.4, 3}, {10.5, 4}, {4, -0.6}, {5, 8.3}}) {
    Plate plate = Plate::create(10, 8, 0.1, kThickness_mm).value();
    plate.add_dot(centre, 2.4, 0.7);
    const double ball = (1.2 * 1.2 + 0.7 * 0.7) / (2 * 0.7);
    expect_samples(
        plate,
        [&](PlatePoint p) {
          const double d = geometry::distance(p, centre);
          return d < 1.2 ? std::max(0.0, std::sqrt(ball * ball - d * d) - (ball - 0.7)) : 0;
        },
        1e-5);
  }
}

/// A map of 9 x 9 samples by its place from the lower left, 0..1.
template <class F>
surface::HeightMap map_of(const F& height) {
  auto map = surface::HeightMap::create(9).value();
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column)
      map.set(column, row, static_cast<float>(height(column / 8.0, 1 - row / 8.0)));
  return map;
}

TEST(PlateSamples, OfAMapAreBetweenItsOwnInProportion) {
  // What is linear along both sides is exact between its samples, too.
  const auto bilinear = [](double u, double v) { return 0.1 + 0.3 * u + 0.2 * v + 0.35 * u * v; };
  const auto map = map_of(bilinear);
  for (const PlatePoint corner : {PlatePoint{3, 2}, {-2.5, -3.5}, {8.25, 5.75}, {0, 0}}) {
    Plate sunk = Plate::create(12, 10, 0.25, kThickness_mm).value();
    Plate raised = sunk;
    sunk.sink(map, corner, 6, 2);
    raised.put(map, corner, 6, 2);
    const auto inside = [&](PlatePoint p) {
      const PlatePoint at = (p - corner) * (1.0 / 6);
      return at.x > -1e-6 && at.y > -1e-6 && at.x < 1 + 1e-6 && at.y < 1 + 1e-6;
    };
    const auto height = [&](PlatePoint p) {
      const PlatePoint at = (p - corner) * (1.0 / 6);
      return bilinear(at.x, at.y);
    };
    expect_samples(
        sunk, [&](PlatePoint p) { return inside(p) ? -2 * (1 - height(p)) : 0; }, 1e-5);
    expect_samples(
        raised, [&](PlatePoint p) { return inside(p) ? 2 * height(p) : 0; }, 1e-5);
  }
}

TEST(PlateSamples, TwoMapsInOnePlaceAdd) {
  const auto map = map_of([](double, double) { return 0.25; });
  Plate plate = Plate::create(6, 6, 0.5, kThickness_mm).value();
  plate.put(map, {0, 0}, 6, 2);
  plate.sink(map, {0, 0}, 3, 1);
  expect_samples(
      plate, [](PlatePoint p) { return 0.5 - (p.x <= 3 && p.y <= 3 ? 0.75 : 0); }, 1e-6);
}

TEST(PlateSamples, OfABorderAreAsWideAsItOnAllSides) {
  Plate plate = Plate::create(7, 5, 0.5, kThickness_mm).value();
  plate.add_border(1, 2);
  expect_samples(
      plate,
      [](PlatePoint p) {
        return std::min({p.x, p.y, 7 - p.x, 5 - p.y}) <= 1 ? 2 : 0;
      },
      1e-6);
}

TEST(PlateSamples, OfAMouldAreMirroredAndTurnedOver) {
  Plate plate = Plate::create(7, 5, 0.5, kThickness_mm).value();
  plate.add_dot({2, 3}, 2, 0.8);
  plate.add_border(0.5, 0.3);
  const Plate mould = plate.negative();
  EXPECT_EQ(mould.thickness_mm(), kThickness_mm);
  for (int row = 0; row < 11; ++row)
    for (int column = 0; column < 15; ++column)
      ASSERT_NEAR(mould.at(column, row), 2 * kThickness_mm + 0.8 - plate.at(14 - column, row), 1e-6);
}

TEST(PlateHole, NeedsAMillimetreOfFlatGroundAroundItAndNoMore) {
  const auto refusal = [](PlatePoint dot) {
    Plate plate = Plate::create(20, 20, 0.25, kThickness_mm).value();
    plate.add_dot(dot, 0.4, 0.5);  // raises the one sample at its middle
    const auto made = plate.add_hole({{10, 10}, 2.5});
    return made ? std::string() : made.error().what;
  };
  for (const PlatePoint way : {PlatePoint{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    EXPECT_EQ(refusal(PlatePoint{10, 10} + way * 3.5), "is not on flat ground");
    EXPECT_EQ(refusal(PlatePoint{10, 10} + way * 3.75), "");
    EXPECT_EQ(refusal(PlatePoint{10, 10} + way * 1), "is not on flat ground");
  }
}

TEST(PlateHole, MayTouchTheMillimetreAtTheEdgeAndAroundOthers) {
  Plate plate = Plate::create(20, 15, 0.25, kThickness_mm).value();
  EXPECT_FALSE(plate.add_hole({{10, 8}, 1.99})) << "eight steps of the grid at least";
  EXPECT_TRUE(plate.add_hole({{3, 3}, 2}));
  EXPECT_TRUE(plate.add_hole({{17, 12}, 2}));
  EXPECT_TRUE(plate.add_hole({{8, 3}, 2})) << "a millimetre between two";
  EXPECT_FALSE(plate.add_hole({{12.99, 3}, 2}));
  for (const PlatePoint wrong : {PlatePoint{2.99, 12}, {10, 12.01}}) EXPECT_FALSE(plate.add_hole({wrong, 2}));
}

}  // namespace
}  // namespace nazori::model
