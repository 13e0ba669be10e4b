// SPDX-License-Identifier: Apache-2.0
#include "nazori/geometry/needed_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nazori/geometry/frames.h"

namespace nazori::geometry {
namespace {

using Line = std::vector<GlyphPoint>;
using Indices = std::vector<std::size_t>;

Indices needed(const Line& line, double tolerance) {
  return needed_points(std::span<const GlyphPoint>(line), tolerance);
}

TEST(NeededPoints, CornersStayAndWhatLiesBetweenThemGoes) {
  EXPECT_EQ(needed({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, 0.1), (Indices{0, 2, 4}));
  EXPECT_EQ(needed({{0, 0}, {1, 0.5}, {2, 0}}, 0.5), (Indices{0, 2}))
      << "as far as the tolerance is near enough";
  EXPECT_EQ(needed({{0, 0}, {1, 0.5}, {2, 0}}, 0.49), (Indices{0, 1, 2}));
}

TEST(NeededPoints, OnePointAndALoopKeepTheirEnds) {
  EXPECT_EQ(needed({}, 1), Indices());
  EXPECT_EQ(needed({{3, 4}}, 1), Indices{0});
  EXPECT_EQ(needed({{0, 0}, {std::nan(""), 1}, {2, 0}}, 0.1), (Indices{0, 2}));
  EXPECT_EQ(needed({{0, 0}, {4, 0}, {4, 3}, {0, 0}}, 0.1), (Indices{0, 1, 2, 3}));
}

TEST(NeededPoints, EveryPointStaysWithinTheToleranceOfTheNewLine) {
  Line wave;
  for (int i = 0; i <= 400; ++i) wave.push_back({i * 0.05, std::sin(i * 0.05)});
  for (const double tolerance : {0.3, 0.03, 0.003}) {
    const Indices kept = needed(wave, tolerance);
    EXPECT_LT(kept.size(), wave.size());
    for (std::size_t k = 1; k < kept.size(); ++k)
      for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i)
        EXPECT_LE(distance_to_segment(wave[i], wave[kept[k - 1]], wave[kept[k]]), tolerance);
  }
}

}  // namespace
}  // namespace nazori::geometry
