// SPDX-License-Identifier: Apache-2.0
// The study session: what the learner does on the tablet, and what of it is saved.
#include <algorithm>
#include <utility>

#include "nazori/practice/study_session.h"
#include "nazori/practice/writing_results.h"

namespace nazori::practice {
namespace {

using std::chrono::milliseconds;
using study::Stage;

/// Longer than this means that the learner walked away, so the time is not counted.
constexpr milliseconds kLongest{10 * 60 * 1000};

}  // namespace

void StudySession::enter_stage(Stage stage) {
  if (!is_running() || away_) return;
  if (state_ == State::judged) {
    // It stays as it was judged, whatever the learner looks at before rating it.
    final_ = true;
    return;
  }
  if (stage != Stage::memory) note_look();
  if (stage == stage_ && state_ == State::doing) {
    since_ = clock_.steady();
    return;
  }
  begin_stage(stage);
}

void StudySession::leave_lesson() {
  if (!is_running() || away_) return;
  if (state_ == State::judged)
    final_ = true;
  else
    note_look();
}

void StudySession::note_look() {
  // Looking at the strokes before a review counts as being shown all of them.
  if (task_.kind != study::TaskKind::fresh && asks_from_memory() && !reviewed_) looked_ = true;
}

milliseconds StudySession::elapsed() const {
  return std::min(kLongest, std::chrono::duration_cast<milliseconds>(clock_.steady() - since_));
}

void StudySession::add_stroke() { last_stroke_ = elapsed(); }

study::MissReply StudySession::add_mistake(int stroke) {
  ++misses_;
  misses_of_stroke_ = stroke == missed_stroke_ ? misses_of_stroke_ + 1 : 1;
  missed_stroke_ = stroke;
  const auto reply = study::reply_to_miss(misses_of_stroke_, store().settings().lesson);
  if (reply == study::MissReply::show) {
    ++shown_;
    misses_of_stroke_ = 0;
  }
  return reply;
}

bool StudySession::save(Stage stage, study::Rating rating, study::Rating proposed,
                        const study::WritingResult& result, const study::Handwriting& ink) {
  study::Writing writing;
  writing.stage = stage;
  writing.rating = rating;
  writing.proposed = proposed;
  writing.result = result;
  const int strokes = std::max<int>(1, sheet_ ? static_cast<int>(sheet_->character.strokes.size()) : 1);
  const auto kept = store().add_writing(task_.character, strokes, writing, ink);
  if (!kept) {
    (void)learner_.report(kept);
    return false;
  }
  return learner_.report(kept);
}

void StudySession::finish_stage(Stage stage, study::WritingResult result) {
  if (state_ != State::doing || away_ || stage != stage_) return;
  result.hints = hints_;
  result.shown_strokes = std::max(result.shown_strokes, shown_);
  result.misses = std::max(result.misses, misses_);
  result.duration = elapsed();
  if (!save(stage, study::Rating::good, study::Rating::good, result, {})) return;
  const auto card = store().card(task_.character);
  stage_ = card.next_stage;
  // Enough for today: a review that failed is practised, not asked for again at once.
  const bool over = (reviewed_ || leech_lesson_) && stage_ == Stage::memory;
  state_ = State::offered;
  if (over) reviewed_ = true;
  changed();
}

void StudySession::propose(study::WritingResult result, const std::vector<HandStroke>& strokes) {
  result.hints = hints_;
  result.misses = misses_;
  result.shown_strokes = shown_;
  if (looked_)
    result.shown_strokes = std::max<int>(1, sheet_ ? static_cast<int>(sheet_->character.strokes.size()) : 1);
  result.duration = last_stroke_.count() > 0 ? last_stroke_ : elapsed();
  result_ = std::move(result);
  ink_ = to_handwriting(strokes);
  const auto usual = store().usual_writing(task_.character);
  if (!usual) learner_.announce_unread(usual.error());
  proposed_ = study::suggested_rating(result_, usual.value_or(study::UsualWriting{}));
  state_ = State::judged;
  changed();
}

void StudySession::judge(const writing::Grade& grade, const std::vector<HandStroke>& strokes) {
  if (!is_running() || away_ || stage_ != Stage::memory || state_ == State::offered || final_) return;
  propose(to_result(grade), strokes);
}

void StudySession::give_up(const std::vector<HandStroke>& strokes) {
  if (!is_running() || away_ || stage_ != Stage::memory || state_ == State::offered || final_) return;
  study::WritingResult result;
  result.accepted = false;
  result.score = 0;
  shown_ = std::max<int>(1, sheet_ ? static_cast<int>(sheet_->character.strokes.size()) : 1);
  propose(result, strokes);
}

void StudySession::reopen() {
  if (state_ != State::judged || final_) return;
  // Correcting a rejected writing counts as one mistake.
  if (!result_.accepted) ++misses_;
  state_ = State::doing;
  changed();
}

}  // namespace nazori::practice
