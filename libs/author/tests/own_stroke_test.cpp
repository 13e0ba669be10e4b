// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/own_stroke.h"

#include <gtest/gtest.h>

namespace nazori::author {
namespace {

TEST(OwnStroke, ItsLineKeepsPointsEndingAndNumber) {
  OwnStroke stroke;
  stroke.points = {{{10, 20}, 3, 1}, {{90, 25}, 1, 0.5}};
  stroke.ending = kanji::StrokeEnding::taper;
  stroke.number_position = geometry::GlyphPoint{8, 15};
  const auto lines = stroke_lines(std::vector{OwnStroke{.points = {{{1, 2}, 3, 1}}}, stroke});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].ending, kanji::StrokeEnding::stop);
  EXPECT_FALSE(lines[0].number_position);
  EXPECT_EQ(lines[1].points, (geometry::Polyline<geometry::GlyphFrame>{{10, 20}, {90, 25}}));
  EXPECT_EQ(lines[1].ending, kanji::StrokeEnding::taper);
  EXPECT_EQ(lines[1].number_position, (geometry::GlyphPoint{8, 15}));
}

}  // namespace
}  // namespace nazori::author
