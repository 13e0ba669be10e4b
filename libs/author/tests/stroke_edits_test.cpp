// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/stroke_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "own_forms.h"

namespace nazori::author {
namespace {

using namespace test;
using Pen = geometry::WrittenStroke<geometry::GlyphFrame>;

Pen straight_pen(int points, double pressure_from, double pressure_to) {
  Pen pen;
  for (int i = 0; i < points; ++i) {
    const double t = i / (points - 1.0);
    pen.push_back({.at = {20 + 60 * t, 40}, .pressure = pressure_from + (pressure_to - pressure_from) * t});
  }
  return pen;
}

TEST(StrokeOfPen, IsAsBroadAsThePenPressesAndHasOnlyThePointsItNeeds) {
  const auto stroke = stroke_of_pen(straight_pen(60, 1, 0), {.width = 8, .depth = 0.9, .thinnest = 0.25});
  ASSERT_TRUE(stroke);
  EXPECT_EQ(stroke->points, (std::vector<GroovePoint>{{{20, 40}, 4, 0.9}, {{80, 40}, 1, 0.9}}));
  EXPECT_FALSE(stroke->number_position);
}

TEST(StrokeOfPen, WithoutPressureItHasItsFullWidth) {
  const auto stroke = stroke_of_pen({{.at = {10, 10}}, {.at = {20, 30}}}, {.width = 6});
  EXPECT_EQ(stroke->points, (std::vector<GroovePoint>{{{10, 10}, 3, 1}, {{20, 30}, 3, 1}}));
}

TEST(StrokeOfPen, KeepsABendAndAPressWithinItsTolerance) {
  Pen pen;
  for (int i = 0; i <= 40; ++i) pen.push_back({.at = {10.0 + i, 10}, .pressure = 0.5});
  for (int i = 1; i <= 40; ++i) pen.push_back({.at = {50, 10.0 + i}, .pressure = i == 20 ? 1.0 : 0.5});
  const auto stroke = stroke_of_pen(pen);
  ASSERT_TRUE(stroke);
  std::vector<GlyphPoint> places;
  for (const GroovePoint& p : stroke->points) places.push_back(p.at);
  EXPECT_EQ(places, (std::vector<GlyphPoint>{{10, 10}, {50, 10}, {50, 29}, {50, 30}, {50, 31}, {50, 50}}));
  // What a hand's shake adds stays out.
  for (std::size_t i = 0; i < pen.size(); i += 2) pen[i].at.y += 0.1;
  EXPECT_LE(stroke_of_pen(pen)->points.size(), 6U);
}

TEST(StrokeOfPen, LeavesOutWhatIsNoNumberAndStaysNearThePicture) {
  EXPECT_FALSE(stroke_of_pen({}));
  EXPECT_FALSE(stroke_of_pen({{.at = {NAN, 1}}}));
  const auto stroke =
      stroke_of_pen({{.at = {1, 1}}, {.at = {1, INFINITY}}, {.at = {1e9, -1e9}, .pressure = NAN}});
  ASSERT_EQ(stroke->points.size(), 2U);
  EXPECT_EQ(stroke->points[1], (GroovePoint{{218, -109}, 3.5, 1}));
}

TEST(StrokeOfPen, NeverHasMorePointsThanAStrokeMay) {
  Pen pen;
  for (int i = 0; i < 5000; ++i)
    pen.push_back({.at = {50 + 50 * std::sin(i * 0.9), 50 + 50 * std::cos(i * 1.3)}});
  const auto stroke = stroke_of_pen(pen);
  EXPECT_LE(stroke->points.size(), kMostPoints);
  EXPECT_TRUE(validate({*stroke}));
}

TEST(EndingOf, IsReadFromTheWidthAndTheLine) {
  OwnStroke stroke = even_stroke({{20, 20}, {50, 20}, {80, 20}});
  EXPECT_EQ(ending_of(stroke), StrokeEnding::stop);
  stroke.points[2].half_width = 0.5;
  EXPECT_EQ(ending_of(stroke), StrokeEnding::taper);
  OwnStroke hooked = even_stroke({{50, 20}, {50, 80}, {44, 74}});
  EXPECT_EQ(ending_of(hooked), StrokeEnding::stop);
  hooked.points[2].half_width = 0;
  EXPECT_EQ(ending_of(hooked), StrokeEnding::hook);
  OwnStroke short_hook = even_stroke({{50, 50}, {50, 52.1}, {48, 52}});
  short_hook.points[2].half_width = 0;
  EXPECT_EQ(ending_of(short_hook), StrokeEnding::hook);
  // A sharp bend far from the end is a bend.
  OwnStroke bent = even_stroke({{20, 20}, {50, 20}, {50, 80}, {50, 90}});
  bent.points[3].half_width = 0;
  EXPECT_EQ(ending_of(bent), StrokeEnding::taper);
  EXPECT_EQ(ending_of(even_stroke({{20, 20}})), StrokeEnding::stop);
}

TEST(EndingOf, AgreesWithTheBrushThatCarved) {
  for (const StrokeEnding ending : {StrokeEnding::stop, StrokeEnding::taper}) {
    const kanji::StrokeLine line{{{20, 20}, {50, 24}, {90, 20}}, ending, {}};
    EXPECT_EQ(ending_of(own_strokes({line})[0]), ending);
  }
  const kanji::StrokeLine hook{{{50, 20}, {50, 80}, {43, 75}}, StrokeEnding::hook, {}};
  EXPECT_EQ(ending_of(own_strokes({hook})[0]), StrokeEnding::hook);
}

TEST(NearestPlace, IsOnTheLineThatIsCut) {
  const std::vector<OwnStroke> strokes{even_stroke({{20, 20}, {80, 20}}),
                                       even_stroke({{20, 60}, {50, 60}, {80, 60}})};
  const auto place = nearest_place(strokes, {65, 57});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->stroke, 1U);
  EXPECT_EQ(place->segment, 1U);
  EXPECT_NEAR(place->groove.at.x, 65, 1e-9);
  EXPECT_NEAR(place->groove.at.y, 60, 1e-9);
  EXPECT_EQ(place->groove.half_width, 3);
  EXPECT_NEAR(place->distance, 3, 1e-9);
  EXPECT_FALSE(nearest_place({}, {0, 0}));
  EXPECT_EQ(nearest_place(strokes, {30, 61})->segment, 0U);
  EXPECT_EQ(nearest_place(std::vector{even_stroke({{5, 5}})}, {8, 9})->distance, 5);
}

TEST(NearestPlace, InterpolatesTheGroove) {
  OwnStroke stroke = even_stroke({{20, 20}, {80, 20}}, 2, 0.4);
  stroke.points[1].half_width = 6;
  stroke.points[1].depth = 1;
  const auto place = nearest_place(std::span(&stroke, 1), {35, 30});
  EXPECT_NEAR(place->groove.half_width, 3, 1e-9);
  EXPECT_NEAR(place->groove.depth, 0.55, 1e-9);
}

TEST(Snap, FindsTheNearestPointWithinReach) {
  const std::vector<OwnStroke> strokes{even_stroke({{20, 20}, {50, 20}, {80, 20}}),
                                       even_stroke({{80, 20}, {80, 70}})};
  const auto found = snap(strokes, {51, 21});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->stroke, 0U);
  EXPECT_EQ(found->point, 1U);
  EXPECT_EQ(found->kind, PointKind::bend);
  EXPECT_NEAR(found->distance, std::sqrt(2), 1e-12);
  // The end of the first is the start of the second, which lies on top.
  const auto start = snap(strokes, {80, 20});
  EXPECT_EQ(start->stroke, 1U);
  EXPECT_EQ(start->kind, PointKind::start);
  EXPECT_EQ(snap(strokes, {80, 71})->kind, PointKind::end);
  EXPECT_EQ(snap(strokes, {80, 71})->point, 1U);
  EXPECT_TRUE(snap(strokes, {80, 74}));
  EXPECT_FALSE(snap(strokes, {80, 74.1}));
  EXPECT_TRUE(snap(strokes, {80, 79}, 9));
  EXPECT_EQ(snap(std::vector{even_stroke({{1, 1}})}, {1, 1})->kind, PointKind::start);
}

TEST(StrokeEdits, APointIsAddedOnTheLineAndTakenAway) {
  const OwnStroke stroke = even_stroke({{20, 20}, {50, 20}, {80, 20}});
  const auto place = nearest_place(std::span(&stroke, 1), {60, 25});
  const OwnStroke more = with_point(stroke, *place);
  ASSERT_EQ(more.points.size(), 4U);
  EXPECT_NEAR(more.points[2].at.x, 60, 1e-9);
  EXPECT_EQ(without_point(more, 2), stroke);
}

TEST(StrokeEdits, SplitAndJoinAreInverse) {
  OwnStroke stroke = even_stroke({{20, 20}, {50, 20}, {80, 20}});
  stroke.ending = StrokeEnding::taper;
  stroke.number_position = GlyphPoint{10, 10};
  const auto [first, second] = split_at(stroke, 1);
  EXPECT_EQ(first.points.size(), 2U);
  EXPECT_EQ(first.ending, StrokeEnding::stop);
  EXPECT_EQ(first.number_position, stroke.number_position);
  EXPECT_EQ(second.points.front(), stroke.points[1]);
  EXPECT_EQ(second.ending, StrokeEnding::taper);
  EXPECT_FALSE(second.number_position);
  EXPECT_EQ(joined(first, second), stroke);
  EXPECT_EQ(joined(even_stroke({{1, 1}, {2, 2}}), even_stroke({{3, 3}, {4, 4}})).points.size(), 4U);
}

TEST(StrokeEdits, AReversedStrokeHasTheEndingOfItsOtherEnd) {
  OwnStroke stroke = even_stroke({{20, 20}, {50, 20}, {80, 20}});
  stroke.points[0].half_width = 0.2;
  stroke.number_position = GlyphPoint{10, 10};
  const OwnStroke other = reversed(stroke);
  EXPECT_EQ(other.points.front(), stroke.points.back());
  EXPECT_EQ(other.points.back(), stroke.points.front());
  EXPECT_EQ(other.ending, StrokeEnding::taper);
  EXPECT_FALSE(other.number_position);
}

TEST(StrokeEdits, ScalingStaysInRange) {
  const OwnStroke stroke = even_stroke({{20, 20}, {50, 20}}, 4, 0.6);
  EXPECT_EQ(scaled(stroke, 0.5, 1.5), even_stroke({{20, 20}, {50, 20}}, 2, 0.6 * 1.5));
  EXPECT_EQ(scaled(stroke, 10, 10), even_stroke({{20, 20}, {50, 20}}, 20, 1));
}

NumberBox box_of_number(const std::vector<GlyphPoint>& places, std::size_t k) {
  return number_box(k + 1, places[k]);
}

double away_from(const NumberBox& box, GlyphPoint p) {
  return std::hypot(std::max({box.left - p.x, p.x - box.right, 0.0}),
                    std::max({box.top - p.y, p.y - box.bottom, 0.0}));
}

TEST(NumberPlaces, NeitherCoverOneAnotherNorAStartAndStayInThePicture) {
  // Many strokes that start close together, at the edge and in a corner, too.
  std::vector<OwnStroke> strokes;
  for (int i = 0; i < 30; ++i)
    strokes.push_back(even_stroke({{2.0 + 6.5 * (i % 6), 3.0 + 8 * (i / 6)}, {60.0 + i, 104}}, 2));
  const auto places = number_places(strokes);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const NumberBox box = box_of_number(places, k);
    EXPECT_GE(box.left, 0);
    EXPECT_GE(box.top, 0);
    EXPECT_LE(box.right, 109);
    EXPECT_LE(box.bottom, 109);
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_GE(away_from(box, strokes[i].points.front().at), 1.5) << k << ", " << i;
      const NumberBox other = box_of_number(places, i);
      const bool apart = box.right <= other.left || other.right <= box.left || box.bottom <= other.top ||
                         other.bottom <= box.top;
      EXPECT_TRUE(i == k || apart) << k << ", " << i;
    }
  }
}

TEST(NumberPlaces, ASingleStrokeHasItsNumberAtTheLeftOfItsStart) {
  const auto places = number_places(std::vector{even_stroke({{50, 50}, {50, 100}})});
  const NumberBox box = number_box(1, places[0]);
  // The nearest ring on which the start stays free, a sixteenth of a turn from the upper left.
  const double angle = 22.5 * 3.14159265358979323846 / 180;
  EXPECT_NEAR((box.left + box.right) / 2, 50 - 5 * std::cos(angle), 1e-9);
  EXPECT_NEAR((box.top + box.bottom) / 2, 50 - 5 * std::sin(angle), 1e-9);
}

TEST(NumberPlaces, ANumberMayReachTheEdgeOfThePicture) {
  // As above, 0.58 units from the left edge.
  const auto places = number_places(std::vector{even_stroke({{7.5, 50}, {7.5, 100}})});
  EXPECT_NEAR(places[0].x, 7.5 - 5 * std::cos(22.5 * 3.14159265358979323846 / 180) - 2.3, 1e-9);
  const auto lower = number_places(std::vector{even_stroke({{6.5, 50}, {6.5, 100}})});
  EXPECT_GE(lower[0].x, 0);
}

TEST(NumberPlaces, ANumberStandsBesideTheGroovesWhereThatIsNear) {
  const std::vector<OwnStroke> strokes{even_stroke({{50, 50}, {50, 100}}),
                                       even_stroke({{20, 46}, {48, 46}}, 4)};
  const NumberBox box = number_box(1, number_places(strokes)[0]);
  for (double x = 20; x <= 48; x += 1) EXPECT_GT(away_from(box, {x, 46}), 2.7) << x;
}

TEST(NumberPlaces, GivenPlacesAreKeptAndOthersAvoidThem) {
  std::vector<OwnStroke> strokes{even_stroke({{50, 50}, {50, 100}}), even_stroke({{70, 50}, {70, 100}})};
  const GlyphPoint usual = number_places(strokes)[0];
  strokes[1].number_position = usual;
  const auto places = number_places(strokes);
  EXPECT_EQ(places[1], usual);
  EXPECT_NE(places[0], usual);
}

TEST(NumberPlaces, TwoDigitsAreTwiceAsBroad) {
  const NumberBox one = number_box(9, {10, 20});
  const NumberBox two = number_box(10, {10, 20});
  EXPECT_DOUBLE_EQ(one.right, 14.6);
  EXPECT_DOUBLE_EQ(two.right, 19.2);
  EXPECT_DOUBLE_EQ(one.top, 14);
  EXPECT_DOUBLE_EQ(one.bottom, 20);
}

TEST(NumberPlaces, WithoutRoomEachStillHasAPlace) {
  const std::vector<OwnStroke> strokes(200, even_stroke({{50, 50}, {50, 100}}));
  const auto places = number_places(strokes);
  ASSERT_EQ(places.size(), 200U);
  EXPECT_EQ(places.back(), (GlyphPoint{42, 48}));
}

TEST(Thinned, KeepsOnlyPointsThatLineWidthOrDepthNeed) {
  OwnStroke stroke;
  for (int i = 0; i <= 40; ++i) stroke.points.push_back({{20.0 + i, 50}, 3, 1});
  stroke.points[10].at.y = 50.1;  // within the tolerance
  stroke.points[20].half_width = 4;
  stroke.points[30].depth = 0.5;
  stroke.ending = kanji::StrokeEnding::taper;
  const OwnStroke thin = thinned(stroke);
  std::vector<double> kept;
  for (const GroovePoint& point : thin.points) kept.push_back(point.at.x);
  EXPECT_EQ(kept, (std::vector<double>{20, 39, 40, 41, 49, 50, 51, 60}));
  EXPECT_EQ(thin.ending, kanji::StrokeEnding::taper);
  EXPECT_EQ(thinned(thin), thin);
}

TEST(StrokeOfPen, WithTooManyPointsItIsOnlyAsCoarseAsItMustBe) {
  // 1,200 small teeth, which the tolerance of 0.3 keeps, that of 0.45 does not, and a few larger ones.
  Pen pen;
  for (int i = 0; i <= 2400; ++i) {
    const bool is_large = i > 0 && i % 240 == 1;
    pen.push_back({.at = {i * 0.04, 50 + (is_large ? 0.55 : i % 2 == 1 ? 0.4 : 0)}});
  }
  const auto stroke = stroke_of_pen(pen);
  ASSERT_TRUE(stroke);
  std::size_t large = 0;
  std::size_t small = 0;
  for (const GroovePoint& p : stroke->points) {
    if (std::abs(p.at.y - 50.55) < 1e-9) ++large;
    if (std::abs(p.at.y - 50.4) < 1e-9) ++small;
  }
  EXPECT_EQ(large, 10U);
  EXPECT_LT(small, 20U);
}

TEST(EndingOf, AHookTurnsByFiftyDegreesFromTwoToFourteenUnitsFromItsEnd) {
  const auto ending = [](double tail, double degrees) {
    const double a = (90 + degrees) * 3.14159265358979323846 / 180;
    OwnStroke stroke = even_stroke({{50, 10}, {50, 70}, {50 + tail * std::cos(a), 70 + tail * std::sin(a)}});
    stroke.points[2].half_width = 0;
    return ending_of(stroke);
  };
  EXPECT_EQ(ending(8, 90), StrokeEnding::hook);
  EXPECT_EQ(ending(8, 49), StrokeEnding::taper);
  EXPECT_EQ(ending(14, 90), StrokeEnding::hook);
  EXPECT_EQ(ending(18, 90), StrokeEnding::taper);
}

TEST(EndingOf, ATaperIsNarrowerThanSixTenthsOfTheWidthBeforeItsLastPart) {
  OwnStroke stroke = even_stroke({{20, 20}, {71, 20}, {80, 20}});
  stroke.points[2].half_width = 1.79;
  EXPECT_EQ(ending_of(stroke), StrokeEnding::taper);
  stroke.points[2].half_width = 1.81;
  EXPECT_EQ(ending_of(stroke), StrokeEnding::stop);
  // Farther back than the last 15 % it may narrow as it likes.
  stroke.points = {{{20, 20}, 9, 1}, {{68, 20}, 3, 1}, {{80, 20}, 2.9, 1}};
  EXPECT_EQ(ending_of(stroke), StrokeEnding::stop);
}

TEST(NumberPlaces, AroundAStartWithoutRoomItIsTheNearestFreePlaceOfThePicture) {
  // The second number would have its place around the same start, where fixed numbers leave no room.
  std::vector<OwnStroke> strokes{even_stroke({{54, 54}, {54, 100}})};
  for (double y = 30; y <= 84; y += 6.2)
    for (double x = 28; x <= 80; x += 4.8) {
      strokes.push_back(even_stroke({{105, 3}, {106, 3}}, 1));
      strokes.back().number_position = GlyphPoint{x, y};
    }
  const GlyphPoint at = number_places(strokes)[0];
  // Whole units; no nearer one to (46, 52) is free.
  EXPECT_EQ(at.x, std::floor(at.x));
  EXPECT_EQ(at.y, std::floor(at.y));
  const auto is_free = [&](GlyphPoint p) {
    const NumberBox box = number_box(1, p);
    if (box.left < 0 || box.top < 0 || box.right > 109 || box.bottom > 109) return false;
    for (std::size_t k = 1; k < strokes.size(); ++k) {
      const NumberBox other = number_box(k + 1, *strokes[k].number_position);
      if (box.left < other.right + 0.4 && other.left < box.right + 0.4 && box.top < other.bottom + 0.4 &&
          other.top < box.bottom + 0.4)
        return false;
    }
    return away_from(box, {54, 54}) >= 1.5 && away_from(box, {105, 3}) >= 1.5;
  };
  EXPECT_TRUE(is_free(at));
  double least = 1e9;
  for (double y = 6; y <= 109; y += 1)
    for (double x = 0; x < 109; x += 1)
      if (is_free({x, y})) least = std::min(least, std::hypot(x - 46, y - 52));
  EXPECT_GT(least, 18) << "the places around the start are taken";
  EXPECT_NEAR(std::hypot(at.x - 46, at.y - 52), least, 1e-9);
}

TEST(NumberPlaces, OnAGrooveCountsAsSevenUnitsFarther) {
  // Broad grooves cover all that is within this distance of the start.
  const auto distance = [](double covered) {
    const OwnStroke start = even_stroke({{54, 54}, {54, 60}}, 1);
    const OwnStroke wide = even_stroke({{54.2, 54}, {54.3, 54}}, covered / 0.7);
    const NumberBox box = number_box(1, number_places(std::vector{start, wide})[0]);
    return std::hypot((box.left + box.right) / 2 - 54, (box.top + box.bottom) / 2 - 54);
  };
  EXPECT_NEAR(distance(1), 5, 1e-9);
  EXPECT_NEAR(distance(6), 9.5, 1e-9);
  EXPECT_NEAR(distance(14), 5, 1.1) << "beside it is too far";
}

}  // namespace
}  // namespace nazori::author
