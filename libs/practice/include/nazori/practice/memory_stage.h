// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/base/settings.h"
#include "nazori/practice/practice_stage.h"
#include "nazori/practice/writing_attempt.h"
#include "nazori/practice/writing_groove.h"

namespace nazori::practice {

/// Writing from memory, judged stroke by stroke or at the end. Nothing that was written goes away unless the
/// learner undoes it: a wrong stroke is marked and explained, and writing goes on. A writing is kept while
/// the learner looks at something else.
class MemoryStage final : public PracticeStage {
 public:
  /// What the learner chose.
  struct Options {
    bool judges_each = true;  ///< every stroke as it ends; false: the writing at its end
    WritingGroove::Mode groove = WritingGroove::Mode::hidden;
    double strictness = writing::kNormal;  ///< 0..1

    /// Reads stored settings ("judge_each", "groove", "strictness"); invalid values keep their defaults.
    void load(const base::Settings& settings);
    /// Stores all that load() reads; other keys are unchanged.
    void save(base::Settings& settings) const;
  };
  enum class State : std::uint8_t { writing, judged, answer_shown };

  /// @param inbox, tablet, judge  outlive this.
  MemoryStage(base::Inbox& inbox, TabletControl& tablet, WritingJudge& judge);

  static constexpr std::string_view kId = "memory";
  [[nodiscard]] std::string_view id() const override { return kId; }
  [[nodiscard]] std::vector<StageCommand> commands() override;
  [[nodiscard]] bool is_busy() const override { return is_judging() || attempt_.is_naming(); }
  [[nodiscard]] StageDetails details(const StageFeedback& what) const override;
  void forget() override;
  [[nodiscard]] bool hides_character() const override;

  [[nodiscard]] const Options& options() const { return options_; }
  void set_judges_each(bool on);
  void set_groove(WritingGroove::Mode mode);
  /// Judges what is written again.
  void set_strictness(double strictness);
  /// Takes over what was saved, without a report.
  void set_options(const Options& options) {
    options_ = options;
    attempt_.set_strictness(options.strictness);
  }

  /// Whether entering the stage with the character that was written last goes on with that writing, judged or
  /// not.
  /// @param unrated  the session waits for the rating of a writing: it is kept whatever is written meanwhile.
  void set_resumes(bool resumes, bool unrated) {
    resumes_ = resumes;
    is_unrated_ = unrated;
  }

  // What the learner does.
  /// A stroke as if it had just been written.
  void add_stroke(HandStroke stroke);
  void undo();
  /// Begins the character again.
  void start_over();
  /// Has the writing judged as a whole.
  void finish_writing();
  void give_hint();
  void show_answer();

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] const std::vector<HandStroke>& strokes() const { return attempt_.strokes(); }
  /// Whether an answer of the judge is still to come.
  [[nodiscard]] bool is_judging() const { return attempt_.is_judging(); }
  /// Whether something is written that is not judged as a whole.
  [[nodiscard]] bool has_unjudged() const { return state_ == State::writing && !attempt_.is_empty(); }
  /// The newest judgement; its strokes may lag behind what is written.
  [[nodiscard]] const writing::Grade& grade() const { return attempt_.grade(); }
  /// How the pen moved in the writing that was judged last as a whole.
  [[nodiscard]] const PenReport& pen_report() const { return attempt_.content().pen; }

  /// Lays the model over the writing.
  void set_model_over(bool on);
  /// Whether the writing was judged and something in it could be better.
  [[nodiscard]] bool can_show_right() const;
  /// Draws the right strokes over the writing; again from the beginning each time. @param moves  false: they
  /// are there at once.
  void show_right(bool moves);
  /// Whether they are still being drawn: advance_right() then draws on.
  [[nodiscard]] bool is_showing_right() const { return correction_.is_moving(); }
  void advance_right(double passed_s);
  /// Shows the writing as it was at a moment after its beginning [s]; nothing: all of it.
  void show_moment(std::optional<double> time_s);

  /// The writing was judged as a whole.
  base::Signal<const writing::Grade&> judged;
  /// What was judged, or shown, goes on being written.
  base::Signal<> continued;
  base::Signal<> stroke_added;
  base::Signal<> hint_given;
  base::Signal<> answer_was_shown;
  /// The writing on the tablet changed: strokes, verdicts, or the moment that is shown.
  base::Signal<> writing_shown;
  /// A replay of the writing must stop.
  base::Signal<> replay_stopped;
  /// The tablet is empty for the character: comparisons with the model are over.
  base::Signal<> started_over;

 protected:
  void begin() override;
  void end() override;

 private:
  /// A writing whose character left the tablet.
  struct Aside {
    char32_t character = 0;
    WritingAttempt::Content content;
    State state = State::writing;
    bool unrated = false;
  };

  void clear();
  void invite();
  void use_check(bool is_about_new);
  void report_other(char32_t written, char32_t asked);
  void report_last_stroke();
  void finish();
  [[nodiscard]] Tone tone_of_judgement() const;
  void put_aside();
  void resume();
  void set_state(State state);
  [[nodiscard]] bool shows_groove() const;
  void put_groove();
  void show_writing();

  Options options_;
  WritingAttempt attempt_;
  WritingAttempt::Look look_;
  Correction correction_;
  State state_ = State::writing;
  char32_t character_ = 0;  ///< that is being written
  std::optional<Aside> aside_;
  bool resumes_ = false;
  bool is_unrated_ = false;
  bool was_lesson_ = false;  ///< what is written is part of a lesson
  WritingGroove groove_;
};

}  // namespace nazori::practice
