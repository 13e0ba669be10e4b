// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "nazori/practice/character_library.h"
#include "nazori/practice/pen_recorder.h"
#include "nazori/study/day_plan.h"
#include "nazori/writing/grade.h"
#include "study/learner.h"

namespace nazori::ui {

/// What a session came to.
struct SessionSummary {
  int reviews = 0;                ///< from memory
  std::array<int, 4> ratings{};   ///< again, hard, good, easy
  int practices = 0;              ///< in other stages
  std::vector<char32_t> met;      ///< characters met first
  std::vector<char32_t> again;    ///< those that were forgotten
  std::vector<char32_t> lessons;  ///< leeches that had their other lesson
  std::chrono::milliseconds time{0};
};

/// Goes through what is due, character by character and stage by stage. Knows no widgets: it is told what was
/// done on the tablet, keeps it in the learner's store, and says what comes next. Everything that is kept is
/// kept at once, so a session can end, or be killed, at any moment. Thread: interface.
class StudySession final : public QObject {
  Q_OBJECT
 public:
  enum class State : std::uint8_t {
    idle,     ///< no session
    doing,    ///< the learner is at a stage
    offered,  ///< the stage is done and kept; go_on() goes to the next
    judged,   ///< written from memory: rate() keeps it
  };

  /// Goes on evenly from any beginning, whatever is done to the computer's clock.
  using Stopwatch = std::function<std::chrono::milliseconds()>;

  /// @param stopwatch  how long a stage takes; empty: the computer's.
  explicit StudySession(Learner& learner, Stopwatch stopwatch = {});
  ~StudySession() override;

  /// Begins with what is due now; with the characters set apart where `leeches`.
  /// @return false where nothing is due, or nothing can be kept; it is said why.
  bool start(bool leeches = false);
  /// Ends it; what is not rated is not kept. @param done  there is nothing more to do.
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
  [[nodiscard]] int done() const { return done_; }
  [[nodiscard]] int total() const { return done_ + left_; }
  [[nodiscard]] std::chrono::milliseconds time_left() const { return time_left_; }
  [[nodiscard]] const SessionSummary& summary() const { return summary_; }

  /// Another word with the character left out, where one is asked for by a word; nullptr: by its meaning.
  [[nodiscard]] const kanji::Word* word() const { return word_ ? &*word_ : nullptr; }
  void set_asks_by_words(bool on) { asks_by_words_ = on; }

  /// What was kept or taken back last, as a sentence; empty: nothing yet in this session.
  [[nodiscard]] const QString& note() const { return note_; }

  // When judged.
  [[nodiscard]] study::Rating proposed() const { return proposed_; }
  [[nodiscard]] const study::WritingResult& result() const { return result_; }
  /// The card as it would be after a rating.
  [[nodiscard]] base::Result<study::Card> after(study::Rating rating) const;
  [[nodiscard]] const study::Ink& ink() const { return ink_; }

  // What happens on the tablet. Ignored unless it is about the session's character.
  /// The character came to the desk, or left it for another one.
  void take_sheet(const std::shared_ptr<const practice::CharacterSheet>& sheet);
  /// The tablet shows another character than the session's.
  [[nodiscard]] bool is_away() const { return is_running() && away_; }
  /// The learner, or the session, went to a stage.
  void enter_stage(study::Stage stage);
  void note_stroke();
  void note_hint() { ++hints_; }
  /// A stroke was tried and refused. @return what to do about it.
  study::MissReply note_miss(int stroke);
  void take_practice(study::Stage stage, study::WritingResult result);
  void take_judgement(const writing::Grade& grade, const std::vector<practice::HandStroke>& strokes);
  void take_surrender(const std::vector<practice::HandStroke>& strokes);
  /// What was judged goes on being written.
  void take_back_judgement();

  // What the learner decides.
  void rate(study::Rating rating);
  /// To the next stage, the proposed rating, or back to the session's character.
  void go_on();
  void undo();
  void postpone();
  void pause();
  void reset();

 signals:
  /// Something of the above is different.
  void changed();
  /// A character must come to the desk. It is to be done at stage().
  void character_wanted(char32_t character);
  void stage_wanted(nazori::study::Stage stage);
  void ended();
  void said(nazori::ui::Feedback kind, QString sentence);

 private:
  void next_task();
  void present(const study::StudyTask& task);
  void finish_task();
  void begin_stage(study::Stage stage);
  void measure(const study::DayPlan& plan);
  void choose_word();
  bool keep(study::Stage stage, study::Rating rating, study::Rating proposed,
            const study::WritingResult& result, const study::Ink& ink);
  void judge(study::WritingResult result, const std::vector<practice::HandStroke>& strokes);
  [[nodiscard]] std::chrono::milliseconds elapsed() const;
  [[nodiscard]] study::LearnerStore& store() const { return learner_.store(); }
  /// Takes the present character out of the day by an action of the store.
  void put_aside(const base::Result<void>& done, const QString& sentence);
  /// Says it, and keeps it for who looks later: the next task has words of its own at once.
  void tell(Feedback kind, const QString& sentence);

  Learner& learner_;
  State state_ = State::idle;
  study::StudyTask task_;
  study::Stage stage_ = study::Stage::watch;
  bool leech_lesson_ = false;
  std::vector<char32_t> leeches_;  ///< still to do
  bool away_ = false;
  bool reviewed_ = false;  ///< the present task was written from memory
  bool peeked_ = false;    ///< the learner looked before writing from memory
  bool final_ = false;     ///< the judgement stays whatever is written still
  bool asks_by_words_ = true;
  std::shared_ptr<const practice::CharacterSheet> sheet_;
  std::optional<kanji::Word> word_;

  Stopwatch stopwatch_;
  std::chrono::milliseconds since_{0};  ///< on the stopwatch: the stage began
  std::chrono::milliseconds last_stroke_{0};
  int hints_ = 0;
  int misses_ = 0;
  int shown_ = 0;
  int missed_stroke_ = -1;
  int misses_of_stroke_ = 0;
  study::WritingResult result_;
  study::Rating proposed_ = study::Rating::good;
  study::Ink ink_;

  QString note_;
  int done_ = 0;
  int left_ = 0;
  std::chrono::milliseconds time_left_{0};
  SessionSummary summary_;
};

}  // namespace nazori::ui
