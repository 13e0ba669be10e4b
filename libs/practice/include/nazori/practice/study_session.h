// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "nazori/base/clock.h"
#include "nazori/base/signal.h"
#include "nazori/practice/character_library.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/pen_recorder.h"
#include "nazori/practice/session_feedback.h"
#include "nazori/study/day_plan.h"
#include "nazori/writing/grade.h"

namespace nazori::practice {

/// Goes through what is due, character by character and stage by stage: what was done on the tablet goes in
/// and is saved in the learner's store, what comes next goes out. Everything is saved at once, so a session
/// can end, or be killed, at any moment. Thread: that of the learner.
class StudySession {
 public:
  using State = SessionState;

  /// @param learner  outlives this, as `clock` does.
  /// @param clock  how long a stage takes.
  StudySession(Learner& learner, const base::Clock& clock);
  ~StudySession();
  StudySession(const StudySession&) = delete;
  StudySession& operator=(const StudySession&) = delete;

  /// Begins with what is due now; with the characters set apart where `leeches`.
  /// @return false where nothing is due, or nothing can be saved; why is announced.
  bool start(bool leeches = false);
  /// Begins with these characters, each once, whether they are due or not: a new one with its lesson, any
  /// other one from memory.
  /// @return false where there are none, or nothing can be saved; why is announced.
  bool start_with(std::vector<char32_t> characters);
  /// Ends it; what is not rated is not saved. @param done  there is nothing more to do.
  void end(bool done = false);

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool is_running() const { return state_ != State::idle; }
  [[nodiscard]] const study::StudyTask& task() const { return task_; }
  [[nodiscard]] char32_t character() const { return is_running() ? task_.character : 0; }
  /// The stage to do now, or, when offered, next.
  [[nodiscard]] study::Stage stage() const { return stage_; }
  /// When offered: the character is done, another one is next.
  [[nodiscard]] bool is_over() const {
    return state_ == State::offered && stage_ == study::Stage::memory && reviewed_;
  }
  /// How much help guided writing gives now, 0..1.
  [[nodiscard]] double help() const;
  [[nodiscard]] bool is_leech_lesson() const { return leech_lesson_; }
  /// Whether the character is still the learner's secret.
  [[nodiscard]] bool asks_from_memory() const {
    return stage_ == study::Stage::memory && state_ == State::doing;
  }
  /// Whether the learner has studied a character; false where that is not known.
  [[nodiscard]] bool knows(char32_t character) const;
  [[nodiscard]] int done() const { return done_; }
  [[nodiscard]] int total() const { return done_ + left_; }
  [[nodiscard]] std::chrono::milliseconds time_left() const { return time_left_; }

  /// Another word with the character left out, where one is asked for by a word; nullptr: by its meaning.
  [[nodiscard]] const kanji::Word* word() const { return word_ ? &*word_ : nullptr; }
  void set_asks_by_words(bool on) { asks_by_words_ = on; }

  /// What was saved or undone last; nothing yet in this session where it is empty.
  [[nodiscard]] const std::optional<SessionFeedback>& last_event() const { return last_event_; }

  // When judged.
  [[nodiscard]] study::Rating proposed() const { return proposed_.rating; }
  /// Why that rating is suggested.
  [[nodiscard]] study::RatingReason reason() const { return proposed_.reason; }
  [[nodiscard]] const study::WritingResult& result() const { return result_; }
  /// The card as it would be after a rating.
  [[nodiscard]] base::Result<study::Card> after(study::Rating rating) const;
  [[nodiscard]] const study::Handwriting& ink() const { return ink_; }

  // What happens on the tablet. Ignored unless it is about the session's character.
  /// The tablet shows a character now; nullptr: none.
  void set_sheet(const std::shared_ptr<const CharacterSheet>& sheet);
  /// The tablet shows another character than the session's.
  [[nodiscard]] bool is_away() const { return is_running() && away_; }
  /// The learner, or the session, went to a stage.
  void enter_stage(study::Stage stage);
  /// The learner went to a stage that is no part of a lesson.
  void leave_lesson();
  void add_stroke();
  void add_hint() { ++hints_; }
  /// A stroke was tried and refused. @return what to do about it.
  study::MissReply add_mistake(int stroke);
  /// A stage other than memory was done.
  void finish_stage(study::Stage stage, study::WritingResult result);
  /// What was written from memory was judged.
  void judge(const writing::Grade& grade, const std::vector<HandStroke>& strokes);
  /// The learner asked for the answer.
  void give_up(const std::vector<HandStroke>& strokes);
  /// What was judged goes on being written.
  void reopen();

  // What the learner decides.
  void rate(study::Rating rating);
  /// To the next stage, the proposed rating, or back to the session's character.
  void go_on();
  void undo();
  void postpone();
  void pause();
  void reset();

  /// Something of the above is different.
  base::Signal<> changed;
  /// The tablet must show this character. It is to be done at stage().
  base::Signal<char32_t> character_wanted;
  base::Signal<study::Stage> stage_wanted;
  base::Signal<> ended;
  base::Signal<const SessionFeedback&> announced;

 private:
  void begin();
  /// Ends it and announces why.
  void stop(SessionFeedback::Kind why, const base::Error& error = {});
  void next_task();
  void present(const study::StudyTask& task);
  void finish_task();
  void begin_stage(study::Stage stage);
  void measure(const study::DayPlan& plan);
  void choose_word();
  void note_look();
  bool save(study::Stage stage, study::Rating rating, study::Rating proposed,
            const study::WritingResult& result, const study::Handwriting& ink);
  void propose(study::WritingResult result, const std::vector<HandStroke>& strokes);
  [[nodiscard]] std::chrono::milliseconds elapsed() const;
  [[nodiscard]] study::LearnerStore& store() const { return learner_.store(); }
  /// Takes the present character out of the day, if the action of the store is `done`.
  void put_aside(const base::Result<void>& done, SessionFeedback::Kind kind);
  /// Feedback about the present character.
  [[nodiscard]] SessionFeedback about_character(SessionFeedback::Kind kind) const;
  void announce(SessionFeedback::Kind kind, const base::Error& error = {});
  /// Announces it, and keeps it for those who look later: the next task may have feedback of its own at once.
  void announce_event(const SessionFeedback& event);

  Learner& learner_;
  State state_ = State::idle;
  study::StudyTask task_;
  study::Stage stage_ = study::Stage::watch;
  bool leech_lesson_ = false;
  std::vector<char32_t> leeches_;  ///< still to do
  bool has_choice_ = false;        ///< only the characters of start_with() are done
  std::vector<char32_t> chosen_;   ///< of these still to do
  bool away_ = false;
  bool reviewed_ = false;  ///< the present task was written from memory
  bool looked_ = false;    ///< the learner looked before writing from memory
  bool final_ = false;     ///< the judgement stays whatever is written still
  bool asks_by_words_ = true;
  std::shared_ptr<const CharacterSheet> sheet_;
  std::optional<kanji::Word> word_;

  const base::Clock& clock_;
  base::Clock::Steady since_{};  ///< the stage began
  std::chrono::milliseconds last_stroke_{0};
  int hints_ = 0;
  int misses_ = 0;
  int shown_ = 0;
  int missed_stroke_ = -1;
  int misses_of_stroke_ = 0;
  study::WritingResult result_;
  study::SuggestedRating proposed_;
  study::Handwriting ink_;

  std::optional<SessionFeedback> last_event_;
  int done_ = 0;
  int left_ = 0;
  std::chrono::milliseconds time_left_{0};
  base::Connection profile_changed_;
};

}  // namespace nazori::practice
