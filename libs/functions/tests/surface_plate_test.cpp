// SPDX-License-Identifier: Apache-2.0
// The plate of a surface, sample by sample, and how a plot is drawn in steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/functions/plate.h"

namespace nazori::functions {
namespace {

constexpr int kSize = 64;
const Window kWindow{-2, 2, -2, 2};

Plate carved(const std::string& text, std::optional<HeightRange> heights = {}, const Window& window = kWindow,
             int size = kSize) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  PlateSettings settings;
  settings.size = size;
  settings.heights = heights;
  auto plate = carve_surface(plot->statements[0], window, settings);
  EXPECT_TRUE(plate) << text;
  return std::move(*plate);
}

/// Calls of(sample, x, y) with the middle of every cell.
void for_all(const std::function<void(std::size_t, double, double)>& of) {
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column)
      of(static_cast<std::size_t>(row * kSize + column), kWindow.x((column + 0.5) / kSize),
         kWindow.y(1 - (row + 0.5) / kSize));
  }
}

std::size_t holes_of(const Plate& p) {
  return static_cast<std::size_t>(std::count(p.mask.begin(), p.mask.end(), std::uint8_t{0}));
}

TEST(SurfacePlate, AHeightIsThatInTheMiddleOfItsCell) {
  const Plate p = carved("z = 0.3x - 0.2y + 0.05x y", HeightRange{-2, 2});
  for_all([&](std::size_t i, double x, double y) {
    // The highest and the lowest corner are a peak and a pit.
    if (std::abs(x) > 1.9 && std::abs(y) > 1.9) return;
    ASSERT_NEAR(p.heights.samples()[i], (0.3 * x - 0.2 * y + 0.05 * x * y + 2) / 4, 1e-6) << x << ' ' << y;
    ASSERT_EQ(p.mask[i], 255);
    ASSERT_EQ(p.statement[i], 1);
  });
}

TEST(SurfacePlate, WithoutARangeItIsThatOfTheValues) {
  const Plate p = carved("z = 3x + 1");
  EXPECT_NEAR(p.range.low, 3 * (-2 + 2.0 / kSize) + 1, 0.2);
  EXPECT_NEAR(p.range.high, 7, 0.2);
  EXPECT_EQ(*std::min_element(p.heights.samples().begin(), p.heights.samples().end()), 0);
  EXPECT_EQ(*std::max_element(p.heights.samples().begin(), p.heights.samples().end()), 1);
  const Plate level = carved("z = 5 + 0x");
  EXPECT_EQ(level.range.low, 4);
  EXPECT_EQ(level.range.high, 6);
  const Plate none = carved("z = sqrt(-1 - x^2) + 0y");
  EXPECT_EQ(none.range.low, -1);
  EXPECT_EQ(none.range.high, 1);
  EXPECT_EQ(holes_of(none), none.mask.size());
  // For a needle the outermost hundredths do not count: 1/(x^2 + y^2 + 0.001) goes up to a thousand.
  EXPECT_LT(carved("z = 1/(x^2 + y^2 + 0.001)").range.high, 60);
  EXPECT_GT(carved("z = -1/(x^2 + y^2 + 0.001)").range.low, -60);
  EXPECT_NEAR(carved("z = 1/(x^2 + y^2 + 0.001)").range.low, 1 / 8.0, 0.01);
  // A hill that is not a needle keeps its top, also far above zero.
  EXPECT_NEAR(carved("z = 100 + e^(-x^2-y^2)").range.high, 101, 1e-9);
  EXPECT_NEAR(carved("z = -100 - e^(-x^2-y^2)").range.low, -101, 1e-9);
  EXPECT_NEAR(carved("z = e^(-x^2-y^2)").range.high, 1, 1e-9);
}

TEST(SurfacePlate, APeakBesideTheMiddleOfItsCellHasItsHeight) {
  // The peak lies on a corner of cells, a pit likewise.
  const HeightRange range{-4, 4};
  const Plate peak = carved("z = 1 - |x| - |y|", range);
  EXPECT_NEAR(peak.heights.at(32, 31), 5.0 / 8, 1e-6);
  const Plate pit = carved("z = |x| + |y| - 1", range);
  EXPECT_NEAR(pit.heights.at(31, 32), 3.0 / 8, 1e-6);
  for_all([&](std::size_t i, double x, double y) {
    if (std::abs(x) < 0.05 && std::abs(y) < 0.05) return;
    const double edge = 2 - 1.5 * 4.0 / kSize;
    if (std::abs(x) > edge && std::abs(y) > edge) return;
    ASSERT_NEAR(peak.heights.samples()[i], (5 - std::abs(x) - std::abs(y)) / 8, 1e-6) << x << ' ' << y;
  });
  // A level surface has neither.
  const Plate level = carved("z = 1 + 0x", range);
  for (const float h : level.heights.samples()) ASSERT_NEAR(h, 5.0 / 8, 1e-6);
}

TEST(SurfacePlate, APlateauHasEveryCellThatReachesIt) {
  // A slope cut at 0.5 and at -0.5: x = 0.5 is in the middle between two cells at 0.46875 and 0.53125.
  const Plate p = carved("z = x + 0.001y", HeightRange{-0.51, 0.52});
  for_all([&](std::size_t i, double x, double y) {
    const double half = 2.0 / kSize;
    const double z = x + 0.001 * y;
    double wanted = z;
    if (z + half * 1.001 >= 0.52) wanted = 0.52;
    if (z - half * 1.001 <= -0.51) wanted = -0.51;
    ASSERT_NEAR(p.heights.samples()[i], (wanted + 0.51) / 1.03, 1e-6) << x << ' ' << y;
  });
}

TEST(SurfacePlate, APoleLiesOutsideTheMaskAndNothingElse) {
  const Plate p = carved("z = 1/((x - 0.03)^2 + (y + 0.03)^2)", HeightRange{0, 4});
  EXPECT_EQ(holes_of(p), 1U);
  EXPECT_EQ(p.mask[32 * kSize + 32], 0);
  EXPECT_EQ(p.statement[32 * kSize + 32], 0);
  EXPECT_EQ(p.heights.at(32, 32), 1);
  // Along a line every cell that it passes.
  const Plate wall = carved("z = 1/(x - 0.03)", HeightRange{-4, 4});
  EXPECT_EQ(holes_of(wall), static_cast<std::size_t>(kSize));
  for (int row = 0; row < kSize; ++row) EXPECT_EQ(wall.mask[static_cast<std::size_t>(row * kSize + 32)], 0);
  EXPECT_EQ(wall.heights.at(31, 10), 0);
  EXPECT_EQ(wall.heights.at(33, 10), 1);
  EXPECT_EQ(holes_of(carved("z = 1/(y - 0.03)", HeightRange{-4, 4})), static_cast<std::size_t>(kSize));
  // A pole on the border between cells belongs to one of them.
  EXPECT_EQ(holes_of(carved("z = 1/x", HeightRange{-4, 4})), static_cast<std::size_t>(kSize));
  EXPECT_EQ(holes_of(carved("z = 1/(x^2 + y^2)", HeightRange{0, 4})), 1U);
  EXPECT_EQ(holes_of(carved("z = 1/(x^2 + y^2 + 0.1)", HeightRange{0, 4})), 0U);
}

TEST(SurfacePlate, WhatIsUndefinedLiesOutsideTheMask) {
  const Plate p = carved("z = ln(x - 0.03) y", HeightRange{-4, 4});
  for_all([&](std::size_t i, double x, double) {
    if (std::abs(x - 0.03) > 4.0 / kSize) {
      ASSERT_EQ(p.mask[i], x > 0.03 ? 255 : 0) << x;
    }
  });
}

TEST(SurfacePlate, ADomeComesDownToWhereItEnds) {
  const Plate p = carved("z = sqrt(2 - x^2 - y^2)", HeightRange{-1, 2});
  for_all([&](std::size_t i, double x, double y) {
    const double r2 = x * x + y * y;
    const double half = 2.0 / kSize;
    const double nearest = std::hypot(std::max(0.0, std::abs(x) - half), std::max(0.0, std::abs(y) - half));
    if (r2 < 2) {
      if (std::sqrt(r2) > 0.1) {
        ASSERT_NEAR(p.heights.samples()[i], (std::sqrt(2 - r2) + 1) / 3, 0.002) << x << ' ' << y;
      }
      ASSERT_EQ(p.mask[i], 255) << x << ' ' << y;
    } else if (nearest > std::sqrt(2) + 1e-9) {
      ASSERT_EQ(p.mask[i], 0) << x << ' ' << y;
    } else if (p.mask[i] != 0) {
      // The middle is undefined: the border of the dome is at height 0.
      ASSERT_NEAR(p.heights.samples()[i], 1.0 / 3, 1e-3) << x << ' ' << y;
    }
  });
  const auto cells = std::count_if(p.mask.begin(), p.mask.end(), [](std::uint8_t m) { return m != 0; });
  EXPECT_GT(static_cast<double>(cells) * 16.0 / (kSize * kSize), std::acos(-1.0) * 2)
      << "cells that the border cuts belong to it";
}

TEST(SurfacePlate, ASingleGapIsClosedAndAStepIsNot) {
  // Undefined in one cell, at its very middle.
  const std::string gap = "(x - 0.03125)^2 + (y - 0.03125)^2";
  const Plate closed = carved("z = 0.5x + 0(" + gap + ")/(" + gap + ")", HeightRange{-2, 2});
  EXPECT_EQ(holes_of(closed), 0U);
  for_all([&](std::size_t i, double x, double) {
    // Both ends of the slope are its peaks.
    if (std::abs(x) < 1.9) {
      ASSERT_NEAR(closed.heights.samples()[i], (0.5 * x + 2) / 4, 1e-3);
    }
  });
  // sin(r)/r is 1 in the middle.
  const Plate wave = carved("z = sin(" + gap + ")/(" + gap + ")", HeightRange{-2, 2});
  EXPECT_EQ(holes_of(wave), 0U);
  EXPECT_NEAR(wave.heights.at(32, 31), 0.75, 1e-3);
  // On the corner of the plate as well.
  const Plate corner = carved("z = 0.5x + 0/((x + 1.96875)^2 + (y - 1.96875)^2)", HeightRange{-2, 2});
  EXPECT_EQ(holes_of(corner), 0U);
  EXPECT_NEAR(corner.heights.at(0, 0), (2 - 0.5 * 1.96875) / 4, 2e-2);
  // A step of a quarter of the range is not a gap that could be closed: the sign of x at a pole.
  const Plate step = carved("z = sign(x)|x - 0.03125|/(x - 0.03125)", HeightRange{-1, 1});
  EXPECT_EQ(step.heights.at(40, 5), 1);
}

TEST(SurfacePlate, IsForSurfacesAndStopsWhenAsked) {
  const auto curve = parse("y = x");
  const auto surface = parse("z = x y");
  ASSERT_TRUE(curve && surface);
  EXPECT_FALSE(carve_surface(curve->statements[0], kWindow));
  EXPECT_FALSE(carve_surface(surface->statements[0], {1, 1, 0, 1}));
  PlateSettings small;
  small.size = 31;
  EXPECT_FALSE(carve_surface(surface->statements[0], kWindow, small));
  std::vector<double> reported;
  PlateSettings settings;
  settings.size = kSize;
  ASSERT_TRUE(
      carve_surface(surface->statements[0], kWindow, settings, [&](double done, std::string_view step) {
        EXPECT_EQ(step, "surface");
        reported.push_back(done);
        return true;
      }));
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.size(), static_cast<std::size_t>(kSize) + 1);
  EXPECT_NEAR(reported.back(), 63.0 / 64, 1e-12);
  std::size_t calls = 0;
  const auto stopped = carve_surface(surface->statements[0], kWindow, settings,
                                     [&](double, std::string_view) { return ++calls < 10; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
  EXPECT_EQ(calls, 10U);
}

TEST(Draw, OneStatementCanBeCarvedAlone) {
  const auto plot = parse("y = 1; y = -1; x^2 + y^2 = 0; y = sin(2000x)/4; y > 1.5");
  ASSERT_TRUE(plot);
  PlateSettings settings;
  settings.size = kSize;
  for (int k = 0; k < 5; ++k) {
    settings.alone = k;
    const auto picture = draw(*plot, kWindow, settings);
    ASSERT_TRUE(picture);
    const Tracing& t = picture->tracing;
    for (const Branch& b : t.branches) EXPECT_EQ(b.statement, k);
    for (const Bar& b : t.bars) EXPECT_EQ(b.statement, k);
    for (const Dot& d : t.dots) EXPECT_EQ(d.statement, k);
    for (const Fill& f : t.fills) EXPECT_EQ(f.statement, k);
    for (const Event& e : t.events) EXPECT_EQ(e.statement, k);
    EXPECT_EQ(t.dense, k == 3);
    EXPECT_EQ(t.fills.empty(), k != 4);
    EXPECT_EQ(t.dots.empty(), k != 2);
    for (const std::uint8_t s : picture->plate.statement) ASSERT_TRUE(s == 0 || s == k + 1);
  }
  settings.alone = -1;
  const auto all = draw(*plot, kWindow, settings);
  ASSERT_TRUE(all);
  EXPECT_TRUE(all->tracing.dense);
  EXPECT_FALSE(all->tracing.dots.empty());
}

TEST(Draw, CurvesAreFollowedAsFarOutAsTheirGrooveIsWide) {
  const auto plot = parse("y = 1.95");
  ASSERT_TRUE(plot);
  PlateSettings settings;
  settings.size = kSize;
  settings.half_width = 0.1;
  const auto picture = draw(*plot, kWindow, settings);
  ASSERT_TRUE(picture);
  EXPECT_NEAR(picture->tracing.branches[0].points.front().u, -0.105, 1e-12);
  settings.half_width = 0.01;
  EXPECT_NEAR(draw(*plot, kWindow, settings)->tracing.branches[0].points.front().u, -0.02, 1e-12);
}

TEST(Draw, TheCoarsePictureTakesATenthOfTheProgress) {
  const auto plot = parse("y = sin(x)");
  ASSERT_TRUE(plot);
  PlateSettings settings;
  settings.size = 160;
  std::vector<double> coarse, fine;
  std::vector<int> sizes;
  const auto show = [&](Picture&& p, bool final) {
    sizes.push_back(p.plate.heights.size());
    EXPECT_EQ(final, sizes.back() == 160);
    return true;
  };
  ASSERT_TRUE(draw_coarse_to_fine(*plot, kWindow, settings, show, [&](double done, std::string_view) {
    (sizes.empty() ? coarse : fine).push_back(done);
    return true;
  }));
  EXPECT_EQ(sizes, (std::vector{128, 160}));
  EXPECT_EQ(coarse.front(), 0);
  EXPECT_LE(coarse.back(), 0.1);
  EXPECT_GT(coarse.back(), 0.09);
  EXPECT_EQ(fine.front(), 0.1);
  EXPECT_GT(fine.back(), 0.95);
  EXPECT_LE(fine.back(), 1);
  // A small picture is drawn once.
  sizes.clear();
  coarse.clear();
  settings.size = 128;
  ASSERT_TRUE(draw_coarse_to_fine(
      *plot, kWindow, settings,
      [&](Picture&&, bool final) {
        EXPECT_TRUE(final);
        sizes.push_back(1);
        return true;
      },
      [&](double done, std::string_view) {
        coarse.push_back(done);
        return true;
      }));
  EXPECT_EQ(sizes.size(), 1U);
  EXPECT_EQ(coarse.front(), 0);
  EXPECT_GT(coarse.back(), 0.95);
}

TEST(Draw, WhoeverShowsAPictureCanStopThere) {
  const auto plot = parse("y = sin(x)");
  ASSERT_TRUE(plot);
  PlateSettings settings;
  settings.size = 160;
  for (const int last : {1, 2}) {
    int shown = 0;
    const auto stopped =
        draw_coarse_to_fine(*plot, kWindow, settings, [&](Picture&&, bool) { return ++shown < last; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
    EXPECT_EQ(shown, last);
  }
  for (const bool coarse : {true, false}) {
    int shown = 0;
    const auto stopped = draw_coarse_to_fine(
        *plot, kWindow, settings, [&](Picture&&, bool) { return ++shown > 0; },
        [&](double, std::string_view) { return shown == 0 && !coarse; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
    EXPECT_EQ(shown, coarse ? 0 : 1);
  }
  settings.size = 8;
  EXPECT_FALSE(draw(*plot, kWindow, settings));
  EXPECT_FALSE(draw(*plot, {1, 1, 1, 1}));
}

}  // namespace
}  // namespace nazori::functions
