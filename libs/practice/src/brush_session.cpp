// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/brush_session.h"

#include <algorithm>
#include <span>
#include <utility>

#include "nazori/practice/writing_results.h"
#include "undo_last.h"

namespace nazori::practice {
namespace {

using std::chrono::milliseconds;
using Kind = SessionFeedback::Kind;

/// Longer than this means that the learner walked away, so the time is not counted.
constexpr milliseconds kLongestWithBrush{10 * 60 * 1000};

/// As WritingResult::help.
double help_of(BrushModel model) {
  switch (model) {
    case BrushModel::none:
      return 0;
    case BrushModel::beside:
      return 0.5;
    case BrushModel::beneath:
      return 1;
  }
  return 0;
}

}  // namespace

BrushSession::BrushSession(Learner& learner, const base::Clock& clock) : learner_(learner), clock_(clock) {
  profile_changed_ = learner_.profile_changed.connect([this] { end(); });
}

bool BrushSession::start() {
  if (!learner_.can_write()) {
    announce(Kind::not_writable);
    return false;
  }
  skipped_.clear();
  const auto all = due();
  if (!all) {
    announce(Kind::no_plan, all.error());
    return false;
  }
  if (all->empty()) {
    announce(Kind::nothing_due);
    return false;
  }
  done_ = 0;
  left_ = static_cast<int>(all->size());
  present(all->front());
  return true;
}

void BrushSession::end(bool done) {
  if (is_running()) stop(done ? Kind::all_done : Kind::ended);
}

void BrushSession::stop(SessionFeedback::Kind why, const base::Error& error) {
  state_ = State::idle;
  changed();
  ended();
  announce(why, error);
}

base::Result<std::vector<char32_t>> BrushSession::due() {
  auto plan = learner_.plan();
  if (!plan) return tl::unexpected(std::move(plan.error()));
  std::erase_if(plan->brush, [this](char32_t one) {
    return std::find(skipped_.begin(), skipped_.end(), one) != skipped_.end();
  });
  return std::move(plan->brush);
}

void BrushSession::next() {
  const auto all = due();
  left_ = all ? static_cast<int>(all->size()) : 0;
  if (!all) return stop(Kind::plan_lost, all.error());
  if (all->empty()) return end(true);
  present(all->front());
}

void BrushSession::present(char32_t character) {
  character_ = character;
  state_ = State::writing;
  model_ = shown_;
  since_ = clock_.steady();
  last_stroke_ = milliseconds(0);
  result_ = {};
  ink_.clear();
  strokes_ = 1;
  if (const auto* database = learner_.database())
    if (const auto found = database->find(character))
      strokes_ = std::max(1, static_cast<int>(found->strokes.size()));
  changed();
  character_wanted(character);
}

milliseconds BrushSession::elapsed() const {
  return std::min(kLongestWithBrush, std::chrono::duration_cast<milliseconds>(clock_.steady() - since_));
}

void BrushSession::show_model(BrushModel model) {
  shown_ = model;
  if (state_ != State::writing || model <= model_) return;
  model_ = model;
  changed();
}

void BrushSession::add_stroke() {
  if (is_running()) last_stroke_ = elapsed();
}

void BrushSession::judge(const std::optional<writing::Grade>& grade, const study::Handwriting& ink) {
  if (state_ != State::writing) return;
  result_ = {};
  if (grade) {
    result_ = to_result(*grade);
  } else {
    result_.accepted = false;
    result_.score = 0;
  }
  result_.help = help_of(model_);
  result_.duration = last_stroke_.count() > 0 ? last_stroke_ : elapsed();
  ink_ = to_saved(ink);
  state_ = State::advised;
  changed();
}

void BrushSession::reopen() {
  if (state_ != State::advised) return;
  state_ = State::writing;
  // The advice has shown the model.
  model_ = std::max(model_, BrushModel::beside);
  changed();
}

study::Rating BrushSession::proposed() const {
  return result_.accepted ? study::Rating::good : study::Rating::again;
}

base::Result<study::Card> BrushSession::after(study::Rating rating) const {
  return learner_.store().preview(character_, rating, study::Stage::brush);
}

void BrushSession::rate(study::Rating rating) {
  if (state_ != State::advised) return;
  study::Writing writing;
  writing.stage = study::Stage::brush;
  writing.rating = rating;
  writing.proposed = proposed();
  writing.result = result_;
  const auto card = learner_.store().add_writing(character_, strokes_, writing, ink_);
  if (!learner_.report(card)) return;
  SessionFeedback event;
  event.kind = Kind::rated;
  event.characters = {character_};
  event.stage = study::Stage::brush;
  event.rating = rating;
  event.card = *card;
  event.now = learner_.store().now();
  event.today = learner_.store().today();
  announced(event);
  ++done_;
  next();
}

void BrushSession::skip() {
  if (!is_running()) return;
  skipped_.push_back(character_);
  next();
}

void BrushSession::undo() {
  auto event = undo_last(learner_);
  if (!event) return;
  const bool undone = event->kind == Kind::undone;
  if (!undone) event->stage = study::Stage::brush;
  announced(*event);
  if (!undone) return;
  if (!is_running()) return;
  const auto all = due();
  if (!all) return stop(Kind::plan_lost, all.error());
  left_ = static_cast<int>(all->size());
  if (event->characters.size() != 1) return changed();
  const char32_t back = event->characters.front();
  const bool is_due = std::find(all->begin(), all->end(), back) != all->end();
  if (!is_due || back == character_) return changed();
  if (done_ > 0) --done_;
  present(back);
}

void BrushSession::announce(SessionFeedback::Kind kind, const base::Error& error) {
  SessionFeedback event;
  event.kind = kind;
  event.stage = study::Stage::brush;
  event.error = error;
  if (kind == Kind::not_writable) event.trouble = learner_.trouble();
  announced(event);
}

}  // namespace nazori::practice
