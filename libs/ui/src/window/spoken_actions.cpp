// SPDX-License-Identifier: Apache-2.0
#include "window/spoken_actions.h"

#include <QActionGroup>
#include <QEvent>
#include <utility>

#include "nazori/widgets/controls/feedback_line.h"

namespace nazori::ui {
namespace {

/// A dialog speaks its own name when it opens, and this would come after it.
bool opens_dialog(const QAction& action) { return action.text().contains(QChar(0x2026)); }

}  // namespace

QString spoken_name(const QAction& action) {
  const bool one_of_several = action.actionGroup() != nullptr && action.actionGroup()->isExclusive();
  if (!action.isCheckable() || one_of_several) return action.iconText();
  return (action.isChecked() ? SpokenActions::tr("%1: on") : SpokenActions::tr("%1: off"))
      .arg(action.iconText());
}

SpokenActions::SpokenActions(QWidget& window, FeedbackLine& feedback)
    : QObject(&window), feedback_(feedback) {
  for (auto* action : window.findChildren<QAction*>()) {
    if (action->shortcuts().isEmpty() || opens_dialog(*action)) continue;
    action->installEventFilter(this);
    // Connected after all handlers, so that it runs after them.
    connect(action, &QAction::triggered, this, [this, action] {
      if (std::exchange(pressed_, nullptr) == action && feedback_.times_spoken() == spoken_before_)
        feedback_.speak_unseen(spoken_name(*action));
    });
  }
}

bool SpokenActions::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Shortcut) {
    pressed_ = static_cast<QAction*>(watched);
    spoken_before_ = feedback_.times_spoken();
  }
  return false;
}

}  // namespace nazori::ui
