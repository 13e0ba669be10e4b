// SPDX-License-Identifier: Apache-2.0
// Reviews with the brush: which character is on the sheet, and what becomes of it.
#include <QAction>
#include <algorithm>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/brush/brush_review_bar.h"
#include "nazori/studio/brush/brush_words.h"
#include "nazori/studio/brush/tools_panel.h"
#include "nazori/studio/parts/unsaved_box.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {

using State = practice::BrushSession::State;

bool BrushPage::reviews() const { return parts().brush_session().is_running(); }

void BrushPage::connect_reviews() {
  auto& session = parts().brush_session();
  on(actions_->review, [this] { start_reviews(); });
  on(actions_->go_on, [this] { go_on(); });
  on(actions_->skip, [&session] { session.skip(); });
  on(actions_->undo_rating, [&session] { session.undo(); });
  on(actions_->end, [&session] { session.end(); });
  for (std::size_t i = 0; i < actions_->rate.size(); ++i)
    on(actions_->rate[i], [&session, i] { session.rate(study::kRatings[i]); });
  connect(&parts(), &WindowParts::review_with_brush, this, [this] {
    if (!entered_) emit wants_to_be_entered();
    start_reviews();
  });
  subscribe(session.changed, this, [this] { show_reviews(); });
  subscribe(session.character_wanted, this, [this](char32_t) { take_character(); });
  subscribe(session.ended, this, [this] { end_reviews(); });
}

void BrushPage::start_reviews() {
  auto& session = parts().brush_session();
  if (session.is_running()) return parts().focus_tablet();
  if (parts().learner().store().settings().brush_per_day == 0) {
    return parts().announce(Feedback::hint,
                            tr("Reviews with the brush are off. Choose how many you want a day "
                               "at Home, in Study settings, Daily goal."));
  }
  if (!writing_->state().is_saved && writing_->state().strokes > 0) {
    const Unsaved choice = ask_unsaved(
        "unsaved_sheet_box", tr("The sheet with your brush writing is not saved."), &parts().window());
    if (choice == Unsaved::save) ask_and_save();
    if (choice != Unsaved::discard) return;
  }
  session.show_model(brush_model_of(choice_.place));
  if (!session.start()) return;
  parts().focus_tablet();
}

void BrushPage::make_room() {
  if (!reviews() || tools_folded_ || tools_wanted_ || !choice_.show_tools) return;
  const int width = widget_->width() - panel_->sizeHint().width();
  const int side = std::min(width, widget_->height() - bar_->heightForWidth(width));
  const QSize window = parts().window().size();
  if (2 * side < std::min(window.width(), window.height())) fold_tools(true);
}

void BrushPage::fold_tools(bool folded) {
  if (folded == tools_folded_ || !choice_.show_tools) return;
  tools_folded_ = folded;
  actions_->tools->setChecked(!folded);
  panel_->setVisible(!folded);
}

void BrushPage::take_character() {
  if (!writing_) return;
  is_quiet_ = true;
  strokes_ = 0;
  part_ = 0;
  writing_->set_brush({calligraphy::size_for(1), choice_.brush.hair});
  writing_->take_new_sheet(choice_.paper);
  panel_->show_ruling(ruling());
  panel_->set_model_free(false);
  request_model();
  show_reviews();
  wake();
}

void BrushPage::show_reviews() {
  const auto& session = parts().brush_session();
  actions_->show_session(session.is_running(), session.state() == State::advised);
  std::optional<kanji::Character> character;
  if (const auto known = characters_.find(session.character()); known != characters_.end())
    character = known->second;
  bar_->show_state(character);
  make_room();
}

void BrushPage::end_reviews() {
  fold_tools(false);
  tools_wanted_ = false;
  panel_->set_model_free(true);
  panel_->show_ruling(choice_.ruling);
  show_reviews();
  if (!writing_) return;
  is_quiet_ = true;
  writing_->set_brush(choice_.brush);
  writing_->take_new_sheet(choice_.paper);
  request_model();
  wake();
}

void BrushPage::go_on() {
  auto& session = parts().brush_session();
  if (session.state() == State::advised) return session.rate(session.proposed());
  if (session.state() == State::writing && !actions_->advice->isChecked()) actions_->advice->trigger();
}

void BrushPage::judge(const calligraphy::CharacterAdvice& advice) {
  auto& session = parts().brush_session();
  if (session.state() != State::writing || advice.character != session.character()) return;
  session.judge(advice.grade, advice.ink);
}

void BrushPage::note_strokes(int strokes) {
  if (reviews() && strokes > strokes_) parts().brush_session().add_stroke();
  strokes_ = strokes;
}

}  // namespace nazori::ui
