// SPDX-License-Identifier: Apache-2.0
// What a learner decides about the character that is shown: to learn it, to know it, to tell it from others.
#include "characters/character_actions.h"
#include "characters/characters.h"
#include "characters/confusable_view.h"
#include "characters/drill_dialog.h"
#include "characters/information_panel.h"
#include "characters/standing_bar.h"
#include "nazori/practice/character_choice.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"
#include "study/session_actions.h"
#include "study/study_dialogs.h"

namespace nazori::ui {

void Characters::show_standing() {
  const auto& sheet = practice_.sheet();
  const bool has_character = sheet != nullptr;
  actions_->tell_apart->setEnabled(has_character && !sheet->confusables.empty());
  if (has_character)
    standing_bar_->show_standing(
        practice::standing_of(parts().learner().store(), sheet->character.code_point));
}

void Characters::connect_standing() {
  information_panel_->set_standing(standing_bar_);
  information_panel_->set_confusables(confusable_view_);
  information_panel_->set_knows([this](char32_t one) { return parts().session().knows(one); });
  actions_->tell_apart->setEnabled(false);
  subscribe(parts().learner().changed, this, [this] { show_standing(); });
  const auto on = [this](QAction* action, auto&& what) {
    connect(action, &QAction::triggered, this, std::forward<decltype(what)>(what));
  };
  on(session_actions_->study_this, [this] {
    if (const auto& sheet = practice_.sheet()) {
      auto& session = parts().session();
      if (session.is_running()) session.end();
      (void)session.start_with({sheet->character.code_point});
      parts().focus_tablet();
    }
  });
  on(session_actions_->know_this, [this] {
    const auto& sheet = practice_.sheet();
    if (!sheet) return;
    const char32_t character = sheet->character.code_point;
    auto& learner = parts().learner();
    if (!practice::mark_known(learner, character)) return;
    const auto standing = practice::standing_of(learner.store(), character);
    parts().announce(
        Feedback::good,
        tr("%1 is marked as known. It comes in a review %2. Ctrl+Shift+Z: undo.")
            .arg(to_text(character), StudyWords::comes_again(standing.card, standing.now, standing.today)));
  });
  on(session_actions_->add_to_list, [this] {
    if (const auto& sheet = practice_.sheet()) ask_list(parts(), sheet->character.code_point);
    parts().focus_tablet();
  });
  on(actions_->tell_apart, [this] {
    const auto& sheet = practice_.sheet();
    if (!sheet || sheet->confusables.empty()) return;
    std::vector<char32_t> characters{sheet->character.code_point};
    for (const auto& other : sheet->confusables) characters.push_back(other.code_point);
    parts().library().request_drill(std::move(characters));
  });
  subscribe(parts().library().drill_ready, this, [this](const std::vector<practice::ConfusableFacts>& facts) {
    // Another order every day is variety enough.
    const auto seed = static_cast<unsigned>(parts().learner().store().today().time_since_epoch().count());
    DrillDialog dialog(facts, seed, &parts().window());
    dialog.exec();
    if (!dialog.wants_to_write()) return;
    std::vector<char32_t> characters;
    characters.reserve(facts.size());
    for (const auto& one : facts) characters.push_back(one.character);
    auto& session = parts().session();
    if (session.is_running()) session.end();
    (void)session.start_with(std::move(characters));
    parts().focus_tablet();
  });
}

}  // namespace nazori::ui
