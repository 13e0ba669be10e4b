// SPDX-License-Identifier: Apache-2.0
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "nazori/widgets/controls/focus_frame.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using Keys = WindowTest;

TEST_F(Keys, FullStopAndCommaStepThroughTheStrokesAndWrapThroughAll) {
  find<QListView>("character_grid")->setFocus();
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 6 strokes"));
  press(Qt::Key_Period);
  EXPECT_EQ(text("stroke_label"), QStringLiteral("stroke 1 of 6"));
  press(Qt::Key_Comma);
  press(Qt::Key_Comma);
  EXPECT_EQ(text("stroke_label"), QStringLiteral("stroke 6 of 6"));
  press(Qt::Key_Period);
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 6 strokes"));
}

TEST_F(Keys, SAndFSwitchStrokesAndSnapping) {
  find<QListView>("character_grid")->setFocus();
  EXPECT_TRUE(action("strokes")->isChecked());
  EXPECT_FALSE(action("snap")->isChecked());
  press(Qt::Key_S);
  press(Qt::Key_F);
  EXPECT_FALSE(action("strokes")->isChecked());
  EXPECT_TRUE(action("snap")->isChecked());
  EXPECT_TRUE(feedback().contains(QStringLiteral("only while strokes are visible")))
      << feedback().toStdString();
}

TEST_F(Keys, LettersTypedIntoTheSearchBoxAreOnlyLetters) {
  auto* search = find<QLineEdit>("search");
  search->setFocus();
  ASSERT_TRUE(search->hasFocus());
  QTest::keyClicks(search, QStringLiteral("sfq.,n"));
  EXPECT_EQ(search->text(), QStringLiteral("sfq.,n"));
  EXPECT_TRUE(action("strokes")->isChecked());
  EXPECT_FALSE(action("snap")->isChecked());
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 6 strokes"));
  EXPECT_TRUE(window_->isVisible());
}

TEST_F(Keys, QClosesTheWindow) {
  find<QListView>("character_grid")->setFocus();
  press(Qt::Key_Q);
  EXPECT_FALSE(window_->isVisible());
}

TEST_F(Keys, ControlFGoesToTheSearchBoxEvenWhereItIsFoldedAway) {
  action("left_panel")->trigger();
  ASSERT_FALSE(find("library_panel")->isVisible());
  press(Qt::Key_F, Qt::ControlModifier);
  EXPECT_TRUE(find("library_panel")->isVisible());
  EXPECT_TRUE(find<QLineEdit>("search")->hasFocus());
}

TEST_F(Keys, F2AndF3FoldThePanelsAwayAndBack) {
  press(Qt::Key_F2);
  EXPECT_FALSE(find("library_panel")->isVisible());
  press(Qt::Key_F3);
  EXPECT_FALSE(find("information_panel")->isVisible());
  press(Qt::Key_F2);
  press(Qt::Key_F3);
  EXPECT_TRUE(find("library_panel")->isVisible());
  EXPECT_TRUE(find("information_panel")->isVisible());
}

TEST_F(Keys, APanelThatF2OrF3OpensHasTheKeyboardAndGivesItBackToTheTablet) {
  for (const auto& [key, panel] :
       {std::pair{Qt::Key_F2, "library_panel"}, {Qt::Key_F3, "information_panel"}}) {
    const auto has_keyboard = [name = panel, this] {
      const auto* focus = QApplication::focusWidget();
      return focus != nullptr && find(name)->isAncestorOf(focus);
    };
    press(key);
    ASSERT_FALSE(find(panel)->isVisible());
    EXPECT_FALSE(has_keyboard());
    press(key);
    ASSERT_TRUE(find(panel)->isVisible());
    EXPECT_TRUE(has_keyboard()) << panel;
    press(key);
    EXPECT_FALSE(has_keyboard());
  }
}

TEST_F(Keys, APanelThatIsOpenedAgainGivesTheKeyboardToTheControlThatHadIt) {
  find("character_grid")->setFocus();
  press(Qt::Key_F2);
  press(Qt::Key_F2);
  EXPECT_TRUE(find("character_grid")->hasFocus());
}

TEST_F(Keys, F11LeavesOnlyTheTabletAndTheFeedbackAndEscapeComesBack) {
  press(Qt::Key_F11);
  EXPECT_FALSE(find("library_panel")->isVisible());
  EXPECT_FALSE(find("information_panel")->isVisible());
  EXPECT_FALSE(find<QToolBar>("tool_bar")->isVisible());
  EXPECT_TRUE(find("feedback_line")->isVisible());
  press(Qt::Key_Escape);
  EXPECT_TRUE(find("library_panel")->isVisible());
  EXPECT_TRUE(find<QToolBar>("tool_bar")->isVisible());
}

TEST_F(Keys, EveryMenuEntryShowsAKeyAndNoKeyIsGivenTwice) {
  QStringList keys;
  for (const auto* menu : find<QMenuBar>("menu_bar")->findChildren<QMenu*>())
    for (const auto* entry : menu->actions()) {
      if (entry->isSeparator() || entry->menu() != nullptr) continue;
      EXPECT_FALSE(entry->shortcut().isEmpty()) << entry->text().toStdString();
      for (const auto& key : entry->shortcuts()) keys.append(key.toString());
    }
  EXPECT_GT(keys.size(), 40);
  EXPECT_EQ(keys.removeDuplicates(), 0);
}

TEST_F(Keys, F10OpensTheFirstMenuAndAltAloneNone) {
  auto* bar = find<QMenuBar>("menu_bar");
  press(Qt::Key_F10);
  ASSERT_NE(bar->activeAction(), nullptr);
  EXPECT_EQ(bar->activeAction(), bar->actions().constFirst());
  EXPECT_TRUE(bar->activeAction()->menu()->isVisible());
  bar->activeAction()->menu()->close();
  find<QListView>("character_grid")->setFocus();
  QTest::keyClick(find<QListView>("character_grid"), Qt::Key_Alt, Qt::AltModifier);
  EXPECT_FALSE(bar->hasFocus());
}

TEST_F(Keys, EachEntryOfAMenuHasALetterOfItsOwnOnEveryPageInBothLanguages) {
  for (const char* language : {"en", "ja"}) {
    window_.reset();
    install_language(QString::fromLatin1(language));
    open_window();
    auto* bar = find<QMenuBar>("menu_bar");
    const auto expect_letters = [&](const QList<QAction*>& entries, const QString& where) {
      QString letters;
      for (const auto* entry : entries) {
        if (entry->isSeparator() || !entry->isVisible()) continue;
        const auto mark = entry->text().indexOf(QLatin1Char('&'));
        EXPECT_GE(mark, 0) << where.toStdString() << ": " << entry->text().toStdString();
        const QChar letter = entry->text().at(mark + 1).toLower();
        EXPECT_FALSE(letters.contains(letter)) << where.toStdString() << ": " << entry->text().toStdString();
        letters += letter;
      }
    };
    for (int page = Qt::Key_1; page <= Qt::Key_7; ++page) {
      press(static_cast<Qt::Key>(page), Qt::AltModifier);
      expect_letters(bar->actions(), QStringLiteral("page %1").arg(page - Qt::Key_0));
      for (const auto* title : bar->actions()) expect_letters(title->menu()->actions(), title->text());
    }
  }
  install_language(QStringLiteral("en"));
}

TEST_F(Keys, TheTextGrowsFrom12To28PointsAndNoFurther) {
  // Each step needs a new layout of the window, so the test starts shortly before the last size.
  window_.reset();
  QSettings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat)
      .setValue(QStringLiteral("window/text_pt"), 24);
  open_window();
  for (int i = 0; i < 4; ++i) press(Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_EQ(QApplication::font().pointSize(), 28);
  EXPECT_FALSE(action("text_larger")->isEnabled());
  press(Qt::Key_Minus, Qt::ControlModifier);
  EXPECT_EQ(QApplication::font().pointSize(), 26);
  action("text_usual")->trigger();
  EXPECT_EQ(QApplication::font().pointSize(), 12);
  press(Qt::Key_Minus, Qt::ControlModifier);
  EXPECT_EQ(QApplication::font().pointSize(), 12);
}

TEST_F(Keys, TheRingIsShownWhenTheTabletIsReachedByKeyAndNotByClick) {
  auto* frame = find<FocusFrame>("tablet_frame");
  ASSERT_NE(frame, nullptr);
  find<QLineEdit>("search")->setFocus();
  EXPECT_FALSE(frame->shows_ring());
  // The focus comes not by Tab but after a key of the window.
  press(Qt::Key_Period);
  find("tablet")->setFocus(Qt::OtherFocusReason);
  EXPECT_TRUE(frame->shows_ring());
  QTest::mouseClick(frame, Qt::LeftButton);
  EXPECT_FALSE(frame->shows_ring());
  QTest::keyClick(find("tablet"), Qt::Key_Shift);
  EXPECT_TRUE(frame->shows_ring());
  find<QLineEdit>("search")->setFocus();
  EXPECT_FALSE(frame->shows_ring());
}

}  // namespace
}  // namespace nazori::ui
