// SPDX-License-Identifier: Apache-2.0
#include <QDateTime>
#include <QFileDialog>
#include <QFontInfo>
#include <QMenuBar>
#include <algorithm>
#include <cmath>

#include "nazori/practice/session_question.h"
#include "nazori/studio/print/sheet_check_dialog.h"
#include "nazori/studio/print/worksheet_dialog.h"
#include "nazori/widgets/controls/feedback_line.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/controls/panes.h"
#include "nazori/widgets/controls/status_line.h"
#include "nazori/widgets/dialogs/about_dialog.h"
#include "nazori/widgets/dialogs/key_list_dialog.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/look/appearance.h"
#include "nazori/widgets/tablet/tablet_window.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "window/actions.h"
#include "window/main_window_inside.h"
#include "window/page_rail.h"
#include "window/tool_bar.h"

namespace nazori::ui {
namespace {

QString names(const std::vector<std::filesystem::path>& files) {
  QStringList list;
  for (const auto& file : files) list.append(to_text(file.string()));
  return list.join(QStringLiteral(", "));
}

constexpr int kLargeText_pt = 20;
constexpr double kTurnStep_px = 40;
constexpr double kMoveStep_px = 60;
constexpr double kZoomStep = 1.25;
constexpr int kTextStep_pt = 2;

/// The first or last widget of a panel that the Tab key stops at.
QWidget* tab_stop(QWidget* panel, bool last) {
  if (panel == nullptr) return nullptr;
  QWidget* found = nullptr;
  const auto stops = [](const QWidget* w) {
    return w->isVisible() && w->isEnabled() && (w->focusPolicy() & Qt::TabFocus) != 0;
  };
  if (stops(panel)) found = panel;
  for (auto* w = panel->nextInFocusChain(); w != panel && (last || found == nullptr);
       w = w->nextInFocusChain())
    if (panel->isAncestorOf(w) && stops(w)) found = w;
  return found;
}

}  // namespace

void MainWindow::Inside::connect_actions() {
  const auto on = [this](QAction* action, auto&& what) {
    QObject::connect(action, &QAction::triggered, &window, std::forward<decltype(what)>(what));
  };
  const auto camera = [this, on](QAction* action, auto&& move) {
    on(action, [this, move] {
      if (tablet_window != nullptr) move(*tablet_window);
    });
  };

  // After a dialog the focus returns to the tablet.
  on(actions->open, [this] {
    current->ask_and_open();
    focus_tablet();
  });
  on(actions->save, [this] {
    current->ask_and_save();
    focus_tablet();
  });
  on(actions->print, [this] { ask_worksheet(parts); });
  on(actions->check_sheets, [this] { ask_sheet_check(parts); });
  on(actions->record, [this](bool wanted) {
    record(wanted);
    focus_tablet();
  });
  on(actions->quit, [this] { window.close(); });

  auto* controller = &parts.tablet();
  on(actions->wood, [controller] { controller->set_style(view::Style::wood); });
  on(actions->slate, [controller] { controller->set_style(view::Style::slate); });
  on(actions->classic, [controller] { controller->set_style(view::Style::classic); });
  const auto theme = [this](ThemeChoice choice) {
    return [this, choice] {
      parts.preferences().theme = choice;
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
  on(actions->text_larger, [this] { set_text_size(parts.preferences().text_pt + kTextStep_pt); });
  on(actions->text_smaller, [this] { set_text_size(parts.preferences().text_pt - kTextStep_pt); });
  on(actions->text_usual, [this] { set_text_size(Preferences::kMinText_pt); });
  on(actions->reduced_motion, [this](bool reduced) {
    parts.preferences().reduced_motion = reduced;
    parts.practice().watch().set_reduced_motion(reduced);
    if (tablet_window != nullptr) tablet_window->set_reduced_motion(reduced);
    save_later();
  });
  on(actions->left_handed, [this](bool left) {
    parts.preferences().left_handed = left;
    emit parts.study_settings_changed();
    save_later();
  });
  on(actions->left_panel, [this](bool open) {
    panes->open_left(open);
    if (open) panes->give_keyboard_left();
  });
  on(actions->right_panel, [this](bool open) {
    panes->open_right(open);
    if (open) panes->give_keyboard_right();
  });
  on(actions->menus, [this] {
    auto* bar = window.menuBar();
    if (bar->isVisible()) bar->setActiveAction(bar->actions().constFirst());
  });
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

  on(actions->keys, [this] {
    KeyListDialog(actions->groups_with(*current), &window).exec();
    focus_tablet();
  });
  on(actions->about, [this] {
    AboutDialog(sources, &window).exec();
    focus_tablet();
  });
}

void MainWindow::Inside::connect_parts() {
  QObject::connect(&parts, &WindowParts::announced, feedback, &FeedbackLine::announce);
  QObject::connect(&parts, &WindowParts::respond, feedback, &FeedbackLine::respond);
  QObject::connect(&parts, &WindowParts::save_later, &window, [this] { save_later(); });
  QObject::connect(&parts, &WindowParts::focus_tablet, &window, [this] { focus_tablet(); });
  QObject::connect(&parts, &WindowParts::close_drawers, panes, &Panes::close_drawers);
  QObject::connect(&parts, &WindowParts::open_left_panel, &window, [this] {
    if (actions->full_screen->isChecked()) set_full_screen(false);
    panes->open_left(true);
  });
  QObject::connect(&parts, &WindowParts::character_shown, &window, &MainWindow::character_shown);
  QObject::connect(&parts, &WindowParts::go_to, &window, &MainWindow::go_to);
  QObject::connect(&parts, &WindowParts::study_settings_changed, &window, [this] {
    const bool left = parts.preferences().left_handed;
    panes->set_mirrored(left);
    if (tablet_window != nullptr) tablet_window->set_hand(left ? view::Hand::left : view::Hand::right);
    actions->left_handed->setChecked(left);
  });
  QObject::connect(&parts, &WindowParts::opened, &window, &MainWindow::opened);
  subscribe(parts.library().opened, &window,
            [this](const std::vector<kanji::Source>& read) { sources = read; });
  subscribe(parts.library().failed, &window, [this](const base::Error& error) {
    parts.announce(Feedback::wrong, MainWindow::tr("Kanji database: %1.").arg(reason(error)));
  });
  QObject::connect(panes, &Panes::keyboard_closing, &window, [this] { focus_tablet(); });
  QObject::connect(panes, &Panes::opened, &window, [this](bool left, bool right) {
    actions->left_panel->setChecked(left);
    actions->right_panel->setChecked(right);
    save_later();
  });
  subscribe(parts.tablet().state_changed, &window, [this] {
    show_state();
    save_later();
  });
  auto& device = parts.tablet().device();
  const auto watch_device = [&device] { InputWatch::of_program().set_has_device(!device.is_pointer()); };
  subscribe(device.changed, &window, watch_device);
  watch_device();
  subscribe(parts.tablet().depth_changed, status, [this](double depth_m) { status->show_depth(depth_m); });
  QObject::connect(&appearance, &Appearance::changed, &window, [this] { refresh_appearance(); });
}

void MainWindow::Inside::refresh_appearance() {
  actions->draw_icons();
  for (const auto& page : pages) {
    if (auto* own = page->actions()) own->draw_icons();
    page->refresh_appearance();
  }
  if (tablet_window == nullptr) return;
  tablet_window->set_theme(appearance.is_dark() ? view::Theme::dark : view::Theme::light);
  tablet_window->set_text_size(parts.preferences().text_pt);
}

void MainWindow::Inside::show_room() {
  const auto folded = current->folded();
  panes->fold(folded.list, folded.information);
  const bool full = actions->full_screen->isChecked();
  tool_bar->setVisible(!full && !folded.list);
  // The tablet comes before the figures of the device, not before the sign of a recording.
  status->setVisible(!full && (!folded.list || parts.recording().is_on()));
  const double height_em = static_cast<double>(window.height()) / QFontInfo(window.font()).pixelSize();
  const bool is_low = practice::room_for_question(height_em) == practice::QuestionRoom::line;
  const bool is_tight = folded.list && is_low;
  feedback->set_compact(is_tight && window.font().pointSizeF() > kLargeText_pt);
}

void MainWindow::Inside::set_full_screen(bool on) {
  actions->full_screen->setChecked(on);
  window.menuBar()->setVisible(!on);
  show_room();
  rail->setVisible(!on && entries.size() > 1);
  panes->set_alone(on);
  window.setWindowState(on ? window.windowState() | Qt::WindowFullScreen
                           : window.windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::Inside::connect_recording() {
  auto& recording = parts.recording();
  subscribe(recording.changed, &window,
            [this, &recording] { actions->record->setChecked(recording.is_on()); });
  using Path = std::filesystem::path;
  subscribe(recording.moved_on, &window, [this](const Path& path) {
    parts.announce_when_open(
        Feedback::hint,
        MainWindow::tr("Device changed: the recording continues in %1.").arg(to_text(path.string())));
  });
  subscribe(recording.failed, &window, [this](const Path& path, const base::Error& error) {
    parts.announce_when_open(
        Feedback::wrong,
        MainWindow::tr("The recording %1 stopped: %2.").arg(to_text(path.string()), reason(error)));
  });
  subscribe(recording.exported, &window, [this](const Path& path) {
    parts.announce_when_open(Feedback::good, MainWindow::tr("Recorded: %1.").arg(to_text(path.string())));
  });
  subscribe(recording.recovered, &window, [this](const practice::TabletRecording::Recovered& found) {
    if (!found.files.empty())
      parts.announce_when_open(
          Feedback::good,
          MainWindow::tr("An interrupted recording was recovered: %1.").arg(names(found.files)));
    if (!found.broken.empty())
      parts.announce_when_open(
          Feedback::advice,
          MainWindow::tr(
              "A recording was cut off when the computer stopped. Its last second may be missing: %1.")
              .arg(names(found.broken)));
  });
  disk_timer.setInterval(1000);
  QObject::connect(&disk_timer, &QTimer::timeout, &window, [&recording] { recording.tick(); });
  disk_timer.start();
  recording.recover();
}

void MainWindow::Inside::connect_sound() {
  auto& preferences = parts.preferences();
  auto& controller = parts.tablet();
  sound.on_failure(
      [this](const base::Error& error) { parts.announce_when_open(Feedback::advice, no_sound(error)); });
  subscribe(controller.device().sampled, &window,
            [this, &controller](std::span<const haptics::ServoSample> samples) {
              const auto& tablet = controller.tablet();
              sound.follow(samples, tablet ? tablet->shape() : geometry::TabletShape{});
            });
  QObject::connect(actions->groove_sound, &QAction::toggled, &window, [this](bool on) {
    parts.preferences().groove_sound = on;
    sound.set_on(on);
    save_later();
  });
  const auto volume = [this](double by) {
    return [this, by] {
      double& of = parts.preferences().sound_volume;
      of = std::clamp(of + by, 0.1, 1.0);
      sound.set_volume(of);
      parts.announce(Feedback::hint, MainWindow::tr("Volume %1%.").arg(std::lround(of * 100)));
      save_later();
    };
  };
  QObject::connect(actions->sound_louder, &QAction::triggered, &window, volume(+0.1));
  QObject::connect(actions->sound_softer, &QAction::triggered, &window, volume(-0.1));
  QObject::connect(actions->slope_help, &QAction::toggled, &window, [this, &controller](bool on) {
    parts.preferences().slope_help = on;
    controller.set_slope_help(on);
    save_later();
  });
  sound.set_volume(preferences.sound_volume);
  actions->groove_sound->setChecked(preferences.groove_sound);
  actions->slope_help->setChecked(preferences.slope_help);
}

void MainWindow::Inside::record(bool on) {
  auto& recording = parts.recording();
  if (!on) {
    const auto written = recording.finish();
    if (written && recording.is_exporting())
      parts.announce(Feedback::hint,
                     MainWindow::tr("The recording has ended. Writing %1.").arg(names(*written)));
    else if (written)
      parts.announce(Feedback::good, MainWindow::tr("Recorded: %1.").arg(names(*written)));
    else
      parts.announce(Feedback::wrong,
                     MainWindow::tr("The recording is incomplete: %1.").arg(reason(written.error())));
    return;
  }
  actions->record->setChecked(false);  // until recording has begun
  QFileDialog dialog(&window, MainWindow::tr("Record pen motion"));
  dialog.setObjectName(QStringLiteral("record_dialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters({MainWindow::tr("Recording for replay (*.nzr)"), MainWindow::tr("Table (*.csv)")});
  dialog.setDefaultSuffix(QStringLiteral("nzr"));
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.contains(QLatin1String("csv")) ? QStringLiteral("csv")
                                                                  : QStringLiteral("nzr"));
  });
  dialog.setDirectory(parts.preferences().start_folder());
  dialog.selectFile(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HHmm")));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString path = dialog.selectedFiles().front();
  const auto& tablet = parts.tablet().tablet();
  const auto started =
      recording.start(path.toStdString(), current->title().toStdString(),
                      tablet ? tablet->shape() : geometry::TabletShape{}, parts.tablet().tip_radius_m());
  if (!started) {
    parts.announce(Feedback::wrong,
                   MainWindow::tr("%1: %2. Nothing is recorded.").arg(path, reason(started.error())));
    return;
  }
  parts.announce(Feedback::hint,
                 MainWindow::tr("Recording to %1. Press %2 to stop.")
                     .arg(path, actions->record->shortcut().toString(QKeySequence::NativeText)));
}

void MainWindow::Inside::connect_tablet() {
  if (tablet_window != nullptr) {
    tablet_window->set_reduced_motion(parts.preferences().reduced_motion);
    tablet_window->set_hand(parts.preferences().left_handed ? view::Hand::left : view::Hand::right);
    QObject::connect(tablet_window, &TabletWindow::files_dropped, &window,
                     [this](const QStringList& paths) { window.open_files(paths); });
    QObject::connect(tablet_window, &TabletWindow::focus_leaves, &window,
                     [this](bool forwards) { leave_tablet(forwards); });
    QObject::connect(tablet_window, &TabletWindow::drawing_failed, &window, [this](const base::Error& error) {
      parts.announce(Feedback::wrong, MainWindow::tr("The tablet cannot be shown: %1.").arg(reason(error)));
    });
  }
  connect_recording();
  connect_sound();
  if (const auto started = parts.tablet().start(); !started)
    parts.announce(Feedback::wrong,
                   MainWindow::tr("The stylus does not work: %1.").arg(reason(started.error())));
}

void MainWindow::Inside::leave_tablet(bool forwards) {
  // If the panel on that side is hidden, the focus goes to the toolbar.
  QWidget* next = forwards ? tab_stop(panes->shown_right(), false) : tab_stop(panes->shown_left(), true);
  if (next == nullptr) next = tab_stop(tool_bar, !forwards);
  if (next == nullptr) return;
  window.activateWindow();
  next->setFocus(forwards ? Qt::TabFocusReason : Qt::BacktabFocusReason);
}

void MainWindow::Inside::set_language(const QString& language) {
  auto& preferences = parts.preferences();
  if (preferences.language == language) return;
  if (!may_close(false)) return show_state();
  preferences.language = language;
  save_preferences();
  emit window.language_chosen();
}

void MainWindow::Inside::show_title() {
  const QString title = current->title().isEmpty() ? without_mnemonic(current->name()) : current->title();
  window.setWindowTitle(MainWindow::tr("%1 – Nazori").arg(title));
}

void MainWindow::Inside::show_state() {
  const auto& preferences = parts.preferences();
  const auto style = parts.tablet().style();
  const std::pair<QAction*, bool> states[] = {
      {actions->wood, style == view::Style::wood},
      {actions->slate, style == view::Style::slate},
      {actions->classic, style == view::Style::classic},
      {actions->theme_desktop, preferences.theme == ThemeChoice::desktop},
      {actions->theme_light, preferences.theme == ThemeChoice::light},
      {actions->theme_dark, preferences.theme == ThemeChoice::dark},
      {actions->language_desktop, preferences.language.isEmpty()},
      {actions->language_english, preferences.language == QLatin1String("en")},
      {actions->language_japanese, preferences.language == QLatin1String("ja")},
      {actions->reduced_motion, preferences.reduced_motion},
      {actions->left_handed, preferences.left_handed},
  };
  for (const auto& [action, on] : states) action->setChecked(on);
  actions->text_larger->setEnabled(preferences.text_pt < Preferences::kMaxText_pt);
  actions->text_smaller->setEnabled(preferences.text_pt > Preferences::kMinText_pt);
  tool_bar->refresh();
}

}  // namespace nazori::ui
