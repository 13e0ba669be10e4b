// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QTimer>
#include <memory>
#include <vector>

#include "nazori/audio/stroke_sound.h"
#include "nazori/ui/main_window.h"
#include "nazori/widgets/page/page.h"
#include "nazori/widgets/page/window_parts.h"

class QStackedWidget;

namespace nazori::ui {

class Actions;
class LearnerMenu;
class Panes;
class StatusLine;
class TabletWindow;
class ToolBar;
class PageRail;

/// The widgets of the window and their connections.
struct MainWindow::Inside {
  Inside(MainWindow& owner, const Setup& setup, Appearance& look);
  ~Inside();

  void build(const Setup& setup);
  void build_tablet(bool draws_tablet);
  void connect_actions();
  void connect_parts();
  void connect_tablet();

  void enter(Page& page);
  void show_title();
  void show_state();
  void apply_appearance();
  void refresh_appearance();
  void fit();
  /// Folds away what the page needs no room for.
  void show_room();
  void set_text_size(int text_pt);
  void set_language(const QString& language);
  void record(bool on);
  void connect_recording();
  void connect_sound();
  void set_full_screen(bool on);
  void focus_tablet();
  void leave_tablet(bool forwards);
  /// Asks first if a writing is not rated yet. @param quits  false: the window closes to open again.
  [[nodiscard]] bool may_close(bool quits);
  void save_later();
  void save_preferences();

  MainWindow& window;
  Appearance& appearance;
  audio::StrokeSound sound;  ///< the stylus calls it, so it must outlive `parts`
  WindowParts parts;
  std::vector<std::unique_ptr<Page>> pages;
  Page* current = nullptr;
  QHash<const Page*, QAction*> entries;  ///< of the pages in the rail

  Actions* actions = nullptr;
  LearnerMenu* learner_menu = nullptr;
  ToolBar* tool_bar = nullptr;
  PageRail* rail = nullptr;
  FeedbackLine* feedback = nullptr;
  StatusLine* status = nullptr;
  Panes* panes = nullptr;
  QStackedWidget* stage = nullptr;        ///< the panes, or the widget of a page that replaces them
  TabletWindow* tablet_window = nullptr;  ///< null where nothing can be drawn
  QWidget* tablet_container = nullptr;

  std::vector<kanji::Source> sources;
  QTimer save_timer;
  QTimer disk_timer;  ///< looks whether the disk of a recording is full
};

}  // namespace nazori::ui
