// SPDX-License-Identifier: Apache-2.0
// What is meant where nothing is said, as the headers promise it.
#include <gtest/gtest.h>

#include "../src/arc_tracer.h"
#include "../src/parser.h"
#include "nazori/functions/plot_document.h"
#include "nazori/functions/print_picture.h"
#include "nazori/functions/tablet_curves.h"

namespace nazori::functions {
namespace {

TEST(Defaults, OfWindowsAndSettings) {
  EXPECT_EQ(Window{}, (Window{-10, 10, -10, 10}));
  EXPECT_EQ(TraceSettings{}.resolution, 512);
  EXPECT_EQ(TraceSettings{}.margin, 0.02);
  EXPECT_EQ(TraceSettings{}.most_milliseconds, 0);
  EXPECT_EQ(TraceSettings::kFewestCells, 32);
  EXPECT_EQ(TraceSettings::kMostCells, 8192);
  const PlateSettings plate;
  EXPECT_EQ(plate.size, 512);
  EXPECT_EQ(plate.half_width, 0.0125);
  EXPECT_EQ(plate.alone, -1);
  EXPECT_FALSE(plate.heights);
  EXPECT_TRUE(plate.layers.axes && plate.layers.ticks && plate.layers.rim);
  EXPECT_FALSE(plate.layers.grid);
  EXPECT_EQ(HeightRange{}.low, -1);
  EXPECT_EQ(HeightRange{}.high, 1);
  const SoundSettings sound;
  EXPECT_EQ(sound.sample_rate, 44'100);
  EXPECT_EQ(sound.seconds, 4);
  EXPECT_EQ(sound.lowest_hz, 200);
  EXPECT_EQ(sound.highest_hz, 1000);
  EXPECT_EQ(sound.volume, 0.5);
  EXPECT_TRUE(sound.earcons);
  EXPECT_EQ(Sound{}.sample_rate, 44'100);
  EXPECT_EQ(PrintSettings{}.side_mm, 160);
  EXPECT_EQ(PrintSettings{}.dots_per_inch, 300);
  EXPECT_TRUE(PrintSettings{}.axes);
  EXPECT_FALSE(ParseOptions{}.decimal_comma);
  EXPECT_EQ(kPlotDocumentVersion, 1);
}

TEST(Defaults, LayersAreAnyWhereOneIsThere) {
  EXPECT_FALSE(Layers::none().any());
  for (int k = 0; k < 4; ++k) EXPECT_TRUE((Layers{k == 0, k == 1, k == 2, k == 3}.any())) << k;
}

TEST(Defaults, OfWhatIsTraced) {
  const Tracing t;
  EXPECT_EQ(t.undecided_cells, 0);
  EXPECT_EQ(t.cells, 1);
  EXPECT_EQ(t.undecided_share(), 0);
  EXPECT_TRUE(t.complete);
  EXPECT_FALSE(t.dense);
  const Branch b;
  EXPECT_EQ(b.statement, 0);
  EXPECT_FALSE(b.closed || b.boundary || b.strict || b.has_parameter);
  EXPECT_EQ(CurvePoint{}.u + CurvePoint{}.v + CurvePoint{}.parameter, 0);
  EXPECT_EQ(PlatePoint{}, (PlatePoint{0, 0}));
  EXPECT_EQ(Bar{}.statement + Dot{}.statement + Fill{}.statement, 0);
  const Event e;
  EXPECT_EQ(e.kind, EventKind::hole);
  EXPECT_EQ(e.statement, 0);
  EXPECT_EQ(e.parameter, 0);
  EXPECT_EQ(e.x, 0);
  EXPECT_EQ(e.y, 0);
  EXPECT_EQ(e.x_after, 0);
  EXPECT_EQ(e.y_after, 0);
  const PointOfInterest p;
  EXPECT_EQ(p.kind, PointKind::zero);
  EXPECT_EQ(p.statement, 0);
  EXPECT_EQ(p.other, -1);
  EXPECT_EQ(p.x, 0);
  EXPECT_EQ(p.y, 0);
  EXPECT_EQ(p.parameter, 0);
}

TEST(Defaults, OfPlacesCuesAndCurves) {
  const CurvePlace place;
  EXPECT_EQ(place.branch, 0U);
  EXPECT_EQ(place.piece, 0U);
  EXPECT_EQ(place.distance, 0);
  EXPECT_EQ(TabletCurve{}.statement, 0);
  EXPECT_FALSE(TabletCurve{}.closed);
  EXPECT_EQ(CurveFeel{}.friction, 0.05);
  EXPECT_EQ(CurveFeel{}.texture_period, 0);
  const Cue cue;
  EXPECT_EQ(cue.hertz, 0);
  EXPECT_EQ(cue.pan, 0);
  EXPECT_EQ(cue.noise, 0);
  EXPECT_EQ(cue.loudness, 0);
}

TEST(Defaults, OfExpressionsAndTexts) {
  const Node n;
  EXPECT_EQ(n.kind, NodeKind::number);
  EXPECT_EQ(n.value, 0);
  EXPECT_TRUE(n.exact);
  EXPECT_EQ(Rational{}, (Rational{0, 1}));
  const Statement s;
  EXPECT_EQ(s.kind, StatementKind::explicit_y);
  EXPECT_FALSE(s.from_is_open || s.to_is_open || s.range_given);
  EXPECT_EQ(s.column, 1);
  const SyntaxError error;
  EXPECT_EQ(error.column, 1);
  EXPECT_EQ(error.fault, SyntaxFault::no_expression);
  EXPECT_EQ(error.number, 0);
  EXPECT_EQ(error.wanted, 0);
  const Token token;
  EXPECT_EQ(token.kind, TokenKind::end);
  EXPECT_EQ(token.column, 1);
  EXPECT_EQ(token.value, 0);
  EXPECT_EQ(token.degree, 2);
  EXPECT_TRUE(token.exact);
  EXPECT_FALSE(token.space_before);
  EXPECT_EQ(Relation{}.column, 1);
  EXPECT_TRUE(is_strict(Comparison::less) && is_strict(Comparison::greater));
  EXPECT_FALSE(is_strict(Comparison::equal) || is_strict(Comparison::less_equal) ||
               is_strict(Comparison::greater_equal));
}

TEST(Defaults, OfNumbersAndArcs) {
  const Interval i;
  EXPECT_EQ(i.lower, 0);
  EXPECT_EQ(i.upper, 0);
  EXPECT_TRUE(i.is_continuous());
  EXPECT_EQ(i.cause, Cause::none);
  const Dual<double, 2> d(3);
  EXPECT_EQ(d.value, 3);
  EXPECT_EQ(d.slopes[0], 0);
  EXPECT_EQ(d.slopes[1], 0);
  const Dual<double, 2> second(3, 1);
  EXPECT_EQ(second.slopes[0], 0);
  EXPECT_EQ(second.slopes[1], 1);
  const Arc arc;
  EXPECT_EQ(arc.from, 0);
  EXPECT_EQ(arc.to, 1);
  EXPECT_FALSE(arc.ends_are_real || arc.from_is_open || arc.to_is_open);
  const geometry::TabletShape shape;
  EXPECT_EQ(tablet_curves({}, 64, shape).size(), 0U);
}

}  // namespace
}  // namespace nazori::functions
