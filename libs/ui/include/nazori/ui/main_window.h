// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMainWindow>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/devices/back_end.h"
#include "nazori/study/time.h"

namespace nazori::ui {

class Appearance;

class WindowParts;
class Page;

/// The window: the carved tablet in the middle, the panels of the current page on its left and right, and one
/// sentence below. The pages are registered in src/window/pages.cpp. Every widget has an objectName.
class MainWindow final : public QMainWindow {
  Q_OBJECT
 public:
  struct Setup {
    std::filesystem::path database;        ///< kanji.db
    std::filesystem::path own_characters;  ///< folder of the characters that people made; empty: none
    QString settings_file;                 ///< INI; empty: nazori/nazori.ini in the XDG config home
    char32_t character = 0;                ///< to open with; 0: the last one
    QString page;                          ///< id of the page to begin with; empty: as the settings say
    std::filesystem::path learners;        ///< folder of the profiles; empty: study::profiles_folder()
    study::Clock clock;                    ///< for all that is study; empty: the computer's
    bool draws_tablet = true;              ///< false: no OpenGL (tests, machines without it)
    /// Makes the pages; empty: all that are registered.
    std::vector<std::unique_ptr<Page> (*)(WindowParts&)> pages;
    /// Makes the back ends for haptic devices; empty: all that the program knows.
    std::function<std::vector<std::unique_ptr<devices::BackEnd>>()> back_ends;
  };

  MainWindow(const Setup& setup, Appearance& appearance);
  ~MainWindow() override;

  /// Goes to a page by its id. An id that is not registered changes nothing.
  void go_to(const QString& page);
  /// Shows a character on the tablet. If the database does not have it, the window says so and changes
  /// nothing.
  void show_character(char32_t code_point);
  /// Opens height maps and stroke orders as if they had been dropped on the window.
  void open_files(const QStringList& paths);

 signals:
  /// A character is shown, with its tablet.
  void character_shown(char32_t code_point);
  /// Once: the window shows its first content.
  void opened();
  /// Another language was chosen and saved. The window must be made again.
  void language_chosen();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::ui
