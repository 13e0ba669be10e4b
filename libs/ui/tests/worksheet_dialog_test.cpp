// SPDX-License-Identifier: Apache-2.0
// Printing from the window: the dialog, its preview against the pages of the PDF as poppler draws them, and
// the file.
#include "nazori/studio/print/worksheet_dialog.h"

#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QPainter>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>

#include "nazori/studio/print/page_view.h"
#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/words/kanji_text.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using practice::WorksheetSource;

class WorksheetDialogTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    open_dialog();
  }
  void open_dialog() {
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    press(Qt::Key_P, Qt::ControlModifier);
    dialog_ = find<WorksheetDialog>("worksheet_dialog");
    ASSERT_NE(dialog_, nullptr);
    ASSERT_TRUE(wait_for_page());
  }
  void close_dialog() {
    dialog_->reject();
    ASSERT_TRUE(QTest::qWaitFor([this] { return find<WorksheetDialog>("worksheet_dialog") == nullptr; }));
  }
  template <class T>
  T* part(const char* name) {
    return dialog_->findChild<T*>(QString::fromLatin1(name));
  }
  PageView* view() { return part<PageView>("worksheet_preview"); }
  bool wait_for_page() {
    return QTest::qWaitFor([this] { return view()->page() != nullptr; }, 20000);
  }
  /// What is written on the page that is shown next.
  QString text_after(const std::function<void()>& change) {
    const auto before = view()->page();
    change();
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return view()->page() != before && part<QPushButton>("worksheet_save")->isEnabled(); }, 20000));
    return view()->page() ? to_text(view()->page()->text) : QString();
  }
  bool says(const QString& words) {
    return QTest::qWaitFor([&] { return part<QLabel>("worksheet_words")->text().contains(words); }, 20000);
  }
  void choose_source(WorksheetSource source) {
    auto* box = part<QComboBox>("worksheet_source");
    box->setCurrentIndex(box->findData(static_cast<int>(source)));
  }
  QString pages() { return part<QLabel>("worksheet_number")->text(); }

  WorksheetDialog* dialog_ = nullptr;
};

TEST_F(WorksheetDialogTest, BeginsWithTheCharacterThatIsShown) {
  EXPECT_TRUE(to_text(view()->page()->text).startsWith(QStringLiteral("Date\nClass\nName\n")));
  EXPECT_TRUE(to_text(view()->page()->text).contains(QStringLiteral("休\n")));
  EXPECT_TRUE(says(QStringLiteral("1 character · 1 page")));
  EXPECT_EQ(pages(), QStringLiteral("Page 1 of 1"));
}

TEST_F(WorksheetDialogTest, APageIsShownAsThePdfHasIt) {
  struct Case {
    int layout;
    bool vertical, booklet;
  };
  for (const Case& one : {Case{0, false, false}, Case{0, true, true}, Case{1, false, false},
                          Case{2, false, false}, Case{4, false, false}}) {
    text_after([&] {
      choose_source(WorksheetSource::text);
      part<QPlainTextEdit>("worksheet_text")->setPlainText(QStringLiteral("休永日%1").arg(one.layout));
      part<QComboBox>("worksheet_layout")->setCurrentIndex(one.layout);
      part<QCheckBox>("worksheet_vertical")->setChecked(one.vertical);
      part<QCheckBox>("worksheet_booklet")->setChecked(one.booklet);
    });
    const auto page = view()->page();
    ASSERT_TRUE(page);
    const QString file = folder_.filePath(QStringLiteral("sheet.pdf"));
    dialog_->save(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return find<WorksheetDialog>("worksheet_dialog") == nullptr; }, 20000));
    QProcess poppler;
    poppler.start(QStringLiteral("pdftoppm"),
                  {QStringLiteral("-gray"), QStringLiteral("-r"), QStringLiteral("50"), QStringLiteral("-f"),
                   QStringLiteral("1"), QStringLiteral("-l"), QStringLiteral("1"), file});
    ASSERT_TRUE(poppler.waitForFinished(20000));
    const QImage printed =
        QImage::fromData(poppler.readAllStandardOutput(), "PGM").convertToFormat(QImage::Format_Grayscale8);
    ASSERT_FALSE(printed.isNull());
    QImage shown(printed.size(), QImage::Format_Grayscale8);
    QPainter painter(&shown);
    painter.scale(shown.width() / page->width_mm, shown.height() / page->height_mm);
    paint_page(painter, *page, Qt::white);
    painter.end();
    // Compared in fields of 4 x 4 dots, because the two draw edges in different ways.
    constexpr int kField = 4;
    int different = 0;
    int inked = 0;
    for (int y = 0; y + kField <= shown.height(); y += kField) {
      for (int x = 0; x + kField <= shown.width(); x += kField) {
        int a = 0;
        int b = 0;
        for (int i = 0; i < kField * kField; ++i) {
          a += qGray(shown.pixel(x + i % kField, y + i / kField));
          b += qGray(printed.pixel(x + i % kField, y + i / kField));
        }
        if (b < 250 * kField * kField) ++inked;
        if (std::abs(a - b) > 40 * kField * kField) ++different;
      }
    }
    EXPECT_GT(inked, 300) << one.layout;
    EXPECT_LT(different, inked / 50) << one.layout << " of " << inked;
    open_dialog();
  }
}

TEST_F(WorksheetDialogTest, ThePreviewFollowsTheOptions) {
  auto text = text_after([this] {
    choose_source(WorksheetSource::list);
    part<ListChoice>("worksheet_list")->set_list(QStringLiteral("grade-1"));
    part<QLineEdit>("worksheet_title")->setText(QStringLiteral("Week 3"));
  });
  EXPECT_TRUE(text.contains(QStringLiteral("Week 3\n")));
  EXPECT_TRUE(text.contains(QStringLiteral("一\n")));
  EXPECT_TRUE(says(QStringLiteral("80 characters")));
  text = text_after([this] { part<QCheckBox>("worksheet_name_line")->setChecked(false); });
  EXPECT_FALSE(text.contains(QStringLiteral("Name\n")));
  text = text_after([this] { part<QCheckBox>("worksheet_whole_page")->setChecked(true); });
  EXPECT_EQ(pages(), QStringLiteral("Page 1 of 80"));
  text = text_after([this] { part<QCheckBox>("worksheet_booklet")->setChecked(true); });
  EXPECT_EQ(pages(), QStringLiteral("Page 1 of 40"));
  EXPECT_DOUBLE_EQ(view()->page()->width_mm, 297);
  text_after([this] { part<QComboBox>("worksheet_paper")->setCurrentIndex(1); });
  EXPECT_DOUBLE_EQ(view()->page()->width_mm, 257);
}

TEST_F(WorksheetDialogTest, KeysTurnThePages) {
  text_after([this] {
    choose_source(WorksheetSource::text);
    part<QPlainTextEdit>("worksheet_text")->setPlainText(QStringLiteral("一二三"));
    part<QCheckBox>("worksheet_whole_page")->setChecked(true);
  });
  const auto shows = [this](const QString& number, const QString& character) {
    return QTest::qWaitFor(
        [&] {
          return pages() == number && to_text(view()->page()->text).contains(character + QLatin1Char('\n'));
        },
        20000);
  };
  EXPECT_TRUE(shows(QStringLiteral("Page 1 of 3"), QStringLiteral("一")));
  EXPECT_FALSE(part<QPushButton>("worksheet_previous")->isEnabled());
  QTest::keyClick(view(), Qt::Key_PageDown);
  EXPECT_TRUE(shows(QStringLiteral("Page 2 of 3"), QStringLiteral("二")));
  QTest::keyClick(view(), Qt::Key_End);
  EXPECT_TRUE(shows(QStringLiteral("Page 3 of 3"), QStringLiteral("三")));
  EXPECT_FALSE(part<QPushButton>("worksheet_next")->isEnabled());
  QTest::keyClick(view(), Qt::Key_PageUp);
  EXPECT_TRUE(shows(QStringLiteral("Page 2 of 3"), QStringLiteral("二")));
  QTest::keyClick(view(), Qt::Key_Home);
  EXPECT_TRUE(shows(QStringLiteral("Page 1 of 3"), QStringLiteral("一")));
  QTest::keyClick(dialog_, Qt::Key_PageDown, Qt::ControlModifier);
  EXPECT_TRUE(shows(QStringLiteral("Page 2 of 3"), QStringLiteral("二")));
  // A screen reader finds the page and what is on it.
  EXPECT_TRUE(view()->accessibleDescription().startsWith(QStringLiteral("Page 2 of 3. ")));
  EXPECT_TRUE(view()->accessibleDescription().contains(QStringLiteral("二")));
  // Another choice begins with its first page.
  text_after([this] { part<QCheckBox>("worksheet_facts")->setChecked(false); });
  EXPECT_EQ(pages(), QStringLiteral("Page 1 of 3"));
}

TEST_F(WorksheetDialogTest, APageOfAnOlderChoiceIsNotShown) {
  text_after([this] {
    choose_source(WorksheetSource::text);
    part<QPlainTextEdit>("worksheet_text")->setPlainText(QStringLiteral("一二"));
    part<QCheckBox>("worksheet_whole_page")->setChecked(true);
  });
  const auto before = view()->page();
  QTest::keyClick(view(), Qt::Key_PageDown);
  part<QCheckBox>("worksheet_name_line")->setChecked(false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view()->page() != before; }, 20000));
  EXPECT_FALSE(to_text(view()->page()->text).contains(QStringLiteral("Name")));
  EXPECT_EQ(pages(), QStringLiteral("Page 1 of 2"));
}

TEST_F(WorksheetDialogTest, WhatCannotBePrintedIsSaidAndNotSaved) {
  choose_source(WorksheetSource::text);
  EXPECT_TRUE(says(QStringLiteral("Type or paste a text")));
  EXPECT_EQ(view()->page(), nullptr);
  EXPECT_FALSE(part<QPushButton>("worksheet_save")->isEnabled());
  EXPECT_FALSE(part<QPushButton>("worksheet_next")->isEnabled());
  choose_source(WorksheetSource::due);
  EXPECT_TRUE(says(QStringLiteral("No reviews are due now.")));
  choose_source(WorksheetSource::difficult);
  EXPECT_TRUE(says(QStringLiteral("There are no difficult characters.")));
  choose_source(WorksheetSource::list);
  EXPECT_TRUE(wait_for_page());
  part<QSpinBox>("worksheet_cell")->setValue(60);
  part<QSpinBox>("worksheet_rows")->setValue(40);
  EXPECT_TRUE(says(QStringLiteral("The rows do not fit on a page.")));
  EXPECT_FALSE(part<QPushButton>("worksheet_save")->isEnabled());
}

TEST_F(WorksheetDialogTest, ManuscriptPaperMayBeEmpty) {
  text_after([this] { part<QComboBox>("worksheet_layout")->setCurrentIndex(3); });
  EXPECT_TRUE(says(QStringLiteral("1 page")));
  const QString text = text_after(
      [this] { part<QPlainTextEdit>("worksheet_text")->setPlainText(QStringLiteral("春はあけぼの")); });
  EXPECT_TRUE(text.contains(QStringLiteral("ぼ\n")));
}

TEST_F(WorksheetDialogTest, OnlyOptionsWithAnEffectAreShown) {
  const auto shown = [this](const char* name) { return part<QWidget>(name)->isVisible(); };
  EXPECT_TRUE(shown("worksheet_cell"));
  EXPECT_TRUE(shown("worksheet_rows"));
  EXPECT_FALSE(shown("worksheet_answers"));
  EXPECT_FALSE(shown("worksheet_list"));
  EXPECT_FALSE(shown("worksheet_text"));
  part<QCheckBox>("worksheet_whole_page")->setChecked(true);
  EXPECT_FALSE(shown("worksheet_rows"));
  auto* layout = part<QComboBox>("worksheet_layout");
  layout->setCurrentIndex(1);
  EXPECT_TRUE(shown("worksheet_answers"));
  EXPECT_FALSE(shown("worksheet_steps"));
  EXPECT_TRUE(shown("worksheet_guide"));
  layout->setCurrentIndex(2);
  EXPECT_FALSE(shown("worksheet_booklet"));
  EXPECT_FALSE(shown("worksheet_title"));
  EXPECT_TRUE(shown("worksheet_numbers"));
  EXPECT_TRUE(shown("worksheet_source"));
  layout->setCurrentIndex(3);
  EXPECT_FALSE(shown("worksheet_source"));
  EXPECT_TRUE(shown("worksheet_text"));
  EXPECT_FALSE(shown("worksheet_per_sheet"));
  layout->setCurrentIndex(4);
  for (const char* name :
       {"worksheet_source", "worksheet_per_sheet", "worksheet_guide", "worksheet_rows", "worksheet_copies",
        "worksheet_numbers", "worksheet_arrows", "worksheet_name_line"})
    EXPECT_TRUE(shown(name)) << name;
  for (const char* name : {"worksheet_cell", "worksheet_whole_page", "worksheet_steps", "worksheet_facts",
                           "worksheet_vertical", "worksheet_booklet", "worksheet_title"})
    EXPECT_FALSE(shown(name)) << name;
}

TEST_F(WorksheetDialogTest, ABrushSheetHasAsManyCharactersAsChosenOnAsManySheets) {
  text_after([this] {
    choose_source(WorksheetSource::text);
    part<QPlainTextEdit>("worksheet_text")->setPlainText(QStringLiteral("休永日山川"));
    part<QComboBox>("worksheet_layout")->setCurrentIndex(4);
    part<QComboBox>("worksheet_paper")->setCurrentIndex(3);
    part<QComboBox>("worksheet_per_sheet")->setCurrentText(QStringLiteral("2"));
    part<QSpinBox>("worksheet_rows")->setValue(3);
  });
  EXPECT_TRUE(says(QStringLiteral("9 pages")));
  EXPECT_DOUBLE_EQ(view()->page()->width_mm, 243);
  EXPECT_EQ(part<QSpinBox>("worksheet_rows")->accessibleName(),
            QStringLiteral("Sheets of the same characters"));
  part<QComboBox>("worksheet_layout")->setCurrentIndex(0);
  EXPECT_EQ(part<QSpinBox>("worksheet_rows")->accessibleName(), QStringLiteral("Rows per character"));
}

TEST_F(WorksheetDialogTest, ThePdfHasTheCharactersAndTheWindowSaysWhereItIs) {
  text_after([this] {
    choose_source(WorksheetSource::text);
    part<QPlainTextEdit>("worksheet_text")->setPlainText(QStringLiteral("山と川"));
  });
  const QString file = folder_.filePath(QStringLiteral("山川.pdf"));
  dialog_->save(file);
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return find<WorksheetDialog>("worksheet_dialog") == nullptr; }, 20000));
  EXPECT_EQ(feedback(), QStringLiteral("Saved 1 page as %1.").arg(file));
  QProcess poppler;
  poppler.start(QStringLiteral("pdftotext"), {file, QStringLiteral("-")});
  ASSERT_TRUE(poppler.waitForFinished(20000));
  const QString text = QString::fromUtf8(poppler.readAllStandardOutput());
  for (const char* one : {"山", "川", "サン", "Name"})
    EXPECT_TRUE(text.contains(QString::fromUtf8(one))) << one;
}

TEST_F(WorksheetDialogTest, AFileThatCannotBeWrittenLeavesTheDialogOpen) {
  dialog_->save(folder_.filePath(QStringLiteral("missing/sheet.pdf")));
  EXPECT_TRUE(says(QStringLiteral("sheet.pdf: ")));
  EXPECT_TRUE(says(QStringLiteral("Nothing was saved.")));
  EXPECT_TRUE(dialog_->isVisible());
}

TEST_F(WorksheetDialogTest, TheChoiceIsThereTheNextTime) {
  text_after([this] {
    part<QSpinBox>("worksheet_cell")->setValue(22);
    part<QLineEdit>("worksheet_title")->setText(QStringLiteral("Week 4"));
    part<QCheckBox>("worksheet_arrows")->setChecked(false);
  });
  close_dialog();
  open_dialog();
  EXPECT_EQ(part<QSpinBox>("worksheet_cell")->value(), 22);
  EXPECT_EQ(part<QLineEdit>("worksheet_title")->text(), QStringLiteral("Week 4"));
  EXPECT_FALSE(part<QCheckBox>("worksheet_arrows")->isChecked());
  EXPECT_TRUE(part<QCheckBox>("worksheet_numbers")->isChecked());
}

TEST_F(WorksheetDialogTest, EveryOptionHasAName) {
  for (auto* field : dialog_->findChildren<QWidget*>()) {
    const QString name = field->objectName();
    if (!name.startsWith(QStringLiteral("worksheet_")) || field->focusPolicy() == Qt::NoFocus) continue;
    const auto* part = QAccessible::queryAccessibleInterface(field);
    ASSERT_NE(part, nullptr) << name.toStdString();
    EXPECT_FALSE(part->text(QAccessible::Name).isEmpty()) << name.toStdString();
  }
}

TEST_F(WorksheetDialogTest, TheAnswerToAQuestionIsNotOffered) {
  close_dialog();
  action("memory")->trigger();
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  press(Qt::Key_P, Qt::ControlModifier);
  dialog_ = find<WorksheetDialog>("worksheet_dialog");
  ASSERT_NE(dialog_, nullptr);
  EXPECT_LT(part<QComboBox>("worksheet_source")->findData(static_cast<int>(WorksheetSource::shown)), 0);
  ASSERT_TRUE(wait_for_page());
  EXPECT_TRUE(says(QStringLiteral("80 characters")));
}

}  // namespace
}  // namespace nazori::ui
