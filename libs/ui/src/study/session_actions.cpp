// SPDX-License-Identifier: Apache-2.0
#include "study/session_actions.h"

#include <utility>

namespace nazori::ui {

SessionActions::SessionActions(QWidget* window) : ActionSet(window) {
  start = make("study_start", tr("&Start today's study"), tr("Start today's reviews and new characters"),
               "Ctrl+Return", Icon::play);
  go_on = make("study_go_on", tr("&Next"), tr("Go to the next stage, or accept the suggested rating"),
               "Shift+Return", Icon::next);
  go_on->setEnabled(false);
  rate = {make("rate_again", tr("&Again"), tr("Forgotten: comes back soon"), "1"),
          make("rate_hard", tr("&Hard"), tr("Remembered with effort"), "2"),
          make("rate_good", tr("Goo&d"), tr("Remembered"), "3"),
          make("rate_easy", tr("&Easy"), tr("Remembered easily"), "4")};
  undo = make("study_undo", tr("Undo las&t review"),
              tr("Undo the last saved review or change; repeat to go further back, even to earlier days"),
              "Ctrl+Shift+Z", Icon::undo);
  postpone = make("study_postpone", tr("&Postpone to tomorrow"), tr("Show this character tomorrow instead"),
                  "Ctrl+Shift+P");
  pause = make("study_pause", tr("S&uspend or resume"),
               tr("A suspended character does not come up until you resume it"), "Ctrl+Shift+U");
  reset = make("study_reset", tr("Start &over"), tr("Treat this character as new again"), "Ctrl+Shift+N");
  tags = make("study_tags", tr("&Tags…"), tr("Your own labels for this character; you can study by tag"),
              "Ctrl+Shift+T");
  study_this = make("study_this", tr("St&udy this"),
                    tr("Learn this character now; it then comes back in reviews"), "Ctrl+Shift+S");
  know_this = make("know_this", tr("I &know this"),
                   tr("Skip the lesson: the character comes in a review after about a week"), "Ctrl+Shift+Y");
  add_to_list = make("add_to_list", tr("Add to &list…"), tr("Put this character into one of your own lists"),
                     "Ctrl+Shift+A");
  end = make("study_end", tr("End the &session"), tr("Everything you rated is saved"), "Ctrl+Shift+E");
  choices = make("study_choices", tr("Change &what I learn…"),
                 tr("What you want to write, what you know already, and how long a day"), "Ctrl+Shift+G");
  settings = make("study_settings", tr("Study se&ttings…"),
                  tr("Daily goal, lists, order and desired retention"), "Ctrl+,");
  QList<QAction*> all{start, go_on, nullptr};
  for (auto* one : rate) all.append(one);
  all.append({nullptr, undo, nullptr, study_this, know_this, add_to_list, tags, nullptr, postpone, pause,
              reset, nullptr, end, choices, settings});
  add_group(tr("St&udy"), all);
}

void SessionActions::show_state(const practice::StudySession& session, bool can_write) {
  const bool running = session.is_running();
  const auto state = session.state();
  go_on->setEnabled(running && (session.is_away() || state == practice::StudySession::State::offered ||
                                state == practice::StudySession::State::judged));
  give_keys();
  for (auto* one : rate)
    one->setEnabled(state == practice::StudySession::State::judged && !session.is_away());
  start->setEnabled(!running && can_write);
  end->setEnabled(running);
  for (auto* one : {undo, postpone, pause, reset, tags, study_this, know_this, add_to_list})
    one->setEnabled(can_write);
}

void SessionActions::set_one_hand(OneHand hand, QAction* hint, QAction* undo_stroke, QAction* done) {
  struct Keys {
    QAction* action;
    const char* left;
    const char* right;
  };
  const Keys added[] = {
      {rate[0], "1", "7"},
      {rate[1], "2", "8"},
      {rate[2], "3", "9"},
      {rate[3], "4", "0"},
      {done, "E", "K"},
      {hint, "W", "U"},
      {undo_stroke, "X", "Backspace"},
      {undo, "Shift+X", "Shift+Backspace"},
  };
  for (const auto& [action, left, right] : added) {
    if (!own_keys_.contains(action)) own_keys_.insert(action, action->shortcuts());
    auto keys = own_keys_.value(action);
    const QKeySequence more(QString::fromLatin1(hand == OneHand::left ? left : right),
                            QKeySequence::PortableText);
    if (hand != OneHand::none && !keys.contains(more)) keys.append(more);
    action->setShortcuts(keys);
  }
  done_ = done;
  done_keys_ = done->shortcuts();
  give_keys();
}

void SessionActions::set_has_unjudged(bool has_unjudged) {
  if (std::exchange(has_unjudged_, has_unjudged) != has_unjudged) give_keys();
}

void SessionActions::give_keys() {
  // Return finishes a writing that is not judged yet. Otherwise it goes on.
  if (done_ == nullptr) return;
  const bool goes_on = go_on->isEnabled() && !has_unjudged_;
  QList<QKeySequence> keys{QKeySequence(Qt::ShiftModifier | Qt::Key_Return)};
  if (goes_on) keys.append(done_keys_);
  const auto left = goes_on ? QList<QKeySequence>() : done_keys_;
  if (left != done_->shortcuts()) done_->setShortcuts(left);
  if (keys != go_on->shortcuts()) go_on->setShortcuts(keys);
}

}  // namespace nazori::ui
