// SPDX-License-Identifier: Apache-2.0
#include "study/home.h"

#include "desk.h"
#include "signals.h"
#include "study/home_page.h"
#include "study/study_dialogs.h"

namespace nazori::ui {
namespace {

constexpr int kLook_ms = 30'000;

}  // namespace

HomeActions::HomeActions(QWidget* window) : ActionSet(window) {
  const auto key = [](const char* text) { return QStringList{QString::fromLatin1(text)}; };
  start = make("home_study", tr("&Study what is due"), tr("Begin with what is due now"), key("Ctrl+Return"));
  leeches = make("home_leeches_lesson", tr("&Another lesson for what is forgotten often"),
                 tr("Characters that were set apart, from watching on"), key("Ctrl+Shift+Return"));
  undo = make("home_undo", tr("&Take back the last review"),
              tr("Take back what was kept last; again for the one before, also of other days"),
              key("Ctrl+Shift+Z"));
  settings = make("home_study_settings", tr("Study se&ttings…"),
                  tr("Limits, lists, order, desired retention"), key("Ctrl+,"));
  draw(start, Icon::play);
  draw(undo, Icon::undo);
  add_group(tr("St&udy"), {start, leeches, nullptr, undo, nullptr, settings});
}

Home::Home(Desk& desk)
    : Workplace(desk),
      actions_(new HomeActions(&desk.window())),
      page_(new HomePage(desk.learner(), desk.session(), &desk.window())) {
  connect(actions_->start, &QAction::triggered, this, [this] { start(false); });
  connect(actions_->leeches, &QAction::triggered, this, [this] { start(true); });
  connect(actions_->undo, &QAction::triggered, this, [this] {
    this->desk().session().undo();
    page_->show_summary({});  // what it counts is no longer so
  });
  connect(page_, &HomePage::start_wanted, actions_->start, &QAction::trigger);
  connect(page_, &HomePage::leeches_wanted, actions_->leeches, &QAction::trigger);
  connect(page_, &HomePage::settings_wanted, actions_->settings, &QAction::trigger);
  connect(page_, &HomePage::free_writing_wanted, this,
          [this] { this->desk().go_to(QStringLiteral("characters")); });
  connect(actions_->settings, &QAction::triggered, this, [this] {
    ask_study_settings(this->desk());
    this->desk().focus_tablet();
  });
  subscribe(desk.learner().changed, this, [this] { refresh(); });
  subscribe(desk.session().ended, this, [this] { page_->show_summary(this->desk().session().summary()); });
  // After the session of the learner before has ended, which shows what it came to.
  subscribe(desk.learner().profile_changed, this, [this] { page_->show_summary({}); });
  connect(&look_, &QTimer::timeout, this, &Home::refresh);
}

Home::~Home() = default;

QString Home::id() const { return QStringLiteral("home"); }
QString Home::name() const { return tr("H&ome"); }
QString Home::purpose() const { return tr("What is due today, and how to begin"); }
Icon Home::drawing() const { return Icon::home; }
QWidget* Home::page() const { return page_; }

QList<Tool> Home::tools() const { return {{actions_->start, true}, {}, {actions_->undo, true}}; }

void Home::enter() {
  entered_ = true;
  refresh();
  look_.start(kLook_ms);
  if (page_->can_start())
    desk().say(Feedback::hint, tr("Enter starts. Everything is kept as soon as it is rated."));
  // After the window's own connections are made.
  QTimer::singleShot(0, &desk(), &Desk::note_opened);
}

void Home::leave() {
  entered_ = false;
  look_.stop();
}

void Home::refresh() {
  if (entered_) page_->refresh();
}

void Home::start(bool leeches) {
  auto& session = desk().session();
  if (session.is_running()) {
    desk().go_to(QStringLiteral("characters"));
    return;
  }
  if (!session.start(leeches)) return;
  page_->show_summary({});
}

}  // namespace nazori::ui
