// SPDX-License-Identifier: Apache-2.0
// Laying one set of strokes over another.
#include "fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace nazori::writing::test {
namespace {

Shape line(std::vector<double> xs, std::vector<double> ys) { return make_shape(xs, ys); }

/// Strokes all over the box, so many that the map is not noticeably restrained.
std::vector<Samples> many(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-500, 500);
  std::vector<Samples> strokes;
  for (std::size_t i = 0; i < count; ++i)
    strokes.push_back(line({place(random), place(random)}, {place(random), place(random)}).whole);
  return strokes;
}

/// The map that is found from strokes that were moved by the inverse of `truth`.
Affine found(const std::vector<Samples>& model, const Affine& truth, double expected, bool reversed = false) {
  const double det = truth.a * truth.d - truth.b * truth.c;
  const Affine inverse{truth.d / det,  -truth.b / det, (truth.b * truth.ty - truth.d * truth.tx) / det,
                       -truth.c / det, truth.a / det,  (truth.c * truth.tx - truth.a * truth.ty) / det};
  std::vector<Samples> drawn;
  for (const auto& m : model) {
    drawn.push_back(transformed(m, inverse));
    if (reversed) {
      std::reverse(drawn.back().x.begin(), drawn.back().x.end());
      std::reverse(drawn.back().y.begin(), drawn.back().y.end());
    }
  }
  std::vector<FitPair> pairs;
  for (std::size_t k = 0; k < model.size(); ++k) pairs.push_back({&drawn[k], &model[k], reversed, 1});
  return fit(pairs, expected);
}

void expect_near(const Affine& got, const Affine& expected, double tolerance) {
  EXPECT_NEAR(got.a, expected.a, tolerance);
  EXPECT_NEAR(got.b, expected.b, tolerance);
  EXPECT_NEAR(got.c, expected.c, tolerance);
  EXPECT_NEAR(got.d, expected.d, tolerance);
  EXPECT_NEAR(got.tx, expected.tx, 500 * tolerance);
  EXPECT_NEAR(got.ty, expected.ty, 500 * tolerance);
}

TEST(Fit, OfPlaceAndSizeIsExactHoweverFewStrokesThereAre) {
  for (const std::size_t count : {1U, 2U, 5U})
    for (const bool reversed : {false, true}) {
      expect_near(found(many(count, 7), {1, 0, 30, 0, 1, -20}, 1, reversed), {1, 0, 30, 0, 1, -20}, 1e-3);
      expect_near(found(many(count, 8), {3, 0, -7, 0, 3, 11}, 3, reversed), {3, 0, -7, 0, 3, 11}, 1e-3);
    }
}

TEST(Fit, OfManyStrokesFindsAnyMapThatAHandMakes) {
  for (const Affine truth : {Affine{1.2, 0.15, 30, -0.1, 0.9, -20}, Affine{0.9, -0.2, 0, 0.1, 1.2, 40},
                             Affine{2, 0, 5, 0, 2, 5}, Affine{0.5, 0, 5, 0, 0.5, 5}})
    expect_near(found(many(60, 9), truth, 1), truth, 0.02);
}

TEST(Fit, IsTheSameInAnyUnit) {
  const auto model = many(4, 3);
  const Affine truth{1.3, 0.2, 4, -0.1, 0.9, 8};
  const auto one = found(model, truth, 1);
  const auto hundred = found(model, {130, 20, 4, -10, 90, 8}, 100);
  EXPECT_NEAR(hundred.a, 100 * one.a, 0.1);
  EXPECT_NEAR(hundred.b, 100 * one.b, 0.1);
  EXPECT_NEAR(hundred.c, 100 * one.c, 0.1);
  EXPECT_NEAR(hundred.d, 100 * one.d, 0.1);
}

TEST(Fit, AWeightIsANumberOfStrokes) {
  const auto model = many(3, 5);
  auto drawn = model;
  drawn[0] = transformed(model[0], {1, 0.2, 9, 0.1, 1, -5});
  drawn[2] = transformed(model[2], {0.9, 0, 2, 0, 1.1, 8});
  const auto pair = [&](std::size_t k, double weight) {
    return FitPair{&drawn[k], &model[k], false, weight};
  };
  const std::vector<FitPair> weighed{pair(0, 3), pair(1, 1), pair(2, 2)};
  const std::vector<FitPair> counted{pair(0, 1), pair(2, 1), pair(0, 1), pair(1, 1), pair(2, 1), pair(0, 1)};
  expect_near(fit(weighed, 1), fit(counted, 1), 1e-4);
  const std::vector<FitPair> others{pair(0, 1), pair(1, 1), pair(2, 2)};
  EXPECT_GT(std::abs(fit(weighed, 1).tx - fit(others, 1).tx), 0.1);
}

TEST(Fit, ASlantIsHeldBackTheLessTheMoreStrokesHaveIt) {
  // A cross that leans, n times: what is found of its slant is 1 / (1 + c / n) of it.
  const auto post = line({50, 50}, {10, 90}).whole, bar = line({10, 90}, {50, 50}).whole;
  const Affine lean{1, -0.3, 15, 0, 1, 0};
  const auto leaning = transformed(post, lean), level = transformed(bar, lean);
  const auto share = [&](std::size_t n) {
    std::vector<FitPair> pairs;
    for (std::size_t k = 0; k < n; ++k) {
      pairs.push_back({&leaning, &post, false, 1});
      pairs.push_back({&level, &bar, false, 1});
    }
    return fit(pairs, 1).b / 0.3;
  };
  EXPECT_GT(share(1), 0.05);
  EXPECT_LT(share(1), 0.6);
  const double one = 1 / share(1), two = 1 / share(2), four = 1 / share(4);
  EXPECT_NEAR((one - two) / (two - four), 2, 0.2);
  EXPECT_NEAR(1 / share(10'000), 1, 0.01);
  // A single rising bar is restrained as much as a leaning vertical.
  const auto rising = transformed(bar, {1, 0, 0, -0.3, 1, 0});
  const std::vector<FitPair> bars{{&rising, &bar, false, 1}}, posts{{&leaning, &post, false, 1}};
  EXPECT_NEAR(fit(bars, 1).c, fit(posts, 1).b, 1e-3);
}

TEST(Fit, WhatNoStrokeTellsIsAsExpected) {
  // One bar does not determine the height: it follows the width.
  const auto bar = line({10, 90}, {50, 50}).whole;
  const auto half = transformed(bar, {0.5, 0, 0, 0, 0.5, 0});
  const std::vector<FitPair> pairs{{&half, &bar, false, 1}};
  const auto map = fit(pairs, 1);
  EXPECT_GT(map.a, 1.3);
  EXPECT_LT(map.a, 2);
  EXPECT_GT(map.d, 1.2);
  EXPECT_LE(map.d, map.a + 1e-6);
  EXPECT_NEAR(map.a * half.centre_x + map.tx, 50, 1e-3) << "centre on centre";
  EXPECT_NEAR(map.d * half.centre_y + map.ty, 50, 1e-3);
  // Points determine nothing.
  const auto point = line({20}, {30}).whole, place = line({70}, {80}).whole;
  const std::vector<FitPair> points{{&point, &place, false, 1}};
  expect_near(fit(points, 4), {4, 0, 70 - 4 * 20, 0, 4, 80 - 4 * 30}, 1e-6);
}

TEST(Fit, WithoutStrokesOrWeightIsNoMapAtAll) {
  expect_near(fit(std::span<const FitPair>(), 5), {}, 0);
  const auto bar = line({10, 90}, {50, 50}).whole;
  const std::vector<FitPair> pairs{{&bar, &bar, false, 0}};
  expect_near(fit(pairs, 5), {}, 0);
}

TEST(Fit, WritingIsNeitherMirroredNorSqueezedFlatNorBlownUp) {
  const auto model = many(60, 4);
  for (const double size : {-1.0, 0.36, 2.8}) {
    EXPECT_NEAR(found(model, {size, 0, 0, 0, size, 0}, 1).a, 1, 1e-9) << size;
    EXPECT_NEAR(found(model, {size, 0, 0, 0, size, 0}, 1).d, 1, 1e-9) << size;
  }
  for (const double size : {0.44, 2.2}) EXPECT_NEAR(found(model, {size, 0, 0, 0, size, 0}, 1).a, size, 0.02);
  // The same of one direction alone.
  EXPECT_NEAR(found(model, {0.5, 0, 0, 0, 0.36, 0}, 1).a, 1, 1e-9);
  EXPECT_NEAR(found(model, {0.36, 0, 0, 0, 0.5, 0}, 1).d, 1, 1e-9);
  EXPECT_NEAR(found(model, {2.8, 0, 0, 0, 2.2, 0}, 1).d, 1, 1e-9);
  EXPECT_NEAR(found(model, {2.2, 0, 0, 0, 2.8, 0}, 1).a, 1, 1e-9);
}

TEST(Fit, NorStretchedBeyondWhatHandsDo) {
  const auto model = many(60, 4);
  for (const bool wide : {true, false}) {
    const auto within = found(model, wide ? Affine{1.24, 0, 0, 0, 0.8, 0} : Affine{0.8, 0, 0, 0, 1.24, 0}, 1);
    EXPECT_NEAR(wide ? within.a / within.d : within.d / within.a, 1.55, 0.02);
    const auto beyond = found(model, wide ? Affine{1.5, 0, 9, 0, 0.75, 0} : Affine{0.75, 0, 0, 0, 1.5, 9}, 1);
    EXPECT_NEAR(wide ? beyond.a / beyond.d : beyond.d / beyond.a, 1.6, 1e-6);
    EXPECT_NEAR(beyond.a * beyond.d, 1.5 * 0.75, 0.03) << "the area stays";
  }
}

TEST(FitByMoments, LaysCentreOnCentreAndSpreadOnSpread) {
  const std::vector<Shape> model{line({10, 90}, {20, 20}), line({50, 50}, {5, 95})};
  const Affine truth{0.02, 0, 7, 0, 0.02, -3};
  std::vector<Shape> drawn;
  for (const auto& m : model) drawn.push_back(transformed(m, truth));
  const auto map = fit_by_moments(drawn, model);
  EXPECT_NEAR(map.a, 50, 0.01);
  EXPECT_NEAR(map.d, 50, 0.01);
  EXPECT_EQ(map.b, 0);
  EXPECT_EQ(map.c, 0);
  EXPECT_NEAR(map.tx, -7 * 50, 0.1);
  EXPECT_NEAR(map.ty, 3 * 50, 0.1);
}

TEST(FitByMoments, CountsStrokesByTheirLengthAndTheirOwnSpread) {
  // Two bars of 30 and 10: the centre is at three quarters.
  const std::vector<Shape> bars{line({0, 30}, {10, 10}), line({0, 10}, {50, 50})};
  const std::vector<Shape> unit{line({-1, 1}, {0, 0}), line({0, 0}, {-1, 1})};
  const auto map = fit_by_moments(bars, unit);
  EXPECT_NEAR(map.a * (0.75 * 15 + 0.25 * 5) + map.tx, 0, 1e-3);
  EXPECT_NEAR(map.d * (0.75 * 10 + 0.25 * 50) + map.ty, 0, 1e-3);
  // Mean square distance from the centre, samples of a line of length l having l^2 (n^2 - 1) / 12 (n - 1)^2
  // of their own.
  const double own = (24.0 * 24 - 1) / 12 / (23 * 23);
  const double x = 0.75 * 2.5 * 2.5 + 0.25 * 7.5 * 7.5, y = 0.75 * 10 * 10 + 0.25 * 30 * 30;
  const double spread = x + y + 0.75 * 900 * own + 0.25 * 100 * own;
  EXPECT_NEAR(map.a, std::sqrt(4 * own / spread), 1e-4);
}

TEST(FitByMoments, APointKeepsItsSize) {
  const std::vector<Shape> point{line({5}, {6})}, bar{line({10, 90}, {20, 20})};
  const auto map = fit_by_moments(point, bar);
  EXPECT_EQ(map.a, 1);
  EXPECT_EQ(map.d, 1);
  EXPECT_NEAR(map.tx, 45, 1e-4);
  EXPECT_NEAR(map.ty, 14, 1e-4);
}

}  // namespace
}  // namespace nazori::writing::test
