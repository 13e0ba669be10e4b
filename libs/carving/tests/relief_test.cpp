// SPDX-License-Identifier: Apache-2.0
#include "../src/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace nazori::carving {
namespace {

/// The cross sections by their definition, x in half widths.
double section(CrossSection which, double x) {
  x = std::min(std::abs(x), 1.0);
  switch (which) {
    case CrossSection::rounded:
      return (1 - x * x) * (1 - x * x);
    case CrossSection::v_shaped: {
      // Straight walls of slope 1 / 0.85 whose slope begins and ends over 0.15 half widths.
      const double slope = 1 / 0.85;
      if (x < 0.15) return 1 - slope * x * x / 0.3;
      if (x > 0.85) return slope * (1 - x) * (1 - x) / 0.3;
      return 1 - slope * (x - 0.075);
    }
    case CrossSection::flat_bottom: {
      const double t = std::min(2 - 2 * x, 1.0);
      return t * t * (3 - 2 * t);
    }
  }
  return 0;
}

/// The effect of a piece on every sample, each computed alone. Not a number where a sample lies so close to
/// the border between two parts that rounding decides.
std::vector<double> depths_of(const Piece& piece, int size, CrossSection which) {
  std::vector<double> depths;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      double depth = 0;
      bool unsure = false;
      for (std::size_t i = 0; i + 1 < piece.joints.size(); ++i) {
        const Joint& a = piece.joints[i];
        const Joint& b = piece.joints[i + 1];
        const double after = (x - a.x) * a.forward_x + (y - a.y) * a.forward_y;
        const double before = -(x - b.x) * b.forward_x - (y - b.y) * b.forward_y;
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double across = std::abs((x - a.x) * (b.y - a.y) - (y - a.y) * (b.x - a.x)) / length;
        if (across > std::max(a.half_width, b.half_width)) continue;
        if (std::abs(after) < 1e-6 || std::abs(before) < 1e-6) unsure = true;
        if (after < 0 || before < 0) continue;
        const double t = after / (after + before);
        const double width = a.half_width + (b.half_width - a.half_width) * t;
        const double cut = a.depth + (b.depth - a.depth) * t;
        depth = std::max(depth, cut * section(which, across / std::max(width, 1e-4)));
      }
      const auto press = [&](const Joint& j) {
        if (j.half_width > 0)
          depth = std::max(depth, j.depth * section(which, std::hypot(x - j.x, y - j.y) / j.half_width));
      };
      for (const Joint& joint : piece.joints)
        if (joint.needs_disc) press(joint);
      if (piece.round_start) press(piece.joints.front());
      if (piece.round_end) press(piece.joints.back());
      depths.push_back(unsure ? std::nan("") : depth);
    }
  }
  return depths;
}

/// Cuts the pieces and compares with the definition: grooves join as a + b - a b of their squares.
void expect_as_defined(const std::vector<Piece>& pieces, int size, CrossSection which) {
  std::vector<float> samples(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0F);
  std::vector<double> expected(samples.size(), 0.0);
  Relief relief(samples, size, which);
  for (const Piece& piece : pieces) {
    relief.cut(piece);
    const std::vector<double> depths = depths_of(piece, size, which);
    for (std::size_t i = 0; i < expected.size(); ++i)
      expected[i] += depths[i] * depths[i] * (1 - expected[i]);
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::isnan(expected[i])) continue;
    ASSERT_NEAR(samples[i], expected[i], 2e-4)
        << i % static_cast<std::size_t>(size) << ", " << i / static_cast<std::size_t>(size) << " of " << size;
  }
}

constexpr CrossSection kSections[] = {CrossSection::rounded, CrossSection::v_shaped,
                                      CrossSection::flat_bottom};

Joint joint(double x, double y, double forward_x, double forward_y, double half_width, double depth = 1) {
  return {x, y, forward_x, forward_y, half_width, depth, false};
}

TEST(Relief, AStraightGrooveOfChangingWidthAndDepthIsAsDefinedWhicheverWayItRuns) {
  for (const CrossSection which : kSections) {
    for (int degree = 0; degree < 360; degree += 15) {
      const double a = degree * 3.14159265358979323846 / 180;
      const double dx = std::cos(a);
      const double dy = std::sin(a);
      for (const bool round : {false, true}) {
        const Piece piece{{joint(35.3 - 20 * dx, 37.1 - 20 * dy, dx, dy, 9, 0.9),
                           joint(35.3 + 20 * dx, 37.1 + 20 * dy, dx, dy, 4, 0.3)},
                          round,
                          !round};
        expect_as_defined({piece}, 75, which);
      }
    }
  }
}

TEST(Relief, ALevelGrooveOfEvenWidthHasItsSectionInEachColumn) {
  for (const CrossSection which : kSections) {
    const Piece piece{{joint(10.5, 20.25, 1, 0, 7), joint(30.5, 20.25, 1, 0, 7)}, false, false};
    expect_as_defined({piece}, 40, which);
    const Piece upright{{joint(20.25, 30.5, 0, -1, 7), joint(20.25, 10.5, 0, -1, 7)}, false, false};
    expect_as_defined({upright}, 40, which);
  }
}

/// A line that wanders with gentle bends, its direction at each joint halfway between those before and after.
Piece wandering(std::mt19937& random, double x, double y) {
  std::uniform_real_distribution<double> width(1, 9);
  std::uniform_real_distribution<double> depth(0.2, 1);
  std::uniform_real_distribution<double> turn(-0.25, 0.25);
  std::uniform_real_distribution<double> step(6, 14);
  Piece piece;
  double a = turn(random) * 25;
  std::vector<double> ways;
  for (int i = 0; i < 7; ++i) {
    piece.joints.push_back(joint(x, y, 0, 0, width(random), depth(random)));
    // Parts of constant width are cut by other code.
    if (i % 3 == 1) {
      piece.joints.back().half_width = piece.joints[piece.joints.size() - 2].half_width;
      piece.joints.back().depth = piece.joints[piece.joints.size() - 2].depth;
    }
    piece.joints.back().needs_disc = random() % 3 == 0;
    a += turn(random);
    const double length = step(random);
    x += length * std::cos(a);
    y += length * std::sin(a);
    ways.push_back(a);
  }
  for (std::size_t i = 0; i < piece.joints.size(); ++i) {
    const double before = i > 0 ? ways[i - 1] : ways[0];
    const double after = i + 1 < piece.joints.size() ? ways[i] : before;
    piece.joints[i].forward_x = std::cos((before + after) / 2);
    piece.joints[i].forward_y = std::sin((before + after) / 2);
  }
  piece.round_start = random() % 2 == 0;
  piece.round_end = random() % 2 == 0;
  return piece;
}

TEST(Relief, WanderingLinesThatCrossAndLeaveTheGridAreAsDefined) {
  std::mt19937 random(41);
  for (int round = 0; round < 12; ++round) {
    const int size = 60 + round * 13;  // some of whole tiles, some not, some of several bands
    std::uniform_real_distribution<double> anywhere(-10, size + 10);
    std::vector<Piece> pieces;
    for (int k = 0; k < 5; ++k) pieces.push_back(wandering(random, anywhere(random), anywhere(random)));
    expect_as_defined(pieces, size, kSections[round % 3]);
  }
}

TEST(Relief, APieceOutsideTheGridCutsNothing) {
  for (const auto& [x, y] :
       {std::pair{-30.0, 20.0}, {70.0, 20.0}, {20.0, -30.0}, {20.0, 70.0}, {-40.0, -40.0}}) {
    const Piece piece{{joint(x, y, 1, 0, 8), joint(x + 5, y, 1, 0, 8)}, true, true};
    expect_as_defined({piece}, 40, CrossSection::rounded);
  }
}

TEST(Relief, DimplesAndBrushesWithoutWidthAreAsDefined) {
  const Piece dimple{{joint(20.3, 19.6, 1, 0, 9.5, 0.8)}, true, true};
  expect_as_defined({dimple}, 40, CrossSection::rounded);
  const Piece none{{joint(20, 20, 1, 0, 0, 0)}, true, true};
  expect_as_defined({none, dimple}, 40, CrossSection::v_shaped);
  const Piece taper{{joint(5.5, 20.4, 1, 0, 6), joint(30.5, 20.4, 1, 0, 0, 0)}, true, true};
  expect_as_defined({taper}, 40, CrossSection::flat_bottom);
  const Piece still{{joint(20.2, 20.2, 1, 0, 6), joint(20.2, 20.2, 1, 0, 6)}, true, false};
  std::vector<float> samples(40 * 40, 0.0F);
  Relief(samples, 40, CrossSection::rounded).cut(still);
  EXPECT_NEAR(samples[20 * 40 + 20], std::pow(section(CrossSection::rounded, std::hypot(0.2, 0.2) / 6), 2),
              1e-5);
}

TEST(Relief, WhereAllIsFullNothingMoreIsCutAndBesideItEverythingIs) {
  // The flat floor of a broad groove fills some tiles to the last bit, because it is cut so often.
  constexpr int kSide = 160;
  std::vector<Piece> pieces;
  for (int k = 0; k < 8; ++k)
    pieces.push_back({{joint(-30.5, 40.25 + k, 1, 0, 60), joint(80.5, 40.25 + k, 1, 0, 60)}, false, false});
  std::mt19937 random(5);
  for (int k = 0; k < 6; ++k) pieces.push_back(wandering(random, 20 + 18 * k, 20 + 15 * k));
  const Piece upright{{joint(90.25, -5.5, 0, 1, 20, 0.5), joint(90.25, 170.5, 0, 1, 20, 0.5)}, true, true};
  pieces.push_back(upright);
  for (const double x : {30.0, 62.0, 95.0, 130.0})
    pieces.push_back({{joint(x + 0.3, 100.2, 1, 0, 12, 0.7)}, true, true});
  expect_as_defined(pieces, kSide, CrossSection::flat_bottom);
}

}  // namespace
}  // namespace nazori::carving
