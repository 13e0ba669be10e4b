// SPDX-License-Identifier: Apache-2.0
// The page for characters during a study session.

#include "characters/character_actions.h"
#include "characters/characters.h"
#include "characters/information_panel.h"
#include "characters/library_panel.h"
#include "characters/writing_report.h"
#include "nazori/practice/stage_table.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "study/question_view.h"
#include "study/session_actions.h"
#include "study/session_answers.h"
#include "study/session_bar.h"
#include "study/session_panel.h"
#include "study/study_dialogs.h"

namespace nazori::ui {

void Characters::connect_session() {
  auto& session = parts().session();
  information_panel_->set_head(session_panel_);
  subscribe(session.changed, this, [this] { show_session(); });
  subscribe(session.ended, this, [this] { parts().go_to(QStringLiteral("home")); });
  subscribe(practice_.memory().changed, this, [this] {
    session_actions_->set_has_unjudged(practice_.memory().has_unjudged());
    if (practice_.is_entered()) session_answers_->show_state();
  });
  subscribe(parts().learner().changed, this, [this] { show_session(); });
  subscribe(parts().learner().profile_changed, this, [this] {
    for (const auto& stage : practice_.stages()) stage->forget();
  });
  connect(&parts(), &WindowParts::study_settings_changed, this, [this] {
    session_actions_->set_one_hand(parts().preferences().one_hand, actions_->hint, actions_->undo_stroke,
                                   actions_->done);
    parts().session().set_asks_by_words(parts().preferences().asks_by_words);
    session_answers_->set_left_handed(parts().preferences().left_handed);
  });
  session_answers_->set_left_handed(parts().preferences().left_handed);
  session_actions_->set_one_hand(parts().preferences().one_hand, actions_->hint, actions_->undo_stroke,
                                 actions_->done);
}

void Characters::connect_study_actions() {
  auto& session = parts().session();
  on(session_actions_->start, [&session] { (void)session.start(); });
  on(session_actions_->go_on, [this, &session] {
    session.go_on();
    parts().focus_tablet();
  });
  for (std::size_t i = 0; i < study::kRatings.size(); ++i)
    on(session_actions_->rate[i], [this, &session, rating = study::kRatings[i]] {
      session.rate(rating);
      parts().focus_tablet();
    });
  on(session_actions_->undo, [&session] { session.undo(); });
  on(session_actions_->end, [&session] { session.end(); });
  on(session_actions_->choices, [this] { parts().go_to(QStringLiteral("start")); });
  on(session_actions_->settings, [this] {
    ask_study_settings(parts());
    parts().focus_tablet();
  });
  on(session_actions_->tags, [this] {
    if (const char32_t character = practice_.studied_character(); character != 0)
      ask_tags(parts(), character);
    parts().focus_tablet();
  });
  // During a session these act on the character it asks for, otherwise on the character that is shown.
  const auto aside = [this](QAction* action, void (practice::StudySession::*within)(),
                            const std::function<void(char32_t)>& outside) {
    on(action, [this, within, outside] {
      auto& running = parts().session();
      if (running.is_running() && !running.is_away())
        (running.*within)();
      else if (const char32_t character = practice_.studied_character(); character != 0)
        outside(character);
    });
  };
  aside(session_actions_->postpone, &practice::StudySession::postpone, [this](char32_t character) {
    auto& learner = parts().learner();
    auto& store = learner.store();
    if (learner.report(store.postpone(std::span(&character, 1), store.today() + std::chrono::days(1))))
      parts().announce(Feedback::hint, tr("Postponed %1 to tomorrow.").arg(to_text(character)));
  });
  aside(session_actions_->pause, &practice::StudySession::pause, [this](char32_t character) {
    auto& learner = parts().learner();
    auto& store = learner.store();
    const bool paused = store.card(character).paused;
    const auto done = paused ? store.resume(std::span(&character, 1)) : store.pause(std::span(&character, 1));
    if (learner.report(done))
      parts().announce(Feedback::hint, paused
                                           ? tr("Resumed %1.").arg(to_text(character))
                                           : tr("Suspended %1 until you resume it.").arg(to_text(character)));
  });
  aside(session_actions_->reset, &practice::StudySession::reset, [this](char32_t character) {
    auto& learner = parts().learner();
    if (learner.report(learner.store().reset(std::span(&character, 1))))
      parts().announce(Feedback::hint,
                       tr("Started %1 over as a new character. Ctrl+Shift+Z: undo.").arg(to_text(character)));
  });
}

void Characters::show_cross() { parts().tablet().set_cross(parts().preferences().cross); }

void Characters::show_session() {
  const auto& session = parts().session();
  session_actions_->show_state(session, parts().learner().can_write());
  const bool lists = !actions_->draw_to_find->isChecked();
  if (!lists && has_keyboard(*library_panel_)) parts().focus_tablet();
  library_panel_->setVisible(lists);
  if (!practice_.is_entered()) return;
  const auto& memory = practice_.memory();
  const bool is_checked = memory.state() == practice::MemoryStage::State::judged;
  session_bar_->show_state();
  QuestionView::Verdict verdict{tr("Answer shown"), tr("Answer shown"), tr("Answer shown")};
  if (is_checked)
    verdict = {WritingReport::verdict(memory.grade()), WritingReport::spoken_verdict(memory.grade()),
               WritingReport::stars(memory.grade())};
  question_view_->show_state(practice_.sheet(), verdict);
  // In a dictation the session's question would stand above the tablet with the answer.
  const auto* kind = practice::stage_kind(practice_.current_stage().id());
  if (kind != nullptr && !kind->lesson) question_view_->hide();
  session_answers_->show_state();
  session_panel_->show_state(practice_.sheet());
  emit room_changed();
}

}  // namespace nazori::ui
