// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/sheet_editor.h"

#include <gtest/gtest.h>

#include "editor_under_test.h"

namespace nazori::calligraphy {
namespace {

using test::editor;
using test::line;

TEST(SheetEditorUndo, UndoAndRedoBringBackEveryByte) {
  SheetEditor e = editor();
  const auto empty = e.bytes();
  line(e, {-0.03, 0.02}, {0.03, 0.02});
  for (int i = 0; i < 10; ++i) e.step();
  const auto one = e.bytes();
  line(e, {-0.03, -0.02}, {0.03, -0.02});
  const auto two = e.bytes();
  EXPECT_EQ(e.undo(), Edit::stroke);
  EXPECT_EQ(e.bytes(), one);
  EXPECT_EQ(e.state().strokes, 1);
  EXPECT_EQ(e.state().redoes, Edit::stroke);
  EXPECT_EQ(e.undo(), Edit::stroke);
  EXPECT_EQ(e.bytes(), empty);
  EXPECT_EQ(e.undo(), Edit::none);
  EXPECT_EQ(e.redo(), Edit::stroke);
  EXPECT_EQ(e.redo(), Edit::stroke);
  EXPECT_EQ(e.bytes(), two);
  EXPECT_EQ(e.state().strokes, 2);
  EXPECT_EQ(e.redo(), Edit::none);
}

TEST(SheetEditorUndo, ANewStrokeEndsWhatCouldBeRedone) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  e.undo();
  line(e, {0, -0.03}, {0, 0.03});
  EXPECT_EQ(e.state().redoes, Edit::none);
  EXPECT_EQ(e.redo(), Edit::none);
}

TEST(SheetEditorUndo, UndoEndsAStrokeThatIsUnderWayAndTakesAllOfIt) {
  SheetEditor e = editor();
  const auto empty = e.bytes();
  brush::PenSample sample;
  sample.pressure = 0.6;
  e.move_pen(sample);
  sample.at.x = 0.01;
  sample.time_s = 0.1;
  e.move_pen(sample);
  EXPECT_TRUE(e.state().is_writing);
  EXPECT_EQ(e.undo(), Edit::stroke);
  EXPECT_FALSE(e.state().is_writing);
  EXPECT_EQ(e.bytes(), empty);
}

TEST(SheetEditorUndo, DryingCanBeUndone) {
  SheetEditor e = editor();
  EXPECT_FALSE(e.dry_now());
  EXPECT_EQ(e.state().undoes, Edit::none);
  line(e, {-0.03, 0}, {0.03, 0});
  const auto wet = e.bytes();
  EXPECT_TRUE(e.dry_now());
  EXPECT_FALSE(e.state().is_wet);
  EXPECT_EQ(e.state().strokes, 1);
  EXPECT_EQ(e.state().undoes, Edit::drying);
  EXPECT_EQ(e.undo(), Edit::drying);
  EXPECT_EQ(e.bytes(), wet);
  EXPECT_EQ(e.redo(), Edit::drying);
  EXPECT_FALSE(e.state().is_wet);
}

TEST(SheetEditorUndo, MoreStrokesThanCanBeUndoneStayOnThePaper) {
  SheetEditor e = editor();
  constexpr int kMany = static_cast<int>(paint::History::kStrokes) + 3;
  for (int i = 0; i < kMany; ++i) line(e, {0, 0}, {0.002, 0}, 0.2, 0.02);
  int undone = 0;
  while (e.undo() == Edit::stroke) ++undone;
  EXPECT_EQ(undone, static_cast<int>(paint::History::kStrokes));
  EXPECT_EQ(e.state().strokes, 3);
}

TEST(SheetEditorUndo, ANewSheetIsEmptyAndUndoBringsTheOldOneBack) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  e.dip_in_water();
  const auto old = e.bytes();
  const double strength = e.state().strength;
  ASSERT_TRUE(e.take_new_sheet("gasenshi"));
  EXPECT_EQ(e.state().strokes, 0);
  EXPECT_EQ(e.state().paper, "gasenshi");
  EXPECT_EQ(e.state().undoes, Edit::new_sheet);
  EXPECT_TRUE(e.state().is_saved);
  EXPECT_EQ(test::painted_cells(e), 0);
  // The brush is the same.
  EXPECT_EQ(e.state().strength, strength);
  line(e, {0, -0.03}, {0, 0.03});
  const auto next = e.bytes();
  EXPECT_EQ(e.undo(), Edit::stroke);
  EXPECT_EQ(e.undo(), Edit::new_sheet);
  EXPECT_EQ(e.bytes(), old);
  EXPECT_EQ(e.state().strokes, 1);
  EXPECT_EQ(e.state().redoes, Edit::new_sheet);
  EXPECT_FALSE(e.state().is_saved);
  EXPECT_EQ(e.redo(), Edit::new_sheet);
  EXPECT_EQ(e.redo(), Edit::stroke);
  EXPECT_EQ(e.bytes(), next);
}

TEST(SheetEditorUndo, ANewSheetEndsTheStrokeOnTheOldOne) {
  SheetEditor e = editor();
  brush::PenSample sample;
  sample.pressure = 0.6;
  e.move_pen(sample);
  ASSERT_TRUE(e.take_new_sheet("hanshi"));
  EXPECT_FALSE(e.state().is_writing);
  EXPECT_EQ(test::painted_cells(e), 0);
  EXPECT_EQ(e.undo(), Edit::new_sheet);
  EXPECT_EQ(e.state().strokes, 1);
  EXPECT_FALSE(e.state().is_writing);
}

TEST(SheetEditorUndo, ANewSheetEndsWhatCouldBeRedoneOnTheOldOne) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  e.undo();
  ASSERT_TRUE(e.take_new_sheet("board"));
  EXPECT_EQ(e.undo(), Edit::new_sheet);
  // Next is the new sheet again, not the stroke from before it.
  EXPECT_EQ(e.redo(), Edit::new_sheet);
  EXPECT_EQ(e.state().paper, "board");
  e.undo();
  line(e, {-0.03, 0}, {0.03, 0});
  EXPECT_EQ(e.redo(), Edit::none);
}

TEST(SheetEditorUndo, ANewSheetEndsWhatCouldBeRedoneAmongSheets) {
  SheetEditor e = editor();
  ASSERT_TRUE(e.take_new_sheet("board"));
  e.undo();
  ASSERT_TRUE(e.take_new_sheet("gasenshi"));
  EXPECT_EQ(e.state().redoes, Edit::none);
  EXPECT_EQ(e.redo(), Edit::none);
  EXPECT_EQ(e.state().paper, "gasenshi");
}

TEST(SheetEditorUndo, OnlySoManySheetsAreKept) {
  SheetEditor e = editor();
  for (const char* paper : {"gasenshi", "board", "gasenshi-slow"}) ASSERT_TRUE(e.take_new_sheet(paper));
  EXPECT_EQ(e.undo(), Edit::new_sheet);
  EXPECT_EQ(e.undo(), Edit::new_sheet);
  EXPECT_EQ(e.state().paper, "gasenshi");
  EXPECT_EQ(e.undo(), Edit::none);
}

TEST(SheetEditorUndo, UndoAfterAnotherBrushFitsItsInkToThisOne) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  e.set_brush({BrushSize::fine, brush::Hair::goat});
  e.undo();
  e.dip_in_water();
  EXPECT_EQ(e.load().capacity,
            paint::dipped(form_of({BrushSize::fine, brush::Hair::goat}).holds_m3, 0, {}, {}).capacity);
  EXPECT_EQ(e.state().fullness, 1);
}

}  // namespace
}  // namespace nazori::calligraphy
