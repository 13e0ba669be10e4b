// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/sheet_editor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor_under_test.h"

namespace nazori::calligraphy {
namespace {

using test::editor;
using test::line;
using test::painted;

TEST(SheetEditor, BeginsEmptyWithABrushFullOfSumi) {
  const SheetEditor e = editor();
  const SheetState state = e.state();
  EXPECT_EQ(state.strokes, 0);
  EXPECT_EQ(state.undoes, Edit::none);
  EXPECT_EQ(state.redoes, Edit::none);
  EXPECT_FALSE(state.is_wet);
  EXPECT_TRUE(state.is_saved);
  EXPECT_EQ(state.paper, "hanshi");
  EXPECT_EQ(state.ink, "sumi");
  EXPECT_EQ(state.fullness, 1);
  EXPECT_NEAR(state.strength, 1, 1e-9);
}

TEST(SheetEditor, APaperThatThereIsNotIsRefused) {
  EXPECT_FALSE(SheetEditor::create("parchment", 128));
  SheetEditor e = editor();
  EXPECT_FALSE(e.take_new_sheet("parchment"));
  EXPECT_EQ(e.state().undoes, Edit::none);
}

TEST(SheetEditor, AStrokeLeavesInkAlongItsWayOnly) {
  SheetEditor e = editor();
  line(e, {-0.03, 0.02}, {0.03, 0.02});
  EXPECT_TRUE(painted(e, {0, 0.02}));
  EXPECT_FALSE(painted(e, {0, -0.03}));
  const SheetState state = e.state();
  EXPECT_EQ(state.strokes, 1);
  EXPECT_EQ(state.undoes, Edit::stroke);
  EXPECT_TRUE(state.is_wet);
  EXPECT_FALSE(state.is_saved);
  EXPECT_FALSE(state.is_writing);
  EXPECT_LT(state.fullness, 1);
}

TEST(SheetEditor, AboveThePaperNothingIsWritten) {
  SheetEditor e = editor();
  for (int i = 0; i < 20; ++i) {
    brush::PenSample sample;
    sample.time_s = 0.01 * i;
    sample.at = {0.002 * i, 0};
    sample.down = false;
    e.move_pen(sample);
  }
  EXPECT_EQ(e.state().strokes, 0);
  EXPECT_FALSE(e.state().is_wet);
}

TEST(SheetEditor, TheNextStrokeDoesNotBeginWhereTheLastOneEnded) {
  SheetEditor e = editor();
  line(e, {-0.03, 0.03}, {-0.03, 0.02});
  line(e, {0.03, -0.02}, {0.03, -0.03});
  for (const double share : {0.0, 0.25, 0.5})
    EXPECT_FALSE(painted(e, {0.03 * share, -0.02 * share})) << share;
  EXPECT_EQ(e.state().strokes, 2);
}

TEST(SheetEditor, AStrokeEndsWhereThePenLeavesThePaper) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.02, 0});
  EXPECT_TRUE(painted(e, {0.019, 0}));
  EXPECT_FALSE(painted(e, {0.024, 0}));
  EXPECT_FALSE(painted(e, {-0.037, 0}));
}

TEST(SheetEditor, AStrokeBeginsWhereThePenComesDownHoweverHardItPresses) {
  SheetEditor e = editor();
  brush::PenSample sample;
  sample.at = {0.01, -0.01};
  sample.pressure = 0.9;
  e.move_pen(sample);
  e.lift_pen();
  // The tip is at the pen, give or take the gaps between hairs.
  int near = 0;
  for (const double x : {-0.001, 0.0, 0.001})
    for (const double y : {-0.001, 0.0, 0.001}) near += painted(e, {0.01 + x, -0.01 + y}) ? 1 : 0;
  EXPECT_GE(near, 3);
}

TEST(SheetEditor, MorePressureMakesABroaderLine) {
  const auto width = [](double pressure) {
    SheetEditor e = editor();
    line(e, {-0.03, 0}, {0.03, 0}, pressure);
    int cells = 0;
    for (int row = 0; row < e.sheet().size(); ++row)
      cells += test::is_painted(e, e.sheet().size() / 2, row) ? 1 : 0;
    return cells;
  };
  EXPECT_GT(width(0.8), 1.3 * width(0.25));
}

TEST(SheetEditor, WithoutPressureAFastStrokeIsThinnerUnlessNothingIsGuessed) {
  const auto amount = [](double seconds, bool guesses) {
    SheetEditor e = editor();
    brush::Handling handling;
    handling.guess_pressure = guesses;
    e.set_handling(handling);
    line(e, {-0.03, 0}, {0.03, 0}, {}, seconds);
    return test::painted_cells(e);
  };
  EXPECT_GT(amount(1.5, true), 1.2 * amount(0.15, true));
  EXPECT_NEAR(amount(1.5, false), amount(0.5, false), 0.3 * amount(0.5, false));
}

TEST(SheetEditor, SamplesThatAreNoNumbersAreIgnored) {
  SheetEditor e = editor();
  const double wrong = std::numeric_limits<double>::quiet_NaN();
  for (int field = 0; field < 8; ++field) {
    brush::PenSample sample;
    sample.pressure = field == 0 ? wrong : 0.5;
    if (field == 1) sample.time_s = wrong;
    if (field == 2) sample.at.x = wrong;
    if (field == 3) sample.at.y = std::numeric_limits<double>::infinity();
    if (field == 4) sample.lean_rad = wrong;
    if (field == 5) sample.lean_to_rad = wrong;
    if (field == 6) sample.twist_rad = wrong;
    if (field == 7) sample.height_m = wrong;
    e.move_pen(sample);
    EXPECT_EQ(e.state().strokes, 0) << field;
  }
}

TEST(SheetEditor, TimesThatDoNotGrowStillMakeAStroke) {
  SheetEditor e = editor();
  for (int i = 0; i <= 240; ++i) {
    brush::PenSample sample;
    sample.time_s = 5 - 0.01 * i;
    sample.at = {-0.03 + 0.00025 * i, 0};
    sample.pressure = 7;  // counts as 1
    e.move_pen(sample);
  }
  e.lift_pen();
  EXPECT_TRUE(painted(e, {0, 0}));
  EXPECT_FALSE(e.state().is_writing);
}

/// How much redder than blue the middle of the sheet is, in levels of 255.
int redness(SheetEditor& e) {
  std::vector<int> changed;
  const auto& picture = e.picture(changed);
  const auto side = static_cast<std::size_t>(e.sheet().size());
  const std::size_t at = 3 * (side * side / 2 + side / 2);
  return picture.rgb[at] - picture.rgb[at + 2];
}

TEST(SheetEditor, InksStandSideBySideInTheirOwnColours) {
  SheetEditor e = editor();
  for (const auto ink : {"vermilion", "sumi-blue", "sumi"}) {
    ASSERT_TRUE(e.set_ink(ink)) << ink;
    EXPECT_EQ(e.state().ink, ink);
    EXPECT_EQ(e.state().fullness, 1);
    EXPECT_NEAR(e.state().strength, 1, 1e-9);
  }
  ASSERT_TRUE(e.set_ink("vermilion"));
  line(e, {-0.03, 0}, {0.03, 0});
  EXPECT_GT(redness(e), 60);
  // Each has one slot, however often it was taken.
  for (const auto ink : {"vermilion", "sumi-blue", "sumi"})
    EXPECT_EQ(std::count_if(e.sheet().palette().begin(), e.sheet().palette().end(),
                            [&](const paint::Pigment& pigment) { return pigment.name == ink; }),
              1)
        << ink;
}

TEST(SheetEditor, AFourthInkTakesADrySlotAndIsRefusedWhereAllAreWet) {
  SheetEditor e = editor();
  EXPECT_EQ(e.set_ink("green").error().code, base::Errc::not_found);
  EXPECT_EQ(e.state().ink, "sumi");
  const auto write = [&](const char* ink, double y) {
    ASSERT_TRUE(e.set_ink(ink));
    line(e, {-0.03, y}, {0.03, y});
  };
  write("sumi", 0.03);
  write("vermilion", 0);
  write("sumi-blue", -0.03);
  const auto refused = e.set_ink("sumi-brown");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::Errc::in_use);
  EXPECT_EQ(e.state().ink, "sumi-blue");
  // One that is on the sheet needs no slot.
  EXPECT_TRUE(e.set_ink("vermilion"));
  EXPECT_TRUE(e.set_ink("sumi-blue"));
  e.dry_now();
  EXPECT_TRUE(e.set_ink("sumi-brown"));
  EXPECT_EQ(e.state().ink, "sumi-brown");
  // The inks that were there are undone to, with the ink of that time.
  EXPECT_EQ(e.undo(), Edit::drying);
  EXPECT_EQ(e.state().ink, "sumi-blue");
}

TEST(SheetEditor, UndoBringsBackTheInkOfThatTime) {
  SheetEditor e = editor();
  ASSERT_TRUE(e.set_ink("vermilion"));
  line(e, {-0.03, 0.03}, {0.03, 0.03});
  ASSERT_TRUE(e.set_ink("sumi"));
  line(e, {-0.03, -0.03}, {0.03, -0.03});
  e.undo();
  EXPECT_EQ(e.state().ink, "sumi");
  e.undo();
  EXPECT_EQ(e.state().ink, "vermilion");
  e.dip_in_ink();
  line(e, {-0.03, 0}, {0.03, 0});
  EXPECT_GT(redness(e), 60);
}

TEST(SheetEditor, WaterLeavesNoPigment) {
  SheetEditor e = editor();
  ASSERT_TRUE(e.set_ink(kWater));
  line(e, {-0.03, 0}, {0.03, 0});
  EXPECT_TRUE(e.state().is_wet);
  EXPECT_EQ(test::painted_cells(e), 0);
  EXPECT_EQ(e.state().strength, 0);
}

TEST(SheetEditor, PaperForWaterComesWithWaterAndOtherPaperWithInkAgain) {
  SheetEditor e = editor();
  ASSERT_TRUE(e.take_new_sheet("water"));
  EXPECT_EQ(e.state().ink, "water");
  ASSERT_TRUE(e.take_new_sheet("hanshi"));
  EXPECT_EQ(e.state().ink, "sumi");
  EXPECT_NEAR(e.state().strength, 1, 1e-9);
  e.undo();
  EXPECT_EQ(e.state().ink, "water");
  EXPECT_EQ(e.state().strength, 0);
  EXPECT_EQ(SheetEditor::create("water", 128)->state().ink, "water");
  // Water that was chosen for other paper stays.
  SheetEditor other = editor();
  ASSERT_TRUE(other.set_ink(kWater));
  ASSERT_TRUE(other.take_new_sheet("board"));
  EXPECT_EQ(other.state().ink, "water");
}

TEST(SheetEditor, AnotherBrushKeepsItsInkAndWritesAsBroadAsItIs) {
  const auto cells = [](BrushSize size) {
    SheetEditor e = editor();
    e.dip_in_water();
    e.wipe();
    e.set_brush({size, brush::Hair::mixed});
    EXPECT_NEAR(e.state().fullness, 0.5, 1e-6);
    EXPECT_NEAR(e.state().strength, 0.5, 1e-6);
    EXPECT_EQ(e.state().brush.size, size);
    e.dip_in_ink();
    EXPECT_EQ(e.state().fullness, 1);
    line(e, {-0.03, 0}, {0.03, 0});
    return test::painted_cells(e);
  };
  EXPECT_GT(cells(BrushSize::medium), 1.3 * cells(BrushSize::fine));
}

TEST(SheetEditor, TheBrushIsWhereThePenWasAndTouchesWhileItWrites) {
  SheetEditor e = editor();
  brush::PenSample sample;
  sample.pressure = 0.6;
  sample.at = {0.01, 0.02};
  e.move_pen(sample);
  sample.time_s = 0.2;
  sample.at.x = 0.012;
  e.move_pen(sample);
  const BrushShape shape = e.brush_shape();
  EXPECT_EQ(shape.pen.x, 0.012);
  EXPECT_TRUE(shape.touches);
  EXPECT_EQ(shape.sections.size(), 7U);
  EXPECT_NEAR(shape.shaft_m, 0.0085, 1e-9);
  e.lift_pen();
  EXPECT_FALSE(e.brush_shape().touches);
}

TEST(SheetEditor, OnlyTilesThatChangedAreReported) {
  SheetEditor e = editor();
  std::vector<int> changed;
  e.picture(changed);
  EXPECT_EQ(changed.size(), 16U);  // of 32 cells in 128
  e.picture(changed);
  EXPECT_TRUE(changed.empty());
  line(e, {-0.03, 0.03}, {-0.025, 0.03}, 0.2);
  e.picture(changed);
  EXPECT_FALSE(changed.empty());
  EXPECT_LT(changed.size(), 9U);
  ASSERT_TRUE(e.take_new_sheet("hanshi"));
  e.picture(changed);
  EXPECT_EQ(changed.size(), 16U);
  e.undo();
  e.picture(changed);
  EXPECT_EQ(changed.size(), 16U);
}

TEST(SheetEditor, InkIsCarvedAsAGroove) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  const auto tablet = e.carve();
  ASSERT_TRUE(tablet);
  const auto& map = (*tablet)->height_map();
  ASSERT_EQ(map.size(), 128);
  EXPECT_LT(map.at(64, 64), 0.75F);
  EXPECT_GE(map.at(64, 64), 0.0F);
  for (const int row : {0, 10, 127}) EXPECT_EQ(map.at(0, row), 1.0F) << row;
  EXPECT_EQ(map.at(127, 0), 1.0F);
  // A stylus that is dragged over a wall climbs it: no step is a cliff.
  float steepest = 0;
  for (int i = 0; i < 127; ++i)
    for (int across = 0; across < 128; ++across)
      steepest = std::max({steepest, std::abs(map.at(i, across) - map.at(i + 1, across)),
                           std::abs(map.at(across, i) - map.at(across, i + 1))});
  EXPECT_LT(steepest, 0.4F);
}

}  // namespace
}  // namespace nazori::calligraphy
