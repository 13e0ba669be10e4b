// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "nazori/base/clock.h"
#include "nazori/base/signal.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/placement_check.h"
#include "nazori/practice/session_question.h"
#include "nazori/practice/tablet_control.h"
#include "nazori/practice/writing_attempt.h"
#include "nazori/practice/writing_judge.h"

namespace nazori::practice {

/// What a check found.
struct PlacementResult {
  std::vector<char32_t> known;  ///< what the learner can write, easiest first
  int characters = 0;           ///< of the list that was checked
  std::optional<int> grade;     ///< of the hardest known one: 1..6, 8 and more for secondary school
  std::optional<int> old_jlpt_level;
};

/// A PlacementCheck on the tablet: each character is asked for by its meaning or sound, written from memory
/// and judged. Between enter() and leave() it uses the tablet; it may be left and entered again meanwhile.
/// Thread: the owner of the inbox.
class PlacementRun {
 public:
  /// All outlive this.
  PlacementRun(Learner& learner, TabletControl& tablet, WritingJudge& judge, const base::Clock& clock);
  PlacementRun(const PlacementRun&) = delete;
  PlacementRun& operator=(const PlacementRun&) = delete;

  /// Begins with the first question. @param by_difficulty  easiest first.
  /// @return false where there is nothing to ask.
  bool start(std::vector<char32_t> by_difficulty);
  /// Ends it without a result.
  void stop();
  [[nodiscard]] bool is_running() const { return check_.has_value(); }
  /// Uses the tablet from now on.
  void enter();
  /// Something else uses the tablet from now on.
  void leave();

  /// The question; nothing while it is not running.
  [[nodiscard]] const std::optional<SessionQuestion>& question() const { return question_; }
  /// Questions answered so far.
  [[nodiscard]] int answered() const { return check_ ? check_->answered() : 0; }
  /// Whether something is written that is not judged yet.
  [[nodiscard]] bool has_writing() const { return !attempt_.is_empty(); }

  // What the learner does.
  /// A stroke as if it had just been written.
  void add_stroke(HandStroke stroke);
  /// Has the writing judged; the next question follows.
  void finish_writing();
  void do_not_know();
  void undo_stroke();
  void clear();

  /// Another question, or what is written has changed.
  base::Signal<> changed;
  /// The answer to a question; the next one follows.
  base::Signal<PlacementAnswer> answered_question;
  /// It ended with a result.
  base::Signal<const PlacementResult&> ended;
  /// It ended without one.
  base::Signal<> stopped;
  /// The writing could not be judged; it can be tried again.
  base::Signal<const base::Error&> failed;

 private:
  void ask();
  void answer(PlacementAnswer answer);
  void show() const;

  Learner& learner_;
  TabletControl& tablet_;
  const base::Clock& clock_;
  WritingAttempt attempt_;
  std::optional<PlacementCheck> check_;
  std::optional<SessionQuestion> question_;
  base::Clock::Steady since_{};
  bool is_entered_ = false;
  std::vector<base::Connection> connections_;
};

}  // namespace nazori::practice
