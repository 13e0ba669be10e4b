// SPDX-License-Identifier: Apache-2.0
#include "nazori/geometry/written_stroke.h"

#include <gtest/gtest.h>

namespace nazori::geometry {
namespace {

TEST(WrittenStroke, OfALineHasNeitherTimesNorPressures) {
  const Polyline<GlyphFrame> line{{1, 2}, {3, 4}};
  const auto stroke = written_along(line);
  ASSERT_EQ(stroke.size(), 2U);
  EXPECT_EQ(stroke[1].at, (GlyphPoint{3, 4}));
  EXPECT_FALSE(stroke[1].time_s || stroke[1].pressure || stroke[1].lean_rad);
  EXPECT_EQ(line_of(stroke), line);
  EXPECT_TRUE(written_along(Polyline<GlyphFrame>()).empty());
}

TEST(WrittenStroke, KeepsTimePressureAndLeanInAnotherFrame) {
  const WrittenStroke<GlyphFrame> stroke{{{1, 2}, 0.5, 0.25, 0.1}, {{3, 4}, 0.75}};
  const auto turned = in_frame<GridFrame>(stroke, [](GlyphPoint p) { return GridPoint{p.y, -p.x}; });
  EXPECT_EQ(turned, (WrittenStroke<GridFrame>{{{2, -1}, 0.5, 0.25, 0.1}, {{4, -3}, 0.75}}));
}

}  // namespace
}  // namespace nazori::geometry
