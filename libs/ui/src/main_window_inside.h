// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <memory>
#include <vector>

#include "desk.h"
#include "nazori/audio/stroke_sound.h"
#include "nazori/ui/main_window.h"
#include "workplace.h"

class QStackedWidget;

namespace nazori::ui {

class Actions;
class LearnerMenu;
class Panes;
class StatusLine;
class TabletWindow;
class ToolBar;
class WorkplaceRail;

/// The window's parts and what ties them together.
struct MainWindow::Inside {
  Inside(MainWindow& owner, const Setup& setup, Appearance& look);
  ~Inside();

  void build(const Setup& setup);
  void build_tablet(bool draws_tablet);
  void connect_actions();
  void connect_desk();
  void connect_tablet();

  void enter(Workplace& workplace);
  void show_title();
  void show_state();
  void apply_appearance();
  void take_appearance();
  void fit();
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
  audio::StrokeSound sound;  ///< hears the stylus of the desk, so it outlives it
  Desk desk;
  std::vector<std::unique_ptr<Workplace>> workplaces;
  Workplace* current = nullptr;

  Actions* actions = nullptr;
  LearnerMenu* learner_menu = nullptr;
  ToolBar* tool_bar = nullptr;
  WorkplaceRail* rail = nullptr;
  FeedbackLine* feedback = nullptr;
  StatusLine* status = nullptr;
  Panes* panes = nullptr;
  QStackedWidget* stage = nullptr;        ///< the panes, or a workplace's page
  TabletWindow* tablet_window = nullptr;  ///< null where nothing can be drawn
  QWidget* tablet_place = nullptr;

  std::vector<kanji::Source> sources;
  QTimer save_timer;
};

}  // namespace nazori::ui
