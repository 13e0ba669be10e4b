// SPDX-License-Identifier: Apache-2.0
#include "nazori/ui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "learners/learner_actions.h"
#include "learners/learner_menu.h"
#include "nazori/widgets/controls/choice_access.h"
#include "nazori/widgets/controls/feedback_line.h"
#include "nazori/widgets/controls/focus_frame.h"
#include "nazori/widgets/controls/key_guard.h"
#include "nazori/widgets/controls/panes.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/status_line.h"
#include "nazori/widgets/controls/wheel_guard.h"
#include "nazori/widgets/look/appearance.h"
#include "nazori/widgets/tablet/tablet_window.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"
#include "window/actions.h"
#include "window/back_ends.h"
#include "window/main_window_inside.h"
#include "window/own_font.h"
#include "window/page_rail.h"
#include "window/spoken_actions.h"
#include "window/tool_bar.h"

namespace nazori::ui {
namespace {

constexpr QSize kFirstSize(1280, 800);
constexpr QSize kLeastSize(560, 420);
constexpr QSize kFrame(16, 48);  ///< of window managers, before the real frame is known

}  // namespace

MainWindow::MainWindow(const Setup& setup, Appearance& appearance)
    : inside_(std::make_unique<Inside>(*this, setup, appearance)) {
  setObjectName(QStringLiteral("main_window"));
  setWindowTitle(QStringLiteral("Nazori"));
  setAcceptDrops(true);
  setMinimumSize(kLeastSize);
  inside_->apply_appearance();  // before the widgets are made, so that they are made in the right size
  inside_->build(setup);
  inside_->connect_actions();
  inside_->connect_parts();
  inside_->connect_tablet();
  new SpokenActions(*this, *inside_->feedback);

  const auto& preferences = inside_->parts.preferences();
  inside_->panes->set_open(preferences.left_open, preferences.right_open);
  if (setup.character != 0) {
    show_character(setup.character);
  } else {
    const auto& all = inside_->pages;
    QString first = setup.page;
    if (first.isEmpty())
      for (const auto& page : all)
        if (page->comes_first()) first = page->id();
    if (first.isEmpty())
      first = preferences.begin_at_home && all.front()->id() == QLatin1String("home") ? all.front()->id()
                                                                                      : preferences.page;
    const auto last =
        std::find_if(all.begin(), all.end(), [&](const auto& page) { return page->id() == first; });
    inside_->enter(last == all.end() ? *all.front() : **last);
  }
  inside_->show_state();
  inside_->apply_appearance();

  if (preferences.geometry.isEmpty() || !restoreGeometry(preferences.geometry)) {
    const QSize room = QGuiApplication::primaryScreen()->availableSize();
    resize(kFirstSize.boundedTo(room - kFrame).expandedTo(kLeastSize.boundedTo(room)));
  }
  if (preferences.pane_widths.size() == 2)
    inside_->panes->wish(preferences.pane_widths[0], preferences.pane_widths[1]);
  inside_->fit();
  inside_->focus_tablet();
}

MainWindow::~MainWindow() = default;

void MainWindow::go_to(const QString& page) {
  for (const auto& one : inside_->pages)
    if (one->id() == page) inside_->enter(*one);
}

void MainWindow::show_character(char32_t code_point) { inside_->parts.show_character(code_point); }

void MainWindow::open_files(const QStringList& paths) {
  // Ask the current page first; it reports files that no page can open.
  auto* page = inside_->current;
  if (!page->opens(paths) || !page->has_files())
    for (const auto& other : inside_->pages)
      if (other->opens(paths)) page = other.get();
  inside_->enter(*page);
  page->open_files(paths);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!inside_->may_close(true)) {
    event->ignore();
    return;
  }
  inside_->save_preferences();
  QMainWindow::closeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  inside_->fit();
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
      parts(owner, setup.settings_file,
            {setup.learners, {setup.database, setup.own_characters}, setup.clock}) {
  auto* own_font = new OwnFont(parts.inbox(), setup.own_characters, &owner);
  QObject::connect(&parts, &WindowParts::own_characters_changed, own_font, &OwnFont::refresh);
  parts.set_back_ends(setup.back_ends ? setup.back_ends() : registered_back_ends(parts.settings_file()));
  save_timer.setSingleShot(true);
  save_timer.setInterval(2000);
  QObject::connect(&save_timer, &QTimer::timeout, &owner, [this] { save_preferences(); });
}

// The tablet draws objects of `parts`, and open dialogs use them, so both are destroyed before them.
MainWindow::Inside::~Inside() {
  qDeleteAll(window.findChildren<QDialog*>(QString(), Qt::FindDirectChildrenOnly));
  delete tablet_container;
}

void MainWindow::Inside::build(const Setup& setup) {
  describe_choices();
  actions = new Actions(&window);
  learner_menu = new LearnerMenu(parts);
  for (const auto& group : learner_menu->actions().groups()) actions->add_menu(group);
  qApp->installEventFilter(new KeyGuard(&window));
  qApp->installEventFilter(new WheelGuard(&window));
  window.menuBar()->setObjectName(QStringLiteral("menu_bar"));
  tool_bar = new ToolBar(*actions, &window);
  window.addToolBar(Qt::TopToolBarArea, tool_bar);
  window.setContextMenuPolicy(Qt::NoContextMenu);
  feedback = new FeedbackLine(&window);
  status = new StatusLine(parts.tablet(), parts.recording(), &window);
  window.setStatusBar(status);
  build_tablet(setup.draws_tablet);

  auto* middle = named(new QWidget(&window), "middle");
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(new FocusFrame(tablet_container, middle), 1);
  column->addWidget(feedback);
  panes = new Panes(middle, &window);
  panes->set_mirrored(parts.preferences().left_handed);
  stage = named(new QStackedWidget(&window), "stage");
  stage->addWidget(panes);
  window.setCentralWidget(stage);

  for (const auto make : setup.pages.empty() ? registered_pages() : setup.pages) {
    pages.push_back(make(parts));
    auto& page = *pages.back();
    if (auto* own = page.actions()) own->set_in_force(false);
    for (auto* panel : {page.left().widget, page.right().widget})
      if (panel != nullptr) panel->hide();
    if (auto* bar = page.above_tablet()) column->insertWidget(0, bar);
    if (auto* bar = page.under_tablet()) {
      bar->hide();
      column->addWidget(bar);
    }
    if (auto* replacement = page.instead_of_tablet()) {
      auto* holder = new QWidget(stage);
      auto* page_column = new QVBoxLayout(holder);
      page_column->setContentsMargins(0, 0, 0, 0);
      page_column->setSpacing(0);
      page_column->addWidget(replacement, 1);
      stage->addWidget(holder);
    }
    if (page.is_listed()) {
      auto* entry = entries[&page] = actions->add_page(page);
      QObject::connect(entry, &QAction::triggered, &window, [this, &page] {
        enter(page);
        focus_tablet();  // even if the page is already shown: this is the way back from its lists
      });
    }
    QObject::connect(&page, &Page::wants_to_be_entered, &window, [this, &page] { enter(page); });
    QObject::connect(&page, &Page::title_changed, &window, [this] { show_title(); });
    QObject::connect(&page, &Page::tools_changed, &window, [this, &page] {
      if (current == &page) tool_bar->enter(page);
    });
    QObject::connect(&page, &Page::room_changed, &window, [this, &page] {
      if (current == &page) show_room();
    });
  }
  rail = new PageRail(actions->pages(), &window);
  window.addToolBar(Qt::LeftToolBarArea, rail);
  rail->setVisible(entries.size() > 1);
}

void MainWindow::Inside::build_tablet(bool draws_tablet) {
  if (draws_tablet && TabletWindow::is_possible()) {
    tablet_window = new TabletWindow(&parts.tablet());
    tablet_container = QWidget::createWindowContainer(tablet_window, &window);
    tablet_container->setFocusPolicy(Qt::StrongFocus);
  } else {
    auto* apology = new QLabel(&window);
    apology->setText(MainWindow::tr(
        "The tablet cannot be shown: OpenGL 3.3 is missing. Install the package libgl1-mesa-dri, which works "
        "on any computer. Lists and character information still work."));
    apology->setWordWrap(true);
    apology->setAlignment(Qt::AlignCenter);
    apology->setContentsMargins(40, 40, 40, 40);
    tablet_container = apology;
  }
  tablet_container->setObjectName(QStringLiteral("tablet"));
  tablet_container->setAccessibleName(MainWindow::tr("Carved tablet"));
  tablet_container->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  tablet_container->setMinimumSize(260, 200);
}

void MainWindow::Inside::enter(Page& page) {
  if (current == &page) return;
  if (current != nullptr) {
    current->leave();
    if (auto* old = current->actions()) old->set_in_force(false);
  }
  current = &page;
  if (auto* own = page.actions()) own->set_in_force(true);
  actions->enter(page, window.menuBar());
  if (auto* entry = entries.value(current)) entry->setChecked(true);

  auto* replacement = page.instead_of_tablet();
  auto* holder = replacement != nullptr ? replacement->parentWidget() : panes;
  auto* words_under = replacement != nullptr ? holder : panes->widget(1);
  if (feedback->parentWidget() != words_under) {
    auto* column = static_cast<QVBoxLayout*>(words_under->layout());
    // Under the tablet, above what the page has there.
    auto* tablet = replacement != nullptr ? replacement : tablet_container->parentWidget();
    column->insertWidget(column->indexOf(tablet) + 1, feedback);
  }
  feedback->announce(Feedback::hint, {});
  if (replacement == nullptr) panes->set_panels(page.left().widget, page.right().widget);
  stage->setCurrentWidget(holder);
  tool_bar->enter(page);
  status->show_figures(page.id() == QLatin1String("device"));
  status->show_input(page.id() != QLatin1String("start"));
  tablet_container->setAccessibleDescription(page.tablet_description());
  if (replacement == nullptr) {
    QWidget* before = tool_bar;
    for (auto* widget : {page.left().widget, tablet_container, page.right().widget}) {
      if (widget == nullptr) continue;
      QWidget::setTabOrder(before, widget);
      before = widget;
    }
  }
  page.enter();
  show_room();
  show_title();
  focus_tablet();
  if (!page.is_listed()) return;
  parts.preferences().page = page.id();
  save_later();
}

void MainWindow::Inside::apply_appearance() {
  appearance.apply(parts.preferences().theme, parts.preferences().text_pt);
}

void MainWindow::Inside::set_text_size(int text_pt) {
  auto& preferences = parts.preferences();
  preferences.text_pt = std::clamp(text_pt, Preferences::kMinText_pt, Preferences::kMaxText_pt);
  apply_appearance();
  fit();
  show_state();
  save_later();
}

void MainWindow::Inside::fit() {
  rail->fit(window.width());
  // The tablet has half of the window, with or without the rail.
  const int taken = rail->isVisibleTo(&window) ? 2 * rail->sizeHint().width() : 0;
  panes->fit(window.width() - taken, parts.preferences().text_pt);
  if (current != nullptr) show_room();
}

void MainWindow::Inside::focus_tablet() {
  if (auto* instead = current->instead_of_tablet())
    instead->setFocus(Qt::OtherFocusReason);
  else
    focus_window_container(*tablet_container, tablet_window);
}

bool MainWindow::Inside::may_close(bool quits) {
  for (const auto& page : pages)
    if (!page->may_close(quits)) return false;
  auto& session = parts.session();
  if (session.state() != practice::StudySession::State::judged) return true;
  QMessageBox box(QMessageBox::Question, QStringLiteral("Nazori"),
                  MainWindow::tr("Your writing of %1 is not rated yet.").arg(to_text(session.character())),
                  QMessageBox::NoButton, &window);
  box.setObjectName(QStringLiteral("unrated_box"));
  box.setInformativeText(MainWindow::tr("Without a rating it is not saved."));
  const QString rate_words =
      quits ? MainWindow::tr("Rate as “%1” and quit") : MainWindow::tr("Rate as “%1” and go on");
  auto* rate = box.addButton(rate_words.arg(StudyWords::rating(session.proposed())), QMessageBox::AcceptRole);
  auto* leave =
      box.addButton(quits ? MainWindow::tr("Quit without rating") : MainWindow::tr("Go on without rating"),
                    QMessageBox::DestructiveRole);
  auto* stay = box.addButton(MainWindow::tr("Go back"), QMessageBox::RejectRole);
  box.setDefaultButton(stay);
  box.setEscapeButton(stay);
  box.exec();
  if (box.clickedButton() == leave) return true;
  if (box.clickedButton() != rate) return false;
  session.rate(session.proposed());
  // If the rating could not be saved, the session has announced it and the window stays open.
  return session.state() != practice::StudySession::State::judged;
}

void MainWindow::Inside::save_later() { save_timer.start(); }

void MainWindow::Inside::save_preferences() {
  save_timer.stop();
  auto& preferences = parts.preferences();
  if (!actions->full_screen->isChecked()) {
    preferences.geometry = window.saveGeometry();
    preferences.pane_widths = {panes->left_wish(), panes->right_wish()};
  }
  preferences.left_open = panes->left_wanted();
  preferences.right_open = panes->right_wanted();
  preferences.style = parts.tablet().style();
  const bool saved = preferences.save(parts.settings_file());
  QSettings settings(parts.settings_file(), QSettings::IniFormat);
  for (const auto& page : pages) {
    settings.beginGroup(page->id());
    page->save(settings);
    settings.endGroup();
  }
  if (!saved)
    feedback->announce(Feedback::wrong,
                       MainWindow::tr("Settings could not be saved in %1. They apply until you close Nazori.")
                           .arg(parts.settings_file()));
}

}  // namespace nazori::ui
