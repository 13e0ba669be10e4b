// SPDX-License-Identifier: Apache-2.0
// Switches of the whole window: what they do, announce and save.
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMenuBar>
#include <QSettings>
#include <QSignalSpy>
#include <QToolButton>

#include "nazori/widgets/look/palette.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

class Switches : public WindowTest {
 protected:
  Preferences kept() {
    window_->close();
    return Preferences::load(folder_.filePath(QStringLiteral("nazori.ini")));
  }
};

TEST_F(Switches, TheGrooveSoundsBetweenATenthAndAllOfItsLoudness) {
  press(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Volume 60%."));
  for (int i = 0; i < 5; ++i) action("sound_louder")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("Volume 100%."));
  action("sound_softer")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("Volume 90%."));
  for (int i = 0; i < 9; ++i) action("sound_softer")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("Volume 10%."));
  EXPECT_NEAR(kept().sound_volume, 0.1, 1e-9);
}

TEST_F(Switches, EachIsKeptAndSetAgainByTheNextWindow) {
  for (const char* name : {"slope_help", "reduced_motion"}) {
    EXPECT_FALSE(action(name)->isChecked()) << name;
    action(name)->trigger();
  }
  const Preferences first = kept();
  EXPECT_TRUE(first.slope_help);
  EXPECT_TRUE(first.reduced_motion);
  EXPECT_FALSE(first.groove_sound);
  open_window();
  for (const char* name : {"slope_help", "reduced_motion"}) EXPECT_TRUE(action(name)->isChecked()) << name;
  for (const char* name : {"slope_help", "reduced_motion"}) action(name)->trigger();
  const Preferences second = kept();
  EXPECT_FALSE(second.slope_help);
  EXPECT_FALSE(second.reduced_motion);
}

TEST_F(Switches, TheLookOfTheTabletIsOneOfThree) {
  const auto* tool = find<QToolButton>("tool_style");
  const std::pair<const char*, const char*> looks[] = {
      {"slate", "Slate"}, {"classic", "Classic"}, {"wood", "Wood"}, {"slate", "Slate"}};
  EXPECT_TRUE(action("wood")->isChecked());
  EXPECT_EQ(tool->text(), QStringLiteral("Wood  ▾"));
  for (const auto& [name, words] : looks) {
    action(name)->trigger();
    EXPECT_EQ(tool->text(), QString::fromLatin1(words) + QStringLiteral("  ▾"));
    EXPECT_EQ(tool->accessibleName(), QStringLiteral("Tablet style: ") + QString::fromLatin1(words));
    for (const char* other : {"wood", "slate", "classic"})
      EXPECT_EQ(action(other)->isChecked(), QLatin1String(other) == QLatin1String(name)) << other;
  }
  EXPECT_EQ(kept().style, view::Style::slate);
  open_window();
  EXPECT_TRUE(action("slate")->isChecked());
}

TEST_F(Switches, ColoursAreThoseThatWereChosen) {
  const std::pair<const char*, bool> themes[] = {{"theme_dark", true}, {"theme_light", false}};
  for (const auto& [name, dark] : themes) {
    action(name)->trigger();
    EXPECT_EQ(is_dark(QApplication::palette()), dark);
    EXPECT_EQ(appearance_.is_dark(), dark);
    EXPECT_TRUE(action(name)->isChecked());
    EXPECT_FALSE(action("theme_desktop")->isChecked());
  }
  EXPECT_EQ(kept().theme, ThemeChoice::light);
  open_window();
  EXPECT_TRUE(action("theme_light")->isChecked());
  action("theme_desktop")->trigger();
  EXPECT_EQ(kept().theme, ThemeChoice::desktop);
}

TEST_F(Switches, TextGoesInStepsOfTwoPointsAndIsKept) {
  EXPECT_FALSE(action("text_smaller")->isEnabled()) << "12 is the least";
  EXPECT_TRUE(action("text_larger")->isEnabled());
  action("text_larger")->trigger();
  EXPECT_EQ(QApplication::font().pointSize(), 14);
  EXPECT_EQ(kept().text_pt, 14);
  EXPECT_TRUE(action("text_smaller")->isEnabled());
  action("text_smaller")->trigger();
  EXPECT_EQ(QApplication::font().pointSize(), 12);
  EXPECT_FALSE(action("text_smaller")->isEnabled());
}

TEST_F(Switches, AnotherLanguageIsAskedForOnceAndTheSameOneNot) {
  QSignalSpy chosen(window_.get(), &MainWindow::language_chosen);
  EXPECT_TRUE(action("language_desktop")->isChecked());
  action("language_desktop")->trigger();
  EXPECT_EQ(chosen.count(), 0);
  action("language_japanese")->trigger();
  EXPECT_EQ(chosen.count(), 1);
  action("language_english")->trigger();
  EXPECT_EQ(chosen.count(), 2);
  EXPECT_EQ(kept().language, QStringLiteral("en"));
  open_window();
  EXPECT_TRUE(action("language_english")->isChecked());
}

TEST_F(Switches, FoldedPanelsStayFoldedInTheNextWindow) {
  action("left_panel")->trigger();
  EXPECT_FALSE(kept().left_open);
  open_window();
  EXPECT_FALSE(find("library_panel")->isVisible());
  EXPECT_TRUE(find("information_panel")->isVisible());
  EXPECT_FALSE(action("left_panel")->isChecked());
  EXPECT_TRUE(action("right_panel")->isChecked());
  action("right_panel")->trigger();
  action("left_panel")->trigger();
  const Preferences then = kept();
  EXPECT_TRUE(then.left_open);
  EXPECT_FALSE(then.right_open);
}

TEST_F(Switches, SettingsAreSavedSoonAfterTheyChangeWithoutClosing) {
  action("reduced_motion")->trigger();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return Preferences::load(folder_.filePath(QStringLiteral("nazori.ini"))).reduced_motion; },
      20'000));
}

TEST_F(Switches, InFullScreenNothingButTheTabletAndItsSentenceIsLeft) {
  press(Qt::Key_F11);
  EXPECT_TRUE(action("full_screen")->isChecked());
  EXPECT_TRUE(window_->windowState().testFlag(Qt::WindowFullScreen));
  for (const char* name : {"menu_bar", "tool_bar", "status_line", "page_rail"})
    EXPECT_FALSE(find(name)->isVisible()) << name;
  press(Qt::Key_Escape);
  EXPECT_FALSE(action("full_screen")->isChecked());
  EXPECT_FALSE(window_->windowState().testFlag(Qt::WindowFullScreen));
  for (const char* name : {"menu_bar", "tool_bar", "status_line", "page_rail"})
    EXPECT_TRUE(find(name)->isVisible()) << name;
}

TEST_F(Switches, WhatTheWindowSystemMakesFullScreenIsFullScreen) {
  window_->showFullScreen();
  EXPECT_TRUE(QTest::qWaitFor([this] { return action("full_screen")->isChecked(); }, 5000));
  EXPECT_FALSE(window_->menuBar()->isVisible());
  window_->showNormal();
  EXPECT_TRUE(QTest::qWaitFor([this] { return !action("full_screen")->isChecked(); }, 5000));
  EXPECT_TRUE(window_->menuBar()->isVisible());
}

TEST_F(Switches, SettingsThatCannotBeSavedAreSaidToHoldUntilTheEnd) {
  const QString file = folder_.filePath(QStringLiteral("nazori.ini"));
  QFile::remove(file);
  ASSERT_TRUE(QDir().mkpath(file + QStringLiteral("/in the way")));
  window_->close();
  EXPECT_EQ(
      feedback(),
      QStringLiteral("Settings could not be saved in %1. They apply until you close Nazori.").arg(file));
}

}  // namespace
}  // namespace nazori::ui
