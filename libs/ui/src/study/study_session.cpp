// SPDX-License-Identifier: Apache-2.0
#include "study/study_session.h"

#include <algorithm>
#include <utility>

#include "kanji_text.h"
#include "study/study_words.h"
#include "study/writing_results.h"

namespace nazori::ui {
namespace {

using std::chrono::milliseconds;
using study::Stage;

/// Who takes longer for one stage has left the desk meanwhile.
constexpr milliseconds kLongest{10 * 60 * 1000};
/// Of the reviews of characters that have words, one in so many asks by a word.
constexpr int kEveryWord = 3;

milliseconds steady_time() {
  return std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now().time_since_epoch());
}

}  // namespace

StudySession::StudySession(Learner& learner, Stopwatch stopwatch)
    : learner_(learner), stopwatch_(stopwatch ? std::move(stopwatch) : steady_time) {
  connect(&learner_, &Learner::profile_changed, this, [this] {
    if (is_running()) end();
  });
}

StudySession::~StudySession() = default;

bool StudySession::start(bool leeches) {
  if (!learner_.can_write()) {
    emit said(Feedback::wrong, learner_.trouble());
    return false;
  }
  const auto plan = learner_.plan();
  if (!plan) {
    emit said(Feedback::wrong,
              tr("What is due cannot be told: %1.").arg(to_text(base::to_line(plan.error()))));
    return false;
  }
  if (leeches ? plan->leeches.empty() : plan->now.empty()) {
    emit said(Feedback::hint, tr("Nothing is due now."));
    return false;
  }
  leech_lesson_ = leeches;
  leeches_ = leeches ? plan->leeches : std::vector<char32_t>();
  done_ = 0;
  note_.clear();
  summary_ = {};
  state_ = State::doing;
  next_task();
  return true;
}

void StudySession::end(bool done) {
  if (!is_running()) return;
  state_ = State::idle;
  task_ = {};
  sheet_.reset();
  word_.reset();
  away_ = false;
  emit changed();
  emit ended();
  if (done)
    emit said(Feedback::good, tr("That was all for now. Everything is kept."));
  else
    emit said(Feedback::hint, tr("The session has ended. Everything that was rated is kept."));
}

void StudySession::measure(const study::DayPlan& plan) {
  left_ = leech_lesson_ ? static_cast<int>(leeches_.size()) : static_cast<int>(plan.now.size());
  constexpr milliseconds kLeech{120'000};
  time_left_ = leech_lesson_ ? kLeech * left_ : plan.estimate;
}

void StudySession::next_task() {
  const auto plan = learner_.plan();
  if (!plan) {
    emit said(Feedback::wrong, to_text(base::to_line(plan.error())));
    end(true);
    return;
  }
  // What was paused or reset meanwhile is no leech any more.
  std::erase_if(leeches_, [&](char32_t one) {
    return std::find(plan->leeches.begin(), plan->leeches.end(), one) == plan->leeches.end();
  });
  measure(*plan);
  if (left_ == 0) {
    end(true);
    return;
  }
  if (leech_lesson_) {
    study::StudyTask task;
    task.character = leeches_.front();
    task.stage = Stage::watch;
    present(task);
  } else {
    study::StudyTask task = plan->now.front();
    // After days a review asks first; practice may follow.
    if (task.kind == study::TaskKind::review) task.stage = Stage::memory;
    present(task);
  }
}

void StudySession::present(const study::StudyTask& task) {
  task_ = task;
  reviewed_ = false;
  peeked_ = false;
  sheet_.reset();
  word_.reset();
  ink_ = {};
  away_ = false;
  begin_stage(task.stage);
  emit character_wanted(task.character);
}

void StudySession::begin_stage(Stage stage) {
  stage_ = stage;
  state_ = State::doing;
  since_ = stopwatch_();
  last_stroke_ = milliseconds(0);
  hints_ = misses_ = shown_ = 0;
  missed_stroke_ = -1;
  misses_of_stroke_ = 0;
  ink_ = {};
  final_ = false;
  emit changed();
}

double StudySession::help() const { return store().card(task_.character).help; }

void StudySession::take_sheet(const std::shared_ptr<const practice::CharacterSheet>& sheet) {
  if (!is_running()) return;
  away_ = !sheet || sheet->character.code_point != task_.character;
  if (away_ && state_ == State::judged) final_ = true;
  if (!away_) {
    sheet_ = sheet;
    choose_word();
    since_ = stopwatch_();
  }
  emit changed();
}

void StudySession::choose_word() {
  word_.reset();
  const auto card = store().card(task_.character);
  if (!asks_by_words_ || task_.kind == study::TaskKind::fresh) return;
  if ((card.memory.reps + static_cast<int>(task_.character)) % kEveryWord != 0) return;
  const QString own = to_text(task_.character);
  for (const auto& word : sheet_->words) {
    const QString text = to_text(word.text);
    // A word of this character alone, or one that has it twice, asks for too little or too much.
    if (!word.common || word.glosses.empty() || text.size() < own.size() + 1 || text.count(own) != 1)
      continue;
    word_ = word;
    return;
  }
}

void StudySession::enter_stage(Stage stage) {
  if (!is_running() || away_) return;
  if (state_ == State::judged) {
    // It stays as it was judged, whatever the learner looks at before rating it.
    final_ = true;
    return;
  }
  // To look at the strokes before a review is to be shown them all.
  if (task_.kind != study::TaskKind::fresh && asks_from_memory() && stage != Stage::memory && !reviewed_)
    peeked_ = true;
  if (stage == stage_ && state_ == State::doing) {
    since_ = stopwatch_();
    return;
  }
  begin_stage(stage);
}

milliseconds StudySession::elapsed() const { return std::min(kLongest, stopwatch_() - since_); }

void StudySession::note_stroke() { last_stroke_ = elapsed(); }

study::MissReply StudySession::note_miss(int stroke) {
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

bool StudySession::keep(Stage stage, study::Rating rating, study::Rating proposed,
                        const study::WritingResult& result, const study::Ink& ink) {
  study::Writing writing;
  writing.stage = stage;
  writing.rating = rating;
  writing.proposed = proposed;
  writing.result = result;
  const bool first = !store().card(task_.character).introduced.has_value();
  const int strokes = std::max<int>(1, sheet_ ? static_cast<int>(sheet_->character.strokes.size()) : 1);
  const auto kept = store().add_writing(task_.character, strokes, writing, ink);
  if (!kept) {
    (void)learner_.take(kept);
    return false;
  }
  summary_.time += result.duration;
  if (first) summary_.met.push_back(task_.character);
  if (stage == Stage::memory) {
    ++summary_.reviews;
    ++summary_.ratings[static_cast<std::size_t>(rating) - 1];
    std::erase(summary_.again, task_.character);
    if (rating == study::Rating::again) summary_.again.push_back(task_.character);
  } else {
    ++summary_.practices;
  }
  return learner_.take(kept);
}

void StudySession::take_practice(Stage stage, study::WritingResult result) {
  if (state_ != State::doing || away_ || stage != stage_) return;
  result.hints = hints_;
  result.shown_strokes = std::max(result.shown_strokes, shown_);
  result.misses = std::max(result.misses, misses_);
  result.duration = elapsed();
  if (!keep(stage, study::Rating::good, study::Rating::good, result, {})) return;
  const auto card = store().card(task_.character);
  stage_ = card.next_stage;
  // Enough for today: a review that failed is practised, not asked for again at once.
  const bool over = (reviewed_ || leech_lesson_) && stage_ == Stage::memory;
  state_ = State::offered;
  if (over) reviewed_ = true;
  emit changed();
}

void StudySession::judge(study::WritingResult result, const std::vector<practice::HandStroke>& strokes) {
  result.hints = hints_;
  result.misses = misses_;
  result.shown_strokes = shown_;
  if (peeked_)
    result.shown_strokes = std::max<int>(1, sheet_ ? static_cast<int>(sheet_->character.strokes.size()) : 1);
  result.duration = last_stroke_.count() > 0 ? last_stroke_ : elapsed();
  result_ = std::move(result);
  ink_ = to_study_ink(strokes);
  const auto usual = store().usual_writing(task_.character);
  if (!usual) learner_.announce_unread(usual.error());
  proposed_ = study::proposed_rating(result_, usual.value_or(study::UsualWriting{}));
  state_ = State::judged;
  emit changed();
}

void StudySession::take_judgement(const writing::Grade& grade,
                                  const std::vector<practice::HandStroke>& strokes) {
  if (!is_running() || away_ || stage_ != Stage::memory || state_ == State::offered || final_) return;
  judge(to_result(grade), strokes);
}

void StudySession::take_surrender(const std::vector<practice::HandStroke>& strokes) {
  if (!is_running() || away_ || stage_ != Stage::memory || state_ == State::offered || final_) return;
  study::WritingResult result;
  result.accepted = false;
  result.score = 0;
  shown_ = std::max<int>(1, sheet_ ? static_cast<int>(sheet_->character.strokes.size()) : 1);
  judge(result, strokes);
}

void StudySession::take_back_judgement() {
  if (state_ != State::judged || final_) return;
  // Who corrects what the judge refused had a miss.
  if (!result_.accepted) ++misses_;
  state_ = State::doing;
  emit changed();
}

base::Result<study::Card> StudySession::after(study::Rating rating) const {
  return store().preview(task_.character, rating);
}

void StudySession::rate(study::Rating rating) {
  if (state_ != State::judged) return;
  if (!keep(Stage::memory, rating, proposed_, result_, ink_)) return;
  reviewed_ = true;
  const auto card = store().card(task_.character);
  const QString next = StudyWords::comes_again(card, store().now(), store().today());
  if (card.leech)
    tell(Feedback::advice, tr("%1 is forgotten often. It is set apart: Home offers another lesson for it.")
                               .arg(to_text(task_.character)));
  else
    tell(
        Feedback::good,
        tr("Kept: %1 is “%2” and comes %3.").arg(to_text(task_.character), StudyWords::rating(rating), next));
  if (card.next_stage != Stage::memory && !card.leech) {
    // Where it failed it is practised now, with the help that the error asks for.
    stage_ = card.next_stage;
    begin_stage(stage_);
    emit stage_wanted(stage_);
    return;
  }
  finish_task();
}

void StudySession::finish_task() {
  ++done_;
  if (leech_lesson_) std::erase(leeches_, task_.character);
  next_task();
}

void StudySession::go_on() {
  if (!is_running()) return;
  if (away_) {
    emit character_wanted(task_.character);
    return;
  }
  switch (state_) {
    case State::idle:
    case State::doing:
      return;
    case State::judged:
      rate(proposed_);
      return;
    case State::offered:
      if (is_over()) {
        if (leech_lesson_) {
          if (!learner_.take(store().leech_met(std::span(&task_.character, 1)))) return;
          summary_.lessons.push_back(task_.character);
        }
        finish_task();
        return;
      }
      begin_stage(stage_);
      emit stage_wanted(stage_);
      return;
  }
}

void StudySession::undo() {
  if (!learner_.can_write()) {
    emit said(Feedback::wrong, learner_.trouble());
    return;
  }
  const auto undone = store().undo();
  if (!learner_.take(undone)) return;
  if (!*undone) {
    emit said(Feedback::hint, tr("There is nothing to take back."));
    return;
  }
  QString about;
  for (const char32_t one : (*undone)->characters) {
    if (about.size() > 20) {
      about += QStringLiteral("…");
      break;
    }
    about += to_text(one);
  }
  QString sentence;
  switch ((*undone)->kind) {
    case study::EntryKind::writing:
      sentence = tr("Taken back: the last writing of %1.");
      break;
    case study::EntryKind::postpone:
      sentence = tr("Taken back: %1 is not postponed.");
      break;
    case study::EntryKind::pause:
      sentence = tr("Taken back: %1 is not paused.");
      break;
    case study::EntryKind::resume:
      sentence = tr("Taken back: %1 is paused again.");
      break;
    case study::EntryKind::reset:
      sentence = tr("Taken back: what was learnt of %1 is there again.");
      break;
    default:
      sentence = tr("Taken back: %1.");
      break;
  }
  tell(Feedback::hint, sentence.arg(about));
  if (!is_running()) return;
  if ((*undone)->kind != study::EntryKind::leech_met && (*undone)->characters.size() == 1) {
    const char32_t back = (*undone)->characters.front();
    const auto card = store().card(back);
    if (back != task_.character && done_ > 0) --done_;
    study::StudyTask task;
    task.kind = card.memory.phase == study::Phase::fresh    ? study::TaskKind::fresh
                : card.memory.phase == study::Phase::review ? study::TaskKind::review
                                                            : study::TaskKind::step;
    task.character = back;
    task.stage = card.next_stage;
    if (const auto plan = learner_.plan()) measure(*plan);
    present(task);
  } else {
    next_task();
  }
}

void StudySession::tell(Feedback kind, const QString& sentence) {
  note_ = sentence;
  emit said(kind, sentence);
}

void StudySession::put_aside(const base::Result<void>& done, const QString& sentence) {
  if (!learner_.take(done)) return;
  tell(Feedback::hint, tr("%1 Ctrl+Shift+Z takes it back.").arg(sentence));
  if (leech_lesson_) std::erase(leeches_, task_.character);
  next_task();
}

void StudySession::postpone() {
  if (!is_running()) return;
  put_aside(store().postpone(std::span(&task_.character, 1), store().today() + std::chrono::days(1)),
            tr("%1 comes tomorrow.").arg(to_text(task_.character)));
}

void StudySession::pause() {
  if (!is_running()) return;
  put_aside(store().pause(std::span(&task_.character, 1)),
            tr("%1 is paused until it is asked for.").arg(to_text(task_.character)));
}

void StudySession::reset() {
  if (!is_running()) return;
  put_aside(store().reset(std::span(&task_.character, 1)),
            tr("%1 is new again.").arg(to_text(task_.character)));
}

}  // namespace nazori::ui
