// SPDX-License-Identifier: Apache-2.0
// The dialog for worksheets by itself: its pages, its sentences and what it keeps.
#include <gtest/gtest.h>

#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <filesystem>

#include "in_english.h"
#include "nazori/studio/print/page_view.h"
#include "nazori/studio/print/worksheet_dialog.h"
#include "nazori/studio/print/worksheet_options.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "print_qt.h"
#include "two_sides.h"

namespace nazori::ui {
namespace {

class WorksheetOfACharacter : public testing::Test {
 protected:
  WorksheetOfACharacter() {
    test::speak_english();
    window_.resize(1200, 900);
    QObject::connect(&parts_, &WindowParts::announced, &window_,
                     [this](Feedback, const QString& sentence) { said_.append(sentence); });
  }
  void open(char32_t shown = U'一') { dialog_ = std::make_unique<WorksheetDialog>(parts_, shown, &window_); }
  template <class T>
  T& part(const char* name) {
    return *dialog_->findChild<T*>(QString::fromLatin1(name));
  }
  void choose(const std::function<void(practice::WorksheetChoice&)>& change) {
    auto choice = options().choice();
    change(choice);
    options().set_choice(choice);
    emit options().changed();
  }
  WorksheetOptions& options() { return *dialog_->findChild<WorksheetOptions*>(); }
  QString words() { return part<QLabel>("worksheet_words").text(); }
  QString number() { return part<QLabel>("worksheet_number").text(); }
  void expect_words(const char* wanted) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return words() == QString::fromUtf8(wanted); }, 20'000))
        << words().toStdString();
  }
  void expect_page(const char* wanted) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return number() == QString::fromUtf8(wanted); }, 20'000))
        << number().toStdString();
  }
  [[nodiscard]] QString file(const char* name) const { return folder_.filePath(QString::fromUtf8(name)); }

  QTemporaryDir folder_;
  QWidget window_;
  WindowParts parts_{window_,
                     file("nazori.ini"),
                     {file("learners").toStdString(),
                      std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db",
                      {}}};
  std::unique_ptr<WorksheetDialog> dialog_;
  QStringList said_;
};

TEST_F(WorksheetOfACharacter, HasItsPreviewBesideTheOptionsWhereThereIsRoom) {
  open();
  EXPECT_EQ(dialog_->windowTitle(), QStringLiteral("Print a worksheet"));
  EXPECT_EQ(options().choice().source, practice::WorksheetSource::shown);
  EXPECT_EQ(options().choice().list, "grade-1");
  EXPECT_EQ(options().choice().sheet.language, print::Language::english);
  EXPECT_EQ(part<QPushButton>("worksheet_previous").shortcut(), QKeySequence(QStringLiteral("Ctrl+PgUp")));
  EXPECT_EQ(part<QPushButton>("worksheet_next").shortcut(), QKeySequence(QStringLiteral("Ctrl+PgDown")));
  EXPECT_EQ(part<QPushButton>("worksheet_previous").toolTip(),
            QStringLiteral("Show the previous page (Ctrl+PgUp)"));
  EXPECT_EQ(part<QPushButton>("worksheet_next").toolTip(),
            QStringLiteral("Show the next page (Ctrl+PgDown)"));
  EXPECT_FALSE(part<QPushButton>("worksheet_previous").autoDefault());
  EXPECT_FALSE(part<QPushButton>("worksheet_next").autoDefault());
  EXPECT_TRUE(part<QPushButton>("worksheet_save").isDefault());
  EXPECT_EQ(part<QLabel>("worksheet_number").alignment(), Qt::AlignCenter);
  EXPECT_FALSE(part<QLabel>("worksheet_number").wordWrap());
  const auto& area = *dialog_->findChild<QScrollArea*>();
  EXPECT_EQ(area.frameShape(), QFrame::NoFrame);
  EXPECT_EQ(dialog_->layout()->contentsMargins(), QMargins(16, 16, 16, 12));
  EXPECT_EQ(part<QWidget>("worksheet_preview").parentWidget()->layout()->contentsMargins(), QMargins());
  const int em = QFontInfo(dialog_->font()).pixelSize();
  EXPECT_EQ(dialog_->size(), QSize(em * 62, em * 46).boundedTo(QSize(1140, 855)));
  dialog_->show();
  test::expect_preview_beside_options(*dialog_);
}

TEST_F(WorksheetOfACharacter, PagesAreTurnedFromTheFirstToTheLast) {
  open();
  auto& previous = part<QPushButton>("worksheet_previous");
  auto& next = part<QPushButton>("worksheet_next");
  EXPECT_FALSE(previous.isEnabled());
  EXPECT_FALSE(next.isEnabled());
  expect_page("Page 1 of 1");
  expect_words("1 characters · 1 pages");
  EXPECT_TRUE(part<QPushButton>("worksheet_save").isEnabled());
  EXPECT_FALSE(next.isEnabled());
  // Twelve rows of ten cells at most are on a page, so that 80 characters need more than two.
  choose([](auto& choice) { choice.source = practice::WorksheetSource::list; });
  EXPECT_FALSE(part<QPushButton>("worksheet_save").isEnabled()) << "until it is known what there is";
  ASSERT_TRUE(QTest::qWaitFor([&] { return next.isEnabled(); }, 20'000));
  EXPECT_FALSE(previous.isEnabled());
  const int pages = number().section(QLatin1Char(' '), -1).toInt();
  ASSERT_GT(pages, 2);
  EXPECT_EQ(words(), QStringLiteral("80 characters · %1 pages").arg(pages));
  const auto page = [pages](int at) {
    return QStringLiteral("Page %1 of %2").arg(at).arg(pages).toStdString();
  };
  next.click();
  expect_page(page(2).c_str());
  EXPECT_TRUE(previous.isEnabled());
  EXPECT_TRUE(next.isEnabled());
  previous.click();
  expect_page(page(1).c_str());
  auto& view = part<PageView>("worksheet_preview");
  emit view.turned(-5);
  emit view.turned(pages + 5);
  expect_page(page(pages).c_str());
  EXPECT_FALSE(next.isEnabled());
  choose([](auto& choice) { choice.sheet.title = "x"; });
  expect_page(page(1).c_str());
}

TEST_F(WorksheetOfACharacter, WhereThereIsNothingToPrintTheReasonIsSaid) {
  open();
  expect_page("Page 1 of 1");
  using Source = practice::WorksheetSource;
  const std::pair<Source, const char*> all[] = {
      {Source::due, "No reviews are due now. Choose other characters."},
      {Source::difficult, "There are no difficult characters. Choose other characters."},
      {Source::text, "Type or paste a text with characters to write."}};
  for (const auto& [source, sentence] : all) {
    choose([source = source](auto& choice) { choice.source = source; });
    expect_words(sentence);
    EXPECT_EQ(number(), QString());
    EXPECT_FALSE(part<QPushButton>("worksheet_save").isEnabled());
    EXPECT_FALSE(part<QPushButton>("worksheet_next").isEnabled());
    emit part<PageView>("worksheet_preview").turned(1);
    EXPECT_EQ(number(), QString());
  }
}

TEST_F(WorksheetOfACharacter, IsSavedUnderItsTitleAndItsChoiceIsKept) {
  open();
  expect_page("Page 1 of 1");
  choose([](auto& choice) { choice.sheet.title = "a/b"; });
  expect_page("Page 1 of 1");
  ASSERT_TRUE(QTest::qWaitFor([this] { return part<QPushButton>("worksheet_save").isEnabled(); }, 20'000));
  QString proposed;
  QTimer::singleShot(0, &window_, [&proposed] {
    auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(files, nullptr);
    proposed = QFileInfo(files->selectedFiles().value(0)).fileName();
    EXPECT_EQ(files->nameFilters(), QStringList{QStringLiteral("PDF (*.pdf)")});
    static_cast<QDialog*>(files)->reject();
  });
  part<QPushButton>("worksheet_save").click();
  EXPECT_EQ(proposed, QStringLiteral("a-b.pdf"));
  EXPECT_TRUE(said_.isEmpty());
  dialog_->save(file("none/a.pdf"));
  ASSERT_TRUE(QTest::qWaitFor([this] { return words().startsWith(QStringLiteral("✗ ")); }, 20'000));
  EXPECT_TRUE(words().startsWith(QStringLiteral("✗ a.pdf: "))) << words().toStdString();
  EXPECT_TRUE(words().endsWith(QStringLiteral(". Nothing was saved.")));
  int focused = 0;
  QObject::connect(&parts_, &WindowParts::focus_tablet, &window_, [&focused] { ++focused; });
  dialog_->show();
  QTimer::singleShot(0, &window_, [this] {
    auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(files, nullptr);
    files->selectFile(file("sheet"));
    static_cast<QDialog*>(files)->done(QDialog::Accepted);
  });
  part<QPushButton>("worksheet_save").click();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !said_.isEmpty(); }, 20'000));
  EXPECT_EQ(said_, QStringList{QStringLiteral("Saved 1 pages as %1.").arg(file("sheet.pdf"))});
  EXPECT_TRUE(QFileInfo::exists(file("sheet.pdf")));
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
  EXPECT_EQ(dialog_->result(), QDialog::Accepted);
  EXPECT_EQ(focused, 1);
  const auto chosen = options().choice();
  open();
  EXPECT_EQ(options().choice().sheet.title, chosen.sheet.title);
  EXPECT_EQ(options().choice().source, chosen.source);
  expect_page("Page 1 of 1");
}

TEST_F(WorksheetOfACharacter, TheListOfThePageForCharactersIsProposed) {
  const std::pair<kanji::List, const char*> all[] = {{kanji::List::secondary, "secondary"},
                                                     {kanji::List::jinmeiyou, "jinmeiyou"},
                                                     {kanji::List::hiragana, "hiragana"},
                                                     {kanji::List::katakana, "katakana"},
                                                     {kanji::List::own, "own"},
                                                     {kanji::List::latin_and_digits, "grade-1"},
                                                     {kanji::List::all, "grade-1"},
                                                     {kanji::List::grade_1, "grade-1"},
                                                     {kanji::List::grade_3, "grade-3"},
                                                     {kanji::List::grade_6, "grade-6"}};
  for (const auto& [list, id] : all) {
    parts_.preferences().list = list;
    open();
    EXPECT_EQ(options().choice().list, id);
    expect_page("Page 1 of 1");
  }
}

}  // namespace
}  // namespace nazori::ui
