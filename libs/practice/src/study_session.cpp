// SPDX-License-Identifier: Apache-2.0
// The study session: which character comes next, and what the learner decides about it.
#include "nazori/practice/study_session.h"

#include <algorithm>
#include <string>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana_sound.h"
#include "undo_last.h"

namespace nazori::practice {
namespace {

using std::chrono::milliseconds;
using study::Stage;
using Kind = SessionFeedback::Kind;

/// Of the reviews of characters that have words, one in so many asks by a word.
constexpr int kEveryWord = 3;

/// What one chosen character takes, about.
constexpr milliseconds kChosen{60'000};

}  // namespace

StudySession::StudySession(Learner& learner, const base::Clock& clock) : learner_(learner), clock_(clock) {
  profile_changed_ = learner_.profile_changed.connect([this] {
    if (is_running()) end();
  });
}

StudySession::~StudySession() = default;

bool StudySession::knows(char32_t character) const { return store().card(character).introduced.has_value(); }

bool StudySession::start(bool leeches) {
  if (!learner_.can_write()) {
    announce(Kind::not_writable);
    return false;
  }
  const auto plan = learner_.plan();
  if (!plan) {
    announce(Kind::no_plan, plan.error());
    return false;
  }
  if (leeches ? plan->leeches.empty() : plan->now.empty()) {
    announce(Kind::nothing_due);
    return false;
  }
  leech_lesson_ = leeches;
  leeches_ = leeches ? plan->leeches : std::vector<char32_t>();
  has_choice_ = false;
  begin();
  return true;
}

bool StudySession::start_with(std::vector<char32_t> characters) {
  if (!learner_.can_write()) {
    announce(Kind::not_writable);
    return false;
  }
  if (characters.empty()) {
    announce(Kind::nothing_due);
    return false;
  }
  leech_lesson_ = false;
  leeches_.clear();
  has_choice_ = true;
  chosen_ = std::move(characters);
  begin();
  return true;
}

void StudySession::begin() {
  done_ = 0;
  last_event_.reset();
  state_ = State::doing;
  next_task();
}

void StudySession::end(bool done) {
  if (is_running()) stop(done ? Kind::all_done : Kind::ended);
}

void StudySession::stop(SessionFeedback::Kind why, const base::Error& error) {
  state_ = State::idle;
  task_ = {};
  sheet_.reset();
  word_.reset();
  away_ = false;
  changed();
  ended();
  announce(why, error);
}

void StudySession::measure(const study::DayPlan& plan) {
  if (has_choice_) {
    left_ = static_cast<int>(chosen_.size());
    time_left_ = kChosen * left_;
    return;
  }
  left_ = leech_lesson_ ? static_cast<int>(leeches_.size()) : static_cast<int>(plan.now.size());
  constexpr milliseconds kLeech{120'000};
  time_left_ = leech_lesson_ ? kLeech * left_ : plan.estimate;
}

void StudySession::next_task() {
  const auto plan = learner_.plan();
  if (!plan) return stop(Kind::plan_lost, plan.error());
  // What was paused or reset meanwhile is no leech any more.
  std::erase_if(leeches_, [&](char32_t one) {
    return std::find(plan->leeches.begin(), plan->leeches.end(), one) == plan->leeches.end();
  });
  measure(*plan);
  if (left_ == 0) {
    end(true);
    return;
  }
  if (has_choice_) {
    const auto card = store().card(chosen_.front());
    study::StudyTask task;
    task.kind = card.memory.phase == study::Phase::fresh ? study::TaskKind::fresh : study::TaskKind::review;
    task.character = chosen_.front();
    task.stage = task.kind == study::TaskKind::fresh ? card.next_stage : Stage::memory;
    present(task);
  } else if (leech_lesson_) {
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
  looked_ = false;
  sheet_.reset();
  word_.reset();
  ink_ = {};
  away_ = false;
  begin_stage(task.stage);
  character_wanted(task.character);
}

void StudySession::begin_stage(Stage stage) {
  stage_ = stage;
  state_ = State::doing;
  since_ = clock_.steady();
  last_stroke_ = milliseconds(0);
  hints_ = misses_ = shown_ = 0;
  missed_stroke_ = -1;
  misses_of_stroke_ = 0;
  ink_ = {};
  final_ = false;
  changed();
}

double StudySession::help() const { return store().card(task_.character).help; }

void StudySession::set_sheet(const std::shared_ptr<const CharacterSheet>& sheet) {
  if (!is_running()) return;
  away_ = !sheet || sheet->character.code_point != task_.character;
  if (away_ && state_ == State::judged) final_ = true;
  if (!away_) {
    sheet_ = sheet;
    choose_word();
    since_ = clock_.steady();
  }
  changed();
}

void StudySession::choose_word() {
  word_.reset();
  const auto card = store().card(task_.character);
  if (!asks_by_words_ || task_.kind == study::TaskKind::fresh) return;
  if ((card.memory.reps + static_cast<int>(task_.character)) % kEveryWord != 0) return;
  if (kanji::kana_sound(task_.character)) {
    // A kana is asked for by a word only where all its other kana are known.
    for (const auto& one : sheet_->dictation) {
      const auto is_known = [&](char32_t kana) { return kana == task_.character || knows(kana); };
      const auto times = std::count(one.characters.begin(), one.characters.end(), task_.character);
      if (times != 1 || !std::all_of(one.characters.begin(), one.characters.end(), is_known)) continue;
      word_ = one.word;
      return;
    }
    return;
  }
  const std::string own = base::encode_utf8(task_.character);
  for (const auto& word : sheet_->words) {
    // A word of this character alone, or one that has it twice, asks for too little or too much.
    const auto at = word.text.find(own);
    if (!word.common || word.glosses.empty() || word.text.size() <= own.size() || at == std::string::npos ||
        word.text.find(own, at + own.size()) != std::string::npos)
      continue;
    word_ = word;
    return;
  }
}

base::Result<study::Card> StudySession::after(study::Rating rating) const {
  return store().preview(task_.character, rating);
}

void StudySession::rate(study::Rating rating) {
  if (state_ != State::judged) return;
  if (!save(Stage::memory, rating, proposed_.rating, result_, ink_)) return;
  reviewed_ = true;
  const auto card = store().card(task_.character);
  SessionFeedback event = about_character(card.leech ? Kind::set_apart : Kind::rated);
  event.rating = rating;
  event.card = card;
  event.now = store().now();
  event.today = store().today();
  announce_event(event);
  if (card.next_stage != Stage::memory && !card.leech) {
    // Where it failed it is practised now, with the help that the error asks for.
    stage_ = card.next_stage;
    begin_stage(stage_);
    stage_wanted(stage_);
    return;
  }
  finish_task();
}

void StudySession::finish_task() {
  ++done_;
  if (leech_lesson_) std::erase(leeches_, task_.character);
  std::erase(chosen_, task_.character);
  next_task();
}

void StudySession::go_on() {
  if (!is_running()) return;
  if (away_) {
    character_wanted(task_.character);
    return;
  }
  switch (state_) {
    case State::idle:
    case State::doing:
      return;
    case State::judged:
      rate(proposed_.rating);
      return;
    case State::offered:
      if (is_over()) {
        if (leech_lesson_) {
          if (!learner_.report(store().leech_met(std::span(&task_.character, 1)))) return;
        }
        finish_task();
        return;
      }
      begin_stage(stage_);
      stage_wanted(stage_);
      return;
  }
}

void StudySession::undo() {
  const auto event = undo_last(learner_);
  if (!event) return;
  if (event->kind != Kind::undone) return announced(*event);
  announce_event(*event);
  if (!is_running()) return;
  if (event->entry != study::EntryKind::leech_met && event->characters.size() == 1) {
    const char32_t back = event->characters.front();
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

SessionFeedback StudySession::about_character(SessionFeedback::Kind kind) const {
  SessionFeedback event;
  event.kind = kind;
  event.characters = {task_.character};
  return event;
}

void StudySession::announce(SessionFeedback::Kind kind, const base::Error& error) {
  SessionFeedback event;
  event.kind = kind;
  event.error = error;
  if (kind == Kind::not_writable) event.trouble = learner_.trouble();
  announced(event);
}

void StudySession::announce_event(const SessionFeedback& event) {
  last_event_ = event;
  announced(event);
}

void StudySession::put_aside(const base::Result<void>& done, SessionFeedback::Kind kind) {
  if (!learner_.report(done)) return;
  announce_event(about_character(kind));
  if (leech_lesson_) std::erase(leeches_, task_.character);
  std::erase(chosen_, task_.character);
  next_task();
}

void StudySession::postpone() {
  if (!is_running()) return;
  put_aside(store().postpone(std::span(&task_.character, 1), store().today() + std::chrono::days(1)),
            Kind::postponed);
}

void StudySession::pause() {
  if (!is_running()) return;
  put_aside(store().pause(std::span(&task_.character, 1)), Kind::paused);
}

void StudySession::reset() {
  if (!is_running()) return;
  put_aside(store().reset(std::span(&task_.character, 1)), Kind::reset);
}

}  // namespace nazori::practice
