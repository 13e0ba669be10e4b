// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "nazori/devices/device_catalogue.h"
#include "nazori/ui/main_window.h"
#include "nazori/widgets/look/appearance.h"
#include "nazori/widgets/page/page.h"
#include "nazori/widgets/settings/preferences.h"
#include "print_qt.h"
#include "window/language.h"

namespace nazori::ui {

/// The real window with the real database, without OpenGL, with settings in its own folder.
class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    install_language(QStringLiteral("en"));
    open_window();
  }

  /// The setup of a window without OpenGL, with settings and learners in a folder of the test.
  [[nodiscard]] MainWindow::Setup setup() const {
    MainWindow::Setup made;
    made.database = std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db";
    made.settings_file = folder_.filePath(QStringLiteral("nazori.ini"));
    made.learners = folder_.filePath(QStringLiteral("learners")).toStdString();
    made.own_characters = own_characters_.toStdString();
    made.clock = clock_;
    made.draws_tablet = false;
    made.pages = pages_;
    made.back_ends = back_ends_;
    return made;
  }

  void open_window(char32_t character = 0, QSize size = {1280, 800}) {
    window_.reset();
    begin_with_characters();
    MainWindow::Setup first = setup();
    first.character = character;
    window_ = std::make_unique<MainWindow>(first, appearance_);
    QSignalSpy shown(window_.get(), &MainWindow::character_shown);
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    ASSERT_TRUE(shown.wait(20000)) << feedback().toStdString();
    // The screen of the tests is smaller than a learner's.
    if (size.isValid()) window_->resize(size);
    QCoreApplication::processEvents();
  }

  /// The settings of a learner who does not start with Home, so that there is a tablet at once.
  void begin_with_characters() {
    QSettings settings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat);
    if (settings.contains(QStringLiteral("study/begin_at_home"))) return;
    settings.setValue(QStringLiteral("study/begin_at_home"), false);
    settings.setValue(QStringLiteral("window/workplace"), QStringLiteral("characters"));
  }

  void show(char32_t character) {
    QSignalSpy shown(window_.get(), &MainWindow::character_shown);
    window_->show_character(character);
    ASSERT_TRUE(shown.wait(20000)) << feedback().toStdString();
  }

  /// Gives the window another size and lays its contents out for it.
  void resize(int width, int height) {
    window_->resize(width, height);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_->size() == QSize(width, height); }));
    // A layout may ask for another pass, once for each level of nesting.
    for (int pass = 0; pass < 5; ++pass) {
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
    }
  }

  /// Sets the text size in one step. The menu entry changes it by 2 points at a time, with a new layout of
  /// the window for each.
  void set_text_size(int text_pt, int width = 1280, int height = 800) {
    appearance_.apply(ThemeChoice::desktop, text_pt);
    // The window fits its parts only where its size changes.
    resize(width + 1, height);
    resize(width, height);
  }

  template <class T = QWidget>
  T* find(const char* name) {
    return window_->findChild<T*>(QString::fromUtf8(name));
  }
  QAction* action(const char* name) { return window_->findChild<QAction*>(QString::fromLatin1(name)); }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
  QString feedback() { return text("feedback_text"); }
  QStringList texts(const char* labels) {
    QStringList all;
    for (const auto* label : window_->findChildren<QLabel*>(QString::fromLatin1(labels)))
      if (!label->isHidden()) all.append(label->text());
    return all;
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* at = window_->focusWidget() != nullptr ? window_->focusWidget() : window_.get();
    QTest::keyClick(at, key, modifiers);
  }

  /// No test may open a device that is plugged in.
  std::function<std::vector<std::unique_ptr<devices::BackEnd>>()> back_ends_ = [] {
    std::vector<std::unique_ptr<devices::BackEnd>> all;
    all.push_back(devices::pointer_back_end());
    all.push_back(devices::simulated_back_end());
    return all;
  };
  study::Clock clock_;           ///< empty: the computer's
  QString own_characters_;       ///< folder of own characters; empty: none
  std::vector<MakePage> pages_;  ///< empty: all that are registered
  QTemporaryDir folder_;
  Appearance appearance_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace nazori::ui
