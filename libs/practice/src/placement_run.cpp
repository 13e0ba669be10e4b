// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/placement_run.h"

#include <chrono>
#include <utility>

#include "nazori/practice/blank_tablet.h"

namespace nazori::practice {

using std::chrono::milliseconds;

PlacementRun::PlacementRun(Learner& learner, TabletControl& tablet, WritingJudge& judge,
                           const base::Clock& clock)
    : learner_(learner), tablet_(tablet), clock_(clock), attempt_(tablet, judge) {
  connections_.emplace_back(
      attempt_.stroke_ended.connect([this](const HandStroke& stroke) { add_stroke(stroke); }));
  connections_.emplace_back(attempt_.pen_moved.connect([this] { show(); }));
  connections_.emplace_back(attempt_.eraser_used.connect([this] { undo_stroke(); }));
  connections_.emplace_back(attempt_.judged.connect(
      [this] { answer(attempt_.grade().accepted ? PlacementAnswer::written : PlacementAnswer::refused); }));
  connections_.emplace_back(attempt_.failed.connect([this](const base::Error& error) { failed(error); }));
  connections_.emplace_back(learner_.profile_changed.connect([this] { stop(); }));
}

bool PlacementRun::start(std::vector<char32_t> by_difficulty) {
  if (learner_.database() == nullptr) return false;
  check_.emplace(std::move(by_difficulty));
  if (check_->is_over()) {
    check_.reset();
    return false;
  }
  since_ = clock_.steady();
  ask();
  return true;
}

void PlacementRun::stop() {
  if (!check_) return;
  check_.reset();
  question_.reset();
  if (is_entered_) ask();
  stopped();
}

void PlacementRun::enter() {
  is_entered_ = true;
  ask();
}

void PlacementRun::leave() {
  if (!is_entered_) return;
  is_entered_ = false;
  attempt_.end();
  tablet_.set_writing({});
  tablet_.set_judged(false);
  tablet_.set_guides({});
}

void PlacementRun::ask() {
  question_.reset();
  const char32_t character = check_ ? check_->question().value_or(0) : 0;
  if (character != 0)
    if (const auto found = learner_.database()->find(character)) question_ = question_about(*found);
  if (is_entered_) {
    tablet_.set_guides(TabletGuides{});
    tablet_.set_judged(true);
    const Tablet blank = blank_tablet();
    tablet_.set_tablet(blank);
    attempt_.begin(character, blank);
    show();
  }
  changed();
}

void PlacementRun::show() const {
  if (is_entered_) attempt_.show({});
}

void PlacementRun::add_stroke(HandStroke stroke) {
  if (!check_ || attempt_.is_full()) return;
  attempt_.add(std::move(stroke), false);
  show();
  changed();
}

void PlacementRun::finish_writing() {
  if (check_ && !attempt_.is_empty()) attempt_.ask(true);
}

void PlacementRun::do_not_know() {
  if (check_) answer(PlacementAnswer::unknown);
}

void PlacementRun::undo_stroke() {
  if (!check_ || !attempt_.undo(false)) return;
  show();
  changed();
}

void PlacementRun::clear() {
  if (check_) ask();
}

void PlacementRun::answer(PlacementAnswer answer) {
  if (!check_) return;
  check_->answer(answer, std::chrono::duration_cast<milliseconds>(clock_.steady() - since_));
  answered_question(answer);
  // A listener may have stopped it.
  if (!check_) return;
  if (!check_->is_over()) {
    ask();
    return;
  }
  PlacementResult result;
  const auto& all = check_->characters();
  result.characters = static_cast<int>(all.size());
  result.known.assign(all.begin(), all.begin() + check_->rounded_ability());
  if (!result.known.empty() && learner_.lists() != nullptr) {
    if (const auto* facts = learner_.lists()->facts(result.known.back())) {
      result.grade = facts->grade;
      result.old_jlpt_level = facts->old_jlpt_level;
    }
  }
  check_.reset();
  ask();
  ended(result);
}

}  // namespace nazori::practice
