// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/sheet_editor.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <functional>
#include <string>

#include "editor_under_test.h"
#include "nazori/base/file.h"
#include "nazori/calligraphy/sheet_export.h"
#include "nazori/paint/sheet_file.h"

namespace nazori::calligraphy {
namespace {

using test::editor;
using test::line;

namespace fs = std::filesystem;

class SheetEditorFiles : public testing::Test {
 protected:
  // Tests run beside each other: each has a folder of its own.
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "nazori-calligraphy-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(SheetEditorFiles, TheBrushIsDippedInTheSameInkWhereverItIsInAnOpenedSheet) {
  auto sheet =
      paint::Sheet::create(128, {},
                           {paint::find_pigment("vermilion").value(),
                            paint::find_pigment("indian-red").value(), paint::find_pigment("sumi").value()})
          .value();
  ASSERT_TRUE(paint::save_sheet(sheet, paint::dipped(1e-6, 1, {}, {}), folder_ / "other.nzs"));
  SheetEditor e = editor();
  ASSERT_TRUE(e.open(folder_ / "other.nzs"));
  EXPECT_EQ(e.state().ink, "sumi");
  e.wipe();
  e.dip_in_ink();
  EXPECT_EQ(e.load().tip.pigment[0], 0);
  EXPECT_GT(e.load().tip.pigment[2], 0);
}

TEST_F(SheetEditorFiles, WhateverIsDoneWhileWritingEndsTheStroke) {
  const fs::path path = folder_ / "stroke.nzs";
  const std::function<void(SheetEditor&)> acts[] = {
      [](SheetEditor& e) {
        e.set_brush({BrushSize::fine, brush::Hair::goat});
      },
      [](SheetEditor& e) { EXPECT_TRUE(e.set_ink("vermilion")); },
      [](SheetEditor& e) { e.set_handling({}); },
      [](SheetEditor& e) { e.dip_in_ink(); },
      [](SheetEditor& e) { e.dip_in_water(); },
      [](SheetEditor& e) { e.wipe(); },
      [](SheetEditor& e) { EXPECT_TRUE(e.dry_now()); },
      [&](SheetEditor& e) { EXPECT_TRUE(e.save(path)); },
      [&](SheetEditor& e) { EXPECT_TRUE(e.open(path)); },
      [](SheetEditor& e) { e.redo(); },
  };
  for (const auto& act : acts) {
    SheetEditor e = editor();
    brush::PenSample sample;
    sample.pressure = 0.6;
    e.move_pen(sample);
    sample.time_s = 0.1;
    sample.at.x = 0.005;
    e.move_pen(sample);
    ASSERT_TRUE(e.brush_shape().touches);
    act(e);
    EXPECT_FALSE(e.state().is_writing);
    EXPECT_FALSE(e.brush_shape().touches);
    // The next contact is the next stroke.
    const int before = e.state().strokes;
    sample.time_s = 0.2;
    e.move_pen(sample);
    EXPECT_EQ(e.state().strokes, before + 1);
  }
}

TEST_F(SheetEditorFiles, ASavedSheetOpensToTheSameBytes) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  for (int i = 0; i < 5; ++i) e.step();
  const auto bytes = e.bytes();
  const fs::path path = folder_ / "one.nzs";
  ASSERT_TRUE(e.save(path));
  EXPECT_TRUE(e.state().is_saved);
  EXPECT_EQ(base::read_file(path, 1U << 26U).value(), bytes);

  SheetEditor other = editor();
  ASSERT_TRUE(other.open(path));
  EXPECT_EQ(other.bytes(), bytes);
  EXPECT_TRUE(other.state().is_saved);
  EXPECT_EQ(other.state().strokes, 1);
  EXPECT_EQ(other.state().undoes, Edit::new_sheet);
  EXPECT_EQ(other.undo(), Edit::new_sheet);
  EXPECT_EQ(test::painted_cells(other), 0);
}

TEST_F(SheetEditorFiles, AnOpenedSheetHasTheStrokesThatWereWritten) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  line(e, {0, -0.03}, {0, 0.03}, std::nullopt);
  const fs::path path = folder_ / "two.nzs";
  ASSERT_TRUE(e.save(path));
  SheetEditor other = editor();
  line(other, {0.01, 0.01}, {0.02, 0.02});
  ASSERT_TRUE(other.open(path));
  EXPECT_EQ(other.state().strokes, 2);
  EXPECT_EQ(to_svg(other.written()), to_svg(e.written()));
  EXPECT_EQ(width_from(other.written()[1]), WidthFrom::speed);
  // They were there when the sheet was opened, so undo takes the sheet away.
  EXPECT_EQ(other.state().undoes, Edit::new_sheet);
  line(other, {-0.03, 0.02}, {0.03, 0.02});
  EXPECT_EQ(other.state().strokes, 3);
  EXPECT_EQ(other.undo(), Edit::stroke);
  EXPECT_EQ(to_svg(other.written()), to_svg(e.written()));
  EXPECT_EQ(other.undo(), Edit::new_sheet);
  EXPECT_EQ(other.written().size(), 1U);
  EXPECT_EQ(other.redo(), Edit::new_sheet);
  EXPECT_EQ(other.written().size(), 2U);
}

TEST_F(SheetEditorFiles, AnUndoneStrokeIsNotInTheFile) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  line(e, {0, -0.03}, {0, 0.03});
  e.undo();
  ASSERT_TRUE(e.save(folder_ / "one.nzs"));
  SheetEditor other = editor();
  ASSERT_TRUE(other.open(folder_ / "one.nzs"));
  EXPECT_EQ(other.written().size(), 1U);
}

TEST_F(SheetEditorFiles, AFileOfAnOlderVersionOpensWithoutStrokes) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  ASSERT_TRUE(paint::save_sheet(e.sheet(), e.load(), folder_ / "old.nzs"));
  SheetEditor other = editor();
  ASSERT_TRUE(other.open(folder_ / "old.nzs"));
  EXPECT_EQ(other.state().strokes, 0);
  EXPECT_TRUE(other.written().empty());
  EXPECT_TRUE(other.sheet().is_same_as(e.sheet()));
}

TEST_F(SheetEditorFiles, StrokesThatNoBrushWritesAreRefusedAndNothingChanges) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  const auto bytes = e.bytes();
  const fs::path path = folder_ / "strange.nzs";
  const std::vector<std::uint8_t> strange{1, 0, 0, 0, 9};
  ASSERT_TRUE(paint::save_sheet(e.sheet(), e.load(), path, strange));
  const auto opened = e.open(path);
  ASSERT_FALSE(opened);
  EXPECT_EQ(base::to_line(opened.error()), path.string() + ": has strokes that no brush writes");
  EXPECT_EQ(e.bytes(), bytes);
}

TEST_F(SheetEditorFiles, WhatWasSavedIsSavedAgainAfterUndoAndRedo) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  ASSERT_TRUE(e.save(folder_ / "one.nzs"));
  line(e, {0, -0.03}, {0, 0.03});
  EXPECT_FALSE(e.state().is_saved);
  e.undo();
  EXPECT_TRUE(e.state().is_saved);
  e.undo();
  EXPECT_FALSE(e.state().is_saved);
  e.redo();
  EXPECT_TRUE(e.state().is_saved);
  // Another stroke in the place of the one that was undone is not what the file has.
  e.undo();
  line(e, {0, -0.03}, {0, 0.03});
  EXPECT_FALSE(e.state().is_saved);
}

TEST_F(SheetEditorFiles, WhatCannotBeReadOrWrittenChangesNothing) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  const auto bytes = e.bytes();
  EXPECT_FALSE(e.open(folder_ / "missing.nzs"));
  EXPECT_FALSE(e.save(folder_ / "no folder" / "one.nzs"));
  EXPECT_FALSE(e.save_png(folder_ / "no folder" / "one.png"));
  EXPECT_FALSE(e.state().is_saved);
  EXPECT_EQ(e.bytes(), bytes);
  EXPECT_EQ(e.state().undoes, Edit::stroke);
}

TEST_F(SheetEditorFiles, APictureIsAPngAndIsNoSavedSheet) {
  SheetEditor e = editor();
  line(e, {-0.03, 0}, {0.03, 0});
  ASSERT_TRUE(e.save_png(folder_ / "one.png"));
  const auto png = base::read_file(folder_ / "one.png", 1U << 26U).value();
  ASSERT_GT(png.size(), 100U);
  EXPECT_EQ(std::string(png.begin() + 1, png.begin() + 4), "PNG");
  EXPECT_FALSE(e.state().is_saved);
  std::vector<int> changed;
  e.picture(changed);
  EXPECT_EQ(changed.size(), 16U);
}

TEST_F(SheetEditorFiles, AnInkThatASheetFromAFileDoesNotHaveGivesWayToItsFirstOne) {
  auto sheet =
      paint::Sheet::create(128, {},
                           {paint::find_pigment("white").value(), paint::find_pigment("indian-red").value(),
                            paint::find_pigment("burnt-umber").value()})
          .value();
  ASSERT_TRUE(
      paint::save_sheet(sheet, paint::dipped(1e-6, 0.3, {1, 0, 0}, {1, 0, 0}), folder_ / "other.nzs"));
  SheetEditor e = editor();
  ASSERT_TRUE(e.open(folder_ / "other.nzs"));
  EXPECT_EQ(e.state().ink, "white");
  EXPECT_NEAR(e.state().fullness, 0.3, 1e-6);
  EXPECT_TRUE(e.set_ink("sumi"));
  e.undo();
  EXPECT_EQ(e.state().ink, "sumi");
}

}  // namespace
}  // namespace nazori::calligraphy
