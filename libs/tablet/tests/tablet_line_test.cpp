// SPDX-License-Identifier: Apache-2.0
#include "nazori/tablet/tablet_line.h"

#include <gtest/gtest.h>

namespace nazori::tablet {
namespace {

TEST(TabletLine, OfAStrokeHasItsEndingAndACurveHasNone) {
  const kanji::StrokeLine stroke{{{1, 2}, {3, 4}}, kanji::StrokeEnding::taper, geometry::GlyphPoint{5, 6}};
  const TabletLine line = stroke;
  EXPECT_EQ(line.points, stroke.points);
  EXPECT_EQ(line.ending, kanji::StrokeEnding::taper);
  EXPECT_FALSE(TabletLine(stroke.points).ending);
  EXPECT_EQ(tablet_lines(std::vector{stroke, stroke}), (std::vector<TabletLine>{line, line}));
}

TEST(TabletLine, WithoutAnEndingIsCarvedAsAStrokeThatStops) {
  const geometry::Polyline<geometry::GlyphFrame> curve{{1, 2}, {3, 4}};
  const TabletLine hook = kanji::StrokeLine{curve, kanji::StrokeEnding::hook, {}};
  const auto strokes = stroke_lines(std::vector{TabletLine(curve), hook});
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_EQ(strokes[0], (kanji::StrokeLine{curve, kanji::StrokeEnding::stop, {}}));
  EXPECT_EQ(strokes[1].ending, kanji::StrokeEnding::hook);
  EXPECT_EQ(centre_lines(std::vector{TabletLine(curve), hook}), (std::vector{curve, curve}));
}

}  // namespace
}  // namespace nazori::tablet
