// SPDX-License-Identifier: Apache-2.0
// The number of a stroke, and its groove along its line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "bench_under_test.h"
#include "nazori/author/stroke_edits.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

using WorkbenchGrooveTest = WorkbenchTest;

/// Where the number of a stroke stands, in its middle.
GlyphPoint middle_of_number(const std::vector<OwnStroke>& strokes, std::size_t stroke) {
  const NumberBox box = number_box(stroke + 1, number_places(strokes)[stroke]);
  return {(box.left + box.right) / 2, (box.top + box.bottom) / 2};
}

TEST_F(WorkbenchGrooveTest, ANumberThatTheProgramPlacedIsDraggedAsOneEdit) {
  use(Tool::edit);
  const GlyphPoint from = middle_of_number(strokes(), 1);
  const GlyphPoint placed = number_places(strokes())[1];
  move({from, from + GlyphPoint{5, -2}, from + GlyphPoint{12, -6}, from + GlyphPoint{12, -6}});
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt, true}));
  ASSERT_TRUE(strokes()[1].number_position);
  EXPECT_NEAR(strokes()[1].number_position->x, placed.x + 12, 1e-9);
  EXPECT_NEAR(strokes()[1].number_position->y, placed.y - 6, 1e-9);
  EXPECT_FALSE(strokes()[0].number_position) << "of the other stroke";
  EXPECT_EQ(strokes()[1].points, bar(60).points);
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::move_number, EditWay::made)));
  bench_.undo();
  EXPECT_FALSE(strokes()[1].number_position);
  EXPECT_EQ(bench_.editor().state().undoes, EditKind::none);
}

TEST_F(WorkbenchGrooveTest, ANumberThatWasPlacedByHandIsDraggedFromThere) {
  bench_.select({0, std::nullopt, true});
  use(Tool::edit);
  move({middle_of_number(strokes(), 0), {60, 90}, {60, 90}});
  ASSERT_TRUE(strokes()[0].number_position);
  const GlyphPoint first = *strokes()[0].number_position;
  move({{60, 90}, {65, 92}, {65, 92}});
  EXPECT_NEAR(strokes()[0].number_position->x, first.x + 5, 1e-9);
  EXPECT_NEAR(strokes()[0].number_position->y, first.y + 2, 1e-9);
}

TEST_F(WorkbenchGrooveTest, AClickOnANumberChoosesItAndAClickOnAPointThePoint) {
  use(Tool::edit);
  click(middle_of_number(strokes(), 0));
  EXPECT_EQ(bench_.selection(), (Selection{0, std::nullopt, true}));
  EXPECT_THAT(edits_, IsEmpty()) << "nothing was moved";
  // The number of the second stroke is laid over a point of the first.
  bench_.select({1, std::nullopt, true});
  move({middle_of_number(strokes(), 1), {50, 30}, {50, 30}});
  click({50.5, 30.5});
  EXPECT_EQ(bench_.selection(), (Selection{0, 1}));
  click({50, 32.5});
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt, true}));
}

TEST_F(WorkbenchGrooveTest, ANumberStaysInThePicture) {
  use(Tool::edit);
  const GlyphPoint from = middle_of_number(strokes(), 0);
  move({from, {300, 300}, {300, 300}});
  NumberBox box = number_box(1, *strokes()[0].number_position);
  EXPECT_DOUBLE_EQ(box.right, geometry::kGlyphSide);
  EXPECT_DOUBLE_EQ(box.bottom, geometry::kGlyphSide);
  move({middle_of_number(strokes(), 0), {-300, -300}, {-300, -300}});
  box = number_box(1, *strokes()[0].number_position);
  EXPECT_DOUBLE_EQ(box.left, 0);
  EXPECT_DOUBLE_EQ(box.top, 0);
  EXPECT_EQ(refusals_, 0);
}

TEST_F(WorkbenchGrooveTest, KeysMoveAChosenNumberAndPutItBack) {
  use(Tool::edit);
  const GlyphPoint placed = number_places(strokes())[1];
  bench_.select({1, 2});
  EXPECT_TRUE(bench_.select_number());
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt, true}));
  EXPECT_FALSE(bench_.place_number()) << "the program places it already";
  bench_.move_by_key({1, 0});
  bench_.move_by_key({0, -1});
  ASSERT_TRUE(strokes()[1].number_position);
  EXPECT_EQ(*strokes()[1].number_position, (placed + GlyphPoint{1, -1}));
  EXPECT_THAT(strokes(), SizeIs(2));
  EXPECT_TRUE(bench_.place_number());
  EXPECT_FALSE(strokes()[1].number_position);
  bench_.move_by_key({1, 0});
  EXPECT_TRUE(bench_.remove()) << "what Delete does to a number";
  EXPECT_FALSE(strokes()[1].number_position);
  EXPECT_THAT(strokes(), SizeIs(2));
  EXPECT_FALSE(bench_.remove());
  EXPECT_THAT(strokes(), SizeIs(2));
  EXPECT_EQ(edits_.back().first, EditKind::move_number);
}

TEST_F(WorkbenchGrooveTest, WithoutAStrokeNoNumberIsChosen) {
  bench_.select({});
  EXPECT_TRUE(bench_.select_number());
  EXPECT_EQ(bench_.selection(), (Selection{0, std::nullopt, true})) << "of the first stroke";
  bench_.select({7, std::nullopt, true});
  EXPECT_EQ(bench_.selection(), Selection{});
  bench_.select({std::nullopt, std::nullopt, true});
  EXPECT_EQ(bench_.selection(), Selection{});
  bench_.select({1, 1, true});
  EXPECT_EQ(bench_.selection(), (Selection{1, std::nullopt, true}));
  Workbench empty{editor_with({})};
  EXPECT_FALSE(empty.select_number());
  EXPECT_FALSE(empty.place_number());
}

TEST_F(WorkbenchGrooveTest, TheGrooveIsChangedAtAPointAndADragIsOneEdit) {
  bench_.select({1, std::nullopt});
  box_ = {};
  EXPECT_TRUE(bench_.set_half_width(1, 4));
  EXPECT_TRUE(bench_.set_half_width(1, 5, true));
  EXPECT_TRUE(bench_.set_half_width(1, 6, true));
  EXPECT_DOUBLE_EQ(strokes()[1].points[1].half_width, 6);
  EXPECT_DOUBLE_EQ(strokes()[1].points[0].half_width, 3) << "its neighbours stay";
  EXPECT_DOUBLE_EQ(strokes()[1].points[2].half_width, 3);
  EXPECT_DOUBLE_EQ(strokes()[0].points[1].half_width, 3) << "and the other stroke";
  EXPECT_FALSE(box_.is_empty());
  EXPECT_TRUE(bench_.set_depth(0, 0.5));
  EXPECT_TRUE(bench_.set_depth(0, 0.25, true));
  EXPECT_DOUBLE_EQ(strokes()[1].points[0].depth, 0.25);
  EXPECT_THAT(edits_, ElementsAre(std::pair(EditKind::set_width, EditWay::made),
                                  std::pair(EditKind::set_depth, EditWay::made)));
  EXPECT_EQ(bench_.editor().map(), *carve(bench_.character(), kSize));
  bench_.undo();
  EXPECT_DOUBLE_EQ(strokes()[1].points[0].depth, 1);
  bench_.undo();
  EXPECT_EQ(strokes()[1].points, bar(60).points);
  EXPECT_EQ(bench_.editor().state().undoes, EditKind::none);
}

TEST_F(WorkbenchGrooveTest, WidthAndDepthAtAPointStayInTheirRange) {
  EXPECT_FALSE(bench_.set_half_width(0, 4)) << "no stroke is chosen";
  EXPECT_FALSE(bench_.set_depth(0, 0.5));
  bench_.select({0, std::nullopt});
  bench_.set_half_width(0, 1000);
  EXPECT_DOUBLE_EQ(strokes()[0].points[0].half_width, carving::kWidestHalf);
  bench_.set_half_width(0, -3);
  EXPECT_DOUBLE_EQ(strokes()[0].points[0].half_width, 0);
  bench_.set_depth(0, 3);
  EXPECT_DOUBLE_EQ(strokes()[0].points[0].depth, 1);
  bench_.set_depth(0, -1);
  EXPECT_DOUBLE_EQ(strokes()[0].points[0].depth, 0);
  EXPECT_EQ(refusals_, 0);
  bench_.set_half_width(9, 1);
  EXPECT_EQ(refusals_, 1) << "a point that is not there";
}

TEST_F(WorkbenchGrooveTest, PlacedPointsBecomeAStrokeAsWideAndDeepAsTheToolIsSet) {
  bench_.set_settings({.tool = Tool::place, .width = 9, .depth = 0.6, .ending = kanji::StrokeEnding::stop});
  click({20, 90});
  click({50, 92});
  click({80, 90});
  ASSERT_TRUE(bench_.finish_placing());
  ASSERT_EQ(strokes().size(), 3U);
  double widest = 0;
  double deepest = 0;
  for (const GroovePoint& p : strokes()[2].points) {
    widest = std::max(widest, p.half_width);
    deepest = std::max(deepest, p.depth);
  }
  // A brush presses a stop broader at its ends.
  EXPECT_GE(widest, 4.5);
  EXPECT_LT(widest, 1.2 * 4.5);
  EXPECT_NEAR(deepest, 0.6, 1e-9);
  EXPECT_EQ(bench_.selection(), (Selection{2, std::nullopt}));
  EXPECT_TRUE(bench_.placed().empty());
  EXPECT_FALSE(bench_.finish_placing());
}

TEST_F(WorkbenchGrooveTest, TwoPlacedPointsAreEnoughForAStrokeOneIsNot) {
  use(Tool::place);
  click({20, 90});
  EXPECT_FALSE(bench_.finish_placing());
  click({80, 90});
  ASSERT_TRUE(bench_.finish_placing());
  EXPECT_EQ(strokes().size(), 3U);
}

TEST_F(WorkbenchGrooveTest, APlacedPointTakesThePlaceOfANearPointOfAStroke) {
  use(Tool::place);
  click({52, 31});
  click({50, 34.5});
  ASSERT_EQ(bench_.placed().size(), 2U);
  EXPECT_EQ(bench_.placed()[0], (geometry::GlyphPoint{50, 30}));
  EXPECT_EQ(bench_.placed()[1], (geometry::GlyphPoint{50, 34.5}));
  bench_.step_back();
  EXPECT_EQ(bench_.placed().size(), 1U);
  bench_.step_back();
  EXPECT_TRUE(bench_.placed().empty());
  EXPECT_TRUE(edits_.empty());
  bench_.step_back();
  ASSERT_EQ(edits_.size(), 1U);
  EXPECT_EQ(edits_[0].second, EditWay::undone);
}

TEST_F(WorkbenchGrooveTest, AClickThatTremblesMovesNothingAndADragMovesByAsMuchAsThePen) {
  use(Tool::edit);
  bench_.move_pen({{20.5, 30}, 0.0}, true);
  bench_.move_pen({{21, 30}, 0.1}, true);
  bench_.move_pen({{20.5, 30.5}, 0.2}, false);
  EXPECT_TRUE(edits_.empty());
  EXPECT_EQ(strokes()[0].points[0].at, (geometry::GlyphPoint{20, 30}));
  bench_.move_pen({{20.5, 30}, 1.0}, true);
  bench_.move_pen({{21.2, 30}, 1.1}, true);
  bench_.move_pen({{21.3, 30.1}, 1.2}, true);
  bench_.move_pen({{24.5, 33}, 1.3}, false);
  EXPECT_NEAR(strokes()[0].points[0].at.x, 24, 1e-9);
  EXPECT_NEAR(strokes()[0].points[0].at.y, 33, 1e-9);
  ASSERT_EQ(edits_.size(), 1U);
  EXPECT_EQ(edits_[0], (std::pair(EditKind::move_point, EditWay::made)));
  bench_.undo();
  EXPECT_EQ(strokes()[0].points[0].at, (geometry::GlyphPoint{20, 30})) << "one drag is one change";
}

TEST_F(WorkbenchGrooveTest, AKeyAddsToTheMovementOnlyWhileThePenIsDown) {
  int moves = 0;
  bench_.pen_moved.connect([&moves] { ++moves; });
  bench_.move_by_key({1, 0});
  EXPECT_TRUE(bench_.movement().empty());
  EXPECT_EQ(moves, 1);
  bench_.press_at_cursor(0);
  bench_.move_by_key({1, 0});
  EXPECT_EQ(bench_.movement().size(), 2U);
  EXPECT_EQ(moves, 3);
}

TEST_F(WorkbenchGrooveTest, JoiningAndReorderingNeedTheOtherStroke) {
  bench_.select({0, std::nullopt});
  EXPECT_FALSE(bench_.reorder(-1));
  EXPECT_FALSE(bench_.reorder(2));
  EXPECT_TRUE(edits_.empty());
  EXPECT_TRUE(bench_.join());
  EXPECT_EQ(strokes().size(), 1U);
  EXPECT_FALSE(bench_.join());
  EXPECT_EQ(edits_.size(), 1U);
}

TEST_F(WorkbenchGrooveTest, TheLastPointOfAStrokeGoesWithIt) {
  bench_.take(editor_with({bar(30), OwnStroke{{{{50, 50}, 3, 1}}, kanji::StrokeEnding::stop, {}}}));
  bench_.select({1, 0});
  EXPECT_FALSE(bench_.insert_point()) << "a dot has no second point";
  EXPECT_TRUE(bench_.remove());
  EXPECT_EQ(strokes().size(), 1U);
  ASSERT_EQ(edits_.size(), 1U);
  EXPECT_EQ(edits_[0].first, EditKind::delete_stroke);
}

}  // namespace
}  // namespace nazori::author
