// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/smooth_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace nazori::surface {
namespace {

HeightMap map_of(int size, auto height) {
  HeightMap map = *HeightMap::create(size);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      map.set(column, row, static_cast<float>(height(column, row)));
  return map;
}

HeightMap noise(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0.2, 0.7);
  return map_of(size, [&](int, int) { return any(random); });
}

TEST(SmoothSurface, NeedsAMapWithSamples) {
  const auto surface = SmoothSurface::create(HeightMap());
  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.error().code, base::Errc::bad_argument);
}

TEST(SmoothSurface, KnowsItsSizeAndHasANumberOfItsOwn) {
  const HeightMap map = noise(5, 2);
  const auto one = *SmoothSurface::create(map), other = *SmoothSurface::create(map);
  EXPECT_EQ(one->size(), 5);
  EXPECT_NE(one->serial(), other->serial());
}

TEST(SmoothSurface, MeetsAnInclinedPlaneExactlyWithItsSlope) {
  const auto surface =
      *SmoothSurface::create(map_of(32, [](int c, int r) { return 0.1 + 0.01 * c + 0.005 * r; }));
  for (double column = 1; column <= 30; column += 0.37)
    for (double row = 1; row <= 30; row += 0.41) {
      const SurfacePoint p = surface->at(column, row);
      EXPECT_NEAR(p.height, 0.1 + 0.01 * column + 0.005 * row, 1e-7);
      EXPECT_NEAR(p.d_column, 0.01, 1e-6);
      EXPECT_NEAR(p.d_row, 0.005, 1e-6);
    }
}

// A quadratic B-spline through f(x) = x^2 is x^2 + 1/4 (its second difference / 8, each way).
TEST(SmoothSurface, RoundsABowlByAnEighthOfItsSecondDifference) {
  const auto surface = *SmoothSurface::create(
      map_of(33, [](int c, int r) { return ((c - 16) * (c - 16) + (r - 16) * (r - 16)) / 512.0 * 0.9; }));
  const double a = 0.9 / 512;
  for (double column = 3; column <= 29; column += 0.83)
    for (double row = 3; row <= 29; row += 0.71) {
      const CurvedPoint p = surface->curved_at(column, row);
      const double x = column - 16, y = row - 16;
      EXPECT_NEAR(p.height, a * (x * x + y * y + 0.5), 1e-6);
      EXPECT_NEAR(p.d_column, 2 * a * x, 1e-6);
      EXPECT_NEAR(p.d_row, 2 * a * y, 1e-6);
      EXPECT_NEAR(p.d_column_column, 2 * a, 1e-6);
      EXPECT_NEAR(p.d_row_row, 2 * a, 1e-6);
      EXPECT_NEAR(p.d_column_row, 0, 1e-6);
    }
}

TEST(SmoothSurface, HasNoStepInHeightOrSlopeAnywhereEvenAcrossTheRim) {
  const auto surface = *SmoothSurface::create(noise(9, 3));
  constexpr double kStep = 1e-6;
  for (double row = -2; row < 11; row += 0.173)
    for (int i = -40; i < 220; ++i) {  // every border between squares lies at a half
      const double edge = i * 0.05;
      const SurfacePoint before = surface->at(edge - kStep, row), after = surface->at(edge + kStep, row);
      EXPECT_NEAR(before.height, after.height, 5 * kStep);
      EXPECT_NEAR(before.d_column, after.d_column, 10 * kStep);
      EXPECT_NEAR(before.d_row, after.d_row, 10 * kStep);
      const SurfacePoint above = surface->at(row, edge - kStep), below = surface->at(row, edge + kStep);
      EXPECT_NEAR(above.height, below.height, 5 * kStep);
      EXPECT_NEAR(above.d_row, below.d_row, 10 * kStep);
    }
}

TEST(SmoothSurface, SlopeAndBendAreTheDerivativesOfTheHeight) {
  const auto surface = *SmoothSurface::create(noise(16, 5));
  constexpr double kStep = 1e-5;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> where(-3, 18);
  for (int i = 0; i < 2000; ++i) {
    const double c = where(random), r = where(random);
    const CurvedPoint p = surface->curved_at(c, r);
    const SurfacePoint plain = surface->at(c, r);
    EXPECT_EQ(p.height, plain.height);
    EXPECT_EQ(p.d_column, plain.d_column);
    EXPECT_EQ(p.d_row, plain.d_row);
    const auto left = surface->at(c - kStep, r), right = surface->at(c + kStep, r);
    const auto up = surface->at(c, r - kStep), down = surface->at(c, r + kStep);
    EXPECT_NEAR(p.d_column, (right.height - left.height) / (2 * kStep), 1e-5);
    EXPECT_NEAR(p.d_row, (down.height - up.height) / (2 * kStep), 1e-5);
    if (std::abs(c - std::floor(c) - 0.5) < 2 * kStep || std::abs(r - std::floor(r) - 0.5) < 2 * kStep)
      continue;  // the bend has steps there
    EXPECT_NEAR(p.d_column_column, (right.d_column - left.d_column) / (2 * kStep), 1e-5);
    EXPECT_NEAR(p.d_column_row, (down.d_column - up.d_column) / (2 * kStep), 1e-5);
    EXPECT_NEAR(p.d_row_row, (down.d_row - up.d_row) / (2 * kStep), 1e-5);
  }
}

TEST(SmoothSurface, NeverRingsAboveThePlateauOrBelowTheFloor) {
  std::mt19937 random(1);
  const auto surface = *SmoothSurface::create(map_of(64, [&](int, int) { return random() & 1U; }));
  for (double column = -2; column < 66; column += 0.0917)
    for (double row = -2; row < 66; row += 0.1131) {
      const double height = surface->at(column, row).height;
      EXPECT_GE(height, -1e-12);
      EXPECT_LE(height, 1 + 1e-12);
    }
}

TEST(SmoothSurface, GoesOnLevelOutsideTheGrid) {
  const HeightMap map = noise(8, 11);
  const auto surface = *SmoothSurface::create(map);
  for (const double far : {0.5, 3.0, 1e3, 1e12}) {
    for (double row = 0; row < 8; row += 0.3) {
      const SurfacePoint p = surface->at(-far, row);
      EXPECT_EQ(p.d_column, 0);
      EXPECT_EQ(p.height, surface->at(-0.5, row).height);
      EXPECT_EQ(surface->at(7 + far, row).d_column, 0);
    }
    EXPECT_EQ(surface->at(-far, -far).height, map.at(0, 0));
    EXPECT_EQ(surface->at(7 + far, 7 + far).height, map.at(7, 7));
  }
}

TEST(SmoothSurface, OnItsBorderHalfASampleOutsideItIsAsJustWithin) {
  for (const int size : {2, 3, 4, 6, 8}) {
    const auto surface = *SmoothSurface::create(noise(size, 12));
    const double last = size - 0.5;
    for (double along = -0.5; along <= last; along += 0.25) {
      EXPECT_NEAR(surface->at(along, last).height, surface->at(along, last - 1e-9).height, 1e-6) << along;
      EXPECT_NEAR(surface->at(last, along).height, surface->at(last - 1e-9, along).height, 1e-6) << along;
      EXPECT_NEAR(surface->at(along, -0.5).height, surface->at(along, -0.5 + 1e-9).height, 1e-6) << along;
      EXPECT_NEAR(surface->at(-0.5, along).height, surface->at(-0.5 + 1e-9, along).height, 1e-6) << along;
      EXPECT_EQ(surface->curved_at(along, last).d_row_row, surface->curved_at(along, last - 1e-9).d_row_row);
      EXPECT_EQ(surface->curved_at(last, along).d_column_column,
                surface->curved_at(last - 1e-9, along).d_column_column);
    }
  }
}

/// What a patch says of the point u, v from its sample.
CurvedPoint point_of(const SurfacePatch& patch, double u, double v) {
  const double us[] = {1, u, u * u}, du[] = {0, 1, 2 * u}, dduu[] = {0, 0, 2};
  const double vs[] = {1, v, v * v}, dv[] = {0, 1, 2 * v}, ddvv[] = {0, 0, 2};
  CurvedPoint p{};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double of = patch.of[a][b];
      p.height += of * us[a] * vs[b];
      p.d_column += of * du[a] * vs[b];
      p.d_row += of * us[a] * dv[b];
      p.d_column_column += of * dduu[a] * vs[b];
      p.d_column_row += of * du[a] * dv[b];
      p.d_row_row += of * us[a] * ddvv[b];
    }
  return p;
}

void expect_alike(const CurvedPoint& a, const CurvedPoint& b) {
  EXPECT_NEAR(a.height, b.height, 1e-14);
  EXPECT_NEAR(a.d_column, b.d_column, 1e-14);
  EXPECT_NEAR(a.d_row, b.d_row, 1e-14);
  EXPECT_NEAR(a.d_column_column, b.d_column_column, 1e-14);
  EXPECT_NEAR(a.d_column_row, b.d_column_row, 1e-14);
  EXPECT_NEAR(a.d_row_row, b.d_row_row, 1e-14);
}

TEST(SmoothSurface, APatchIsTheSurfaceInTheWholeSquareAroundItsSample) {
  const auto surface = *SmoothSurface::create(noise(9, 6));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> where(-0.5, 8.5), within(-0.499, 0.499);
  for (int i = 0; i < 1000; ++i) {
    const double column = where(random), row = where(random);
    const SurfacePatch patch = surface->patch_at(column, row);
    EXPECT_FALSE(patch.is_outside);
    EXPECT_EQ(patch.column, std::round(column));
    EXPECT_EQ(patch.row, std::round(row));
    const double u = within(random), v = within(random);
    expect_alike(point_of(patch, u, v), surface->curved_at(patch.column + u, patch.row + v));
  }
}

TEST(SmoothSurface, BeyondTheRimAPatchIsTheSurfaceAtItsPoint) {
  const auto surface = *SmoothSurface::create(noise(9, 8));
  std::mt19937 random(9);
  std::uniform_real_distribution<double> where(-4, 13);
  for (int i = 0; i < 1000; ++i) {
    const double column = where(random), row = where(random);
    const SurfacePatch patch = surface->patch_at(column, row);
    const auto is_on = [](double at) { return at >= -0.5 && at <= 8.5; };
    EXPECT_EQ(patch.is_outside, !is_on(column) || !is_on(row));
    if (patch.is_outside)
      expect_alike(point_of(patch, column - patch.column, row - patch.row), surface->curved_at(column, row));
  }
}

TEST(SmoothSurface, StaysInsideItsMemoryForPlacesThatAreNotNumbers) {
  const auto surface = *SmoothSurface::create(noise(2, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1e308, -1e308}) {
    const double height = surface->at(bad, bad).height;
    EXPECT_GE(height, 0);
    EXPECT_LE(height, 1);
  }
}

}  // namespace
}  // namespace nazori::surface
