// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <vector>

#include "nazori/ui/main_window.h"
#include "preferences.h"
#include "workshop.h"

class QStackedWidget;

namespace nazori::ui {

class Actions;
class FeedbackLine;
class FileExchange;
class InformationPanel;
class Library;
class LibraryPanel;
class Panes;
class StatusLine;
class TabletController;
class TabletWindow;
class ToolBar;

/// The window's parts and what ties them together.
struct MainWindow::Inside {
  Inside(MainWindow& owner, const Setup& setup, Appearance& look);
  ~Inside();

  void build();
  void connect_actions();
  void connect_work();

  void choose(char32_t code_point, bool remember);
  void travel(int step);
  void take_sheet(const std::shared_ptr<const struct CharacterSheet>& sheet);
  void take_tablet(char32_t code_point, const Tablet& tablet);
  void take_own(const OwnTablet& loaded);
  void show_state();
  void apply_appearance();
  void set_text_size(int text_pt);
  void set_language(const QString& language);
  void set_full_screen(bool on);
  void save_later();
  void save_preferences();

  MainWindow& window;
  Appearance& appearance;
  QString settings_file;
  Preferences preferences;
  bool draws_tablet;

  Library* library = nullptr;
  Workshop* workshop = nullptr;
  TabletController* controller = nullptr;
  FileExchange* files = nullptr;
  Actions* actions = nullptr;
  ToolBar* tool_bar = nullptr;
  LibraryPanel* library_panel = nullptr;
  InformationPanel* information_panel = nullptr;
  FeedbackLine* feedback = nullptr;
  StatusLine* status = nullptr;
  Panes* panes = nullptr;
  TabletWindow* tablet_window = nullptr;  ///< null where nothing can be drawn
  QWidget* tablet_place = nullptr;

  OwnTablet own;               ///< loaded from files; empty while a character is on the desk
  char32_t asked = 0;          ///< the character on its way to the desk
  std::vector<char32_t> path;  ///< characters visited
  std::size_t step = 0;        ///< where in `path` we are
  std::vector<kanji::Source> sources;
  QTimer save_timer;
};

}  // namespace nazori::ui
