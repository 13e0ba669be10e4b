// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "nazori/functions/sound.h"

namespace nazori::functions {
namespace {

constexpr double kPi = std::numbers::pi;

struct Found {
  std::vector<PointOfInterest> all;
  [[nodiscard]] std::vector<PointOfInterest> of(PointKind kind) const {
    std::vector<PointOfInterest> some;
    for (const auto& p : all) {
      if (p.kind == kind) some.push_back(p);
    }
    return some;
  }
};

Found found_in(const std::string& text, const Window& window) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  const auto tracing = trace(*plot, window);
  EXPECT_TRUE(tracing);
  return {points_of_interest(*plot, *tracing)};
}

TEST(Points, TheSineHasItsZerosAndExtremaWithExactNames) {
  const Found f = found_in("y = sin(x)", {-5, 5, -5, 5});
  const auto zeros = f.of(PointKind::zero);
  ASSERT_EQ(zeros.size(), 3U);
  EXPECT_EQ(zeros[0].x_name, "-pi");
  EXPECT_EQ(zeros[1].x_name, "0");
  EXPECT_EQ(zeros[2].x_name, "pi");
  const auto maxima = f.of(PointKind::maximum);
  ASSERT_EQ(maxima.size(), 2U);
  EXPECT_NEAR(maxima[0].x, -3 * kPi / 2, 1e-9);
  EXPECT_EQ(maxima[1].x_name, "pi/2");
  EXPECT_EQ(maxima[1].y_name, "1");
  EXPECT_EQ(f.of(PointKind::minimum).size(), 2U);
}

TEST(Points, PolesHolesJumpsAndEndsAreToldApart) {
  EXPECT_EQ(found_in("y = tan(x)", {-6, 6, -4, 4}).of(PointKind::vertical_asymptote).size(), 4U);
  const auto hole = found_in("y = (x^2-1)/(x-1)", {-4, 4, -4, 4}).of(PointKind::hole);
  ASSERT_EQ(hole.size(), 1U);
  EXPECT_EQ(hole[0].x_name, "1");
  EXPECT_NEAR(hole[0].y, 2, 1e-6);
  EXPECT_EQ(found_in("y = floor(x)", {-3.5, 3.5, -4.5, 4.5}).of(PointKind::jump).size(), 7U);
  EXPECT_EQ(found_in("y = |x|/x", {-3, 3, -2, 2}).of(PointKind::jump).size(), 1U);
  const auto ends = found_in("y = asin(x)", {-2, 2, -2, 2}).of(PointKind::end);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[1].y_name, "pi/2");
}

TEST(Points, AnEndThatIsLeftOutIsAnEndButNeitherZeroNorJumpNorCrossing) {
  const Window window{-1, 5, -4, 4};
  const Found closed = found_in("x = t; y = t - 3; 0 <= t <= 3", window);
  EXPECT_EQ(closed.of(PointKind::zero).size(), 1U);
  const Found open = found_in("x = t; y = t - 3; 0 <= t < 3", window);
  EXPECT_EQ(open.of(PointKind::zero).size(), 0U);
  const auto ends = open.of(PointKind::end);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[1].x_name, "3");
  EXPECT_EQ(ends[1].y_name, "0");

  EXPECT_EQ(found_in("x = floor(t); y = t; 0 <= t <= 3", window).of(PointKind::jump).size(), 3U);
  EXPECT_EQ(found_in("x = floor(t); y = t; 0 <= t < 3", window).of(PointKind::jump).size(), 2U);

  EXPECT_EQ(found_in("x = t; y = t; 1 <= t <= 3; y = 3", window).of(PointKind::crossing).size(), 1U);
  EXPECT_EQ(found_in("x = t; y = t; 1 <= t < 3; y = 3", window).of(PointKind::crossing).size(), 0U);
  EXPECT_EQ(found_in("x = t; y = t; 1 < t <= 3; y = 1", window).of(PointKind::crossing).size(), 0U);
  EXPECT_EQ(found_in("x = t; y = t; 1 < t < 3; y = 2", window).of(PointKind::crossing).size(), 1U);
}

TEST(Points, ACrossingIsNotATouch) {
  const auto crossings = found_in("y = sin(x); y = cos(x)", {-5, 5, -5, 5}).of(PointKind::crossing);
  ASSERT_EQ(crossings.size(), 3U);
  EXPECT_EQ(crossings[1].x_name, "pi/4");
  const Found tangent = found_in("y = x^2; y = 2x - 1", {-3, 3, -3, 5});
  EXPECT_TRUE(tangent.of(PointKind::crossing).empty());
  const auto touch = tangent.of(PointKind::touching);
  ASSERT_EQ(touch.size(), 1U);
  EXPECT_NEAR(touch[0].x, 1, 1e-9);
  EXPECT_EQ(found_in("x^2+y^2=1; y=x", {-2, 2, -2, 2}).of(PointKind::crossing).size(), 2U);
  EXPECT_EQ(found_in("x^2+y^2=1; x^2-y^2=0.5", {-2, 2, -2, 2}).of(PointKind::crossing).size(), 4U);
}

TEST(Points, CurvesThatLieCloseWhereTheyCrossCrossThereExactly) {
  // tan x - sin x is about x^3/2 near 0: smaller than rounding errors nearby.
  const auto crossings = found_in("y = tan(x); y = sin(x)", {-6, 6, -4, 4}).of(PointKind::crossing);
  ASSERT_EQ(crossings.size(), 3U);
  EXPECT_EQ(crossings[0].x_name, "-pi");
  EXPECT_EQ(crossings[1].x_name, "0");
  EXPECT_EQ(crossings[1].y_name, "0");
  EXPECT_EQ(crossings[2].x_name, "pi");
  const auto fifth = found_in("y = (x - 0.3)^5; y = 0", {-2, 2, -2, 2}).of(PointKind::crossing);
  ASSERT_EQ(fifth.size(), 1U);
  EXPECT_EQ(fifth[0].x, 0.3);
  const auto fourth = found_in("y = x - sin(x)^4; y = x", {-2, 2, -2, 2}).of(PointKind::touching);
  ASSERT_EQ(fourth.size(), 1U);
  EXPECT_EQ(fourth[0].x, 0);
}

TEST(Points, TheSelfCrossingOfTheFoliumIsAtTheOrigin) {
  const auto p = found_in("x^3 + y^3 = 3xy", {-3, 3, -3, 3}).of(PointKind::self_crossing);
  ASSERT_EQ(p.size(), 1U);
  EXPECT_NEAR(p[0].x, 0, 1e-9);
  EXPECT_EQ(found_in("x^2 + y^2 = 0", {-1, 1, -1, 1}).of(PointKind::isolated).size(), 1U);
}

TEST(Points, ExactNamesAreOnlyForExactNumbers) {
  EXPECT_EQ(exact_name(kPi / 3), "pi/3");
  EXPECT_EQ(exact_name(std::sqrt(2.0)), "sqrt(2)");
  EXPECT_EQ(exact_name(1 / std::numbers::e), "1/e");
  EXPECT_EQ(exact_name((1 + std::sqrt(5.0)) / 2), "(1 + sqrt(5))/2");
  EXPECT_EQ(exact_name(0.75), "3/4");
  EXPECT_EQ(exact_name(std::log(2.0)), "ln(2)");
  EXPECT_FALSE(exact_name(1.0471975));
  EXPECT_FALSE(exact_name(std::nan("")));
}

TEST(Points, AnEmptyPlateIsSaid) {
  const auto plot = parse("x^2 + y^2 = -1");
  ASSERT_TRUE(plot);
  const auto tracing = trace(*plot, {-3, 3, -3, 3});
  ASSERT_TRUE(tracing);
  EXPECT_NE(summary(*plot, *tracing, {}, Language::english).find("no points in this range"),
            std::string::npos);
}

/// The frequency near `expected` at which the sound repeats itself best around a time.
double pitch_of(const Sound& sound, double at_s, double expected) {
  const auto at = [&](std::size_t k) {
    return static_cast<double>(sound.samples[2 * k] + sound.samples[2 * k + 1]);
  };
  const auto count = static_cast<std::size_t>(0.03 * sound.sample_rate);
  const double period = sound.sample_rate / expected;
  double best = 0;
  double best_lag = 1;
  for (auto lag = static_cast<std::size_t>(0.7 * period); lag < static_cast<std::size_t>(1.4 * period);
       ++lag) {
    const std::size_t first = static_cast<std::size_t>(at_s * sound.sample_rate) - (count + lag) / 2;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += at(first + i) * at(first + i + lag);
    if (sum > best) {
      best = sum;
      best_lag = static_cast<double>(lag);
    }
  }
  return sound.sample_rate / best_lag;
}

TEST(Sound, ThePitchOfARisingLineRisesFromTheLowestToTheHighest) {
  const auto plot = parse("y = x");
  ASSERT_TRUE(plot);
  const auto tracing = trace(*plot, {0, 1, 0, 1});
  ASSERT_TRUE(tracing);
  SoundSettings settings;
  settings.earcons = false;
  const auto sound = sweep(*plot, *tracing, {}, settings);
  ASSERT_TRUE(sound);
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double expected = 200 * std::pow(5.0, share);
    EXPECT_NEAR(pitch_of(*sound, share * settings.seconds, expected) / expected, 1.0, 0.015) << share;
  }
}

TEST(Sound, IsSilentWhereTheFunctionIsUndefinedAndAtVolumeZero) {
  const auto plot = parse("y = sqrt(x)");
  ASSERT_TRUE(plot);
  const auto tracing = trace(*plot, {-1, 1, 0, 1});
  ASSERT_TRUE(tracing);
  SoundSettings settings;
  settings.earcons = false;
  const auto sound = sweep(*plot, *tracing, {}, settings);
  ASSERT_TRUE(sound);
  const auto loudest = [](const Sound& s, std::size_t from, std::size_t to) {
    float most = 0;
    for (std::size_t i = 2 * from; i < 2 * to; ++i) most = std::max(most, std::abs(s.samples[i]));
    return most;
  };
  EXPECT_EQ(loudest(*sound, 0, 80'000), 0.0F);
  EXPECT_GT(loudest(*sound, 100'000, 170'000), 0.1F);
  settings.volume = 0;
  const auto muted = sweep(*plot, *tracing, {}, settings);
  ASSERT_TRUE(muted);
  EXPECT_EQ(loudest(*muted, 0, muted->samples.size() / 2), 0.0F);
}

TEST(Sound, BelowZeroHasNoiseInItAndTheSidesAreApart) {
  const Window w{-1, 1, -1, 1};
  EXPECT_EQ(cue_at({0.5, 0.75}, w, 1).noise, 0.0);
  EXPECT_GT(cue_at({0.5, 0.25}, w, 1).noise, 0.1);
  EXPECT_EQ(cue_at({0, 0.5}, w, 1).pan, -1.0);
  EXPECT_EQ(cue_at({1, 0.5}, w, 1).pan, 1.0);
  EXPECT_EQ(cue_at({1, 2.0}, w, 0).loudness, 0.0);
}

TEST(Points, WhatRoundingMakesOfALevelCurveIsNoExtremumAndNoInflection) {
  // Falls from 1 to 0 without a turn; at -3000 both sides of the quotient are below every double.
  const Found fall = found_in("y = 2^x/(2^x+3^x)", {-3000, 3000, -0.5, 1.5});
  EXPECT_TRUE(fall.of(PointKind::maximum).empty());
  EXPECT_TRUE(fall.of(PointKind::minimum).empty());
  EXPECT_EQ(fall.of(PointKind::inflection).size(), 1U);
  // Rises on the left and falls on the right of its hole at (0, e).
  const Found hill = found_in("y = (1+x^2)^(1/x^2)", {-4, 4, -1, 4});
  EXPECT_TRUE(hill.of(PointKind::minimum).empty());
  EXPECT_LE(hill.of(PointKind::maximum).size(), 1U);
  EXPECT_TRUE(hill.of(PointKind::isolated).empty());
  const auto hole = hill.of(PointKind::hole);
  ASSERT_EQ(hole.size(), 1U);
  EXPECT_EQ(hole[0].x, 0);
  EXPECT_NEAR(hole[0].y, std::numbers::e, 1e-4);
}

TEST(Points, AFlatMinimumIsStillFound) {
  const auto least = found_in("y = (x-1)^10", {-1, 3, -1, 3}).of(PointKind::minimum);
  ASSERT_EQ(least.size(), 1U);
  EXPECT_NEAR(least[0].x, 1, 1e-9);
  EXPECT_EQ(found_in("y = sin(50x)", {-1, 1, -2, 2}).of(PointKind::maximum).size(), 16U);
}

}  // namespace
}  // namespace nazori::functions
