// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/history.h"

#include <gtest/gtest.h>

#include "nazori/paint/sheet_file.h"
#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

TEST(History, AHundredStrokesAreUndoneAndRedoneToTheByte) {
  Sheet sheet = sheet_of(128, find_paper("gasenshi").value());
  InkLoad load = full_of();
  const Everything all = everything(sheet, load);
  History history;
  std::vector<std::vector<std::uint8_t>> states;
  for (int i = 0; i < 100; ++i) {
    states.push_back(to_bytes(sheet, load));
    history.remember(sheet, load);
    const double y = 0.04 - 0.0008 * i;
    write(sheet, load, {.from = {-0.01, y}, .to = {0.01, -y}, .width_m = 0.002, .steps = 3});
    sheet.step();
    if (i % 17 == 3) sheet.dry_now();
  }
  states.push_back(to_bytes(sheet, load));
  for (std::size_t i = 100; i-- > 0;) {
    ASSERT_TRUE(history.undo(sheet, load));
    ASSERT_EQ(to_bytes(sheet, load), states[i]) << i;
    EXPECT_EQ(everything(sheet, load), all);
  }
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.undo(sheet, load));
  for (std::size_t i = 1; i <= 100; ++i) {
    ASSERT_TRUE(history.redo(sheet, load));
    ASSERT_EQ(to_bytes(sheet, load), states[i]) << i;
  }
  EXPECT_FALSE(history.redo(sheet, load));
}

TEST(History, AfterAnUndoTheSheetGoesOnAsItDidBefore) {
  const auto next = [](Sheet& sheet, InkLoad& load) {
    write(sheet, load, {.from = {0, 0.03}, .to = {0, -0.03}}, [&] { sheet.step(); });
    for (int i = 0; i < 30; ++i) sheet.step();
    return to_bytes(sheet, load);
  };
  Sheet sheet = sheet_of(256);
  InkLoad load = full_of();
  History history;
  write(sheet, load, {}, [&] { sheet.step(); });
  history.remember(sheet, load);
  const auto once = next(sheet, load);
  ASSERT_TRUE(history.undo(sheet, load));
  EXPECT_EQ(next(sheet, load), once);
}

TEST(History, AStateIsKeptApartFromWhatIsWrittenOnTheSameTileAfterIt) {
  Sheet sheet = sheet_of(128);
  InkLoad load = full_of();
  History history;
  sheet.drop(3, 3, kOne, {});
  history.remember(sheet, load);
  sheet.drop(4, 4, kOne, {});
  history.remember(sheet, load);
  const geometry::BristleSegment dot{{-0.045, 0.045}, {-0.045, 0.045}, 1, 0.002, 0.01, 0, 1, 1};
  sheet.touch({&dot, 1}, load);
  history.undo(sheet, load);
  EXPECT_EQ(sheet.at(4, 4).surface, kOne);
  EXPECT_EQ(sheet.holding().pigment[0], 0);
  history.undo(sheet, load);
  EXPECT_EQ(sheet.at(4, 4).surface, 0);
  EXPECT_EQ(sheet.at(3, 3).surface, kOne);
}

TEST(History, ANewStrokeEndsRedoAndTheOldestStrokesAreForgotten) {
  Sheet sheet = sheet_of(128);
  InkLoad load = full_of();
  History history(3);
  for (int i = 0; i < 5; ++i) {
    history.remember(sheet, load);
    sheet.drop(i, 0, kOne, {});
  }
  EXPECT_GT(history.bytes(), 0U);
  ASSERT_TRUE(history.undo(sheet, load));
  EXPECT_TRUE(history.can_redo());
  history.remember(sheet, load);
  EXPECT_FALSE(history.can_redo());
  EXPECT_TRUE(history.undo(sheet, load));
  EXPECT_TRUE(history.undo(sheet, load));
  EXPECT_TRUE(history.undo(sheet, load));
  EXPECT_FALSE(history.undo(sheet, load));
  EXPECT_EQ(sheet.at(1, 0).surface, kOne);
  EXPECT_EQ(sheet.at(2, 0).surface, 0);
}

TEST(History, ThePaletteComesBackToo) {
  Sheet sheet = sheet_of(128);
  InkLoad load = full_of();
  History history;
  history.remember(sheet, load);
  ASSERT_TRUE(sheet.set_pigment(1, find_pigment("burnt-umber").value()));
  history.undo(sheet, load);
  EXPECT_EQ(sheet.palette()[1].name, "vermilion");
  history.redo(sheet, load);
  EXPECT_EQ(sheet.palette()[1].name, "burnt-umber");
}

}  // namespace
}  // namespace nazori::paint
