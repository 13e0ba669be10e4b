// SPDX-License-Identifier: Apache-2.0
// The hand of a teacher: the brush writes the model by itself.
#include <QAction>
#include <utility>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {

void BrushPage::watch_teacher() {
  if (is_watching()) {
    stop_teacher();
    return parts().respond(Feedback::hint, tr("Stopped."));
  }
  auto strokes = model_strokes();
  if (strokes.empty())
    return parts().respond(Feedback::hint, tr("There is no model to be written. T: type a text."));
  if (writing_->state().strokes > 0) {
    is_quiet_ = true;
    writing_->take_new_sheet(choice_.paper);
  }
  writing_->dip_in_ink();
  awaits_hand_ = true;
  writing_->request_hand(std::move(strokes));
  wake();
}

void BrushPage::begin_hand(std::vector<brush::PenSample> hand) {
  if (!std::exchange(awaits_hand_, false) || hand.empty()) return;
  int strokes = 0;
  for (std::size_t i = 1; i < hand.size(); ++i) strokes += hand[i].down && !hand[i - 1].down ? 1 : 0;
  if (felt_.lead(hand))
    return parts().announce(
        Feedback::hint,
        tr("Hold the stylus loosely: it leads your hand through %n strokes. V: stop.", nullptr, strokes));
  hand_ = std::move(hand);
  hand_next_ = 0;
  hand_begins_s_ = paper_->pen_clock_s();
  hand_time_s_ = 0;
  parts().announce(Feedback::hint, tr("Watch: %n strokes. V: stop.", nullptr, strokes));
  wake();
}

void BrushPage::move_hand(double seconds) {
  if (hand_.empty()) return;
  hand_time_s_ += seconds;
  for (; hand_next_ < hand_.size() && hand_[hand_next_].time_s <= hand_time_s_; ++hand_next_) {
    brush::PenSample sample = hand_[hand_next_];
    const bool lifts = hand_next_ > 0 && hand_[hand_next_ - 1].down && !sample.down;
    sample.time_s += hand_begins_s_;
    writing_->move_pen(sample);
    paper_->show_brush_at(sample.at);
    if (lifts) dip_between_strokes();
  }
  if (hand_next_ < hand_.size()) return;
  stop_teacher();
  tell_written();
}

void BrushPage::dip_between_strokes() {
  constexpr double kDipsAt = 0.3;
  if (writing_->state().fullness < kDipsAt) writing_->dip_in_ink();
}

void BrushPage::tell_written() {
  parts().announce(Feedback::good, tr("That is how it is written. Ctrl+N: a new sheet for you."));
}

void BrushPage::stop_teacher() {
  awaits_hand_ = false;
  felt_.stop_leading();
  if (hand_.empty()) return;
  hand_.clear();
  writing_->lift_pen();
  paper_->take_brush_away();
}

}  // namespace nazori::ui
