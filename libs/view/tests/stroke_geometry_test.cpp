// SPDX-License-Identifier: Apache-2.0
#include "../src/stroke_geometry.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace nazori::view {
namespace {

const geometry::TabletShape kShape{};

std::vector<ArrowHead> heads_of(const std::vector<geometry::GlyphPoint>& points) {
  return make_stroke_geometry(std::array{points}, {}, kShape).heads;
}

void expect_head(const ArrowHead& head, geometry::GlyphPoint tip, double right, double up) {
  const auto at = geometry::glyph_to_tablet(tip, kShape);
  EXPECT_NEAR(head.tip_m.x, at.x, 1e-6);
  EXPECT_NEAR(head.tip_m.y, at.y, 1e-6);
  EXPECT_NEAR(head.direction.x, right, 1e-5);
  EXPECT_NEAR(head.direction.y, up, 1e-5);
}

TEST(ArrowHeads, OfAKickPointsAlongTheKickAloneHoweverShortItIs) {
  for (const double length : {2.6, 4.0, 5.5, 20.0}) {
    const auto heads = heads_of({{20, 20}, {70, 20}, {70, 20 + length}});
    ASSERT_EQ(heads.size(), 2U) << length;
    expect_head(heads[0], {70, 20}, 1, 0);
    expect_head(heads[1], {70, 20 + length}, 0, -1);
  }
}

TEST(ArrowHeads, OfABendPointsAsItsLastBitDoes) {
  // A bend of five degrees is not a corner; the last five units are straight.
  const auto heads = heads_of({{20, 20}, {60, 20}, {64.980973, 20.435779}});
  ASSERT_EQ(heads.size(), 1U);
  expect_head(heads[0], {64.980973, 20.435779}, 0.9961947, -0.0871557);
}

}  // namespace
}  // namespace nazori::view
