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
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

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
