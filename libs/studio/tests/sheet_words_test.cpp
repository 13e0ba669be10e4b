// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/sheet_words.h"

#include <gtest/gtest.h>

#include <QStringList>

#include "print_qt.h"

namespace nazori::ui {
namespace {

scan::CellReading cell(scan::CellState state, std::vector<scan::CellRemark> remarks = {}) {
  scan::CellReading made;
  made.box.character = U'休';
  made.state = state;
  made.remarks = std::move(remarks);
  return made;
}

TEST(SheetWords, ACellIsToldWithItsRemarks) {
  using scan::CellFlaw;
  using scan::CellState;
  EXPECT_EQ(cell_words(3, cell(CellState::legible)), QStringLiteral("Cell 3, 休: legible"));
  EXPECT_EQ(cell_words(3, cell(CellState::legible, {{CellFlaw::small}, {CellFlaw::missing_stroke, 2}})),
            QStringLiteral("Cell 3, 休: too small, stroke 2 is missing"));
  auto other = cell(CellState::illegible);
  EXPECT_EQ(cell_words(1, other), QStringLiteral("Cell 1, 休: not legible"));
  other.looks_like = U'体';
  EXPECT_EQ(cell_words(1, other), QStringLiteral("Cell 1, 休: not legible, looks like 体"));
}

TEST(SheetWords, EveryRemarkHasItsOwnWords) {
  QStringList words;
  for (std::size_t i = 0; i < scan::kCellFlaws.size(); ++i)
    words.append(cell_words(1, cell(scan::CellState::legible, {{static_cast<scan::CellFlaw>(i), 4}})));
  EXPECT_EQ(words.removeDuplicates(), 0);
  EXPECT_EQ(words.filter(QStringLiteral("stroke 4")).size(), 2);
}

TEST(SheetWords, CellsThatNeedCareAreIllegibleOrHaveRemarks) {
  using scan::CellState;
  EXPECT_TRUE(needs_care(cell(CellState::illegible)));
  EXPECT_TRUE(needs_care(cell(CellState::legible, {{scan::CellFlaw::low}})));
  EXPECT_FALSE(needs_care(cell(CellState::legible)));
  EXPECT_FALSE(needs_care(cell(CellState::empty)));
  EXPECT_FALSE(needs_care(cell(CellState::traced)));
}

TEST(SheetWords, ASheetIsToldByWhatItsCellsAre) {
  using scan::CellState;
  scan::SheetReading sheet;
  sheet.mark.page = 2;
  sheet.mark.layout = print::Layout::practice;
  sheet.cells = {cell(CellState::legible), cell(CellState::legible), cell(CellState::illegible),
                 cell(CellState::empty), cell(CellState::traced)};
  EXPECT_EQ(sheet_words(sheet),
            QStringLiteral("Practice sheet, page 2: 4 cells, 2 legible, 1 not legible, 1 empty."));
  sheet.mark.layout = print::Layout::quiz;
  sheet.cells.resize(2);
  EXPECT_EQ(sheet_words(sheet), QStringLiteral("Quiz, page 2: 2 cells, 2 legible, 0 not legible, 0 empty."));
}

TEST(SheetWords, EachFlawOfACellIsSaid) {
  using scan::CellFlaw;
  const std::pair<CellFlaw, const char*> all[] = {{CellFlaw::small, "too small"},
                                                  {CellFlaw::large, "too large"},
                                                  {CellFlaw::high, "too high"},
                                                  {CellFlaw::low, "too low"},
                                                  {CellFlaw::left, "too far left"},
                                                  {CellFlaw::right, "too far right"},
                                                  {CellFlaw::leans_left, "leans to the left"},
                                                  {CellFlaw::leans_right, "leans to the right"},
                                                  {CellFlaw::missing_stroke, "stroke 4 is missing"},
                                                  {CellFlaw::short_stroke, "stroke 4 is too short"},
                                                  {CellFlaw::extra_ink, "has ink that belongs to no stroke"}};
  for (const auto& [flaw, words] : all)
    EXPECT_EQ(cell_words(2, cell(scan::CellState::legible, {{flaw, 4}})),
              QStringLiteral("Cell 2, 休: ") + QString::fromLatin1(words));
}

}  // namespace
}  // namespace nazori::ui
