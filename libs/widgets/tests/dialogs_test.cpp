// SPDX-License-Identifier: Apache-2.0
// The dialogs that every page shares, the choice of a list, and the line of the status.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLayout>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QProgressDialog>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/controls/status_line.h"
#include "nazori/widgets/dialogs/about_dialog.h"
#include "nazori/widgets/dialogs/key_list_dialog.h"
#include "nazori/widgets/dialogs/save_dialog.h"
#include "nazori/widgets/dialogs/work_dialog.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/tablet/window_tablet.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QString words(const char* text) { return QString::fromUtf8(text); }

QStringList lines_of(const QTextBrowser& text) { return text.toPlainText().split(u'\n', Qt::SkipEmptyParts); }

TEST(AboutTheProgram, EachPartIsNamedWithItsLicence) {
  const AboutDialog dialog({}, nullptr);
  EXPECT_EQ(dialog.objectName(), words("about_dialog"));
  EXPECT_EQ(dialog.windowTitle(), words("About Nazori"));
  const auto* text = dialog.findChild<QTextBrowser*>(words("licences"));
  ASSERT_NE(text, nullptr);
  EXPECT_EQ(text->accessibleName(), words("Licences"));
  EXPECT_TRUE(text->openExternalLinks());
  EXPECT_EQ(text->document()->documentMargin(), 12);
  QStringList lines = lines_of(*text);
  for (QString& line : lines) line.replace(QChar::LineSeparator, u'|');
  const QStringList all = lines.join(u'|').split(u'|');
  EXPECT_EQ(all, (QStringList{
                     words("Licences"), words("Nazori (program)"), words("Apache License 2.0"),
                     words("Strokes: KanjiVG, © Ulrich Apel"), words("CC BY-SA 3.0, kanjivg.tagaini.net"),
                     words("Readings, meanings and words: KANJIDIC2 and EDICT, © EDRDG"),
                     words("CC BY-SA 4.0, www.edrdg.org"), words("Textbook font: Klee One, © Fontworks Inc."),
                     words("SIL Open Font License 1.1"),
                     words("User interface: Qt ") + QLatin1String(qVersion()), words("LGPL 3")}));
  const int em = QFontMetrics(dialog.font()).height();
  EXPECT_EQ(dialog.size(), QSize(em * 28, em * 27));
  EXPECT_EQ(dialog.layout()->contentsMargins(), QMargins(20, 20, 20, 16));
}

TEST(AboutTheProgram, TheSourcesOfTheDatabaseAreNamedWithTheBeginningOfTheirChecksum) {
  const AboutDialog dialog({{"kanjivg", "r20<1>", "0123456789abcdef0123", "CC & Co"}}, nullptr);
  const QString text = dialog.findChild<QTextBrowser*>(words("licences"))->toPlainText();
  EXPECT_TRUE(text.contains(words("Sources of the kanji database")));
  EXPECT_TRUE(text.contains(words("kanjivg r20<1>"))) << "a sign is no markup";
  EXPECT_TRUE(text.contains(words("CC & Co")));
  EXPECT_TRUE(text.contains(words("SHA-256 0123456789abcdef…")));
  EXPECT_FALSE(text.contains(words("0123456789abcdef0")));
}

TEST(ListOfKeys, HasTheTabletFirstAndThenEveryGroupWithItsKeys) {
  QAction save(words("&Save…")), hidden(words("Hidden")), two(words("Two"));
  save.setShortcut(QKeySequence(words("Ctrl+S")));
  two.setShortcuts({QKeySequence(words("A")), QKeySequence(words("B"))});
  hidden.setVisible(false);
  const KeyListDialog dialog({{words("&File"), {&save, nullptr, &hidden}}, {words("&Edit"), {&two}}},
                             nullptr);
  EXPECT_EQ(dialog.windowTitle(), words("Keyboard and mouse"));
  const auto* text = dialog.findChild<QTextBrowser*>(words("key_list"));
  ASSERT_NE(text, nullptr);
  EXPECT_EQ(text->accessibleName(), dialog.windowTitle());
  EXPECT_EQ(lines_of(*text), (QStringList{words("On the tablet"),
                                          words("Press the stylus down"),
                                          words("left button, pen tip"),
                                          words("Press deeper or more lightly"),
                                          words("wheel while pressing, or pen pressure"),
                                          words("Undo a stroke (Memory)"),
                                          words("eraser end of the pen"),
                                          words("Turn and tilt"),
                                          words("right button, or side button of the pen"),
                                          words("Move"),
                                          words("middle button, or Shift + right button"),
                                          words("Zoom"),
                                          words("wheel"),
                                          words("Reset view"),
                                          words("Home"),
                                          words("File"),
                                          words("Save…"),
                                          words("Ctrl+S"),
                                          words("Edit"),
                                          words("Two"),
                                          words("A B")}));
  EXPECT_EQ(text->document()->documentMargin(), 12);
  const int em = QFontMetrics(dialog.font()).height();
  EXPECT_EQ(dialog.size(), QSize(em * 28, em * 34));
  EXPECT_EQ(dialog.layout()->contentsMargins(), QMargins(16, 16, 16, 16));
  EXPECT_EQ(dialog.layout()->spacing(), 12);
}

TEST(DialogForWork, AppearsAfterHalfASecondAndStaysUntilItsOwnerEndsIt) {
  QWidget window;
  const auto* dialog = make_work_dialog(words("work"), words("Working…"), words("Stop"), &window);
  EXPECT_EQ(dialog->objectName(), words("work"));
  EXPECT_EQ(dialog->labelText(), words("Working…"));
  EXPECT_EQ(dialog->windowModality(), Qt::WindowModal);
  EXPECT_EQ(dialog->minimumDuration(), 500);
  EXPECT_EQ(dialog->minimum(), 0);
  EXPECT_EQ(dialog->maximum(), 100);
  EXPECT_EQ(dialog->value(), 0);
  EXPECT_FALSE(dialog->autoClose());
  EXPECT_FALSE(dialog->autoReset());
  EXPECT_EQ(dialog->parentWidget(), &window);
  EXPECT_EQ(dialog->findChild<QPushButton*>()->text(), words("Stop"));
}

TEST(DialogForSaving, StartsWithTheFirstFormatAndHasRoomAroundItsFields) {
  const SaveDialog dialog(0, true, nullptr);
  EXPECT_EQ(dialog.format(), practice::FileFormat::raw);
  EXPECT_EQ(dialog.layout()->contentsMargins(), QMargins(20, 20, 20, 16));
  EXPECT_EQ(dialog.layout()->spacing(), 12);
}

TEST(ChoiceOfAList, EachIdHasItsName) {
  const std::pair<const char*, const char*> all[] = {
      {"grade-3", "Grade 3"},
      {"secondary", "Secondary school"},
      {"jinmeiyou", "Kanji for names"},
      {"hiragana", "Hiragana"},
      {"katakana", "Katakana"},
      {"own", "My characters"},
      {"old-jlpt-2", "Old JLPT level 2 (before 2010)"},
      {"list:few", "My list: few"},
      {"tag:hard", "Tag: hard"},
      {"other", "other"},
  };
  for (const auto& [id, name] : all) EXPECT_EQ(ListChoice::name_of(words(id)), words(name));
}

TEST(ChoiceOfAList, HoldsTheListsOfALearnerAndKeepsItsOwn) {
  const QTemporaryDir folder;
  auto store =
      study::LearnerStore::open(std::filesystem::path(folder.path().toStdString()) / "learner" / "learner.db",
                                study::Access::write, [] { return *study::parse_time("2026-03-02T10:00Z"); });
  ASSERT_TRUE(store);
  ListChoice choice;
  EXPECT_EQ(choice.count(), 1);
  EXPECT_EQ(choice.itemText(0), words("Studied so far"));
  EXPECT_EQ(choice.list(), QString());
  EXPECT_EQ(choice.minimumContentsLength(), 20);
  ASSERT_TRUE(store->save_list({"few", {U'休'}}));
  int changed = 0;
  QObject::connect(&choice, &QComboBox::currentIndexChanged, [&changed] { ++changed; });
  choice.fill(*store);
  EXPECT_EQ(changed, 0) << "nobody chose";
  EXPECT_EQ(choice.itemText(0), words("Studied so far"));
  EXPECT_GE(choice.findData(words("grade-1")), 1);
  EXPECT_EQ(choice.itemText(choice.findData(words("list:few"))), words("My list: few"));
  EXPECT_EQ(choice.currentIndex(), 0);
  choice.set_list(words("list:few"));
  EXPECT_EQ(choice.list(), words("list:few"));
  EXPECT_EQ(changed, 1);
  choice.fill(*store);
  EXPECT_EQ(choice.list(), words("list:few")) << "it stays chosen";
  choice.set_list(words("no such list"));
  EXPECT_EQ(choice.currentIndex(), 0);
}

/// A status line without a device of its own.
class StatusOfTheWindow : public testing::Test {
 protected:
  StatusOfTheWindow() {
    // Another test may have written with a pen.
    QMouseEvent mouse(QEvent::MouseMove, QPointF(), QPointF(), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&line_, &mouse);
    line_.resize(3000, 30);
    line_.show();
    line_.show_figures(true);
  }
  QLabel* label(const char* name) { return line_.findChild<QLabel*>(QString::fromLatin1(name)); }
  QTemporaryDir folder_;
  WindowTablet controller_;
  EventLoopInbox loop_;
  practice::TabletRecording recording_{loop_.inbox(), controller_.device(),
                                       unfinished_recordings(folder_.filePath(QStringLiteral("nazori.ini")))};
  StatusLine line_{controller_, recording_, nullptr};
};

TEST_F(StatusOfTheWindow, LeavesOutWholeFiguresWhereTheyDoNotFitTheLeastImportantFirst) {
  line_.show_depth(0.001);
  const char* const order[] = {"depth", "rate", "missed", "timing"};
  for (const char* name : order) EXPECT_TRUE(label(name)->isVisible()) << name;
  EXPECT_EQ(label("missed")->text(), words("0 missed"));
  EXPECT_TRUE(label("timing")->text().startsWith(words("update ")));
  const auto needed = [this](const char* name) { return label(name)->sizeHint().width() + 8; };
  // The whole sentence of the device, then the figures one by one.
  int width = 8 + needed("device");
  for (const char* name : order) {
    width += needed(name);
    line_.resize(width, 30);
    EXPECT_TRUE(label(name)->isVisible()) << name;
    line_.resize(width - 1, 30);
    EXPECT_FALSE(label(name)->isVisible()) << name;
    line_.resize(3000, 30);
  }
  line_.show_input(false);
  EXPECT_FALSE(label("device")->isVisible());
  line_.show_input(true);
  EXPECT_TRUE(label("device")->isVisible());
  line_.show_figures(false);
  for (const char* name : order) EXPECT_FALSE(label(name)->isVisible()) << name;
}

TEST_F(StatusOfTheWindow, TheSentenceOfTheDeviceBecomesShorterWhereThereIsLessRoom) {
  auto* device = label("device");
  const QStringList all = InputWatch::of_program().shorter_and_shorter();
  ASSERT_EQ(all.size(), 3);
  EXPECT_EQ(device->text(), all[0]);
  int before = 4000;
  for (const QString& one : all) {
    const QFontMetrics metrics(device->font());
    EXPECT_LT(metrics.horizontalAdvance(one), before);
    before = metrics.horizontalAdvance(one);
  }
  const auto width_of = [&](const QString& text) {
    QLabel like(text);
    like.setFont(device->font());
    like.ensurePolished();
    return like.sizeHint().width() + 8 + 8;
  };
  line_.resize(width_of(all[1]), 30);
  EXPECT_EQ(device->text(), all[1]);
  line_.resize(width_of(all[1]) - 1, 30);
  EXPECT_EQ(device->text(), all[2]);
  line_.resize(20, 30);
  EXPECT_EQ(device->text(), all[2]);
  EXPECT_TRUE(device->isVisible());
}

TEST(WhatTheLearnerWritesWith, IsNoticedAndSaidLongAndShort) {
  auto& watch = InputWatch::of_program();
  QWidget widget;
  const auto touch = [&](QEvent::Type type, QPointingDevice::PointerType kind) {
    const QPointingDevice device(words("d"), 70 + static_cast<int>(kind), QInputDevice::DeviceType::Mouse,
                                 kind, QInputDevice::Capability::Position, 1, 2);
    QMouseEvent event(type, QPointF(), QPointF(), Qt::NoButton, Qt::NoButton, {}, &device);
    QCoreApplication::sendEvent(&widget, &event);
  };
  int changes = 0;
  QObject::connect(&watch, &InputWatch::changed, &widget, [&changes] { ++changes; });
  touch(QEvent::MouseMove, QPointingDevice::PointerType::Finger);
  const int from = changes;
  EXPECT_EQ(watch.kind(), InputWatch::Kind::finger);
  EXPECT_EQ(watch.sentence({}), words("You are writing with your finger. A pen works better."));
  EXPECT_FALSE(watch.writes_with_button());
  EXPECT_EQ(watch.shorter_and_shorter(),
            (QStringList{watch.sentence({}), words("You are writing with your finger."), words("Finger")}));
  touch(QEvent::MouseMove, QPointingDevice::PointerType::Finger);
  EXPECT_EQ(changes, from) << "it is the same";
  touch(QEvent::MouseButtonPress, QPointingDevice::PointerType::Pen);
  EXPECT_EQ(watch.kind(), InputWatch::Kind::pen);
  EXPECT_EQ(changes, from + 1);
  EXPECT_EQ(watch.shorter_and_shorter()[2], words("Pen"));
  EXPECT_EQ(watch.sentence({}), words("You are writing with the pen."));
  touch(QEvent::MouseMove, QPointingDevice::PointerType::Eraser);
  EXPECT_EQ(watch.kind(), InputWatch::Kind::pen);
  touch(QEvent::MouseButtonRelease, QPointingDevice::PointerType::Generic);
  EXPECT_EQ(watch.kind(), InputWatch::Kind::pen) << "a release points at nothing";
  touch(QEvent::MouseMove, QPointingDevice::PointerType::Generic);
  EXPECT_EQ(watch.kind(), InputWatch::Kind::mouse);
  EXPECT_TRUE(watch.writes_with_button());
  EXPECT_EQ(watch.shorter_and_shorter()[2], words("Mouse"));
  watch.set_has_device(true);
  EXPECT_FALSE(watch.writes_with_button());
  watch.set_has_device(false);
  EXPECT_EQ(watch.sentence(words("the Phantom")), words("You are writing with the Phantom."));
}

}  // namespace
}  // namespace nazori::ui
