// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>

#include "nazori/ui/main_window.h"

namespace nazori::ui {

class Appearance;

/// The desktop program: its window, and a new window when the learner changes the language. Needs a
/// QApplication. Thread: interface.
class Program final : public QObject {
  Q_OBJECT
 public:
  explicit Program(MainWindow::Setup setup);
  ~Program() override;

  /// Sets language, colours and icon, and opens the window.
  void show();
  [[nodiscard]] MainWindow* window() const { return window_.get(); }

  /// What must be set before the QApplication is made: the kind of OpenGL that the tablet needs.
  static void prepare();
  /// Shows a message box that says why the program cannot start.
  static void show_failure(const base::Error& error);

 private:
  void open_window();

  MainWindow::Setup setup_;
  std::unique_ptr<Appearance> appearance_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace nazori::ui
