// SPDX-License-Identifier: Apache-2.0
#include <QComboBox>
#include <QLineEdit>
#include <QPointer>
#include <QToolButton>

#include "nazori/ui/program.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using Memory = WindowTest;

TEST_F(Memory, TheLastKanjiAndTheTogglesSurviveARestart) {
  show(U'雨');
  action("snap")->trigger();
  action("numbers")->trigger();
  action("slate")->trigger();
  action("theme_dark")->trigger();
  action("text_larger")->trigger();
  action("right_panel")->trigger();
  window_->resize(612, 577);
  window_->close();
  open_window(0, {});
  EXPECT_EQ(window_->size(), QSize(612, 577));
  window_->resize(1280, 800);
  QCoreApplication::processEvents();
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("雨 – Nazori"));
  EXPECT_TRUE(action("snap")->isChecked());
  EXPECT_FALSE(action("numbers")->isChecked());
  EXPECT_TRUE(action("slate")->isChecked());
  EXPECT_TRUE(action("theme_dark")->isChecked());
  EXPECT_TRUE(appearance_.is_dark());
  EXPECT_EQ(QApplication::font().pointSize(), 14);
  EXPECT_FALSE(find("information_panel")->isVisible());
  EXPECT_TRUE(find("library_panel")->isVisible());
}

TEST_F(Memory, ACharacterAskedForAtStartWinsOverTheLastOne) {
  open_window(U'水');
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("水 – Nazori"));
}

TEST_F(Memory, AnotherLanguageIsSavedAndAskedFor) {
  const QSignalSpy chosen(window_.get(), &MainWindow::language_chosen);
  action("language_japanese")->trigger();
  EXPECT_EQ(chosen.count(), 1);
  install_language(QStringLiteral("ja"));
  open_window();
  EXPECT_TRUE(action("language_japanese")->isChecked());
  EXPECT_EQ(text("stroke_label"), QStringLiteral("全6画"));
  EXPECT_TRUE(text("facts").contains(QStringLiteral("小学1年")));
  install_language(QStringLiteral("en"));
}

TEST_F(Memory, TheTabletKeepsHalfOfTheWidthAtEverySize) {
  for (const int width : {1000, 1100, 1280, 1600, 1920}) {
    resize(width, 800);
    EXPECT_GE(find("tablet")->width(), width / 2 - 1) << width;
  }
}

TEST_F(Memory, BelowAThousandPixelsThePanelsAreDrawersOneAtATime) {
  resize(900, 700);
  EXPECT_FALSE(find("library_panel")->isVisible());
  EXPECT_FALSE(find("information_panel")->isVisible());
  action("left_panel")->trigger();
  EXPECT_TRUE(find("library_panel")->isVisible());
  action("right_panel")->trigger();
  EXPECT_FALSE(find("library_panel")->isVisible());
  EXPECT_TRUE(find("information_panel")->isVisible());
  EXPECT_GE(find("tablet")->width(), 449);
  resize(1280, 800);
  EXPECT_TRUE(find("library_panel")->isVisible());
  EXPECT_TRUE(find("information_panel")->isVisible());
}

TEST_F(Memory, TheStatusLineShowsAnEntryWholeOrNotAtAll) {
  for (const int width : {1280, 900, 640}) {
    resize(width, 700);
    int shown = 0;
    for (const char* name : {"device", "depth", "rate", "missed", "timing"}) {
      const auto* label = find<QLabel>(name);
      if (!label->isVisible()) continue;
      ++shown;
      EXPECT_GE(label->width(), label->sizeHint().width()) << name << " at " << width;
    }
    EXPECT_GE(shown, 1) << width;
  }
}

TEST_F(Memory, TheStagesAreTheLastToLoseTheirWords) {
  for (const char* stage : {"watch", "trace", "guided", "memory"}) {
    action(stage)->trigger();
    for (const int width : {1600, 1280, 1100, 900}) {
      resize(width, 800);
      const auto has_words = [this](const char* tool) {
        const auto* button = find<QToolButton>(tool);
        return button != nullptr && button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
      };
      for (const char* own : {"tool_play", "tool_arrows", "tool_by_groove", "tool_hint"})
        EXPECT_TRUE(!has_words(own) || has_words("tool_watch")) << own << " at " << width;
    }
  }
}

TEST_F(Memory, WhatCanBePressedHasANameForTheScreenReader) {
  for (const char* name :
       {"search", "lists", "character_grid", "tablet", "information_panel", "feedback_line"})
    EXPECT_FALSE(find(name)->accessibleName().isEmpty()) << name;
}

TEST_F(Memory, AWindowInAnotherLanguageBeginsWhereTheLearnerWas) {
  window_.reset();
  MainWindow::Setup elsewhere = setup();
  QSettings(elsewhere.settings_file, QSettings::IniFormat)
      .setValue(QStringLiteral("study/begin_at_home"), true);
  Program program(elsewhere);
  program.show();
  program.window()->go_to(QStringLiteral("functions"));
  const QString before = program.window()->windowTitle();
  EXPECT_TRUE(before.contains(QLatin1Char('='))) << before.toStdString();
  const QPointer<MainWindow> old(program.window());
  program.window()->findChild<QAction*>(QStringLiteral("language_japanese"))->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return old.isNull(); }));
  EXPECT_EQ(program.window()->windowTitle(), before);
  EXPECT_TRUE(program.window()->findChild<QAction*>(QStringLiteral("language_japanese"))->isChecked());
  install_language(QStringLiteral("en"));
}

}  // namespace
}  // namespace nazori::ui
