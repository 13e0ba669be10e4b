// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/base/clock.h"
#include "nazori/base/signal.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/session_feedback.h"
#include "nazori/study/day_plan.h"
#include "nazori/writing/grade.h"

namespace nazori::practice {

/// Where the model stood while a character was written with the brush.
enum class BrushModel : std::uint8_t {
  none,     ///< written from memory
  beside,   ///< looked at
  beneath,  ///< written over
};

/// Goes through the characters that are due with the brush (study::DayPlan::brush), one after the other. The
/// comparison with the model is advice; only the rating of the learner counts, and it schedules the character
/// with the brush alone. Every rating is saved at once. Thread: that of the learner.
class BrushSession {
 public:
  enum class State : std::uint8_t {
    idle,     ///< no session
    writing,  ///< the character is to be written
    advised,  ///< it was compared with its model: rate() saves it
  };

  /// @param learner  outlives this, as `clock` does. @param clock  how long a character takes.
  BrushSession(Learner& learner, const base::Clock& clock);
  BrushSession(const BrushSession&) = delete;
  BrushSession& operator=(const BrushSession&) = delete;

  /// Begins with what is due with the brush now.
  /// @return false where nothing is due, or nothing can be saved; why is announced.
  bool start();
  /// Ends it; what is not rated is not saved. @param done  there is nothing more to do.
  void end(bool done = false);

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool is_running() const { return state_ != State::idle; }
  /// To be written; 0 without a session.
  [[nodiscard]] char32_t character() const { return is_running() ? character_ : 0; }
  /// Whether the character is still the learner's secret: no model was shown, and it was not compared yet.
  [[nodiscard]] bool asks_from_memory() const {
    return state_ == State::writing && model_ == BrushModel::none;
  }
  [[nodiscard]] int done() const { return done_; }
  [[nodiscard]] int total() const { return done_ + left_; }

  // What happens on the paper.
  /// A model stands there now. What helps most counts until the next character.
  void show_model(BrushModel model);
  /// A stroke was written.
  void add_stroke();
  /// What was written was compared with the model. @param grade  nullopt: too little was written to compare.
  /// @param ink  in glyph units.
  void judge(const std::optional<writing::Grade>& grade, const study::Handwriting& ink);
  /// What was compared is written on.
  void reopen();

  // When advised.
  /// Again where the strokes are not those of the character, else Good.
  [[nodiscard]] study::Rating proposed() const;
  [[nodiscard]] const study::WritingResult& result() const { return result_; }
  /// The card as it would be after a rating.
  [[nodiscard]] base::Result<study::Card> after(study::Rating rating) const;
  void rate(study::Rating rating);

  /// Leaves the character out for the rest of this session; it stays due.
  void skip();
  /// As StudySession::undo(). A character whose rating is undone is to be written again.
  void undo();

  /// Something of the above is different.
  base::Signal<> changed;
  /// This character is to be written on a new sheet.
  base::Signal<char32_t> character_wanted;
  base::Signal<> ended;
  base::Signal<const SessionFeedback&> announced;

 private:
  /// What is due and not skipped. @return as Learner::plan().
  [[nodiscard]] base::Result<std::vector<char32_t>> due();
  /// Ends it and announces why.
  void stop(SessionFeedback::Kind why, const base::Error& error = {});
  void next();
  void present(char32_t character);
  [[nodiscard]] std::chrono::milliseconds elapsed() const;
  void announce(SessionFeedback::Kind kind, const base::Error& error = {});

  Learner& learner_;
  const base::Clock& clock_;
  State state_ = State::idle;
  char32_t character_ = 0;
  BrushModel shown_ = BrushModel::none;  ///< now
  BrushModel model_ = BrushModel::none;  ///< the most help with this character
  base::Clock::Steady since_{};
  std::chrono::milliseconds last_stroke_{0};
  study::WritingResult result_;
  study::Handwriting ink_;
  int strokes_ = 1;
  std::vector<char32_t> skipped_;
  int done_ = 0;
  int left_ = 0;
  base::Connection profile_changed_;
};

}  // namespace nazori::practice
