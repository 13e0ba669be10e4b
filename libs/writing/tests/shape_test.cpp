// SPDX-License-Identifier: Apache-2.0
// Sampling, smoothing, kicks, and the quick looks at strokes, by closed forms.
#include "shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "quick_strokes.h"
#include "stroke_picture.h"

namespace nazori::writing::test {
namespace {

/// Samples at the whole numbers 0..23 of a line in x.
Samples ruler() {
  Samples s;
  for (std::size_t k = 0; k < kSamples; ++k) s.x[k] = static_cast<float>(k);
  return s;
}

TEST(Samples, TheCentreIsTheirMeanAndTheInertiaTheSumOfTheirSquaredDistances) {
  Samples s = ruler();
  for (auto& y : s.y) y = 3;
  s.find_centre();
  EXPECT_FLOAT_EQ(s.centre_x, 11.5F);
  EXPECT_FLOAT_EQ(s.centre_y, 3);
  // n (n^2 - 1) / 12 for n points one apart.
  EXPECT_FLOAT_EQ(s.inertia, 1150);
  std::swap(s.x, s.y);
  s.find_centre();
  EXPECT_FLOAT_EQ(s.centre_y, 11.5F);
  EXPECT_FLOAT_EQ(s.inertia, 1150);
}

TEST(Samples, SmoothingSpreadsASpikeAsTheBinomialsDo) {
  Samples s = ruler();
  s.y[5] = 16;
  s.y[20] = -32;
  s.smooth(2);
  const std::array<float, 5> once{1, 4, 6, 4, 1};
  for (std::size_t k = 0; k < kSamples; ++k) {
    float expected = 0;
    if (k >= 3 && k <= 7) expected = once.at(k - 3);
    if (k >= 18 && k <= 22) expected = -2 * once.at(k - 18);
    EXPECT_FLOAT_EQ(s.y[k], expected) << k;
    EXPECT_FLOAT_EQ(s.x[k], static_cast<float>(k)) << "even steps stay even";
  }
  EXPECT_FLOAT_EQ(s.centre_y, -16.0F / 24);
  float length = 0;
  for (std::size_t k = 1; k < kSamples; ++k) length += std::hypot(1.0F, s.y[k] - s.y[k - 1]);
  EXPECT_FLOAT_EQ(s.length, length);
}

TEST(Samples, SmoothingLeavesTheEndsWhereTheyAre) {
  Samples s = ruler();
  s.y[0] = 8;
  s.x[23] = 31;
  s.smooth(1);
  EXPECT_FLOAT_EQ(s.y[0], 8);
  EXPECT_FLOAT_EQ(s.y[1], 2);
  EXPECT_FLOAT_EQ(s.x[23], 31);
  EXPECT_FLOAT_EQ(s.x[22], 24);
}

TEST(Samples, AMapMovesEachAndMeasuresThemAgain) {
  Samples s = ruler();
  for (std::size_t k = 0; k < kSamples; ++k) s.y[k] = static_cast<float>(k % 3);
  const auto mapped = transformed(s, {2, 0.5, 10, -0.25, 3, -20});
  float length = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    EXPECT_FLOAT_EQ(mapped.x[k], 2 * s.x[k] + 0.5F * s.y[k] + 10);
    EXPECT_FLOAT_EQ(mapped.y[k], -0.25F * s.x[k] + 3 * s.y[k] - 20);
    if (k > 0) length += std::hypot(mapped.x[k] - mapped.x[k - 1], mapped.y[k] - mapped.y[k - 1]);
  }
  EXPECT_FLOAT_EQ(mapped.length, length);
  EXPECT_NEAR(mapped.centre_x, 2 * 11.5 + 0.5 * 1 + 10, 1e-4);
  const Affine same;
  const auto unmoved = transformed(s, same);
  EXPECT_EQ(unmoved.x, s.x);
  EXPECT_EQ(unmoved.y, s.y);
}

TEST(SampledLine, PointsThatComeTwiceAndASinglePointDoNoHarm) {
  const std::vector<double> xs{0, 0, 10, 10, 10, 23, 23};
  const std::vector<double> ys{5, 5, 5, 5, 5, 5, 5};
  const auto s = sample_line(xs, ys);
  EXPECT_FLOAT_EQ(s.length, 23);
  for (std::size_t k = 0; k < kSamples; ++k) {
    EXPECT_NEAR(s.x[k], static_cast<float>(k), 1e-4F);
    EXPECT_FLOAT_EQ(s.y[k], 5);
  }
  const std::vector<double> x{7}, y{9};
  const auto dot = sample_line(x, y);
  EXPECT_EQ(dot.length, 0);
  for (std::size_t k = 0; k < kSamples; ++k) {
    EXPECT_EQ(dot.x[k], 7);
    EXPECT_EQ(dot.y[k], 9);
  }
  EXPECT_EQ(dot.inertia, 0);
}

/// A line of 23 steps of which the last `kick` steps turn by `degrees`; `before` that it is straight.
struct Bent {
  std::vector<double> xs{0}, ys{0};
  void go(int steps, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    xs.push_back(xs.back() + steps * std::cos(angle));
    ys.push_back(ys.back() + steps * std::sin(angle));
  }
  [[nodiscard]] Shape shape() const { return make_shape(xs, ys); }
};
Shape bent(int kick, double degrees) {
  Bent line;
  line.go(23 - kick, 0);
  line.go(kick, degrees);
  return line.shape();
}

TEST(Kick, TurnsByMoreThanFiftyFiveDegrees) {
  for (const int kick : {1, 4, 7}) {
    for (const double side : {1, -1}) {
      EXPECT_FALSE(bent(kick, side * 54).kicked) << kick;
      EXPECT_TRUE(bent(kick, side * 57).kicked) << kick;
      EXPECT_TRUE(bent(kick, side * 120).kicked) << kick;
      EXPECT_EQ(bent(kick, side * 54).body.has_value(), false);
    }
  }
}

TEST(Kick, IsAtMostThreeTenthsOfTheLine) {
  EXPECT_TRUE(bent(7, 60).kicked);
  EXPECT_FALSE(bent(8, 60).kicked);
}

TEST(Kick, BeginsAtTheCornerWhichEndsTheBody) {
  for (const int kick : {1, 3, 5, 7}) {
    const auto shape = bent(kick, 90);
    ASSERT_TRUE(shape.body);
    EXPECT_NEAR(shape.body->x.back(), 23 - kick, 1e-3);
    EXPECT_NEAR(shape.body->y.back(), 0, 1e-3);
    EXPECT_NEAR(shape.body->length, 23 - kick, 1e-3) << "smoothing leaves a straight line alone";
    EXPECT_NEAR(shape.body->x[12], (23 - kick) * 12.0 / 23, 1e-3);
    EXPECT_NEAR(shape.whole.y.back(), kick, 1e-3);
  }
}

TEST(Kick, OfTwoCornersTheSharperCounts) {
  Bent later;
  later.go(18, 0);
  later.go(3, 60);
  later.go(2, 180);
  ASSERT_TRUE(later.shape().body);
  EXPECT_GT(later.shape().body->length, 19.5) << "the corner of 120 degrees";
  Bent sooner;
  sooner.go(18, 0);
  sooner.go(3, 120);
  sooner.go(2, 180);
  ASSERT_TRUE(sooner.shape().body);
  EXPECT_NEAR(sooner.shape().body->length, 18, 0.2);
}

TEST(Shape, AWholeLineIsSmoothedTwice) {
  const auto shape = bent(0, 0);
  EXPECT_NEAR(shape.whole.length, 23, 1e-3);
  EXPECT_EQ(shape.kicked, false);
  // The corner is at sample 12: y rises by one a sample from there on.
  Bent line;
  line.go(12, 0);
  line.go(11, 90);
  const auto corner = line.shape().whole;
  // Binomials 1 4 6 4 1 over 16.
  EXPECT_NEAR(corner.y[10], 0, 1e-3);
  EXPECT_NEAR(corner.y[11], 1.0 / 16, 1e-3);
  EXPECT_NEAR(corner.y[12], (4 + 2) / 16.0, 1e-3);
  EXPECT_NEAR(corner.y[13], (6 + 8 + 3) / 16.0, 1e-3);
  EXPECT_NEAR(corner.x[12], 12 - 6.0 / 16, 1e-3);
}

TEST(Shape, AMapMovesTheBodyTooAndKeepsTheKick) {
  const auto shape = bent(4, 90);
  const auto mapped = transformed(shape, {2, 0, 5, 0, 3, 7});
  EXPECT_TRUE(mapped.kicked);
  ASSERT_TRUE(mapped.body);
  EXPECT_NEAR(mapped.body->x.back(), 2 * 19 + 5, 1e-3);
  EXPECT_NEAR(mapped.body->y.back(), 7, 1e-3);
  EXPECT_NEAR(mapped.whole.y.back(), 3 * 4 + 7, 1e-3);
  EXPECT_FALSE(transformed(bent(0, 0), {}).kicked);
  EXPECT_FALSE(transformed(bent(0, 0), {}).body);
}

TEST(Shape, TwoStrokesWithoutLiftingThePenAreALineThroughBoth) {
  const std::vector<double> x1{0, 10}, y1{0, 0}, x2{10, 24}, y2{6, 6};
  const auto both = joined(sample_line(x1, y1), sample_line(x2, y2));
  const std::vector<double> xs{0, 10, 10, 24}, ys{0, 0, 6, 6};
  const auto line = make_shape(xs, ys);
  EXPECT_NEAR(both.whole.length, line.whole.length, 1e-3);
  for (std::size_t k = 0; k < kSamples; ++k) {
    EXPECT_NEAR(both.whole.x[k], line.whole.x[k], 1e-3) << k;
    EXPECT_NEAR(both.whole.y[k], line.whole.y[k], 1e-3) << k;
  }
}

// Three points of each stroke.

TEST(ThreePoints, AreTheStartTheMiddleOfTheWayAndTheEnd) {
  const std::vector<float> line{0, 0, 10, 0, 10, 4, 10, 30};
  const auto p = three_points(line);
  EXPECT_THAT(p.x, testing::ElementsAre(0, 10, 10));
  EXPECT_THAT(p.y, testing::ElementsAre(0, 10, 30)) << "20 of 40";
  const std::vector<float> first{0, 0, 9, 12, 9, 13};
  EXPECT_NEAR(three_points(first).x[1], 4.8F, 1e-5F) << "8 of 16, within the first part";
  EXPECT_NEAR(three_points(first).y[1], 6.4F, 1e-5F);
  const std::vector<float> dot{3, 4};
  EXPECT_THAT(three_points(dot).x, testing::ElementsAre(3, 3, 3));
  EXPECT_THAT(three_points(dot).y, testing::ElementsAre(4, 4, 4));
  const std::vector<float> twice{3, 4, 3, 4};
  EXPECT_THAT(three_points(twice).x, testing::ElementsAre(3, 3, 3));
}

std::vector<ThreePoints> some_strokes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, 100);
  std::vector<ThreePoints> strokes(count);
  for (auto& s : strokes)
    for (std::size_t k = 0; k < 3; ++k) s.x[k] = place(random), s.y[k] = place(random);
  return strokes;
}

/// By the definition: both brought to their centre and mean square 1, mean squared distance of the points.
double distance_by_definition(std::span<const ThreePoints> a, std::span<const ThreePoints> b) {
  const auto normal = [](std::span<const ThreePoints> strokes) {
    std::vector<std::pair<double, double>> points;
    double x = 0, y = 0, squares = 0;
    for (const auto& s : strokes)
      for (std::size_t k = 0; k < 3; ++k) {
        points.emplace_back(s.x[k], s.y[k]);
        x += points.back().first, y += points.back().second;
      }
    const auto n = static_cast<double>(points.size());
    for (auto& p : points) {
      p = {p.first - x / n, p.second - y / n};
      squares += p.first * p.first + p.second * p.second;
    }
    for (auto& p : points) p = {p.first / std::sqrt(squares / n), p.second / std::sqrt(squares / n)};
    return points;
  };
  const auto p = normal(a), q = normal(b);
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += std::pow(p[i].first - q[i].first, 2) + std::pow(p[i].second - q[i].second, 2);
  return sum / static_cast<double>(p.size());
}

TEST(QuickStrokes, ADrawingIsCentredAndOfUnitSize) {
  const auto drawing = quick_drawing(some_strokes(4, 1));
  double x = 0, y = 0, squares = 0;
  for (const auto& s : drawing.strokes)
    for (std::size_t k = 0; k < 3; ++k) {
      x += s.x[k], y += s.y[k];
      squares += s.x[k] * s.x[k] + s.y[k] * s.y[k];
    }
  EXPECT_NEAR(x, 0, 1e-4);
  EXPECT_NEAR(y, 0, 1e-4);
  EXPECT_NEAR(squares / 12, 1, 1e-4);
  for (const auto& s : quick_drawing(std::vector<ThreePoints>(2)).strokes)
    EXPECT_EQ(s.x[1], 0) << "a mere point";
}

TEST(QuickStrokes, TheDistanceIsThatOfTheDefinition) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto drawn = some_strokes(1 + seed % 5, seed);
    auto model = some_strokes(1 + seed % 5, 100 + seed);
    EXPECT_NEAR(distance_in_order(quick_drawing(drawn), model), distance_by_definition(drawn, model), 1e-4);
    EXPECT_NEAR(distance_in_order(quick_drawing(drawn), drawn), 0, 1e-4);
    // Strokes that were not drawn yet do not count.
    const double before = distance_in_order(quick_drawing(drawn), model);
    model.push_back(ThreePoints{{5, 6, 7}, {500, 600, 700}});
    EXPECT_NEAR(distance_in_order(quick_drawing(drawn), model), before, 1e-6);
  }
}

TEST(QuickStrokes, WithOneStrokeMoreOnEitherSideTheNearestGapCounts) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto shorter = some_strokes(1 + seed % 4, seed);
    const auto longer = some_strokes(2 + seed % 4, 200 + seed);
    double nearest = 9;
    for (std::size_t gap = 0; gap < longer.size(); ++gap) {
      auto others = longer;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(gap));
      nearest = std::min(nearest, distance_by_definition(shorter, others));
    }
    EXPECT_NEAR(distance_with_a_gap(quick_drawing(shorter), longer), nearest, 1e-4) << seed;
    EXPECT_NEAR(distance_with_one_too_many(quick_drawing(longer), shorter), nearest, 1e-4) << seed;
  }
}

// The picture of the ink.

/// How much of the ink of a picture has each slant: 0, 45, 90, 135 degrees.
std::array<float, 4> slants(const Picture& p) {
  std::array<float, 4> sum{};
  for (std::size_t i = 0; i < p.size(); ++i) sum[i % 4] += p[i] * p[i];
  return sum;
}

TEST(Picture, HasLengthOneAndEachSlantInItsPlane) {
  const std::vector<std::pair<std::vector<float>, std::size_t>> lines{
      {{0, 0, 50, 0}, 0}, {{0, 0, 0, 50}, 2}, {{50, 3, 10, 3}, 0}};
  for (const auto& [line, slant] : lines) {
    const auto p = make_picture(std::vector<FlatLine>{line});
    EXPECT_NEAR(slants(p)[slant], 1, 1e-4);
    EXPECT_NEAR(likeness(p, p), 1, 1e-4);
  }
  // Diagonals of a square, so that nothing is squashed: down to the right is 45 degrees.
  const std::vector<float> down{0, 0, 50, 50}, up{0, 50, 50, 0};
  const auto one = make_picture(std::vector<FlatLine>{down});
  EXPECT_NEAR(slants(one)[1], 1, 1e-4);
  EXPECT_NEAR(slants(make_picture(std::vector<FlatLine>{up}))[3], 1, 1e-4);
  EXPECT_NEAR(likeness(one, make_picture(std::vector<FlatLine>{up})), 0, 1e-4) << "no slant in common";
  const auto both = slants(make_picture(std::vector<FlatLine>{down, up}));
  EXPECT_NEAR(both[1], 0.5, 1e-4);
  EXPECT_NEAR(both[3], 0.5, 1e-4);
}

TEST(Picture, ASlantBetweenTwoIsSharedBySquaredCosines) {
  // 22.5 degrees: cos 45 of both neighbours.
  const float t = std::tan(std::numbers::pi_v<float> / 8);
  // A second line turned the other way keeps the spreads as they are; each quarter is mirrored.
  std::vector<std::vector<float>> lines;
  for (const float side : {1.0F, -1.0F}) {
    lines.push_back({-40, side * -40 * t, 40, side * 40 * t});
    lines.push_back({side * -40 * t, -40, side * 40 * t, 40});
  }
  const auto s = slants(make_picture(std::vector<FlatLine>(lines.begin(), lines.end())));
  for (const float share : s) EXPECT_NEAR(share, 0.25, 1e-3);
}

TEST(Picture, InkLiesInTheCellsWhereItWasDrawn) {
  // Four short bars at the corners of a square of side 40, each 2 long: their spread is 20.
  const auto bar = [](float x, float y) { return std::vector<float>{x - 1, y, x + 1, y}; };
  const std::vector<std::vector<float>> bars{bar(0, 0), bar(40, 0), bar(0, 40), bar(40, 40)};
  const auto p = make_picture(std::vector<FlatLine>(bars.begin(), bars.end()));
  // 8 cells span 4.4 spreads: one spread is 8 / 4.4 cells from the middle at 4.
  const double reach = 8 / 4.4;
  std::array<double, 2> least{9, 9}, most{0, 0};
  double sum_x = 0, sum_y = 0;
  for (std::size_t cell = 0; cell < 64; ++cell) {
    const double ink = static_cast<double>(p[4 * cell]) * static_cast<double>(p[4 * cell]);
    if (ink <= 0) continue;
    const double x = static_cast<double>(cell % 8) + 0.5, y = static_cast<double>(cell / 8) + 0.5;
    sum_x += ink * x;
    sum_y += ink * y;
    least = {std::min(least[0], x), std::min(least[1], y)};
    most = {std::max(most[0], x), std::max(most[1], y)};
    // Ink is shared by the cells whose middles are within one of it.
    EXPECT_TRUE(std::abs(std::abs(x - 4) - reach) < 1.1) << cell;
    EXPECT_TRUE(std::abs(std::abs(y - 4) - reach) < 1.1) << cell;
  }
  EXPECT_NEAR(sum_x, 4, 1e-3);
  EXPECT_NEAR(sum_y, 4, 1e-3);
  // A bar alone in the left half has its middle there.
  double left = 0, ink_left = 0;
  for (std::size_t cell = 0; cell < 64; ++cell)
    if (cell % 8 < 4) {
      const double ink = static_cast<double>(p[4 * cell]) * static_cast<double>(p[4 * cell]);
      left += ink * (static_cast<double>(cell % 8) + 0.5);
      ink_left += ink;
    }
  EXPECT_NEAR(ink_left, 0.5, 1e-3);
  EXPECT_NEAR(left / ink_left, 4 - reach, 0.05);
}

TEST(Picture, AFlatCharacterIsStretchedNoMoreThanItsLimit) {
  // A box of 100 x 30; the spreads are integrals along its sides.
  const std::vector<float> box{0, 0, 100, 0, 100, 30, 0, 30, 0, 0};
  const auto p = make_picture(std::vector<FlatLine>{box});
  const double spread_x = std::sqrt((200 * (100.0 * 100 / 12) + 60 * (50.0 * 50)) / 260);
  const double spread_y = std::sqrt((60 * (30.0 * 30 / 12) + 200 * (15.0 * 15)) / 260);
  ASSERT_LT(spread_y, 0.6 * spread_x);
  // 8 cells span 4.4 spreads, and the smaller spread counts as 0.6 of the larger one.
  const double scale_x = 8 / (4.4 * spread_x);
  const double scale_y = 8 / (4.4 * 0.6 * spread_x);
  const double ink = 200 * scale_x + 60 * scale_y;
  double mean = 0, level = 0;
  for (std::size_t cell = 0; cell < 32; ++cell) {
    const double share = std::pow(static_cast<double>(p[4 * cell]), 2);
    level += share;
    mean += share * (static_cast<double>(cell / 8) + 0.5);
  }
  EXPECT_NEAR(level, 100 * scale_x / ink, 2e-3) << "the upper side";
  EXPECT_NEAR(mean / level, 4 - 15 * scale_y, 2e-3);
}

TEST(Picture, LongerLinesHaveMoreInk) {
  const std::vector<float> bar{0, 0, 60, 0}, post{30, 10, 30, 30};
  const auto s = slants(make_picture(std::vector<FlatLine>{bar, post}));
  // In both directions the scale differs: the spreads are not equal.
  EXPECT_GT(s[0], s[2]);
  EXPECT_NEAR(s[0] + s[2], 1, 1e-4);
  const std::vector<float> cross_bar{-30, 0, 30, 0}, cross_post{0, -30, 0, 30};
  const auto even = slants(make_picture(std::vector<FlatLine>{cross_bar, cross_post}));
  EXPECT_NEAR(even[0], 0.5, 1e-3);
}

TEST(Picture, IsTheSameOfALineInPieces) {
  const std::vector<float> whole{0, 0, 40, 30}, pieces{0, 0, 8, 6, 24, 18, 24, 18, 40, 30}, post{0, 40, 0, 0};
  EXPECT_NEAR(likeness(make_picture(std::vector<FlatLine>{whole, post}),
                       make_picture(std::vector<FlatLine>{pieces, post})),
              1, 2e-3);
}

TEST(Picture, OfStrokesWithoutLengthIsEmpty) {
  const std::vector<float> dot{5, 5}, twice{5, 5, 5, 5};
  for (const float v : make_picture(std::vector<FlatLine>{dot, twice})) EXPECT_EQ(v, 0);
}

TEST(Picture, InkBeyondTheEdgeIsHeldThere) {
  // One far speck beside a heavy middle lies many spreads out.
  std::vector<std::vector<float>> lines;
  for (int i = 0; i < 40; ++i) {
    const auto f = static_cast<float>(i % 7);
    lines.push_back({f, 0, f, 10});
    lines.push_back({0, f, 10, f});
  }
  lines.push_back({300, 300, 302, 300});
  const auto p = make_picture(std::vector<FlatLine>(lines.begin(), lines.end()));
  EXPECT_GT(p[4 * 63], 0) << "the last cell";
  EXPECT_NEAR(likeness(p, p), 1, 1e-4);
}

}  // namespace
}  // namespace nazori::writing::test
