// SPDX-License-Identifier: Apache-2.0
// The laws of the flow: docs/brush.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using test::even_paper;
using test::sheet_of;

/// Water that only spreads, K cells^2 a step.
Paper spreading(double k, int size) {
  Paper paper = even_paper();
  const double cell_m = Sheet::kSide_m / size;
  paper.spread_m2_s = k * cell_m * cell_m / Sheet::kStep_s;
  return paper;
}

// G. I. Barenblatt 1952: u_t = laplace(u^2) in the plane has the solution t^-1/2 (C - r^2 t^-1/2 / 16)+,
// which covers the radius 4 sqrt(C) t^1/4 and has the mass 8 pi C^2.
TEST(Flow, SpreadsAsBarenblattsSolution) {
  constexpr int kSize = 256;
  constexpr double k = 0.02;
  Sheet sheet = sheet_of(kSize, spreading(k, kSize));
  const double start = 100, c = 9;  // t in units of 1/k
  const auto profile = [&](double r2, double t) {
    return std::max(c - r2 / std::sqrt(t) / 16, 0.0) / std::sqrt(t);
  };
  const double middle = kSize / 2.0 - 0.5;
  const auto r2_of = [&](int x, int y) { return (x - middle) * (x - middle) + (y - middle) * (y - middle); };
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) sheet.drop(x, y, to_amount(profile(r2_of(x, y), start)), {});
  constexpr int kSteps = 12'000;
  for (int i = 0; i < kSteps; ++i) sheet.step();
  const double t = start + kSteps * k;
  double off = 0, mass = 0, farthest = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double u = to_fraction(sheet.at(x, y).fibre);
      const double wanted = profile(r2_of(x, y), t);
      off += std::abs(u - wanted);
      mass += wanted;
      if (u > 1e-4) farthest = std::max(farthest, std::sqrt(r2_of(x, y)));
    }
  }
  EXPECT_NEAR(mass, 8 * M_PI * c * c, 0.005 * mass);
  EXPECT_LT(off / mass, 1e-3);
  const double radius = 4 * std::sqrt(c) * std::pow(t, 0.25);
  EXPECT_NEAR(farthest, radius, 0.02 * radius);
}

// With a constant source at one end, u = f(x / sqrt(k t)), and the front lies at 1.616 sqrt(2) = 2.285.
TEST(Flow, AFrontAdvancesAsTheRootOfTime) {
  constexpr int kSize = 256;
  constexpr double k = 0.1;
  Sheet sheet = sheet_of(kSize, spreading(k, kSize));
  double lowest = 1e9, highest = 0;
  int next = 500;
  for (int i = 1; i <= 500 * 32; ++i) {
    if (i % 20 == 1)
      for (int y = 0; y < kSize; ++y) sheet.drop(0, y, kOne, {});
    sheet.step({2, true});
    if (i != next) continue;
    next *= 2;
    double front = 0;
    for (int x = 0; x < kSize; ++x)
      if (to_fraction(sheet.at(x, 100).fibre) > 1e-3) front = x;
    const double constant = front / std::sqrt(k * i);
    lowest = std::min(lowest, constant);
    highest = std::max(highest, constant);
  }
  EXPECT_GT(lowest, 2.285 * 0.93);
  EXPECT_LT(highest, 2.285 * 1.01);
  EXPECT_LT(highest / lowest, 1.06);
}

}  // namespace
}  // namespace nazori::paint
