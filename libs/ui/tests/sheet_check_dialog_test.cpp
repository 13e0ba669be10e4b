// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/sheet_check_dialog.h"

#include <QComboBox>
#include <QFile>
#include <QListWidget>
#include <QProcess>
#include <QPushButton>

#include "characters/characters.h"
#include "nazori/practice/worksheet_maker.h"
#include "nazori/studio/print/photo_view.h"
#include "nazori/studio/print/sheet_words.h"
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

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

WindowParts* the_parts = nullptr;
std::unique_ptr<Page> make_characters(WindowParts& parts) {
  the_parts = &parts;
  return std::make_unique<Characters>(parts);
}

class SheetCheckDialogTest : public WindowTest {
 protected:
  SheetCheckDialogTest() { pages_ = {make_characters}; }
  QString printed() {
    practice::WorksheetMaker maker(the_parts->inbox(), the_parts->learner().source());
    bool saved = false;
    base::Connection listening = maker.saved.connect([&](const auto&, std::size_t) { saved = true; });
    practice::WorksheetRequest request;
    request.characters = {U'休'};
    request.choice.sheet.rows = 1;
    maker.save(request, folder_.filePath(QStringLiteral("a.pdf")).toStdString());
    EXPECT_TRUE(QTest::qWaitFor([&] { return saved; }, 20000));
    EXPECT_EQ(QProcess::execute(
                  QStringLiteral("pdftoppm"),
                  {QStringLiteral("-r"), QStringLiteral("100"), QStringLiteral("-png"),
                   folder_.filePath(QStringLiteral("a.pdf")), folder_.filePath(QStringLiteral("photo"))}),
              0);
    return folder_.filePath(QStringLiteral("photo-1.png"));
  }
};

TEST_F(SheetCheckDialogTest, ShowsAPhotographAndSavesItsPicture) {
  SheetCheckDialog dialog(*the_parts, window_.get());
  dialog.show();
  auto* words = dialog.findChild<QLabel*>(QStringLiteral("sheet_check_words"));
  auto* save = dialog.findChild<QPushButton*>(QStringLiteral("sheet_save"));
  EXPECT_FALSE(save->isEnabled());
  dialog.read({printed(), folder_.filePath(QStringLiteral("missing.jpg"))});
  EXPECT_EQ(words->text(), QStringLiteral("Reading 2 photographs…"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.is_idle(); }, 30000));
  EXPECT_TRUE(words->text().startsWith(QStringLiteral("✗ missing.jpg: "))) << words->text().toStdString();
  EXPECT_EQ(dialog.findChild<QComboBox*>(QStringLiteral("sheet_photos"))->currentText(),
            QStringLiteral("photo-1.png"));
  const auto* view = dialog.findChild<PhotoView*>(QStringLiteral("sheet_picture"));
  EXPECT_FALSE(view->picture().isNull());
  EXPECT_TRUE(view->accessibleDescription().startsWith(QStringLiteral("Practice sheet, page 1: ")));
  EXPECT_EQ(dialog.findChild<QListWidget*>(QStringLiteral("sheet_cells"))->count(), 0);
  EXPECT_TRUE(save->isEnabled());
  const QString to = folder_.filePath(QStringLiteral("checked.png"));
  dialog.save(to);
  EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.is_idle(); }, 30000));
  EXPECT_EQ(words->text(), QStringLiteral("Saved checked.png."));
  EXPECT_TRUE(QFile::exists(to));
}

}  // namespace
}  // namespace nazori::ui
