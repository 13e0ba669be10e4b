// SPDX-License-Identifier: Apache-2.0
#include <QMessageBox>
#include <QTimer>
#include <algorithm>

#include "about_dialog.h"
#include "actions.h"
#include "appearance.h"
#include "error_text.h"
#include "feedback_line.h"
#include "file_exchange.h"
#include "information_panel.h"
#include "kanji_text.h"
#include "key_list_dialog.h"
#include "library.h"
#include "library_panel.h"
#include "main_window_inside.h"
#include "panes.h"
#include "status_line.h"
#include "stroke_teller.h"
#include "tablet_controller.h"
#include "tablet_window.h"
#include "tool_bar.h"

namespace nazori::ui {
namespace {

constexpr double kTurnStep_px = 40;
constexpr double kMoveStep_px = 60;
constexpr double kZoomStep = 1.25;
constexpr int kTextStep_pt = 2;

}  // namespace

void MainWindow::Inside::connect_actions() {
  const auto on = [this](QAction* action, auto&& what) {
    QObject::connect(action, &QAction::triggered, &window, std::forward<decltype(what)>(what));
  };
  const auto tell = [this](const StrokeTeller::Sentence& sentence) {
    if (!sentence.text.isEmpty()) feedback->say(sentence.kind, sentence.text);
  };
  const auto camera = [this, on](QAction* action, auto&& move) {
    on(action, [this, move] {
      if (tablet_window != nullptr) move(*tablet_window);
    });
  };

  on(actions->open, [this] { files->ask_and_open(own); });
  on(actions->save, [this] {
    const QString name = own.tablet ? own.name.section(QLatin1Char('.'), 0, 0) : to_text(preferences.kanji);
    files->ask_and_save(controller->tablet(), own, name);
  });
  on(actions->quit, [this] { window.close(); });

  on(actions->find, [this] {
    if (actions->full_screen->isChecked()) set_full_screen(false);
    panes->open_library(true);
    library_panel->focus_search();
  });
  on(actions->next_character, [this] {
    if (const char32_t next = library_panel->neighbour(+1)) choose(next, true);
  });
  on(actions->previous_character, [this] {
    if (const char32_t before = library_panel->neighbour(-1)) choose(before, true);
  });
  on(actions->back, [this] { travel(-1); });
  on(actions->forward, [this] { travel(+1); });

  on(actions->next_stroke, [this, tell] {
    controller->next_stroke();
    tell(StrokeTeller::stroke_shown(*controller));
  });
  on(actions->previous_stroke, [this, tell] {
    controller->previous_stroke();
    tell(StrokeTeller::stroke_shown(*controller));
  });
  on(actions->all_strokes, [this, tell] {
    controller->set_current_stroke(0);
    tell(StrokeTeller::stroke_shown(*controller));
  });
  on(actions->strokes, [this, tell](bool show) {
    controller->set_strokes_visible(show);
    tell(controller->snapping() ? StrokeTeller::snapping(*controller)
                                : StrokeTeller::invitation(*controller));
  });
  on(actions->numbers, [this](bool show) { controller->set_numbers_visible(show); });
  on(actions->arrows, [this](bool show) { controller->set_arrows_visible(show); });
  on(actions->snap, [this, tell](bool hold) {
    controller->set_snapping(hold);
    tell(StrokeTeller::snapping(*controller));
  });
  on(actions->clear_ink, [this, tell] {
    controller->clear_ink();
    tell(StrokeTeller::invitation(*controller));
  });

  on(actions->wood, [this] { controller->set_style(view::Style::wood); });
  on(actions->slate, [this] { controller->set_style(view::Style::slate); });
  on(actions->classic, [this] { controller->set_style(view::Style::classic); });
  const auto theme = [this](ThemeChoice choice) {
    return [this, choice] {
      preferences.theme = choice;
      apply_appearance();
      save_later();
    };
  };
  on(actions->theme_desktop, theme(ThemeChoice::desktop));
  on(actions->theme_light, theme(ThemeChoice::light));
  on(actions->theme_dark, theme(ThemeChoice::dark));
  on(actions->language_desktop, [this] { set_language({}); });
  on(actions->language_english, [this] { set_language(QStringLiteral("en")); });
  on(actions->language_japanese, [this] { set_language(QStringLiteral("ja")); });
  on(actions->text_larger, [this] { set_text_size(preferences.text_pt + kTextStep_pt); });
  on(actions->text_smaller, [this] { set_text_size(preferences.text_pt - kTextStep_pt); });
  on(actions->text_usual, [this] { set_text_size(Preferences::kMinText_pt); });
  on(actions->reduced_motion, [this](bool reduced) {
    preferences.reduced_motion = reduced;
    if (tablet_window != nullptr) tablet_window->set_reduced_motion(reduced);
    save_later();
  });
  on(actions->library, [this](bool open) { panes->open_library(open); });
  on(actions->information, [this](bool open) { panes->open_information(open); });
  on(actions->full_screen, [this](bool full) { set_full_screen(full); });

  camera(actions->turn_left, [](TabletWindow& w) { w.orbit_by(-kTurnStep_px, 0); });
  camera(actions->turn_right, [](TabletWindow& w) { w.orbit_by(kTurnStep_px, 0); });
  camera(actions->tilt_up, [](TabletWindow& w) { w.orbit_by(0, -kTurnStep_px); });
  camera(actions->tilt_down, [](TabletWindow& w) { w.orbit_by(0, kTurnStep_px); });
  camera(actions->move_left, [](TabletWindow& w) { w.pan_by(-kMoveStep_px, 0); });
  camera(actions->move_right, [](TabletWindow& w) { w.pan_by(kMoveStep_px, 0); });
  camera(actions->move_up, [](TabletWindow& w) { w.pan_by(0, -kMoveStep_px); });
  camera(actions->move_down, [](TabletWindow& w) { w.pan_by(0, kMoveStep_px); });
  camera(actions->zoom_in, [](TabletWindow& w) { w.zoom_by(kZoomStep); });
  camera(actions->zoom_out, [](TabletWindow& w) { w.zoom_by(1 / kZoomStep); });
  camera(actions->reset_view, [](TabletWindow& w) { w.reset_camera(); });

  on(actions->keys, [this] { KeyListDialog(*actions, &window).exec(); });
  on(actions->about, [this] { AboutDialog(sources, &window).exec(); });
}

void MainWindow::Inside::connect_work() {
  const auto tell = [this](const StrokeTeller::Sentence& sentence) {
    if (!sentence.text.isEmpty()) feedback->say(sentence.kind, sentence.text);
  };
  QObject::connect(library, &Library::opened, &window,
                   [this](const std::vector<kanji::Source>& read) { sources = read; });
  QObject::connect(library, &Library::failed, &window, [this](const base::Error& error) {
    feedback->say(Feedback::wrong, MainWindow::tr("The kanji database: %1.").arg(reason(error)));
  });
  QObject::connect(library, &Library::sheet_ready, &window,
                   [this](const std::shared_ptr<const CharacterSheet>& sheet) { take_sheet(sheet); });
  QObject::connect(library, &Library::sheet_missing, &window, [this](char32_t code_point) {
    feedback->say(Feedback::advice,
                  MainWindow::tr("%1 has no strokes in the database. The tablet is as it was.")
                      .arg(to_text(code_point)));
    if (!controller->tablet() && code_point != U'休') choose(U'休', false);
  });
  QObject::connect(workshop, &Workshop::carved, &window,
                   [this](char32_t code_point, const Tablet& tablet) { take_tablet(code_point, tablet); });
  QObject::connect(workshop, &Workshop::loaded, &window,
                   [this](const OwnTablet& loaded) { take_own(loaded); });
  QObject::connect(files, &FileExchange::say, &window,
                   [this](Feedback kind, const QString& sentence) { feedback->say(kind, sentence); });
  for (auto signal : {&LibraryPanel::character_chosen})
    QObject::connect(library_panel, signal, &window, [this](char32_t code_point) {
      choose(code_point, true);
      panes->close_drawers();
    });
  QObject::connect(library_panel, &LibraryPanel::list_changed, &window, [this] { save_later(); });
  QObject::connect(information_panel, &InformationPanel::character_chosen, &window,
                   [this](char32_t code_point) { choose(code_point, true); });
  QObject::connect(panes, &Panes::opened, &window, [this](bool left, bool right) {
    actions->library->setChecked(left);
    actions->information->setChecked(right);
    save_later();
  });
  QObject::connect(controller, &TabletController::state_changed, &window, [this] {
    show_state();
    save_later();
  });
  QObject::connect(
      controller, &TabletController::stroke_event, &window,
      [this, tell](InkEvent event, int stroke) { tell(StrokeTeller::about(event, stroke, *controller)); });
  QObject::connect(controller, &TabletController::depth_changed, status, &StatusLine::show_depth);
  QObject::connect(&appearance, &Appearance::changed, &window, [this] {
    actions->draw_icons();
    information_panel->refresh();
    if (tablet_window == nullptr) return;
    tablet_window->set_theme(appearance.is_dark() ? view::Theme::dark : view::Theme::light);
    tablet_window->set_text_size(preferences.text_pt);
  });
  if (tablet_window != nullptr) {
    tablet_window->set_reduced_motion(preferences.reduced_motion);
    QObject::connect(tablet_window, &TabletWindow::files_dropped, &window,
                     [this](const QStringList& paths) { window.open_files(paths); });
    QObject::connect(tablet_window, &TabletWindow::focus_leaves, &window, [this](bool forwards) {
      QWidget* next = forwards ? static_cast<QWidget*>(information_panel)
                               : library_panel->findChild<QWidget*>(QStringLiteral("character_grid"));
      window.activateWindow();
      next->setFocus(forwards ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    });
    QObject::connect(tablet_window, &TabletWindow::drawing_failed, &window, [this](const base::Error& error) {
      feedback->say(Feedback::wrong, MainWindow::tr("The tablet cannot be drawn: %1.").arg(reason(error)));
    });
  }
  if (const auto started = controller->start(); !started)
    feedback->say(Feedback::wrong,
                  MainWindow::tr("The stylus does not work: %1.").arg(reason(started.error())));
}

void MainWindow::Inside::choose(char32_t code_point, bool remember) {
  if (remember && (path.empty() || path[step] != code_point)) {
    // A new way from here: what lay ahead is forgotten.
    if (!path.empty()) path.resize(step + 1);
    path.push_back(code_point);
    step = path.size() - 1;
  }
  asked = code_point;
  library->request_sheet(code_point);
}

void MainWindow::Inside::travel(int by) {
  const auto to = static_cast<std::ptrdiff_t>(step) + by;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(path.size())) return;
  step = static_cast<std::size_t>(to);
  choose(path[step], false);
}

void MainWindow::Inside::take_sheet(const std::shared_ptr<const CharacterSheet>& sheet) {
  information_panel->show_character(sheet);
  library_panel->set_current(sheet->character.code_point);
  workshop->carve(sheet->character);
}

void MainWindow::Inside::take_tablet(char32_t code_point, const Tablet& tablet) {
  own = {};
  preferences.kanji = code_point;
  controller->set_tablet(tablet);
  window.setWindowTitle(MainWindow::tr("%1 – Nazori").arg(to_text(code_point)));
  const auto invitation = StrokeTeller::invitation(*controller);
  feedback->say(invitation.kind, invitation.text);
  save_later();
  emit window.character_shown(code_point);
}

void MainWindow::Inside::take_own(const OwnTablet& loaded) {
  own = loaded;
  controller->set_tablet(own.tablet);
  information_panel->show_own(own.name, own.map_size, controller->stroke_count());
  library_panel->set_current(0);
  window.setWindowTitle(MainWindow::tr("%1 – Nazori").arg(own.name));
  feedback->say(Feedback::good,
                own.has_strokes
                    ? MainWindow::tr("%1 is on the desk.").arg(own.name)
                    : MainWindow::tr("%1 is on the desk. A .str file adds its strokes.").arg(own.name));
}

void MainWindow::Inside::set_language(const QString& language) {
  if (preferences.language == language) return;
  preferences.language = language;
  save_preferences();
  emit window.language_chosen();
}

}  // namespace nazori::ui
