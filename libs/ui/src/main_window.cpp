// SPDX-License-Identifier: Apache-2.0
#include "nazori/ui/main_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "actions.h"
#include "appearance.h"
#include "error_text.h"
#include "feedback_line.h"
#include "file_exchange.h"
#include "focus_frame.h"
#include "information_panel.h"
#include "library.h"
#include "library_panel.h"
#include "main_window_inside.h"
#include "panes.h"
#include "status_line.h"
#include "tablet_controller.h"
#include "tablet_window.h"
#include "tool_bar.h"

namespace nazori::ui {
namespace {

constexpr QSize kFirstSize(1280, 800);
constexpr QSize kLeastSize(560, 420);

QStringList local_files(const QMimeData* data) {
  QStringList paths;
  for (const auto& url : data->urls())
    if (url.isLocalFile()) paths.append(url.toLocalFile());
  return paths;
}

}  // namespace

MainWindow::MainWindow(const Setup& setup, Appearance& appearance)
    : inside_(std::make_unique<Inside>(*this, setup, appearance)) {
  setObjectName(QStringLiteral("main_window"));
  setWindowTitle(QStringLiteral("Nazori"));
  setAcceptDrops(true);
  setMinimumSize(kLeastSize);
  inside_->apply_appearance();  // before the widgets are made, so that they are made in the right size
  inside_->build();
  inside_->connect_actions();
  inside_->connect_work();
  inside_->show_state();
  inside_->apply_appearance();

  const auto& preferences = inside_->preferences;
  if (preferences.geometry.isEmpty() || !restoreGeometry(preferences.geometry)) {
    const QSize room = QGuiApplication::primaryScreen()->availableSize();
    resize(kFirstSize.boundedTo(room));
  }
  inside_->panes->set_open(preferences.library_open, preferences.information_open);
  if (preferences.pane_widths.size() == 2)
    inside_->panes->wish(preferences.pane_widths[0], preferences.pane_widths[1]);
  inside_->panes->fit(width(), preferences.text_pt);
  inside_->tablet_place->setFocus(Qt::OtherFocusReason);
  inside_->library_panel->show_list(preferences.list);
  inside_->choose(setup.character != 0 ? setup.character : preferences.kanji, true);
}

MainWindow::~MainWindow() = default;

void MainWindow::show_character(char32_t code_point) { inside_->choose(code_point, true); }

void MainWindow::open_files(const QStringList& paths) { inside_->files->open(paths, inside_->own); }

void MainWindow::closeEvent(QCloseEvent* event) {
  inside_->save_preferences();
  QMainWindow::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  inside_->panes->fit(width(), inside_->preferences.text_pt);
  inside_->save_later();
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::WindowStateChange && inside_->actions != nullptr) {
    const bool full = windowState().testFlag(Qt::WindowFullScreen);
    if (full != inside_->actions->full_screen->isChecked()) inside_->set_full_screen(full);
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!local_files(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  open_files(local_files(event->mimeData()));
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    if (inside_->actions->full_screen->isChecked())
      inside_->set_full_screen(false);
    else
      inside_->panes->close_drawers();
    return;
  }
  QMainWindow::keyPressEvent(event);
}

MainWindow::Inside::Inside(MainWindow& owner, const Setup& setup, Appearance& look)
    : window(owner),
      appearance(look),
      settings_file(setup.settings_file.isEmpty() ? Preferences::default_file() : setup.settings_file),
      preferences(Preferences::load(settings_file)),
      draws_tablet(setup.draws_tablet),
      library(new Library(setup.database, &owner)),
      workshop(new Workshop(&owner)),
      controller(new TabletController(&owner)),
      files(new FileExchange(workshop, &owner)) {
  controller->set_strokes_visible(preferences.strokes_visible);
  controller->set_numbers_visible(preferences.numbers_visible);
  controller->set_arrows_visible(preferences.arrows_visible);
  controller->set_snapping(preferences.snapping);
  controller->set_style(preferences.style);
  files->set_folder(preferences.folder);
  save_timer.setSingleShot(true);
  save_timer.setInterval(600);
  QObject::connect(&save_timer, &QTimer::timeout, &owner, [this] { save_preferences(); });
}

MainWindow::Inside::~Inside() = default;

void MainWindow::Inside::build() {
  actions = new Actions(&window);
  actions->add_menus(window.menuBar());
  window.menuBar()->setObjectName(QStringLiteral("menu_bar"));
  tool_bar = new ToolBar(*actions, *controller, &window);
  window.addToolBar(Qt::TopToolBarArea, tool_bar);
  window.setContextMenuPolicy(Qt::NoContextMenu);

  library_panel = new LibraryPanel(library, &window);
  information_panel = new InformationPanel(&window);
  feedback = new FeedbackLine(&window);
  status = new StatusLine(*controller, &window);
  window.setStatusBar(status);

  if (draws_tablet && TabletWindow::is_possible()) {
    tablet_window = new TabletWindow(controller);
    tablet_place = QWidget::createWindowContainer(tablet_window, &window);
    tablet_place->setFocusPolicy(Qt::StrongFocus);
  } else {
    auto* apology = new QLabel(&window);
    apology->setText(
        MainWindow::tr("The tablet cannot be drawn here: OpenGL 3.3 is missing. The package "
                       "libgl1-mesa-dri draws it on any computer. Lists and information work."));
    apology->setWordWrap(true);
    apology->setAlignment(Qt::AlignCenter);
    apology->setContentsMargins(40, 40, 40, 40);
    tablet_place = apology;
  }
  tablet_place->setObjectName(QStringLiteral("tablet"));
  tablet_place->setAccessibleName(MainWindow::tr("Carved tablet"));
  tablet_place->setAccessibleDescription(
      MainWindow::tr("The character as grooves to be traced: the left button presses the stylus down, the "
                     "right button turns"));
  tablet_place->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  tablet_place->setMinimumSize(260, 200);

  auto* middle = new QWidget(&window);
  middle->setObjectName(QStringLiteral("middle"));
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(new FocusFrame(tablet_place, middle), 1);
  column->addWidget(feedback);

  panes = new Panes(library_panel, middle, information_panel, &window);
  window.setCentralWidget(panes);
  QWidget::setTabOrder(tool_bar, library_panel);
  QWidget::setTabOrder(library_panel, tablet_place);
  QWidget::setTabOrder(tablet_place, information_panel);
}

void MainWindow::Inside::show_state() {
  const std::pair<QAction*, bool> states[] = {
      {actions->strokes, controller->strokes_visible()},
      {actions->numbers, controller->numbers_visible()},
      {actions->arrows, controller->arrows_visible()},
      {actions->snap, controller->snapping()},
      {actions->wood, controller->style() == view::Style::wood},
      {actions->slate, controller->style() == view::Style::slate},
      {actions->classic, controller->style() == view::Style::classic},
      {actions->theme_desktop, preferences.theme == ThemeChoice::desktop},
      {actions->theme_light, preferences.theme == ThemeChoice::light},
      {actions->theme_dark, preferences.theme == ThemeChoice::dark},
      {actions->language_desktop, preferences.language.isEmpty()},
      {actions->language_english, preferences.language == QLatin1String("en")},
      {actions->language_japanese, preferences.language == QLatin1String("ja")},
      {actions->reduced_motion, preferences.reduced_motion},
  };
  for (const auto& [action, on] : states) action->setChecked(on);
  for (auto* action : {actions->next_stroke, actions->previous_stroke, actions->all_strokes})
    action->setEnabled(controller->stroke_count() > 0);
  for (auto* action : {actions->numbers, actions->arrows}) action->setEnabled(controller->strokes_visible());
  actions->text_larger->setEnabled(preferences.text_pt < Preferences::kMaxText_pt);
  actions->text_smaller->setEnabled(preferences.text_pt > Preferences::kMinText_pt);
  tool_bar->refresh();
}

void MainWindow::Inside::apply_appearance() { appearance.apply(preferences.theme, preferences.text_pt); }

void MainWindow::Inside::set_text_size(int text_pt) {
  preferences.text_pt = std::clamp(text_pt, Preferences::kMinText_pt, Preferences::kMaxText_pt);
  apply_appearance();
  panes->fit(window.width(), preferences.text_pt);
  show_state();
  save_later();
}

void MainWindow::Inside::set_full_screen(bool on) {
  actions->full_screen->setChecked(on);
  for (QWidget* widget : {static_cast<QWidget*>(window.menuBar()), static_cast<QWidget*>(tool_bar),
                          static_cast<QWidget*>(status)})
    widget->setVisible(!on);
  panes->set_alone(on);
  window.setWindowState(on ? window.windowState() | Qt::WindowFullScreen
                           : window.windowState() & ~Qt::WindowFullScreen);
}

void MainWindow::Inside::save_later() { save_timer.start(); }

void MainWindow::Inside::save_preferences() {
  save_timer.stop();
  if (!actions->full_screen->isChecked()) {
    preferences.geometry = window.saveGeometry();
    preferences.pane_widths = {panes->library_wish(), panes->information_wish()};
  }
  preferences.library_open = panes->library_wanted();
  preferences.information_open = panes->information_wanted();
  preferences.list = library_panel->list();
  preferences.strokes_visible = controller->strokes_visible();
  preferences.numbers_visible = controller->numbers_visible();
  preferences.arrows_visible = controller->arrows_visible();
  preferences.snapping = controller->snapping();
  preferences.style = controller->style();
  preferences.folder = files->folder();
  if (!preferences.save(settings_file))
    feedback->say(Feedback::wrong,
                  MainWindow::tr("The settings could not be saved in %1. They hold until Nazori is closed.")
                      .arg(settings_file));
}

}  // namespace nazori::ui
