// SPDX-License-Identifier: Apache-2.0
// The workplace for characters while they are studied.
#include <QFontInfo>

#include "characters/characters.h"
#include "characters/library_panel.h"
#include "characters/memory_page.h"
#include "desk.h"
#include "kanji_text.h"
#include "signals.h"
#include "study/session_actions.h"
#include "study/session_bar.h"
#include "study/session_panel.h"
#include "study/study_dialogs.h"

namespace nazori::ui {

void Characters::connect_session() {
  auto& session = desk().session();
  subscribe(session.changed, this, [this] { show_session(); });
  subscribe(session.ended, this, [this] { desk().go_to(QStringLiteral("home")); });
  connect(memory_page_, &MemoryPage::writing_changed, this,
          [this] { session_actions_->set_has_unjudged(practice_.memory().has_unjudged()); });
  subscribe(desk().learner().changed, this, [this] { show_session(); });
  subscribe(desk().learner().profile_changed, this, [this] { practice_.memory().forget(); });
  connect(&desk(), &Desk::study_settings_changed, this, [this] {
    session_actions_->set_one_hand(desk().preferences().one_hand, actions_->hint, actions_->undo_stroke,
                                   actions_->done);
    desk().session().set_asks_by_words(desk().preferences().asks_by_words);
  });
  session_actions_->set_one_hand(desk().preferences().one_hand, actions_->hint, actions_->undo_stroke,
                                 actions_->done);
}

void Characters::connect_study_actions() {
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  auto& session = desk().session();
  on(session_actions_->start, [&session] { (void)session.start(); });
  on(session_actions_->go_on, [this, &session] {
    session.go_on();
    desk().focus_tablet();
  });
  for (std::size_t i = 0; i < study::kRatings.size(); ++i)
    on(session_actions_->rate[i], [this, &session, rating = study::kRatings[i]] {
      session.rate(rating);
      desk().focus_tablet();
    });
  on(session_actions_->undo, [&session] { session.undo(); });
  on(session_actions_->end, [&session] { session.end(); });
  on(session_actions_->settings, [this] {
    ask_study_settings(desk());
    desk().focus_tablet();
  });
  on(session_actions_->tags, [this] {
    if (const char32_t character = practice_.studied_character(); character != 0) ask_tags(desk(), character);
    desk().focus_tablet();
  });
  // Within the session for what it asks for, else for the character on the desk.
  const auto aside = [this, on](QAction* action, void (practice::StudySession::*within)(),
                                const std::function<void(char32_t)>& outside) {
    on(action, [this, within, outside] {
      auto& running = desk().session();
      if (running.is_running() && !running.is_away())
        (running.*within)();
      else if (const char32_t character = practice_.studied_character(); character != 0)
        outside(character);
    });
  };
  aside(session_actions_->postpone, &practice::StudySession::postpone, [this](char32_t character) {
    auto& learner = desk().learner();
    auto& store = learner.store();
    if (learner.report(store.postpone(std::span(&character, 1), store.today() + std::chrono::days(1))))
      desk().say(Feedback::hint, tr("%1 comes tomorrow.").arg(to_text(character)));
  });
  aside(session_actions_->pause, &practice::StudySession::pause, [this](char32_t character) {
    auto& learner = desk().learner();
    auto& store = learner.store();
    const bool paused = store.card(character).paused;
    const auto done = paused ? store.resume(std::span(&character, 1)) : store.pause(std::span(&character, 1));
    if (learner.report(done))
      desk().say(Feedback::hint, paused ? tr("%1 comes again.").arg(to_text(character))
                                        : tr("%1 is paused until it is resumed.").arg(to_text(character)));
  });
  aside(session_actions_->reset, &practice::StudySession::reset, [this](char32_t character) {
    auto& learner = desk().learner();
    if (learner.report(learner.store().reset(std::span(&character, 1))))
      desk().say(Feedback::hint, tr("%1 is new again. Ctrl+Shift+Z takes it back.").arg(to_text(character)));
  });
}

void Characters::show_session() {
  const auto& session = desk().session();
  session_actions_->show_state(session, desk().learner().can_write());
  const bool drawing = actions_->draw_to_find->isChecked();
  const bool studied = session.is_running() && !searching_;
  session_panel_->setVisible(studied && !drawing);
  library_panel_->setVisible(!studied && !drawing);
  if (!practice_.is_entered()) return;
  session_bar_->show_state(practice_.sheet());
  session_panel_->show_state(practice_.sheet());
}

}  // namespace nazori::ui
