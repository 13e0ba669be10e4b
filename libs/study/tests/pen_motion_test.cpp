// SPDX-License-Identifier: Apache-2.0
// The measures of the pen against their definition.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "nazori/study/handwriting.h"

namespace nazori::study {
namespace {

/// A point on the x axis, in units.
HandwritingPoint at(double x, int time_ms) { return {{x, 0}, time_ms / 1000.0, 1.0}; }

/// A stroke whose speed, in units a second, is given for each 10 ms. Speeds of whole 100 / 32 are exact.
HandwritingStroke with_speeds(const std::vector<int>& steps) {
  HandwritingStroke stroke{at(0, 0)};
  int x = 0;
  int time = 0;
  for (const int one : steps) {
    x += one;
    time += 10;
    stroke.push_back(at(x / 32.0, time));
  }
  return stroke;
}

/// Spectral arc length by its definition (Balasubramanian and others, 2015): amplitudes of the Fourier
/// transform from 0 to 10 Hz in steps of 0.1 Hz, the first being 1, up to the last that is 5 % or more.
double arc_length(const std::vector<double>& speed) {
  std::vector<double> amplitudes;
  for (int step = 0; step <= 100; ++step) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < speed.size(); ++i)
      sum += speed[i] * std::polar(1.0, -2 * std::numbers::pi * 0.1 * step * 0.01 * static_cast<double>(i));
    amplitudes.push_back(std::abs(sum));
  }
  const double first = amplitudes.front();
  for (double& one : amplitudes) one /= first;
  while (amplitudes.back() < 0.05) amplitudes.pop_back();
  const auto parts = static_cast<double>(amplitudes.size() - 1);
  double arc = 0;
  for (std::size_t i = 1; i < amplitudes.size(); ++i)
    arc += std::hypot(1 / parts, amplitudes[i] - amplitudes[i - 1]);
  return -arc;
}

double arc_length_of(const std::vector<int>& steps) { return arc_length({steps.begin(), steps.end()}); }

TEST(PenMotion, SmoothnessIsTheSpectralArcLengthOfTheSpeed) {
  // Other sequences of speeds, also with a halt.
  std::vector<std::vector<int>> profiles{std::vector(30, 12)};
  std::vector<int> bell, two, uneven;
  for (int i = 0; i < 50; ++i)
    bell.push_back(static_cast<int>(std::lround(90 * std::sin(std::numbers::pi * (i + 0.5) / 50))));
  for (int i = 0; i < 90; ++i)
    two.push_back(static_cast<int>(std::lround(40 * std::pow(std::sin(2 * std::numbers::pi * i / 90), 2))));
  for (int i = 0; i < 37; ++i) uneven.push_back(7 + (i * i) % 23);
  profiles.push_back(bell);
  profiles.push_back(two);
  profiles.push_back(uneven);
  for (const std::vector<int>& steps : profiles) {
    const auto motion = motion_of(Handwriting{with_speeds(steps)});
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->smoothness, arc_length_of(steps), 1e-9);
    double length = 0;
    for (const int one : steps) length += one;
    EXPECT_NEAR(motion->speed, length / 32 / (0.01 * static_cast<double>(steps.size())), 1e-9);
  }
}

TEST(PenMotion, OfConstantSpeedHasTheSpectrumOfAPulse) {
  // The amplitudes of N equal samples: sin(pi f N dt) / (N sin(pi f dt)). Of ten samples all reach 10 Hz;
  // there the last is 0, so the cut is where 5 % are passed.
  constexpr int kSamples = 10;
  std::vector<double> amplitudes{1};
  for (int step = 1; step <= 100; ++step) {
    const double turn = std::numbers::pi * 0.1 * step * 0.01;
    amplitudes.push_back(std::abs(std::sin(kSamples * turn) / (kSamples * std::sin(turn))));
  }
  while (amplitudes.back() < 0.05) amplitudes.pop_back();
  ASSERT_GT(amplitudes.size(), 90U);
  double arc = 0;
  for (std::size_t i = 1; i < amplitudes.size(); ++i)
    arc += std::hypot(1.0 / static_cast<double>(amplitudes.size() - 1), amplitudes[i] - amplitudes[i - 1]);
  const auto motion = motion_of(Handwriting{with_speeds(std::vector(kSamples, 32))});
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->smoothness, -arc, 1e-9);
}

TEST(PenMotion, IsTheSameHoweverUnevenlyThePointsCome) {
  // 4 units in 40 ms, then 1 unit in 60 ms, then 6 units in 100 ms: sampled every 10 ms.
  const HandwritingStroke few{at(0, 500), at(4, 540), at(5, 600), at(11, 700)};
  std::vector<double> speed(4, 100.0);
  speed.insert(speed.end(), 6, 1 / 0.06);
  speed.insert(speed.end(), 10, 60.0);
  const auto motion = motion_of(Handwriting{few});
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->smoothness, arc_length(speed), 1e-9);
  EXPECT_NEAR(motion->speed, 11 / 0.2, 1e-9);
  // Points between the samples, one of them twice at the same moment.
  const HandwritingStroke many{at(0, 0),  at(0.5, 5), at(1.5, 15),  at(1.5, 15),
                               at(4, 40), at(5, 100), at(5.5, 108), at(11, 200)};
  const auto again = motion_of(Handwriting{many});
  ASSERT_TRUE(again);
  std::vector<double> other(4, 100.0);
  other.insert(other.end(), 6, 1 / 0.06);
  // Half a unit in 8 ms, then 5.5 units in 92 ms.
  other.push_back((0.5 + 5.5 * 2 / 92) / 0.01);
  other.insert(other.end(), 9, 5.5 / 0.092);
  EXPECT_NEAR(again->smoothness, arc_length(other), 1e-9);
}

TEST(PenMotion, OfAStrokeThatTurnsGoesByItsLength) {
  const Handwriting ink{{{{0, 0}, 0.0}, {{3, 4}, 0.05}, {{0, 0}, 0.1}}};
  const auto motion = motion_of(ink);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->speed, 10 / 0.1, 1e-9) << "there and back, five units each";
}

TEST(PenMotion, TakesStrokesFromTwoUnitsAndEightyMillisecondsOn) {
  const auto counts = [](double length, int time_ms) {
    return motion_of(Handwriting{{at(0, 0), at(length, time_ms)}}).has_value();
  };
  EXPECT_TRUE(counts(2, 80));
  EXPECT_FALSE(counts(2, 79));
  EXPECT_FALSE(counts(2 - 1.0 / 32, 80));
  EXPECT_FALSE(motion_of(Handwriting(1)));
  EXPECT_FALSE(motion_of(Handwriting{{at(0, 0)}}));
}

TEST(PenMotion, IsTheMeanOverStrokesAndTheSpeedOverTheirLength) {
  const std::vector<int> slow(40, 8);
  std::vector<int> uneven;
  for (int i = 0; i < 20; ++i) uneven.push_back(10 + 30 * (i % 2));
  const Handwriting ink{with_speeds(slow), {at(0, 0), at(0.5, 300)}, with_speeds(uneven)};
  const auto motion = motion_of(ink);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->smoothness, (arc_length_of(slow) + arc_length_of(uneven)) / 2, 1e-9);
  EXPECT_NEAR(motion->speed, (40 * 8 + 20 * 25) / 32.0 / 0.6, 1e-9) << "what is too short counts nowhere";
}

TEST(PenMotion, WhatRestsIsCutAfterTwentySeconds) {
  // Five times a second fast and slow.
  std::vector<int> steps;
  for (int i = 0; i < 2'000; ++i) steps.push_back(i / 10 % 2 == 0 ? 1 : 5);
  HandwritingStroke stroke = with_speeds(steps);
  ASSERT_EQ(stroke.back().time_s, 20);
  const double whole = motion_of(Handwriting{stroke})->smoothness;
  EXPECT_NEAR(whole, arc_length_of(steps), 1e-6);
  stroke.push_back(at(stroke.back().at.x + 100, 27'000));
  EXPECT_NEAR(motion_of(Handwriting{stroke})->smoothness, whole, 1e-9);
}

}  // namespace
}  // namespace nazori::study
