// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nazori/carving/carve.h"
#include "nazori/geometry/polyline.h"
#include "nazori/kanji/stroke_order.h"
#include "test_strokes.h"

namespace nazori::carving {
namespace {

using namespace test;

/// Change of slope from sample to sample over a whole map, in brush depths a glyph unit; sorted.
std::vector<float> slope_jumps(const surface::HeightMap& map) {
  std::vector<float> jumps;
  const auto per_unit = static_cast<float>((map.size() - 1) / geometry::kGlyphSide);
  for (int y = 1; y + 1 < map.size(); ++y) {
    for (int x = 1; x + 1 < map.size(); ++x) {
      const float h = 2 * map.at(x, y);
      const float across = std::abs(map.at(x + 1, y) + map.at(x - 1, y) - h);
      const float down = std::abs(map.at(x, y + 1) + map.at(x, y - 1) - h);
      jumps.push_back(std::max(across, down) * per_unit);
    }
  }
  std::sort(jumps.begin(), jumps.end());
  return jumps;
}

TEST(CarvedKanji, SlopeJumpsHalveWithEachDoublingOfTheGridSoNoEdgeRemains) {
  for (const std::string character : {"休", "永", "書", "あ", "の", "る"}) {
    const auto strokes = kanjivg(character);
    // An edge would have the same jump on any grid. Checked for all but one sample in ten thousand, and with
    // a wider limit for these.
    const auto coarse = slope_jumps(carved(strokes, 512, {}));
    const auto fine = slope_jumps(carved(strokes, 1024, {}));
    const auto nearly_all = [](const std::vector<float>& jumps) {
      return jumps[jumps.size() - jumps.size() / 10000];
    };
    EXPECT_LT(nearly_all(fine), 0.62F * nearly_all(coarse)) << character;
    // The steepest wall has a slope of 0.44 to 0.6: a true edge on it would jump by twice that.
    EXPECT_LT(fine.back(), 0.35F) << character;
  }
}

TEST(CarvedKanji, EveryStrokeLiesOnTheFloorOfItsGrooveAsDeepAsTheBrushSays) {
  for (const std::string character : {"休", "永", "鬱", "口", "書", "あ", "の", "る"}) {
    const auto strokes = kanjivg(character);
    const Brush brush = fitted({}, strokes);
    const auto map = carved(strokes, 1024, {});
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      const std::span<const GlyphPoint> line(strokes[k].points);
      const double length = geometry::arc_length(line);
      const double hook = hook_length(strokes[k]);
      for (double s = 0; s <= length; s += 0.5) {
        const double depth = brush_at(brush, strokes[k].ending, s, length, hook).depth;
        // Another stroke may cut deeper, never less deep.
        EXPECT_LT(height_at(map, geometry::point_at(line, s)), 1 - depth + 0.04)
            << character << k + 1 << ' ' << s;
      }
    }
  }
}

TEST(CarvedKanji, BarsOfCrowdedCharactersKeepARidgeBetweenThem) {
  // 書: the bars of its upper half, left of the upright, and 三.
  struct Bars {
    std::string character;
    double x;
    int first;
    int last;
  };
  for (const Bars& bars : {Bars{"書", 40, 3, 5}, Bars{"三", 50, 0, 1}}) {
    const std::string& character = bars.character;
    const double x = bars.x;
    const auto strokes = kanjivg(character);
    const auto map = carved(strokes, 512, {});
    const auto y_of = [&](int k) {
      double best = 1e9;
      double y = 0;
      for (const GlyphPoint p : geometry::resample(
               std::span<const GlyphPoint>(strokes[static_cast<std::size_t>(k)].points), 400)) {
        if (std::abs(p.x - x) < best) {
          best = std::abs(p.x - x);
          y = p.y;
        }
      }
      return y;
    };
    for (int k = bars.first; k < bars.last; ++k) {
      double ridge = 0;
      for (double t = 0; t <= 1; t += 0.02) {
        ridge = std::max(ridge, height_at(map, {x, y_of(k) * (1 - t) + y_of(k + 1) * t}));
      }
      EXPECT_GT(ridge, 0.8) << character << ' ' << k;
    }
  }
}

/// x -> a x + b y + c for both coordinates.
struct Affine {
  std::array<double, 3> to_x;
  std::array<double, 3> to_y;
  GlyphPoint operator()(GlyphPoint p) const {
    return {to_x[0] * p.x + to_x[1] * p.y + to_x[2], to_y[0] * p.x + to_y[1] * p.y + to_y[2]};
  }
};

/// Least-squares affine map of `from` onto `to` (normal equations, Cramer's rule).
Affine fit(const std::vector<GlyphPoint>& from, const std::vector<GlyphPoint>& to) {
  double m[3][3] = {};
  double bx[3] = {};
  double by[3] = {};
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double row[3] = {from[i].x, from[i].y, 1};
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) m[r][c] += row[r] * row[c];
      bx[r] += row[r] * to[i].x;
      by[r] += row[r] * to[i].y;
    }
  }
  const auto determinant = [](const double(&a)[3][3]) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
           a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  };
  const auto solve = [&](const double(&b)[3]) {
    std::array<double, 3> out{};
    for (int c = 0; c < 3; ++c) {
      double copy[3][3];
      for (int r = 0; r < 3; ++r)
        for (int k = 0; k < 3; ++k) copy[r][k] = k == c ? b[r] : m[r][k];
      out[static_cast<std::size_t>(c)] = determinant(copy) / determinant(m);
    }
    return out;
  };
  return {solve(bx), solve(by)};
}

TEST(CarvedKanji, TheStrokesOf2005LieInTheGroovesOfOur休) {
  // The stroke points of character 0018, 休, hard-coded in the 2005 program, on its grid of 128.
  const kanji::StrokeOrder of_2005(std::vector<kanji::StrokeOrder::Points>{{{50, 21}, {19, 53}},
                                                                           {{40, 40}, {38, 99}},
                                                                           {{63, 32}, {109, 31}},
                                                                           {{85, 20}, {86, 97}},
                                                                           {{83, 41}, {72, 59}, {57, 74}},
                                                                           {{90, 41}, {103, 58}, {125, 70}}});
  const auto theirs = of_2005.to_lines(128);
  const auto ours = kanjivg("休");
  ASSERT_EQ(theirs.size(), ours.size());
  // Fit the whole hand-drawn character by one affine map: first point by point along the strokes, then,
  // because the drawings have different proportions, to the nearest point of the same stroke.
  std::vector<GlyphPoint> from;
  std::vector<GlyphPoint> to;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    for (const GlyphPoint p : geometry::resample(std::span<const GlyphPoint>(theirs[k].points), 41))
      from.push_back(p);
    for (const GlyphPoint p : geometry::resample(std::span<const GlyphPoint>(ours[k].points), 41))
      to.push_back(p);
  }
  Affine affine = fit(from, to);
  for (int round = 0; round < 5; ++round) {
    for (std::size_t i = 0; i < from.size(); ++i)
      to[i] =
          geometry::nearest_point(std::span<const GlyphPoint>(ours[i / 41].points), affine(from[i])).point;
    affine = fit(from, to);
  }
  // The map turns and shears by less than two degrees: so the characters really match.
  EXPECT_LT(std::abs(affine.to_x[1]), 0.04);
  EXPECT_LT(std::abs(affine.to_y[0]), 0.04);
  const auto map = carved(ours, 1024, {});
  double worst = 0;
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const GlyphPoint p = affine(from[i]);
    const double d = geometry::nearest_point(std::span<const GlyphPoint>(ours[i / 41].points), p).distance;
    worst = std::max(worst, d);
    sum += d;
  }
  // Half the width of the groove is 3.5 glyph units (of 109): no stroke leaves its groove.
  EXPECT_LT(worst, 3.45);
  EXPECT_LT(sum / static_cast<double>(from.size()), 1.0);
  int inside = 0;
  for (const GlyphPoint p : from) inside += height_at(map, affine(p)) < 0.9 ? 1 : 0;
  EXPECT_GT(inside, static_cast<int>(0.95 * static_cast<double>(from.size())));
}

}  // namespace
}  // namespace nazori::carving
