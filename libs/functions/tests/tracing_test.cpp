// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tracing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "curve_facts.h"
#include "nazori/functions/plate.h"

namespace nazori::functions {
namespace {

using test::is_carved;
using test::pieces_of;

constexpr double kPi = std::numbers::pi;

/// Known facts about a plot: points on it, points that must stay clean, how many separate grooves.
struct Known {
  std::string expression;
  Window window;
  std::vector<std::pair<double, double>> on;
  std::vector<std::pair<double, double>> off;
  int pieces;
};

Picture drawn(const std::string& expression, const Window& window, int size = 256) {
  const auto plot = parse(expression);
  EXPECT_TRUE(plot) << expression;
  PlateSettings settings;
  settings.size = size;
  settings.layers = Layers::none();
  auto picture = draw(*plot, window, settings);
  EXPECT_TRUE(picture) << expression;
  return std::move(*picture);
}

TEST(Tracing, DrawsWhatIsKnownOfHardCurvesAndNothingElse) {
  const Known cases[] = {
      {"y = tan(x)", {-6, 6, -4, 4}, {{0, 0}, {kPi / 4, 1}}, {{kPi / 2, 0}, {-kPi / 2, 1.5}}, 5},
      {"y = 1/(x-1)^2", {-3, 5, -1, 8}, {{2, 1}, {0, 1}}, {{1, 1}, {1, 5}}, 2},
      {"y = floor(x)", {-3.5, 3.5, -4.5, 4.5}, {{0.5, 0}, {0, 0}}, {{0, -0.5}, {1, 0.5}}, 8},
      {"y = |x|/x", {-3, 3, -2, 2}, {{1, 1}, {-1, -1}}, {{0, 0}, {0, 0.5}}, 2},
      {"y = sin(x)/x", {-10, 10, -1, 2}, {{0.001, 1}, {kPi, 0}}, {{0, 0}, {0, 1.6}}, 1},
      {"y = (1-cos(x))/x^2",
       {-10, 10, -1, 1},
       {{0.01, 0.49999583}, {kPi, 2 / (kPi * kPi)}},
       {{0, 0}, {0, 0.2}},
       1},
      {"y = atan(1000000(x-1))", {-3, 5, -2, 2}, {{1, 0}, {1, 1}}, {{0, 0}, {2, 0}}, 1},
      {"y = e^x/(1+e^x)", {-1000, 1000, -0.5, 1.5}, {{0, 0.5}, {900, 1}, {-900, 0}}, {{500, 0.5}}, 1},
      {"y = sin(100x)", {-10, 10, -2, 2}, {{0, 0}, {5, 0.4}}, {{0, 1.4}, {5, -1.4}}, 1},
      {"x^2 + y^2 = 0", {-1, 1, -1, 1}, {{0, 0}}, {{0.2, 0}}, 1},
      {"(x^2+y^2-1)^2 + (x-y)^2 = 0",
       {-2, 2, -2, 2},
       {{std::sqrt(0.5), std::sqrt(0.5)}},
       {{0, 0}, {1, 0}},
       2},
      {"x^2 - 2xy + y^2 = 0", {-3, 3, -3, 3}, {{0, 0}, {2, 2}}, {{1, -1}}, 1},
      {"1/(x-y) = 0", {-3, 3, -3, 3}, {}, {{0, 0}, {1, 1}}, 0},
      {"(x^2-y^2)/(x-y) = 0", {-3, 3, -3, 3}, {{1, -1}, {-2, 2}}, {{1, 1}, {-2, -2}}, 1},
      {"tan(x+y) = 1", {-3, 3, -3, 3}, {{kPi / 4, 0}}, {{kPi / 2, 0}}, 4},
      {"x^3 + y^3 = 3xy", {-3, 3, -3, 3}, {{1.5, 1.5}, {0, 0}}, {{0.8, 0.8}, {-1, -1}}, 1},
      {"y^2 = x^3", {-1, 3, -3, 3}, {{0, 0}, {1, 1}, {1, -1}}, {{-0.5, 0}}, 1},
      {"sqrt(x) + sqrt(y) = 1", {-0.5, 1.5, -0.5, 1.5}, {{0.25, 0.25}, {1, 0}, {0, 1}}, {{0, 0}}, 1},
      {"floor(x) = floor(y)", {-3, 3, -3, 3}, {{0.5, 0.5}, {-1.5, -1.2}}, {{0.5, 1.5}, {-0.5, 0.5}}, -1},
      {"x = 1/cos(t); y = tan(t); 0 <= t <= 2pi", {-4, 4, -4, 4}, {{1, 0}, {-1, 0}}, {{0, 0}, {0, 2}}, 2},
      {"r^2 = cos(2theta)", {-1.5, 1.5, -1, 1}, {{1, 0}, {0, 0}}, {{0.5, 0}, {0, 0.5}}, 1},
      {"theta = pi/4", {-2, 2, -2, 2}, {{1, 1}, {-1, -1}}, {{1, -1}}, 1},
      {"y > x^2", {-3, 3, -1, 5}, {{0, 2}}, {{2, 1}}, 1},
      {"x = floor(t); y = t; 0 <= t < 3", {-1, 4, -1, 4}, {{0, 0}, {2, 2.95}}, {{3, 3}}, 3},
      {"x = floor(t); y = t; 3 > t >= 0", {-1, 4, -1, 4}, {{0, 0}, {2, 2.95}}, {{3, 3}}, 3},
      {"x = ceil(t); y = t; 0 < t <= 3", {-1, 4, -1, 4}, {{1, 0.05}, {3, 3}}, {{0, 0}}, 3},
      {"x = 100floor(t); y = t; 1000 < t < 1003",
       {99900, 100400, 999, 1004},
       {{100000, 1000.5}},
       {{100300, 1003}},
       3},
      {"r = floor(theta); 0 <= theta < 2", {-2, 2, -2, 2}, {{0, 0}}, {{2 * std::cos(2), 2 * std::sin(2)}}, 2},
  };
  for (const Known& k : cases) {
    const Picture p = drawn(k.expression, k.window);
    for (const auto& [x, y] : k.on)
      EXPECT_TRUE(is_carved(p, x, y)) << k.expression << " at " << x << ", " << y;
    for (const auto& [x, y] : k.off)
      EXPECT_FALSE(is_carved(p, x, y)) << k.expression << " at " << x << ", " << y;
    if (k.pieces >= 0) {
      EXPECT_EQ(pieces_of(p.plate), k.pieces) << k.expression;
    }
    EXPECT_LT(p.tracing.undecided_share(), 0.01) << k.expression;
  }
}

TEST(Tracing, AGrooveIsAsWideAcrossItselfWhateverItsSlope) {
  for (const auto& [expression, slope] :
       {std::pair{"y = 50x", 50.0}, std::pair{"y = 0.3x", 0.3}, std::pair{"y = 0.8x", 0.8}}) {
    const Picture p = drawn(expression, {-1, 1, -1, 1}, 512);
    std::int64_t area = 0;
    for (const std::uint8_t m : p.plate.mask) area += m != 0 ? 1 : 0;
    // Area over length is the width.
    const double length = slope > 1 ? std::hypot(1.0, 1 / slope) : std::hypot(1.0, slope);
    EXPECT_NEAR(static_cast<double>(area) / (512.0 * 512.0) / length, 0.025, 0.0008) << expression;
  }
}

TEST(Tracing, TheSameCurveTwiceIsNoDeeper) {
  const Picture once = drawn("y = (x+1)^2", {-4, 2, -1, 5});
  const Picture twice = drawn("y = (x+1)^2; y = x^2+2x+1", {-4, 2, -1, 5});
  for (std::size_t i = 0; i < once.plate.mask.size(); ++i)
    ASSERT_NEAR(once.plate.heights.samples()[i], twice.plate.heights.samples()[i], 0.06F);
}

TEST(Tracing, AxesAreBrokenWhereACurvePasses) {
  const auto plot = parse("y = x");
  ASSERT_TRUE(plot);
  PlateSettings settings;
  settings.size = 256;
  const auto p = draw(*plot, {-1, 1, -1, 1}, settings);
  ASSERT_TRUE(p);
  // Far from the curve the axis stands out, at the crossing the groove is whole.
  EXPECT_GT(p->plate.heights.at(192, 128), 0.92F);
  EXPECT_LT(p->plate.heights.at(128, 127), 0.1F);
  EXPECT_EQ(p->plate.heights.at(0, 128), 1.0F);
}

TEST(Tracing, StopsWhenAskedAndRefusesBadWindows) {
  const auto plot = parse("sin(x^2+y^2) = cos(xy)");
  ASSERT_TRUE(plot);
  const auto stopped = trace(*plot, {-5, 5, -5, 5}, {}, [](double, std::string_view) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
  EXPECT_FALSE(trace(*plot, {1, 1, 0, 1}));
  EXPECT_FALSE(trace(*plot, {0, std::nan(""), 0, 1}));
}

TEST(Tracing, ThreadsShareOnePlotAndGetTheSamePicture) {
  const auto plot = parse("y = tan(x); sin(x^2+y^2) = cos(xy)");
  ASSERT_TRUE(plot);
  PlateSettings settings;
  settings.size = 64;
  std::array<std::vector<std::uint8_t>, 3> masks;
  std::vector<std::thread> threads;
  for (auto& mask : masks) {
    threads.emplace_back([&] {
      auto picture = draw(*plot, {-3, 3, -3, 3}, settings);
      if (picture) mask = std::move(picture->plate.mask);
    });
  }
  for (std::thread& t : threads) t.join();
  EXPECT_FALSE(masks[0].empty());
  EXPECT_EQ(masks[0], masks[1]);
  EXPECT_EQ(masks[0], masks[2]);
}

TEST(Tracing, AStrictBorderAddsNothingAndEqualityInsideItIsNoPartOfTheRegion) {
  EXPECT_EQ(pieces_of(drawn("x^2 + y^2 < 0", {-2, 2, -2, 2}).plate), 0);
  EXPECT_EQ(pieces_of(drawn("x^2 + y^2 <= 0", {-2, 2, -2, 2}).plate), 1);
  const Picture negative = drawn("|x| > x", {-2, 2, -2, 2});
  EXPECT_TRUE(is_carved(negative, -1, 0));
  EXPECT_FALSE(is_carved(negative, 1, 0));
}

TEST(Tracing, ShowsACoarsePictureBeforeTheFineOne) {
  const auto plot = parse("x^2 + y^2 = 1");
  ASSERT_TRUE(plot);
  PlateSettings settings;
  settings.size = 256;
  std::vector<int> sizes;
  const auto done = draw_coarse_to_fine(*plot, {-2, 2, -2, 2}, settings, [&](Picture&& p, bool final) {
    sizes.push_back(p.plate.heights.size());
    EXPECT_EQ(final, sizes.size() == 2);
    return true;
  });
  EXPECT_TRUE(done);
  EXPECT_EQ(sizes, (std::vector<int>{128, 256}));
}

TEST(SurfacePlate, CutsPolesHealsHolesAndLeavesTheUndefinedOut) {
  const auto height = [](const Picture& p, double x, double y) {
    const int n = p.plate.heights.size();
    return p.plate.heights.at(static_cast<int>(p.tracing.window.u(x) * n),
                              static_cast<int>((1 - p.tracing.window.v(y)) * n));
  };
  const auto surface = [](const char* text, const Window& w, HeightRange z) {
    const auto plot = parse(text);
    EXPECT_TRUE(plot);
    PlateSettings settings;
    settings.heights = z;
    settings.layers = Layers::none();
    auto p = draw(*plot, w, settings);
    EXPECT_TRUE(p);
    return std::move(*p);
  };
  const Picture pole = surface("z = 1/(x^2+y^2)", {-2, 2, -2, 2}, {0, 4});
  EXPECT_EQ(height(pole, 0, 0), 1.0F);
  EXPECT_FALSE(is_carved(pole, 0, 0));
  EXPECT_NEAR(height(pole, 1, 1), 0.125, 0.01);
  const Picture hole = surface("z = sin(sqrt(x^2+y^2))/sqrt(x^2+y^2)", {-10, 10, -10, 10}, {-0.5, 1.2});
  EXPECT_TRUE(is_carved(hole, 0, 0));
  EXPECT_NEAR(height(hole, 0, 0), 1.5 / 1.7, 0.01);
  const Picture dome = surface("z = sqrt(4-x^2-y^2)", {-3, 3, -3, 3}, {-1, 3});
  EXPECT_TRUE(is_carved(dome, 1, 1));
  EXPECT_FALSE(is_carved(dome, 2.5, 0));
}

// A root that is zero nowhere but on the border of its own domain.
TEST(Tracing, TheZerosOfARootAreThoseOfWhatStandsUnderIt) {
  for (const char* text : {"sqrt(x^2+y^2-1) = 0", "sqrt(1-x^2-y^2) = 0", "x sqrt(x^2+y^2-1) = 0"}) {
    const auto plot = parse(text);
    ASSERT_TRUE(plot) << text;
    PlateSettings settings;
    settings.size = 256;
    settings.layers = Layers::none();
    const auto picture = draw(*plot, {-2, 2, -2, 2}, settings);
    ASSERT_TRUE(picture) << text;
    for (const double angle : {0.0, 1.0, 2.5, 4.0})
      EXPECT_TRUE(is_carved(*picture, std::cos(angle), std::sin(angle))) << text << ' ' << angle;
    EXPECT_FALSE(is_carved(*picture, 0.4, 0.3)) << text;
    EXPECT_FALSE(is_carved(*picture, 1.3, 0.3)) << text;
  }
}

}  // namespace
}  // namespace nazori::functions
