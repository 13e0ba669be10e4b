// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "bench_under_test.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(WorkbenchTest, TheDrawingToolMakesAStrokeAndChoosesIt) {
  bench_.move_pen({{20, 90}, 0.0}, true);
  bench_.move_pen({{50, 90}, 0.1}, true);
  EXPECT_THAT(bench_.movement(), SizeIs(2));
  EXPECT_TRUE(bench_.is_down());
  bench_.move_pen({{80, 90}, 0.2}, false);
  ASSERT_THAT(strokes(), SizeIs(3));
  EXPECT_EQ(strokes()[2].points.front().at, (GlyphPoint{20, 90}));
  EXPECT_EQ(strokes()[2].points.back().at, (GlyphPoint{80, 90}));
  EXPECT_EQ(bench_.selection(), (Selection{2, std::nullopt}));
  EXPECT_THAT(bench_.movement(), IsEmpty());
  EXPECT_FALSE(bench_.is_down());
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::draw_stroke, EditWay::made)));
  EXPECT_FALSE(box_.is_empty());
  EXPECT_EQ(bench_.editor().map(), *carve(bench_.character(), kSize));
}

TEST_F(WorkbenchTest, AStrokeIsAsWideAndDeepAsTheToolIsSet) {
  bench_.set_settings({.width = 10, .depth = 0.5});
  move({{20, 90}, {50, 90}, {80, 90}}, 1.0);
  ASSERT_THAT(strokes(), SizeIs(3));
  for (const auto& point : strokes()[2].points) {
    EXPECT_DOUBLE_EQ(point.half_width, 5);
    EXPECT_DOUBLE_EQ(point.depth, 0.5);
  }
}

TEST_F(WorkbenchTest, AStraightStrokeHasOnlyItsStartAndEnd) {
  bench_.set_settings({.straight = true});
  move({{20, 90}, {50, 70}, {80, 90}});
  ASSERT_THAT(strokes(), SizeIs(3));
  ASSERT_THAT(strokes()[2].points, SizeIs(2));
  EXPECT_EQ(strokes()[2].points[0].at, (GlyphPoint{20, 90}));
  EXPECT_EQ(strokes()[2].points[1].at, (GlyphPoint{80, 90}));
}

TEST_F(WorkbenchTest, SettingsOutOfRangeAreMovedIntoIt) {
  bench_.set_settings({.width = 1000, .depth = 7});
  EXPECT_EQ(bench_.settings().width, kWidestTool);
  EXPECT_EQ(bench_.settings().depth, 1);
  bench_.set_settings({.width = -1, .depth = 0});
  EXPECT_EQ(bench_.settings().width, kThinnestTool);
  EXPECT_EQ(bench_.settings().depth, kShallowestTool);
}

TEST_F(WorkbenchTest, PositionsThatAreNotFiniteAreIgnored) {
  const double no = std::numeric_limits<double>::quiet_NaN();
  bench_.move_pen({{no, 1}}, true);
  EXPECT_FALSE(bench_.is_down());
  bench_.move_pen({{20, 90}}, true);
  bench_.move_pen({{30, no}}, true);
  EXPECT_THAT(bench_.movement(), SizeIs(1));
}

TEST_F(WorkbenchTest, AnotherToolEndsWhatIsUnderWay) {
  bench_.move_pen({{20, 90}}, true);
  use(Tool::place);
  EXPECT_FALSE(bench_.is_down());
  EXPECT_THAT(bench_.movement(), IsEmpty());
  click({20, 90});
  use(Tool::draw);
  EXPECT_THAT(bench_.placed(), IsEmpty());
  EXPECT_THAT(edits_, IsEmpty());
}

TEST_F(WorkbenchTest, ALostPenLeavesNothing) {
  bench_.move_pen({{20, 90}}, true);
  bench_.move_pen({{40, 90}}, true);
  bench_.lose_pen();
  bench_.move_pen({{60, 90}}, false);
  EXPECT_THAT(strokes(), SizeIs(2));
  EXPECT_THAT(bench_.movement(), IsEmpty());
}

TEST_F(WorkbenchTest, PlacedPointsBecomeAStroke) {
  auto held = bench_.settings();
  held.tool = Tool::place;
  held.ending = kanji::StrokeEnding::taper;
  bench_.set_settings(held);
  click({10, 90});
  EXPECT_FALSE(bench_.finish_placing()) << "one point is no stroke";
  EXPECT_THAT(bench_.placed(), SizeIs(1));
  click({40, 100});
  click({95, 80});
  EXPECT_TRUE(bench_.finish_placing());
  ASSERT_THAT(strokes(), SizeIs(3));
  EXPECT_EQ(strokes()[2].ending, kanji::StrokeEnding::taper);
  EXPECT_EQ(strokes()[2].points.front().at, (GlyphPoint{10, 90}));
  EXPECT_EQ(strokes()[2].points.back().at, (GlyphPoint{95, 80}));
  EXPECT_THAT(bench_.placed(), IsEmpty());
  EXPECT_EQ(bench_.selection(), (Selection{2, std::nullopt}));
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::draw_stroke, EditWay::made)));
}

TEST_F(WorkbenchTest, APlacedPointSnapsToAGrooveInReach) {
  use(Tool::place);
  click({20 + 2.0, 30 + 2.0});
  click({20 + 2.5, 60 + 2.5});
  EXPECT_THAT(bench_.placed(), ElementsAre(GlyphPoint{20, 30}, GlyphPoint{22.5, 62.5}));
}

TEST_F(WorkbenchTest, SteppingBackTakesPlacedPointsBeforeItUndoes) {
  move({{20, 90}, {50, 90}, {80, 90}});
  use(Tool::place);
  click({10, 100});
  bench_.step_back();
  EXPECT_THAT(bench_.placed(), IsEmpty());
  EXPECT_THAT(strokes(), SizeIs(3));
  bench_.step_back();
  EXPECT_THAT(strokes(), SizeIs(2));
  EXPECT_EQ(edits_.back(), (std::pair(EditKind::draw_stroke, EditWay::undone)));
}

TEST_F(WorkbenchTest, AClickChoosesAPointALineOrNothing) {
  use(Tool::edit);
  click({51, 31});
  EXPECT_EQ(bench_.selection(), (Selection{0, 1}));
  click({70, 61});
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt}));
  click({70, 63.5});
  EXPECT_EQ(bench_.selection(), Selection{});
  EXPECT_THAT(edits_, IsEmpty());
}

TEST_F(WorkbenchTest, ADragMovesAPointAndIsUndoneAtOnce) {
  use(Tool::edit);
  move({{50, 30}, {52, 33}, {55, 40}, {56, 41}, {56, 41}});
  EXPECT_EQ(strokes()[0].points[1].at, (GlyphPoint{56, 41}));
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::move_point, EditWay::made)));
  bench_.undo();
  EXPECT_EQ(strokes()[0].points[1].at, (GlyphPoint{50, 30}));
  EXPECT_EQ(bench_.editor().state().undoes, EditKind::none);
}

TEST_F(WorkbenchTest, ADragKeepsThePlaceWhereThePointWasTaken) {
  use(Tool::edit);
  move({{51, 31}, {61, 41}, {61, 41}});
  EXPECT_EQ(strokes()[0].points[1].at, (GlyphPoint{60, 40}));
}

TEST_F(WorkbenchTest, ADragOfALineMovesTheWholeStroke) {
  use(Tool::edit);
  move({{70, 30}, {70, 35}, {72, 40}, {72, 40}});
  EXPECT_EQ(strokes()[0].points[0].at, (GlyphPoint{22, 40}));
  EXPECT_EQ(strokes()[0].points[2].at, (GlyphPoint{92, 40}));
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::move_stroke, EditWay::made)));
}

TEST_F(WorkbenchTest, ATremblingClickMovesNothing) {
  use(Tool::edit);
  move({{50, 30}, {50.3, 30.3}, {50.1, 30}});
  EXPECT_EQ(strokes()[0].points[1].at, (GlyphPoint{50, 30}));
  EXPECT_THAT(edits_, IsEmpty());
}

TEST_F(WorkbenchTest, ADoubleClickOnALineAddsAPoint) {
  EXPECT_TRUE(bench_.insert_point_at({70, 31}));
  ASSERT_THAT(strokes()[0].points, SizeIs(4));
  EXPECT_NEAR(strokes()[0].points[2].at.x, 70, 0.3);
  EXPECT_EQ(bench_.selection(), (Selection{0, 2}));
  EXPECT_FALSE(bench_.insert_point_at({70, 45}));
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::insert_point, EditWay::made)));
}

TEST_F(WorkbenchTest, APointIsAddedByKeyHalfwayToTheNextOne) {
  EXPECT_FALSE(bench_.insert_point());
  bench_.select({0, 1});
  EXPECT_TRUE(bench_.insert_point());
  ASSERT_THAT(strokes()[0].points, SizeIs(4));
  EXPECT_NEAR(strokes()[0].points[2].at.x, 70, 0.3);
  EXPECT_EQ(bench_.selection(), (Selection{0, 2}));
  bench_.select({1, 2});
  EXPECT_TRUE(bench_.insert_point());
  EXPECT_NEAR(strokes()[1].points[2].at.x, 70, 0.3) << "at the end: before the last point";
}

TEST_F(WorkbenchTest, TheNextStrokeAndPointGoRound) {
  bench_.select_next_stroke(1);
  EXPECT_EQ(bench_.selection(), (Selection{0, std::nullopt}));
  bench_.select_next_stroke(1);
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt}));
  bench_.select_next_stroke(1);
  EXPECT_EQ(bench_.selection(), (Selection{0, std::nullopt}));
  bench_.select_next_stroke(-1);
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt}));
  bench_.select_next_point(1);
  EXPECT_EQ(bench_.selection(), (Selection{1, 0}));
  bench_.select_next_point(-1);
  EXPECT_EQ(bench_.selection(), (Selection{1, 2}));
  bench_.select({});
  bench_.select_next_stroke(-1);
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt}));
}

TEST_F(WorkbenchTest, WithoutStrokesNothingIsChosen) {
  Workbench empty(editor_with({}));
  empty.select_next_stroke(1);
  empty.select_next_point(1);
  EXPECT_EQ(empty.selection(), Selection{});
}

TEST_F(WorkbenchTest, WhatIsNotThereIsNotChosen) {
  bench_.select({2, 0});
  EXPECT_EQ(bench_.selection(), Selection{});
  bench_.select({1, 3});
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt}));
  bench_.select({std::nullopt, 1});
  EXPECT_EQ(bench_.selection(), Selection{});
  bench_.select({1, 2});
  EXPECT_EQ(bench_.selection(), (Selection{1, 2}));
}

TEST_F(WorkbenchTest, KeysMoveWhatIsChosenOrElseTheCursor) {
  use(Tool::edit);
  const GlyphPoint middle = bench_.cursor();
  bench_.move_by_key({1, 0});
  EXPECT_EQ(bench_.cursor(), (middle + GlyphPoint{1, 0}));
  bench_.select({0, 0});
  bench_.move_by_key({-1, 2});
  EXPECT_EQ(strokes()[0].points[0].at, (GlyphPoint{19, 32}));
  bench_.select({1, std::nullopt});
  bench_.move_by_key({0, 1});
  EXPECT_EQ(strokes()[1].points[2].at, (GlyphPoint{90, 61}));
  EXPECT_EQ(bench_.cursor(), (middle + GlyphPoint{1, 0}));
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::move_point, EditWay::made),
                                  std::pair(EditKind::move_stroke, EditWay::made)));
}

TEST_F(WorkbenchTest, TheCursorStaysInTheBox) {
  bench_.move_by_key({1000, -1000});
  EXPECT_EQ(bench_.cursor(), (GlyphPoint{109, 0}));
  bench_.move_by_key({-1000, 1000});
  EXPECT_EQ(bench_.cursor(), (GlyphPoint{0, 109}));
}

TEST_F(WorkbenchTest, AStrokeIsDrawnByKey) {
  bench_.press_at_cursor(0);
  EXPECT_TRUE(bench_.is_down());
  for (int i = 0; i < 20; ++i) bench_.move_by_key({1, 1});
  bench_.press_at_cursor(1);
  EXPECT_FALSE(bench_.is_down());
  ASSERT_THAT(strokes(), SizeIs(3));
  EXPECT_EQ(strokes()[2].points.front().at, (GlyphPoint{54.5, 54.5}));
  EXPECT_EQ(strokes()[2].points.back().at, (GlyphPoint{74.5, 74.5}));
}

TEST_F(WorkbenchTest, APressByKeyIsAClickOfThePlacingTool) {
  use(Tool::place);
  bench_.press_at_cursor(0);
  bench_.move_by_key({10, 0});
  bench_.press_at_cursor(1);
  EXPECT_THAT(bench_.placed(), ElementsAre(GlyphPoint{54.5, 54.5}, GlyphPoint{64.5, 54.5}));
  EXPECT_FALSE(bench_.is_down());
}

TEST_F(WorkbenchTest, EachReliefToolChangesTheHandLayerUnderIt) {
  const std::pair<Tool, EditKind> tools[] = {{Tool::groove, EditKind::groove},
                                             {Tool::raise, EditKind::raise},
                                             {Tool::smooth, EditKind::smooth},
                                             {Tool::erase, EditKind::erase}};
  for (const auto& [tool, kind] : tools) {
    use(tool);
    edits_.clear();
    move({{30, 30}, {50, 31}, {70, 30}});
    EXPECT_THAT(edits_, ElementsAre(std::pair(kind, EditWay::made)));
    EXPECT_EQ(bench_.editor().map(), *carve(bench_.character(), kSize));
  }
  EXPECT_THAT(strokes(), SizeIs(2));
}

TEST_F(WorkbenchTest, AMirroredGrooveIsOnBothSides) {
  auto held = bench_.settings();
  held.tool = Tool::groove;
  held.mirrored = true;
  bench_.set_settings(held);
  move({{20, 95}, {30, 95}, {30, 95}});
  const auto& map = bench_.editor().map();
  const int row = 111;  // 95 of 109 in 127 steps
  EXPECT_LT(map.at(29, row), 0.9F);
  EXPECT_NEAR(map.at(29, row), map.at(127 - 29, row), 1e-4);
}

TEST_F(WorkbenchTest, AStampIsPressedWhereItIsClicked) {
  auto held = bench_.settings();
  held.tool = Tool::stamp;
  held.width = 12;
  held.stamp = StampShape::square;
  bench_.set_settings(held);
  click({54.5, 90});
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::stamp, EditWay::made)));
  // A square is an outline, 8 of 12 units wide.
  EXPECT_LT(bench_.editor().map().at(68, 105), 0.3F);
  EXPECT_EQ(bench_.editor().map().at(64, 105), 1.0F);
  EXPECT_EQ(bench_.editor().map().at(64, 85), 1.0F);
}

TEST_F(WorkbenchTest, EditsOfTheChosenStroke) {
  EXPECT_FALSE(bench_.remove());
  EXPECT_FALSE(bench_.reverse());
  EXPECT_FALSE(bench_.split());
  EXPECT_FALSE(bench_.join());
  EXPECT_FALSE(bench_.reorder(1));
  EXPECT_FALSE(bench_.set_ending(kanji::StrokeEnding::hook));
  EXPECT_FALSE(bench_.scale_width(2));
  EXPECT_FALSE(bench_.scale_depth(0.5));
  EXPECT_THAT(edits_, IsEmpty());

  bench_.select({0, std::nullopt});
  EXPECT_TRUE(bench_.reverse());
  EXPECT_EQ(strokes()[0].points.front().at, (GlyphPoint{90, 30}));
  EXPECT_TRUE(bench_.set_ending(kanji::StrokeEnding::hook));
  EXPECT_EQ(strokes()[0].ending, kanji::StrokeEnding::hook);
  EXPECT_TRUE(bench_.scale_width(2));
  EXPECT_DOUBLE_EQ(strokes()[0].points[2].half_width, 6);
  EXPECT_TRUE(bench_.scale_depth(0.5));
  EXPECT_DOUBLE_EQ(strokes()[0].points[0].depth, 0.5);
  EXPECT_TRUE(bench_.reorder(1));
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt}));
  EXPECT_EQ(strokes()[1].ending, kanji::StrokeEnding::hook);
  EXPECT_FALSE(bench_.reorder(1)) << "it is the last one";
  EXPECT_TRUE(bench_.remove());
  EXPECT_EQ(bench_.selection(), Selection{});
  ASSERT_THAT(strokes(), SizeIs(1));
  EXPECT_EQ(strokes()[0].ending, kanji::StrokeEnding::taper);
  EXPECT_EQ(refusals_, 0);
}

TEST_F(WorkbenchTest, EditsOfTheChosenPoint) {
  bench_.select({1, 1});
  EXPECT_TRUE(bench_.scale_width(2));
  EXPECT_DOUBLE_EQ(strokes()[1].points[1].half_width, 6);
  EXPECT_DOUBLE_EQ(strokes()[1].points[0].half_width, 3);
  EXPECT_TRUE(bench_.scale_width(100));
  EXPECT_DOUBLE_EQ(strokes()[1].points[1].half_width, carving::kWidestHalf);
  EXPECT_TRUE(bench_.scale_depth(0.25));
  EXPECT_DOUBLE_EQ(strokes()[1].points[1].depth, 0.25);
  EXPECT_DOUBLE_EQ(strokes()[1].points[2].depth, 1);
  EXPECT_TRUE(bench_.remove());
  EXPECT_THAT(strokes()[1].points, SizeIs(2));
  EXPECT_EQ(bench_.selection(), (Selection{1, 1}));
  EXPECT_EQ(edits_.back().first, EditKind::delete_point);
}

TEST_F(WorkbenchTest, AStrokeIsSplitAtAPointInsideItAndJoinedAgain) {
  bench_.select({0, 0});
  EXPECT_FALSE(bench_.split());
  bench_.select({0, 2});
  EXPECT_FALSE(bench_.split());
  bench_.select({0, 1});
  EXPECT_TRUE(bench_.split());
  ASSERT_THAT(strokes(), SizeIs(3));
  EXPECT_EQ(strokes()[0].points.back().at, (GlyphPoint{50, 30}));
  EXPECT_EQ(strokes()[1].points.front().at, (GlyphPoint{50, 30}));
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt}));
  bench_.select({0, std::nullopt});
  EXPECT_TRUE(bench_.join());
  ASSERT_THAT(strokes(), SizeIs(2));
  EXPECT_THAT(strokes()[0].points, SizeIs(3));
  bench_.select({1, std::nullopt});
  EXPECT_FALSE(bench_.join()) << "there is no next stroke";
}

TEST_F(WorkbenchTest, UndoAndRedoSayWhatTheyDidAndKeepTheSelectionValid) {
  bench_.undo();
  EXPECT_EQ(edits_.back(), (std::pair(EditKind::none, EditWay::undone)));
  move({{20, 90}, {50, 90}, {80, 90}});
  EXPECT_EQ(bench_.selection().stroke, 2U);
  bench_.undo();
  EXPECT_EQ(edits_.back(), (std::pair(EditKind::draw_stroke, EditWay::undone)));
  EXPECT_EQ(bench_.selection(), Selection{});
  bench_.redo();
  EXPECT_EQ(edits_.back(), (std::pair(EditKind::draw_stroke, EditWay::redone)));
  EXPECT_THAT(strokes(), SizeIs(3));
  bench_.redo();
  EXPECT_EQ(edits_.back(), (std::pair(EditKind::none, EditWay::redone)));
}

TEST_F(WorkbenchTest, AnEditThatIsRefusedIsSaidAndChangesNothing) {
  Facts facts;
  facts.name = std::string(kLongestName + 1, 'a');
  bench_.set_facts(facts);
  EXPECT_EQ(refusals_, 1);
  EXPECT_THAT(edits_, IsEmpty());
  EXPECT_EQ(bench_.character().facts, Facts{});
}

TEST_F(WorkbenchTest, TheSameFactsAreNoEdit) {
  bench_.set_facts(bench_.character().facts);
  EXPECT_THAT(edits_, IsEmpty());
  Facts facts;
  facts.name = "sign";
  bench_.set_facts(facts);
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::set_facts, EditWay::made)));
}

TEST_F(WorkbenchTest, AnotherDocumentTakesThePlace) {
  use(Tool::place);
  click({10, 10});
  bench_.select({1, 1});
  box_ = {};
  bench_.take(editor_with({bar(80)}));
  EXPECT_THAT(strokes(), SizeIs(1));
  EXPECT_EQ(bench_.selection(), Selection{});
  EXPECT_THAT(bench_.placed(), IsEmpty());
  EXPECT_EQ(box_, carving::whole_map(kSize));
}

TEST_F(WorkbenchTest, AHeightMapIsLoadedAndClearedAsRelief) {
  auto map = *surface::HeightMap::create(kSize, 0.25F);
  bench_.load_relief(map);
  EXPECT_NEAR(bench_.editor().map().at(64, 10), 0.25F, 1e-6);
  bench_.clear_relief();
  EXPECT_EQ(bench_.editor().map().at(64, 10), 1.0F);
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::load_relief, EditWay::made),
                                  std::pair(EditKind::clear_relief, EditWay::made)));
}

TEST(WorkbenchNames, ThereIsOneForEachValue) {
  EXPECT_EQ(kToolNames[static_cast<std::size_t>(Tool::stamp)], "stamp");
  EXPECT_EQ(kStampNames[static_cast<std::size_t>(StampShape::triangle)], "triangle");
  EXPECT_EQ(kEndingNames[static_cast<std::size_t>(kanji::StrokeEnding::taper)], "taper");
}

}  // namespace
}  // namespace nazori::author
