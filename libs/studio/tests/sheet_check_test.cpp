// SPDX-License-Identifier: Apache-2.0
// The dialog that checks photographs of worksheets: what it lists, marks, says and saves.
#include <QBoxLayout>
#include <QComboBox>
#include <QFileInfo>
#include <QFontInfo>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>

#include "nazori/practice/worksheet_maker.h"
#include "nazori/studio/print/page_view.h"
#include "nazori/studio/print/photo_view.h"
#include "nazori/studio/print/sheet_check_dialog.h"
#include "page_under_test.h"

namespace nazori::ui {
namespace {

using test::sentence;

class CheckOfWorksheets : public test::PageTest {
 protected:
  template <class T>
  T& part(const char* name) {
    return *dialog_.findChild<T*>(QString::fromLatin1(name));
  }
  QString words() { return part<QLabel>("sheet_check_words").text(); }
  void wait_for_photos() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return dialog_.is_idle(); }, 30'000));
  }
  /// A printed page for 休 as a picture. @param scribbles  somebody drew all over it.
  QString photo(const char* name, bool scribbles) {
    practice::WorksheetMaker maker(parts_.inbox(), parts_.learner().source());
    std::shared_ptr<const print::PageDrawing> page;
    base::Connection listening =
        maker.shown.connect([&page](const practice::WorksheetView& view) { page = view.drawing; });
    practice::WorksheetRequest request;
    request.characters = {U'休'};
    request.choice.sheet.rows = 1;
    maker.show(request, 0);
    EXPECT_TRUE(QTest::qWaitFor([&page] { return page != nullptr; }, 20'000));
    constexpr double kDots = 100 / 25.4;
    QImage picture(static_cast<int>(page->width_mm * kDots), static_cast<int>(page->height_mm * kDots),
                   QImage::Format_RGB32);
    QPainter painter(&picture);
    painter.scale(kDots, kDots);
    paint_page(painter, *page, Qt::white);
    if (scribbles) {
      painter.setPen(QPen(Qt::black, 0.8));
      for (double x = page->width_mm / 2; x < page->width_mm - 12; x += 1.5)
        painter.drawLine(QPointF(x, 20), QPointF(x + 4, page->height_mm / 3));
    }
    painter.end();
    EXPECT_TRUE(picture.save(file(name)));
    return file(name);
  }
  static QWidget* large(QWidget& window) {
    window.resize(1200, 900);
    return &window;
  }
  SheetCheckDialog dialog_{parts_, large(window_)};
};

TEST_F(CheckOfWorksheets, BeginsEmptyAndAsLargeAsTheWindowAllows) {
  EXPECT_EQ(dialog_.objectName(), sentence("sheet_check_dialog"));
  EXPECT_EQ(dialog_.windowTitle(), sentence("Check worksheets"));
  EXPECT_EQ(part<QLabel>("sheet_order_words").text(),
            sentence("Stroke order and direction cannot be seen in a photograph."));
  EXPECT_FALSE(part<QPushButton>("sheet_save").isEnabled());
  EXPECT_TRUE(part<QPushButton>("sheet_open").isEnabled());
  EXPECT_TRUE(part<QListWidget>("sheet_cells").wordWrap());
  EXPECT_EQ(part<QComboBox>("sheet_photos").minimumContentsLength(), 16);
  EXPECT_EQ(dialog_.layout()->contentsMargins(), QMargins(16, 16, 16, 12));
  auto& sides = *static_cast<QBoxLayout*>(dialog_.layout()->itemAt(0)->layout());
  EXPECT_EQ(sides.spacing(), 12);
  EXPECT_EQ(sides.stretch(0), 2);
  EXPECT_EQ(sides.stretch(1), 3);
  EXPECT_EQ(static_cast<QBoxLayout*>(dialog_.layout())->stretch(0), 1);
  EXPECT_EQ(sides.itemAt(1)->widget(), &part<QWidget>("sheet_picture"));
  EXPECT_EQ(static_cast<QBoxLayout*>(sides.itemAt(0)->layout())->stretch(2), 1) << "the list";
  const int em = QFontInfo(dialog_.font()).pixelSize();
  EXPECT_EQ(dialog_.size(), QSize(em * 62, em * 46).boundedTo(QSize(1140, 855)));
  dialog_.save(file("early.png"));
  EXPECT_TRUE(dialog_.is_idle()) << "there is nothing to save";
}

TEST_F(CheckOfWorksheets, ListsTheCellsThatNeedCareAndMarksTheChosenOne) {
  dialog_.show();
  auto& cells = part<QListWidget>("sheet_cells");
  auto& photos = part<QComboBox>("sheet_photos");
  const auto& view = part<PhotoView>("sheet_picture");
  dialog_.read({photo("written.png", true), photo("clean.png", false), file("missing.png")});
  EXPECT_EQ(words(), sentence("Reading 3 photographs…"));
  wait_for_photos();
  EXPECT_TRUE(words().startsWith(sentence("✗ missing.png: "))) << words().toStdString();
  ASSERT_EQ(photos.count(), 2);
  EXPECT_EQ(photos.currentText(), sentence("clean.png"));
  EXPECT_EQ(cells.count(), 0);
  const QString clean = view.accessibleDescription();
  EXPECT_TRUE(clean.startsWith(sentence("Practice sheet, page 1: "))) << clean.toStdString();
  EXPECT_TRUE(clean.contains(sentence(" 0 legible, 0 not legible, "))) << clean.toStdString();
  photos.setCurrentIndex(0);
  EXPECT_EQ(words(), view.accessibleDescription());
  ASSERT_GT(cells.count(), 1) << words().toStdString();
  EXPECT_TRUE(words().contains(sentence(" %1 not legible").arg(cells.count()))) << words().toStdString();
  const QString first = cells.item(0)->text(), last = cells.item(cells.count() - 1)->text();
  EXPECT_TRUE(first.startsWith(sentence("✗ Cell "))) << first.toStdString();
  EXPECT_TRUE(first.contains(sentence(", 休: not legible"))) << first.toStdString();
  EXPECT_NE(first, last);
  EXPECT_TRUE(view.marked().isEmpty());
  cells.setCurrentRow(0);
  const QPolygonF mark = view.marked();
  ASSERT_EQ(mark.size(), 4);
  EXPECT_GT(mark.boundingRect().width(), 20);
  EXPECT_TRUE(QRectF({0, 0}, QSizeF(view.picture().size())).contains(mark.boundingRect()));
  cells.setCurrentRow(cells.count() - 1);
  EXPECT_FALSE(mark.boundingRect().intersects(view.marked().boundingRect().adjusted(9, 9, -9, -9)));
  cells.setCurrentRow(-1);
  EXPECT_TRUE(view.marked().isEmpty());
  photos.setCurrentIndex(1);
  EXPECT_EQ(words(), clean);
  EXPECT_EQ(cells.count(), 0);
}

TEST_F(CheckOfWorksheets, SavesThePictureThatIsShownUnderTheNameOfItsPhotograph) {
  dialog_.show();
  dialog_.read({photo("a.b.png", false)});
  wait_for_photos();
  auto& save = part<QPushButton>("sheet_save");
  EXPECT_TRUE(save.isEnabled());
  choose_file({}, [](QFileDialog& files) {
    EXPECT_EQ(files.objectName(), sentence("sheet_file_dialog"));
    EXPECT_EQ(files.windowTitle(), sentence("Save the picture"));
    EXPECT_EQ(files.acceptMode(), QFileDialog::AcceptSave);
    EXPECT_EQ(files.nameFilters(), QStringList{sentence("Picture (*.png)")});
    EXPECT_EQ(files.defaultSuffix(), sentence("png"));
    EXPECT_EQ(QFileInfo(files.selectedFiles().value(0)).fileName(), sentence("a.b checked.png"));
  });
  save.click();
  EXPECT_TRUE(dialog_.is_idle());
  choose_file(file("checked"));
  save.click();
  wait_for_photos();
  EXPECT_EQ(words(), sentence("Saved checked.png."));
  EXPECT_FALSE(QImage(file("checked.png")).isNull());
  dialog_.save(file("no/a.png"));
  wait_for_photos();
  EXPECT_TRUE(words().startsWith(sentence("✗ a.png: "))) << words().toStdString();
  const int focused = focused_;
  dialog_.reject();
  EXPECT_EQ(focused_, focused + 1);
}

TEST_F(CheckOfWorksheets, PhotographsAreAskedForAndTheirFolderIsKept) {
  const QString path = photo("one.png", false);
  auto& open = part<QPushButton>("sheet_open");
  const int saves = saves_;
  choose_file({}, [](QFileDialog& files) {
    EXPECT_EQ(files.windowTitle(), sentence("Open photographs of worksheets"));
    EXPECT_EQ(files.nameFilters(), QStringList{sentence("Photographs and scans (*.jpg *.jpeg *.png)")});
    EXPECT_EQ(files.fileMode(), QFileDialog::ExistingFiles);
  });
  open.click();
  EXPECT_EQ(saves_, saves);
  EXPECT_TRUE(dialog_.is_idle());
  choose_file(path);
  open.click();
  EXPECT_FALSE(dialog_.is_idle());
  EXPECT_EQ(saves_, saves + 1);
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
  wait_for_photos();
  parts_.preferences().folder.clear();
  const int focused = focused_;
  choose_file({});
  ask_sheet_check(parts_);
  EXPECT_EQ(focused_, focused + 1);
  choose_file(path);
  ask_sheet_check(parts_);
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
  const auto dialogs = window_.findChildren<SheetCheckDialog*>();
  ASSERT_EQ(dialogs.size(), 2);
  EXPECT_TRUE(dialogs.back()->isVisible());
  EXPECT_TRUE(dialogs.back()->testAttribute(Qt::WA_DeleteOnClose));
  EXPECT_TRUE(QTest::qWaitFor([&] { return dialogs.back()->is_idle(); }, 30'000));
}

}  // namespace
}  // namespace nazori::ui
