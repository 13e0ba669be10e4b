// SPDX-License-Identifier: Apache-2.0
#include "study/home.h"

#include "events/signals.h"
#include "page/window_parts.h"
#include "study/home_view.h"
#include "study/study_dialogs.h"

namespace nazori::ui {
namespace {

constexpr int kLook_ms = 30'000;

}  // namespace

HomeActions::HomeActions(QWidget* window) : ActionSet(window) {
  start = make("home_study", tr("&Start today's study"), tr("Start today's reviews and new characters"),
               "Ctrl+Return", Icon::play);
  leeches = make("home_leeches_lesson", tr("Rele&arn difficult characters"),
                 tr("Relearn characters you forgot too often, starting with Watch"), "Ctrl+Shift+Return");
  undo = make("home_undo", tr("Undo las&t review"),
              tr("Undo the last saved review or change; repeat to go further back, even to earlier days"),
              "Ctrl+Shift+Z", Icon::undo);
  settings = make("home_study_settings", tr("Study se&ttings…"),
                  tr("Daily goal, lists, order and desired retention"), "Ctrl+,");
  choices = make("home_choices", tr("Change &what I learn…"),
                 tr("What you want to write, what you know already, and how long a day"), "Ctrl+Shift+G");
  add_group(tr("St&udy"), {start, leeches, nullptr, undo, nullptr, choices, settings});
}

Home::Home(WindowParts& parts)
    : Page(parts,
           {QStringLiteral("home"), tr("H&ome"), tr("Today's reviews and new characters"), Icon::home, {}}),
      actions_(new HomeActions(&parts.window())),
      view_(new HomeView(parts.learner(), parts.session(), &parts.window())) {
  on(actions_->start, [this] { start(false); });
  on(actions_->leeches, [this] { start(true); });
  on(actions_->undo, [this] {
    this->parts().session().undo();
    view_->show_summary({});  // the undone review is still counted in it
  });
  connect(view_, &HomeView::start_wanted, actions_->start, &QAction::trigger);
  connect(view_, &HomeView::leeches_wanted, actions_->leeches, &QAction::trigger);
  connect(view_, &HomeView::settings_wanted, actions_->settings, &QAction::trigger);
  connect(view_, &HomeView::free_writing_wanted, this,
          [this] { this->parts().go_to(QStringLiteral("characters")); });
  on(actions_->choices, [this] { this->parts().go_to(QStringLiteral("start")); });
  on(actions_->settings, [this] {
    ask_study_settings(this->parts());
    this->parts().focus_tablet();
  });
  subscribe(parts.learner().changed, this, [this] { refresh(); });
  subscribe(parts.session().ended, this, [this] { view_->show_summary(this->parts().session().summary()); });
  // When the learner changes, the previous session ends first and shows its summary. Remove it again.
  subscribe(parts.learner().profile_changed, this, [this] { view_->show_summary({}); });
  connect(&look_, &QTimer::timeout, this, &Home::refresh);
}

Home::~Home() = default;

QWidget* Home::instead_of_tablet() const { return view_; }

QList<Tool> Home::tools() const { return {{actions_->start, true}, {}, {actions_->undo, true}}; }

void Home::enter() {
  entered_ = true;
  refresh();
  look_.start(kLook_ms);
  if (view_->can_start())
    parts().announce(Feedback::hint, tr("Enter: start. Each review is saved as soon as you rate it."));
  // Later, because the window has not made its own connections yet.
  QTimer::singleShot(0, &parts(), &WindowParts::note_opened);
}

void Home::leave() {
  entered_ = false;
  look_.stop();
}

void Home::refresh() {
  if (entered_) view_->refresh();
}

void Home::start(bool leeches) {
  auto& session = parts().session();
  if (session.is_running()) {
    parts().go_to(QStringLiteral("characters"));
    return;
  }
  if (!session.start(leeches)) return;
  view_->show_summary({});
}

}  // namespace nazori::ui
