// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "line_comparison.h"
#include "nazori/author/trace.h"
#include "nazori/carving/carve.h"
#include "photographed.h"
#include "stroke_guess.h"

namespace nazori::author::test {
namespace {

using kanji::StrokeEnding;

carving::Brush even_brush(double width) {
  carving::Brush brush;
  brush.width = width;
  brush.fit = false;
  brush.endings = false;
  return brush;
}

std::vector<OwnStroke> traced(const std::vector<kanji::StrokeLine>& strokes, const carving::Brush& brush,
                              int size = 512) {
  const auto map = carving::carve(strokes, size, brush);
  auto found = trace(*map);
  if (!found) {
    ADD_FAILURE() << base::to_line(found.error());
    return {};
  }
  return *std::move(found);
}

kanji::StrokeLine line(GlyphLine points, StrokeEnding ending = StrokeEnding::stop) {
  return {std::move(points), ending, {}};
}

double half_width_in_the_middle(const OwnStroke& stroke) {
  return stroke.points[stroke.points.size() / 2].half_width;
}

/// The place of the ink of a picture in the glyph box: the larger side of its box has 8 units beside it.
GlyphPoint placed(GlyphPoint p, GlyphPoint low, GlyphPoint high) {
  const double scale = (109.0 - 16.0) / std::max(high.x - low.x, high.y - low.y);
  const GlyphPoint middle = (low + high) * 0.5;
  return GlyphPoint{54.5, 54.5} + (p - middle) * scale;
}

TEST(TracedGroove, OfABarWithRoundEndsIsItsLineWithItsWidthAndDepth) {
  for (const int size : {256, 512, 1024}) {
    const auto found = traced({line({{20, 40}, {85, 61}})}, even_brush(8), size);
    ASSERT_EQ(found.size(), 1U);
    const OwnStroke& stroke = found[0];
    EXPECT_NEAR(stroke.points.front().at.x, 20, 0.3) << size;
    EXPECT_NEAR(stroke.points.front().at.y, 40, 0.3) << size;
    EXPECT_NEAR(stroke.points.back().at.x, 85, 0.3) << size;
    EXPECT_NEAR(stroke.points.back().at.y, 61, 0.3) << size;
    EXPECT_LT(distance_of(line_of(stroke), {{20, 40}, {85, 61}}).most, 0.35) << size;
    for (const GroovePoint& p : stroke.points) {
      EXPECT_NEAR(p.half_width, 4, 0.35) << size;
      EXPECT_NEAR(p.depth, 1, 0.02) << size;
    }
    EXPECT_NEAR(half_width_in_the_middle(stroke), 4, size < 512 ? 0.25 : 0.08) << size;
    EXPECT_EQ(stroke.ending, StrokeEnding::stop);
  }
}

TEST(TracedGroove, ShowsHowDeepItIs) {
  carving::Brush brush = even_brush(8);
  brush.depth = 0.4;
  const auto found = traced({line({{20, 40}, {85, 40}})}, brush);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].points[found[0].points.size() / 2].depth, 0.4, 0.01);
  EXPECT_NEAR(half_width_in_the_middle(found[0]), 4, 0.1);
}

TEST(TracedGroove, ACrossIsTwoLinesThatGoThrough) {
  const auto found = traced({line({{15, 50}, {95, 50}}), line({{55, 12}, {55, 98}})}, even_brush(7));
  ASSERT_EQ(found.size(), 2U);
  const bool first_falls = std::abs(found[0].points.front().at.x - 55) < 5;
  const LineDistance flat = distance_of(line_of(found[first_falls ? 1 : 0]), {{15, 50}, {95, 50}});
  const LineDistance falling = distance_of(line_of(found[first_falls ? 0 : 1]), {{55, 12}, {55, 98}});
  EXPECT_LT(flat.most, 0.4);
  EXPECT_LT(falling.most, 0.4);
  // The width does not change in the crossing.
  for (const OwnStroke& stroke : found)
    for (const GroovePoint& p : stroke.points) EXPECT_NEAR(p.half_width, 3.5, 0.4);
}

TEST(TracedGroove, ASlantedCrossingIsTwoLinesToo) {
  for (const double degrees : {35.0, 50.0, 70.0}) {
    const double c = 40 * std::cos(degrees / 2 * std::numbers::pi / 180);
    const double s = 40 * std::sin(degrees / 2 * std::numbers::pi / 180);
    const GlyphLine a{{54 - c, 54 - s}, {54 + c, 54 + s}};
    const GlyphLine b{{54 - c, 54 + s}, {54 + c, 54 - s}};
    const auto found = traced({line(a), line(b)}, even_brush(6));
    ASSERT_EQ(found.size(), 2U) << degrees;
    const double straight =
        std::min(distance_of(line_of(found[0]), a).most, distance_of(line_of(found[0]), b).most);
    EXPECT_LT(straight, 0.85) << degrees;
  }
}

TEST(TracedGroove, CornersAreWrittenThroughOrDividedAsInCharacters) {
  // ┐ and └ are one stroke each, ┌ and ┘ are two.
  struct Case {
    GlyphLine points;
    std::size_t strokes;
  };
  const Case cases[] = {{{{20, 20}, {85, 20}, {85, 90}}, 1},
                        {{{20, 20}, {20, 90}, {85, 90}}, 1},
                        {{{85, 20}, {20, 20}, {20, 90}}, 2},
                        {{{85, 20}, {85, 90}, {20, 90}}, 2},
                        {{{60, 20}, {25, 55}, {70, 92}}, 1}};
  for (const Case& c : cases) {
    const auto found = traced({line(c.points)}, even_brush(7));
    ASSERT_EQ(found.size(), c.strokes) << c.points[1].x << ", " << c.points[1].y;
    if (c.strokes != 1) continue;
    const LineDistance d = distance_of(line_of(found[0]), c.points);
    EXPECT_LT(d.mean, 0.15);
    EXPECT_LT(d.most, 1.2);
    EXPECT_LT(geometry::distance(found[0].points.front().at, c.points.front()), 0.4);
  }
}

TEST(TracedGroove, ABoxIsThreeStrokesAsKuchi) {
  const auto found =
      traced({line({{25, 25}, {25, 85}}), line({{25, 25}, {85, 25}, {85, 85}}), line({{25, 85}, {85, 85}})},
             even_brush(6));
  ASSERT_EQ(found.size(), 3U);
  std::vector<GlyphLine> lines;
  for (const auto& s : found) lines.push_back(line_of(s));
  const std::vector<GlyphLine> truth{
      {{25, 25}, {25, 85}}, {{25, 25}, {85, 25}, {85, 85}}, {{25, 85}, {85, 85}}};
  const auto match = matched(truth, lines);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    ASSERT_GE(match[k], 0);
    const GlyphLine& own = lines[static_cast<std::size_t>(match[k])];
    EXPECT_LT(distance_of(truth[k], own).mean, 0.3) << k;
    EXPECT_LT(geometry::distance(own.front(), truth[k].front()), 2.0) << k;
  }
}

TEST(TracedGroove, ATIsTwoStrokesAndTheStemEndsOnTheBar) {
  const auto found = traced({line({{15, 30}, {95, 30}}), line({{55, 30}, {55, 95}})}, even_brush(7));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_LT(distance_of(line_of(found[0]), {{15, 30}, {95, 30}}).most, 0.6);
  EXPECT_LT(distance_of(line_of(found[1]), {{55, 30}, {55, 95}}).most, 1.0);
}

TEST(TracedGroove, StrokesThatOnlyTouchAreDivided) {
  // Their ends are 5 units apart and the grooves 7 wide, so that the ink is connected.
  const auto found = traced({line({{12, 50}, {50, 50}}), line({{55, 50}, {97, 50}})}, even_brush(7));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].points.back().at.x, 50, 0.6);
  EXPECT_NEAR(found[1].points.front().at.x, 55, 0.6);
}

TEST(TracedGroove, ARingIsOneLineThatCloses) {
  GlyphLine ring;
  for (int k = 0; k <= 120; ++k) {
    const double a = k * 2 * std::numbers::pi / 120;
    ring.push_back({54 + 30 * std::cos(a), 54 + 30 * std::sin(a)});
  }
  const auto found = traced({line(ring)}, even_brush(7));
  ASSERT_EQ(found.size(), 1U);
  for (const GroovePoint& p : found[0].points) {
    EXPECT_NEAR(geometry::distance(p.at, {54, 54}), 30, 0.3);
    EXPECT_NEAR(p.half_width, 3.5, 0.3);
  }
  EXPECT_LT(geometry::distance(found[0].points.front().at, found[0].points.back().at), 1.0);
  EXPECT_NEAR(geometry::arc_length<geometry::GlyphFrame>(line_of(found[0])), 60 * std::numbers::pi, 2.0);
}

TEST(TracedGroove, ADotIsAShortStroke) {
  const auto found = traced({line({{54, 54}})}, even_brush(9));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT(geometry::distance(found[0].points.front().at, {54, 54}), 1.0);
  EXPECT_NEAR(found[0].points.front().half_width, 4.5, 0.5);
}

TEST(TracedGroove, ASweepThinsOutToItsEndAndAHookTurnsBack) {
  carving::Brush brush;
  brush.fit = false;
  // Given from the end, so that the thin end says where the start is.
  const auto sweep = traced({line({{30, 90}, {80, 15}}, StrokeEnding::taper)}, brush);
  ASSERT_EQ(sweep.size(), 1U);
  EXPECT_EQ(sweep[0].ending, StrokeEnding::taper);
  EXPECT_LT(geometry::distance(sweep[0].points.back().at, {80, 15}), 0.85);
  EXPECT_LT(sweep[0].points.back().half_width, 0.5);
  const GlyphLine hooked{{60, 12}, {60, 92}, {51, 85}};
  const auto hook = traced({line(hooked, StrokeEnding::hook)}, brush);
  ASSERT_EQ(hook.size(), 1U);
  EXPECT_EQ(hook[0].ending, StrokeEnding::hook);
  EXPECT_LT(geometry::distance(hook[0].points.back().at, {51, 85}), 0.85);
  EXPECT_LT(distance_of(line_of(hook[0]), hooked).mean, 0.25);
}

TEST(TracedGroove, AShortStrokeOnOneSideDoesNotWidenABar) {
  const auto found = traced({line({{12, 50}, {97, 50}}), line({{55, 50}, {55, 57}})}, even_brush(7));
  ASSERT_FALSE(found.empty());
  const auto bar = std::find_if(found.begin(), found.end(),
                                [](const OwnStroke& s) { return std::abs(s.points.front().at.x - 12) < 1; });
  ASSERT_NE(bar, found.end());
  EXPECT_NEAR(bar->points.back().at.x, 97, 1);
  for (const GroovePoint& p : bar->points) EXPECT_NEAR(p.half_width, 3.5, 0.5) << p.at.x;
}

TEST(PutInOrder, IsFromTheTopAndFromTheLeft) {
  std::vector<OwnStroke> strokes{drawn({{60, 80}, {90, 80}}, 3), drawn({{70, 10}, {70, 40}}, 3),
                                 drawn({{20, 80}, {50, 80}}, 3), drawn({{20, 12}, {20, 40}}, 3)};
  put_in_order(strokes);
  EXPECT_EQ(strokes[0].points.front().at, (GlyphPoint{20, 12}));
  EXPECT_EQ(strokes[1].points.front().at, (GlyphPoint{70, 10}));
  EXPECT_EQ(strokes[2].points.front().at, (GlyphPoint{20, 80}));
  EXPECT_EQ(strokes[3].points.front().at, (GlyphPoint{60, 80}));
}

TEST(Direct, IsToTheRightAndDownAndTowardsTheThinEnd) {
  const auto start = [](OwnStroke stroke) {
    direct(stroke);
    return stroke.points.front().at;
  };
  EXPECT_EQ(start(drawn({{90, 50}, {10, 50}}, 3)), (GlyphPoint{10, 50}));
  EXPECT_EQ(start(drawn({{50, 90}, {50, 10}}, 3)), (GlyphPoint{50, 10}));
  EXPECT_EQ(start(drawn({{20, 90}, {80, 10}}, 3)), (GlyphPoint{80, 10}));
  EXPECT_EQ(start(drawn({{90, 40}, {10, 60}}, 3)), (GlyphPoint{10, 60}));
  // A stroke to the upper right that thins out there.
  EXPECT_EQ(start(drawn({{60, 20}, {20, 80}}, 1, 4)), (GlyphPoint{20, 80}));
  EXPECT_EQ(start(drawn({{20, 80}, {60, 20}}, 4, 1)), (GlyphPoint{20, 80}));
}

TEST(TracedInk, OfABarIsItsLineInTheMiddleOfTheBoxWithAMargin) {
  const OwnStroke bar = drawn({{20, 40}, {90, 40}}, 5);
  for (const double scale : {1.7, 3.6, 8.0}) {
    Shot shot;
    shot.scale = scale;
    shot.width = static_cast<int>(130 * scale);
    shot.height = static_cast<int>(120 * scale);
    shot.left = 8 * scale;
    shot.top = 3 * scale;
    const auto found = trace(photographed({{bar}}, shot));
    ASSERT_TRUE(found) << base::to_line(found.error());
    ASSERT_EQ(found->size(), 1U);
    // The ink is 80 units long and 93 in the box.
    const GlyphPoint low{15, 35};
    const GlyphPoint high{95, 45};
    const OwnStroke& stroke = found->front();
    EXPECT_LT(geometry::distance(stroke.points.front().at, placed({20, 40}, low, high)), 0.8) << scale;
    EXPECT_LT(geometry::distance(stroke.points.back().at, placed({90, 40}, low, high)), 0.8) << scale;
    EXPECT_NEAR(half_width_in_the_middle(stroke), 5 * 93.0 / 80, 0.25) << scale;
    EXPECT_EQ(stroke.points[3].depth, 1);
  }
}

TEST(TracedInk, AWedgeHasTheWidthThatItHasEverywhere) {
  // 4.5 to 0.5 units over 70: the discs along it have these radii.
  const OwnStroke wedge = drawn({{20, 50}, {90, 50}}, 6, 0.5);
  const auto found = trace(photographed({{wedge}}, {}));
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 1U);
  const OwnStroke& stroke = found->front();
  EXPECT_EQ(stroke.ending, StrokeEnding::taper);
  EXPECT_LT(stroke.points.front().at.x, stroke.points.back().at.x);
  const double scale = 93.0 / (90.5 - 14);
  for (const GroovePoint& p : stroke.points) {
    const double x = 14 + (p.at.x - 8) / scale;
    EXPECT_NEAR(p.at.y, 54.5, 0.4);
    if (x < 22 || x > 85) continue;
    EXPECT_NEAR(p.half_width, scale * (6 - 5.5 * (x - 20) / 70), 0.3) << x;
  }
}

TEST(TracedInk, SquareEndsHaveNoWhiskers) {
  scan::Photo photo{600, 300, std::vector<std::uint8_t>(600UL * 300, 240)};
  for (int y = 120; y < 160; ++y)
    for (int x = 60; x < 540; ++x) photo.grey[static_cast<std::size_t>(y * 600 + x)] = 20;
  const auto found = trace(photo);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 1U);
  const OwnStroke& stroke = found->front();
  for (const GroovePoint& p : stroke.points) EXPECT_NEAR(p.at.y, 54.5, 0.3);
  EXPECT_NEAR(stroke.points.front().half_width, 20 * 93.0 / 480, 0.5);
}

/// A picture of 600 x 600 with ink where `is_ink(x, y)`, the middle at 0, 0, and soft edges.
scan::Photo inked(auto is_ink) {
  scan::Photo photo{600, 600, {}};
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 600; ++x) {
      int dark = 0;
      for (const double v : {-0.25, 0.25})
        for (const double u : {-0.25, 0.25}) dark += is_ink(x - 300 + u, y - 300 + v) ? 1 : 0;
      photo.grey.push_back(static_cast<std::uint8_t>(240 - 220 * dark / 4));
    }
  return photo;
}

TEST(TracedInk, ASquareEndOfALineThatLeansIsNoHook) {
  for (int step = 0; step < 7; ++step) {
    const double angle = step * 0.47, c = std::cos(angle), s = std::sin(angle);
    for (const double half_width : {14.0, 24.0}) {
      const auto found = trace(inked([&](double x, double y) {
        return std::abs(x * c + y * s) < 230 && std::abs(y * c - x * s) < half_width;
      }));
      ASSERT_TRUE(found);
      ASSERT_EQ(found->size(), 1U) << step;
      EXPECT_EQ(found->front().ending, StrokeEnding::stop) << step;
      for (const GroovePoint& p : found->front().points)
        EXPECT_NEAR((p.at.y - 54.5) * c - (p.at.x - 54.5) * s, 0, 0.7) << step << ' ' << half_width;
    }
  }
}

TEST(TracedInk, ASquareEndOfABentLineIsNoHook) {
  for (int step = 0; step < 6; ++step) {
    const double turned = step * 1.07;
    const auto found = trace(inked([&](double x, double y) {
      const double angle = std::remainder(std::atan2(y, x) - turned, 2 * std::numbers::pi);
      return std::abs(std::hypot(x, y) - 220) < 20 && std::abs(angle) < 0.9;
    }));
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 1U) << step;
    EXPECT_EQ(found->front().ending, StrokeEnding::stop) << step;
    // All points lie on one circle: its middle is where the perpendiculars of two chords meet.
    const auto& points = found->front().points;
    const GlyphPoint a = points.front().at, b = points[points.size() / 2].at, d = points.back().at;
    const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - a.x, vy = d.y - a.y;
    const double uu = ux * ux + uy * uy, vv = vx * vx + vy * vy, across = 2 * (ux * vy - uy * vx);
    const GlyphPoint middle{a.x + (vy * uu - uy * vv) / across, a.y + (ux * vv - vx * uu) / across};
    for (const GroovePoint& p : points)
      EXPECT_NEAR(geometry::distance(p.at, middle) / geometry::distance(a, middle), 1, 0.02) << step;
  }
}

TEST(TracedInk, BumpsOfTheRimAreNoStrokes) {
  // Discs on the rim whose tops are 0.36 of the half width above it.
  std::vector<OwnStroke> ink{drawn({{20, 50}, {90, 50}}, 5)};
  for (const double x : {35.0, 52.0, 71.0}) ink.push_back(drawn({{x, x < 60 ? 45.3 : 54.7}}, 2.1));
  const auto found = trace(photographed(ink, {}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 1U);
}

}  // namespace
}  // namespace nazori::author::test
