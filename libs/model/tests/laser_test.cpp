// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/laser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "nazori/geometry/polyline.h"

namespace nazori::model {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

/// A plate of 30 x 20 mm with a round bowl: depth 3 (1 - d^2 / 36) within 6 mm of (12, 8).
Plate bowl() {
  Plate plate = Plate::create(30, 20, 0.1, 5).value();
  auto map = surface::HeightMap::create(301, 1.0F).value();
  for (int row = 0; row < 301; ++row)
    for (int column = 0; column < 301; ++column) {
      const double d2 = std::pow(column * 0.1 - 12, 2) + std::pow(30 - row * 0.1 - 8, 2);
      map.set(column, row, static_cast<float>(std::min(1.0, d2 / 36)));
    }
  plate.sink(map, {0, 0}, 30, 3);
  return plate;
}

double signed_area(const PlateLine& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PlatePoint a = loop[i];
    const PlatePoint b = loop[(i + 1) % loop.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum / 2;
}

/// The closed lines of each layer of the drawing, y down.
std::vector<std::vector<PlateLine>> layers_of(const std::string& svg) {
  std::vector<std::vector<PlateLine>> layers;
  const std::regex layer("<path d=\"([^\"]*)\"");
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), layer); it != std::sregex_iterator(); ++it) {
    layers.emplace_back();
    std::string path = (*it)[1];
    for (char& c : path)
      if (c == 'L') c = ' ';
    std::istringstream loops(path);
    std::string loop;
    while (std::getline(loops, loop, 'Z')) {
      std::istringstream numbers(loop.substr(1));
      layers.back().emplace_back();
      for (PlatePoint p; numbers >> p.x >> p.y;) layers.back().back().push_back(p);
    }
  }
  return layers;
}

bool is_inside(const std::vector<PlateLine>& loops, PlatePoint p) {
  bool inside = false;
  for (const PlateLine& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PlatePoint a = loop[i];
      const PlatePoint b = loop[(i + 1) % loop.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  return inside;
}

TEST(Contours, OfABowlAreCircles) {
  const auto loops = contours(bowl(), 5 - 1.5);
  ASSERT_THAT(loops, SizeIs(1));
  const double radius = 6 * std::sqrt(0.5);
  for (const PlatePoint p : loops.front()) EXPECT_NEAR(std::hypot(p.x - 12, p.y - 8), radius, 0.002);
  EXPECT_NEAR(signed_area(loops.front()), 3.14159265 * radius * radius, 0.05);
}

TEST(Contours, AHighIslandInALowAreaRunsTheOtherWay) {
  Plate plate = Plate::create(20, 20, 0.2, 4).value();
  auto map = surface::HeightMap::create(101, 1.0F).value();
  for (int row = 0; row < 101; ++row)
    for (int column = 0; column < 101; ++column) {
      const double d = std::hypot(column * 0.2 - 10, row * 0.2 - 10);
      if (d > 3 && d < 7) map.set(column, row, 0.0F);
    }
  plate.sink(map, {0, 0}, 20, 2);
  const auto loops = contours(plate, 3);
  ASSERT_THAT(loops, SizeIs(2));
  const double a = signed_area(loops[0]);
  const double b = signed_area(loops[1]);
  EXPECT_LT(a * b, 0);
  EXPECT_NEAR(a + b, 3.14159265 * (49 - 9), 2);
}

TEST(Contours, AGrooveThatRunsOverTheEdgeIsClosedThere) {
  Plate plate = Plate::create(10, 10, 0.5, 4).value();
  auto map = surface::HeightMap::create(21, 1.0F).value();
  for (int row = 8; row <= 12; ++row)
    for (int column = 0; column < 21; ++column) map.set(column, row, 0.0F);
  plate.sink(map, {0, 0}, 10, 2);
  const auto loops = contours(plate, 3);
  ASSERT_THAT(loops, SizeIs(1));
  EXPECT_NEAR(signed_area(loops.front()), 10 * 2.5, 1e-6);
}

TEST(Contours, LowCornersOfOneCellAreConnectedWhereItsMiddleIsLow) {
  const auto count = [](float high) {
    Plate plate = Plate::create(15, 15, 1, 4).value();
    auto map = surface::HeightMap::create(16, 1.0F).value();
    map.set(7, 7, 0.0F);
    map.set(8, 8, 0.0F);
    map.set(7, 8, high);
    map.set(8, 7, high);
    plate.sink(map, {0, 0}, 15, 2);
    return contours(plate, 3).size();  // half the depth
  };
  EXPECT_EQ(count(1.0F), 2U);
  EXPECT_EQ(count(0.7F), 1U);
}

TEST(LaserDrawing, EachPlaceIsBurntToWithinHalfAStepOfItsDepth) {
  const Plate plate = bowl();
  constexpr int kLayers = 6;
  const std::string svg = to_laser_svg(plate, kLayers, "bowl").value();
  const auto layers = layers_of(svg);
  ASSERT_THAT(layers, SizeIs(kLayers));
  for (double y = 0.53; y < 20; y += 1.1) {
    for (double x = 0.47; x < 30; x += 1.1) {
      int burnt = 0;
      for (const auto& layer : layers) burnt += is_inside(layer, {x, 20 - y}) ? 1 : 0;
      const double depth = std::max(0.0, 3 * (1 - (std::pow(x - 12, 2) + std::pow(y - 8, 2)) / 36));
      EXPECT_NEAR(burnt * 3.0 / kLayers, depth, 0.25 + 0.02) << x << ' ' << y;
    }
  }
}

TEST(LaserDrawing, HasItsTrueSizeItsGreysAndItsCuts) {
  Plate plate = bowl();
  ASSERT_TRUE(plate.add_hole({{25, 15}, 2}));
  const std::string svg = to_laser_svg(plate, 3, "a < b & c").value();
  EXPECT_THAT(svg, HasSubstr("width=\"30.000mm\" height=\"20.000mm\" viewBox=\"0 0 30.000 20.000\""));
  EXPECT_THAT(svg, HasSubstr("<title>a &lt; b &amp; c</title>"));
  EXPECT_THAT(svg, HasSubstr("label=\"depth 1.000 mm\" fill=\"#aaaaaa\""));
  EXPECT_THAT(svg, HasSubstr("label=\"depth 3.000 mm\" fill=\"#000000\""));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"25.000\" cy=\"5.000\" r=\"2.000\"/>"));
  EXPECT_THAT(svg, HasSubstr("<rect x=\"0\" y=\"0\" width=\"30.000\" height=\"20.000\"/>"));
}

TEST(LaserDrawing, WhatCannotBeDrawnIsRefused) {
  EXPECT_FALSE(to_laser_svg(bowl(), 0, "a"));
  EXPECT_FALSE(to_laser_svg(bowl(), 65, "a"));
  EXPECT_TRUE(to_laser_svg(bowl(), 64, "a"));
  EXPECT_TRUE(to_laser_svg(bowl(), 1, "a"));
  const auto flat = to_laser_svg(Plate::create(20, 20, 0.5, 4).value(), 4, "a");
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().code, base::Errc::bad_argument);
}

}  // namespace
}  // namespace nazori::model
