// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_explorer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "drawing_under_test.h"

namespace nazori::functions {
namespace {

using Kind = PlotEventKind;
using Way = PlotExplorer::Way;

PlotExplorer explorer_of(const std::string& expression, const Window& window) {
  PlotExplorer explorer;
  explorer.show(test::draw(expression, window));
  return explorer;
}

TEST(ExploringByKey, WithoutADrawingEveryKeyIsRefused) {
  PlotExplorer explorer;
  EXPECT_FALSE(explorer.has_curve());
  for (const PlotEvent& event : {explorer.step(Way::on), explorer.step_to_tick(Way::back),
                                 explorer.go_to_end(Way::on), explorer.where()}) {
    EXPECT_EQ(event.kind, Kind::no_curve);
    EXPECT_FALSE(event.moves_hand());
  }
  EXPECT_EQ(explorer.change_branch(Way::on).kind, Kind::no_other_branch);
  EXPECT_EQ(explorer.next_point(Way::on).kind, Kind::no_point);
  EXPECT_EQ(explorer.go_to_point(0).kind, Kind::no_point);
  EXPECT_EQ(explorer.drop_beacon().kind, Kind::no_location);
  EXPECT_EQ(explorer.go_to_next_beacon().kind, Kind::no_beacon);
  EXPECT_EQ(explorer.slope().kind, Kind::no_slope);
  EXPECT_EQ(explorer.groove(1, 3).kind, Kind::all_grooves);
}

TEST(ExploringByKey, BeforeTheFirstStepTheHandIsNowhere) {
  auto explorer = explorer_of("y = x", {-4, 4, -4, 4});
  EXPECT_EQ(explorer.where().kind, Kind::no_location);
  EXPECT_EQ(explorer.drop_beacon().kind, Kind::no_location);
  EXPECT_EQ(explorer.step(Way::on).kind, Kind::here);
  EXPECT_EQ(explorer.where().kind, Kind::here);
}

TEST(ExploringByKey, AStepSaysWhereTheHandIsAndWhatIsThere) {
  auto explorer = explorer_of("y = x^2 - 1", {-3, 3, -3, 3});
  auto event = explorer.next_point(Way::on);
  while (event.point && event.point->kind != PointKind::minimum) event = explorer.next_point(Way::on);
  EXPECT_EQ(event.kind, Kind::point_reached);
  ASSERT_TRUE(event.point);
  EXPECT_EQ(explorer.drawing()->points[static_cast<std::size_t>(event.number - 1)].kind, PointKind::minimum);
  ASSERT_TRUE(event.location);
  EXPECT_NEAR(event.location->y, -1, 1e-9);
  EXPECT_TRUE(event.moves_hand());
  event = explorer.step(Way::on);
  EXPECT_EQ(event.kind, Kind::here);
  EXPECT_FALSE(event.point) << "a step away from it";
  EXPECT_GT(event.location->x, 0);
}

TEST(ExploringByKey, EndsAndNextBranchesAreAnnounced) {
  auto explorer = explorer_of("y = 1/x", {-5, 5, -5, 5});
  explorer.step(Way::on);
  explorer.go_to_end(Way::on);
  const bool left = explorer.location()->x < 0;
  EXPECT_EQ(explorer.step(Way::on).kind, left ? Kind::next_branch : Kind::end_of_branch);
  const auto other = explorer.change_branch(Way::on);
  EXPECT_EQ(other.kind, Kind::other_branch);
  EXPECT_EQ(other.statement, 0);
}

TEST(ExploringByKey, BeaconsHaveNumbersAndTheSlopeIsAFigure) {
  auto explorer = explorer_of("y = 2x", {-4, 4, -4, 4});
  explorer.step(Way::on);
  const auto dropped = explorer.drop_beacon();
  EXPECT_EQ(dropped.kind, Kind::beacon_dropped);
  EXPECT_EQ(dropped.number, 1);
  EXPECT_FALSE(dropped.moves_hand());
  explorer.go_to_end(Way::on);
  const auto reached = explorer.go_to_next_beacon();
  EXPECT_EQ(reached.kind, Kind::beacon_reached);
  EXPECT_EQ(reached.number, 1);
  EXPECT_NEAR(reached.location->x, dropped.location->x, 1e-6);
  const auto slope = explorer.slope();
  EXPECT_EQ(slope.kind, Kind::slope);
  EXPECT_NEAR(slope.slope, 2, 1e-12);
}

TEST(ExploringByKey, AGrooveKnowsItsCurve) {
  auto drawing = test::draw("y = 1/x; y = 2", {-5, 5, -5, 5});
  drawing->grooves = tablet_curves(drawing->picture.tracing, drawing->picture.plate.heights.size());
  ASSERT_EQ(drawing->grooves.size(), 3U);
  PlotExplorer explorer;
  explorer.show(drawing);
  const auto last = explorer.groove(3, 3);
  EXPECT_EQ(last.kind, Kind::groove);
  EXPECT_EQ(last.number, 3);
  EXPECT_EQ(last.count, 3);
  EXPECT_EQ(last.statement, 1);
  const auto all = explorer.groove(0, 3);
  EXPECT_EQ(all.kind, Kind::all_grooves);
  EXPECT_EQ(all.count, 3);
}

TEST(ExploringByKey, ACoarsePictureIsFollowedOnlyOnceItIsTheLast) {
  auto coarse = test::draw("y = x", {-4, 4, -4, 4});
  coarse->final = false;
  PlotExplorer explorer;
  explorer.show(coarse);
  EXPECT_EQ(explorer.step(Way::on).kind, Kind::no_curve);
  explorer.settle();
  EXPECT_EQ(explorer.step(Way::on).kind, Kind::here);
}

TEST(ExploringByHand, TheNearerToACurveTheLouderAndTheHigherTheCurveTheHigherTheTone) {
  auto explorer = explorer_of("y = x", {-1, 1, -1, 1});
  const double reach = 3 * explorer.drawing()->request.plate.half_width;
  const auto on = explorer.touch({0.3, 0.3});
  EXPECT_NEAR(on.cue.loudness, 1, 1e-3);
  EXPECT_NEAR(on.cue.pan, -0.4, 1e-3);
  EXPECT_FALSE(on.trembles);
  // Across the line by half of the reach.
  const double off = reach / 2 * std::sqrt(0.5);
  EXPECT_NEAR(explorer.touch({0.3 + off, 0.3 - off}).cue.loudness, 0.5, 1e-2);
  EXPECT_EQ(explorer.touch({0.9, 0.1}).cue.loudness, 0);
  EXPECT_GT(explorer.touch({0.7, 0.7}).cue.hertz, on.cue.hertz);
}

TEST(ExploringByHand, APointOfInterestIsReachedOnceUntilTheHandLeavesIt) {
  auto explorer = explorer_of("y = x^2 - 1", {-2, 2, -2, 2});
  const Window& window = explorer.drawing()->request.window;
  const PlatePoint minimum{window.u(0), window.v(-1)};
  const auto first = explorer.touch(minimum);
  ASSERT_NE(first.reached, nullptr);
  EXPECT_EQ(explorer.touch(minimum).reached, nullptr);
  EXPECT_EQ(explorer.touch({0.5, 0.5}).reached, nullptr) << "nothing is there";
  EXPECT_NE(explorer.touch(minimum).reached, nullptr);
}

TEST(ExploringByHand, ABandThatIsFinerThanACellTrembles) {
  auto explorer = explorer_of("y = sin(1/x)", {-0.01, 0.01, -2, 2});
  const auto& bars = explorer.drawing()->picture.tracing.bars;
  ASSERT_FALSE(bars.empty());
  const auto& bar = bars[bars.size() / 2];
  const auto touch = explorer.touch({bar.from.u, (bar.from.v + bar.to.v) / 2});
  EXPECT_TRUE(touch.trembles);
  EXPECT_EQ(touch.cue.loudness, 1);
  EXPECT_FALSE(explorer.touch({bar.from.u, 0.99}).trembles) << "above the band";
}

TEST(ExploringByHand, ThePitchOfASurfaceIsItsHeightAndWhatIsUndefinedIsSilent) {
  auto explorer = explorer_of("z = sqrt(x)", {-1, 1, -1, 1});
  EXPECT_EQ(explorer.touch({0.2, 0.5}).cue.loudness, 0);
  const auto low = explorer.touch({0.6, 0.5});
  const auto high = explorer.touch({0.9, 0.5});
  EXPECT_EQ(low.cue.loudness, 1);
  EXPECT_GT(high.cue.hertz, low.cue.hertz);
  EXPECT_NEAR(explorer.touch({0.9, 0.1}).cue.hertz, high.cue.hertz, 1e-6) << "z depends on x alone";
}

TEST(ExploringByHand, TheToneOfZeroIsThereOnlyWhereZeroIsShown) {
  const auto cue = reference_cue({-1, 1, -1, 3});
  ASSERT_TRUE(cue);
  // A quarter up the window on a scale from 200 to 1000 Hz.
  EXPECT_NEAR(cue->hertz, 200 * std::pow(5, 0.25), 1e-9);
  EXPECT_FALSE(reference_cue({-1, 1, 1, 3}));
  EXPECT_FALSE(reference_cue({-1, 1, -3, -1}));
}

}  // namespace
}  // namespace nazori::functions
