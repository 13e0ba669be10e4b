// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/stroke_svg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "characters.h"
#include "line_comparison.h"
#include "photographed.h"

namespace nazori::author::test {
namespace {

TEST(StrokeSvg, CurvesLieOnTheLinesAndCornersStay) {
  for (const std::string name : {"永", "休", "の", "口"})
    for (const kanji::StrokeLine& stroke : kanjivg(name)) {
      const auto path = path_of(drawn(stroke.points, 3));
      EXPECT_LT(distance_of(geometry::flatten(path, 0.01), stroke.points).most, 0.2) << name;
      EXPECT_LT(path.pieces.size(), 90U) << name;
      EXPECT_EQ(path.start, stroke.points.front());
      EXPECT_EQ(path.pieces.back()[2], stroke.points.back());
    }
  const auto corner = geometry::flatten(path_of(drawn({{10, 10}, {90, 10}, {90, 80}}, 3)), 0.01);
  EXPECT_EQ(corner, (GlyphLine{{10, 10}, {90, 10}, {90, 80}}));
}

TEST(StrokeSvg, ACircleOfManyPointsStaysRound) {
  GlyphLine circle;
  for (int k = 0; k <= 200; ++k)
    circle.push_back({50 + 30 * std::cos(k * 0.03), 50 + 30 * std::sin(k * 0.03)});
  const auto path = path_of(drawn(circle, 3));
  EXPECT_LT(path.pieces.size(), 80U);
  for (const GlyphPoint p : geometry::flatten(path, 0.001))
    EXPECT_NEAR(geometry::distance(p, {50, 50}), 30, 0.1);
}

TEST(StrokeSvg, HasAPathAndANumberForEachStrokeInOrder) {
  OwnStroke second = drawn({{50, 20}, {50, 90}}, 3);
  second.number_position = GlyphPoint{60, 25};
  const OwnStroke first = drawn({{20, 30}, {90, 30}}, 3);
  EXPECT_EQ(
      to_svg(std::vector{first, second, drawn({{3, 4}}, 2)}),
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"109\" height=\"109\" viewBox=\"0 0 109 109\">\n"
      "<g id=\"StrokePaths\" style=\"fill:none;stroke:#000000;stroke-width:3;stroke-linecap:round;"
      "stroke-linejoin:round;\">\n"
      "<path id=\"s1\" d=\"M20.00,30.00C43.33,30.00,66.67,30.00,90.00,30.00\"/>\n"
      "<path id=\"s2\" d=\"M50.00,20.00C50.00,43.33,50.00,66.67,50.00,90.00\"/>\n"
      "<path id=\"s3\" d=\"M3.00,4.00C3.00,4.00,3.00,4.00,3.00,4.00\"/>\n"
      "</g>\n<g id=\"StrokeNumbers\" style=\"font-size:8;fill:#808080\">\n"
      "<text transform=\"matrix(1 0 0 1 12.00 31.00)\">1</text>\n"
      "<text transform=\"matrix(1 0 0 1 60.00 25.00)\">2</text>\n"
      "<text transform=\"matrix(1 0 0 1 0.00 8.00)\">3</text>\n"
      "</g>\n</svg>\n");
}

}  // namespace
}  // namespace nazori::author::test
