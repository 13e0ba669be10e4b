// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "nazori/carving/carve.h"
#include "nazori/geometry/polyline.h"
#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

class RandomStrokes : public testing::TestWithParam<unsigned> {
 protected:
  std::vector<StrokeLine> strokes_ = random_strokes(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Seeds, RandomStrokes, testing::Range(1U, 41U));

TEST_P(RandomStrokes, SamplesStayBetweenTheDeepestAndThePlateau) {
  for (const auto section : {CrossSection::rounded, CrossSection::v_shaped, CrossSection::flat_bottom}) {
    Brush brush;
    brush.cross_section = section;
    brush.depth = 0.7;
    const auto map = carved(strokes_, 173, brush);
    for (const float height : map.samples()) {
      ASSERT_GE(height, 0.3F - 1e-6F);
      ASSERT_LE(height, 1.0F);
    }
  }
}

TEST_P(RandomStrokes, TheOrderOfStrokesDoesNotMatterToTheLastBit) {
  const auto map = carved(strokes_, 97, {});
  std::mt19937 random(GetParam());
  std::shuffle(strokes_.begin(), strokes_.end(), random);
  EXPECT_EQ(carved(strokes_, 97, {}), map);
}

TEST_P(RandomStrokes, AStrokeGivenTwiceIsCarvedOnce) {
  const auto map = carved(strokes_, 97, plain_brush());
  strokes_.push_back(strokes_.front());
  EXPECT_EQ(carved(strokes_, 97, plain_brush()), map);
}

TEST_P(RandomStrokes, AnotherStrokeOnlyEverDeepens) {
  const auto all = carved(strokes_, 97, plain_brush());
  strokes_.pop_back();
  const auto fewer = carved(strokes_, 97, plain_brush());
  for (std::size_t i = 0; i < all.samples().size(); ++i)
    ASSERT_LE(all.samples()[i], fewer.samples()[i] + 1e-6F);
}

TEST_P(RandomStrokes, AFinerGridShowsTheSameRelief) {
  const auto coarse = carved(strokes_, 129, plain_brush());
  const auto fine = carved(strokes_, 257, plain_brush());  // every second sample coincides with a coarse one
  double worst = 0;
  double sum = 0;
  for (int y = 0; y < 129; ++y) {
    for (int x = 0; x < 129; ++x) {
      const double d = std::abs(coarse.at(x, y) - fine.at(2 * x, 2 * y));
      worst = std::max(worst, d);
      sum += d;
    }
  }
  EXPECT_LT(worst, 0.08);
  EXPECT_LT(sum / (129 * 129), 5e-4);
}

TEST_P(RandomStrokes, MirroredStrokesGiveTheMirroredRelief) {
  const auto map = carved(strokes_, 129, plain_brush());
  for (StrokeLine& line : strokes_)
    for (GlyphPoint& p : line.points) p.x = geometry::kGlyphSide - p.x;
  const auto mirrored = carved(strokes_, 129, plain_brush());
  double worst = 0;
  for (int y = 0; y < 129; ++y)
    for (int x = 0; x < 129; ++x)
      worst = std::max(worst, static_cast<double>(std::abs(map.at(x, y) - mirrored.at(128 - x, y))));
  EXPECT_LT(worst, 2e-3);
}

TEST_P(RandomStrokes, SamplesFartherFromEveryLineThanAPressedBrushArePlateau) {
  const auto map = carved(strokes_, 129, plain_brush(7));
  // Half the width, the press of a stop, and the distance of a curve from its chord.
  constexpr double kReach = 3.5 * 1.16 + 0.25;
  for (int y = 0; y < 129; ++y) {
    for (int x = 0; x < 129; ++x) {
      const GlyphPoint p = geometry::grid_to_glyph({static_cast<double>(x), static_cast<double>(y)}, 129);
      double nearest = 1e9;
      for (const StrokeLine& line : strokes_)
        nearest =
            std::min(nearest, geometry::nearest_point(std::span<const GlyphPoint>(line.points), p).distance);
      ASSERT_TRUE(nearest <= kReach || map.at(x, y) == 1.0F) << p.x << ' ' << p.y;
    }
  }
}

TEST_P(RandomStrokes, TheBodyOfEachLineLiesOnTheFloor) {
  Brush brush = plain_brush(7);
  brush.endings = false;
  const auto map = carved(strokes_, 513, brush);
  for (const StrokeLine& line : strokes_) {
    const std::span<const GlyphPoint> points(line.points);
    for (double s = 0; s <= geometry::arc_length(points); s += 0.4) {
      const GlyphPoint p = geometry::point_at(points, s);
      if (p.x < 1 || p.y < 1 || p.x > 108 || p.y > 108) continue;
      ASSERT_LT(height_at(map, p), 0.03) << p.x << ' ' << p.y;
    }
  }
}

TEST(Crossing, HasNoRidgeAcrossEitherGroove) {
  for (const double angle : {0.3, 0.7, 1.2, 1.57}) {
    const GlyphPoint centre{54.5, 54.5};
    const GlyphPoint across{30 * std::cos(angle), 30 * std::sin(angle)};
    const auto map = carved({stroke({{20, 54.5}, {89, 54.5}}), stroke({centre - across, centre + across})},
                            1091, plain_brush(7));
    for (double t = -0.8; t <= 0.8; t += 0.01) {
      EXPECT_LT(height_at(map, {54.5 + 30 * t, 54.5}), 0.002) << angle << ' ' << t;
      EXPECT_LT(height_at(map, centre + across * t), 0.002) << angle << ' ' << t;
    }
  }
}

TEST(Crossing, WhereWallsMeetTheEdgeIsRounded) {
  // In the corner between two grooves at right angles the slope changes little from sample to sample, in
  // whatever direction a fingertip crosses it.
  const auto slope_jump = [](int size) {
    const auto map =
        carved({stroke({{20, 54.5}, {89, 54.5}}), stroke({{54.5, 20}, {54.5, 89}})}, size, even_brush(9));
    const double per_unit = (size - 1) / geometry::kGlyphSide;
    double worst = 0;
    for (int y = 1; y + 1 < size; ++y)
      for (int x = 1; x + 1 < size; ++x)
        worst =
            std::max(worst, std::abs(map.at(x + 1, y) - 2.0 * map.at(x, y) + map.at(x - 1, y)) * per_unit);
    return worst;
  };
  // An edge would have the same jump on any grid; a rounded one halves it with each doubling.
  const double coarse = slope_jump(273);
  const double middle = slope_jump(545);
  EXPECT_LT(middle, 0.62 * coarse);
  EXPECT_LT(slope_jump(1089), 0.58 * middle);
}

}  // namespace
}  // namespace nazori::carving
