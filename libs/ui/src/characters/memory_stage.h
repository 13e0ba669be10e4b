// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointer>
#include <optional>
#include <vector>

#include "characters/character_stage.h"
#include "nazori/practice/model_fit.h"
#include "nazori/practice/pen_recorder.h"
#include "nazori/practice/writing_groove.h"

class QSettings;

namespace nazori::ui {

class CompareView;
class WritingPanel;

/// Writing freely, judged stroke by stroke or at the end. Nothing that was written goes away unless the
/// learner takes it back: a wrong stroke is marked and explained, and writing goes on. A writing is kept
/// while the learner looks at something else.
class MemoryStage final : public CharacterStage {
  Q_OBJECT
 public:
  /// @param panel  stands beside the tablet: strictness, comparison, what was found.
  MemoryStage(Desk& desk, CharacterActions& actions, WritingPanel* panel);
  ~MemoryStage() override;

  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] bool hides_character() const override;

  void load(const QSettings& settings);
  void save(QSettings& settings) const;

  [[nodiscard]] const std::vector<practice::HandStroke>& strokes() const { return strokes_; }
  /// Whether the next lesson on the character that was written last goes on with that writing, judged or not.
  /// @param unrated  the session waits for the rating of a writing: it is kept whatever is written meanwhile.
  void set_resumes(bool resumes, bool unrated) {
    resumes_ = resumes;
    unrated_ = unrated;
  }
  /// Another learner: nothing that was written is shown to them.
  void forget();
  /// Whether something is written that is not judged as a whole.
  [[nodiscard]] bool has_unjudged() const { return state_ == State::writing && !strokes_.empty(); }
  /// A stroke as if it had just been written.
  void add_stroke(practice::HandStroke stroke);

 signals:
  /// The writing was judged as a whole.
  void judged(nazori::writing::Grade grade);
  /// What was judged goes on being written.
  void taken_back();
  void stroke_added();
  void hint_given();
  void given_up();
  /// has_unjudged() may have changed.
  void writing_changed();

 protected:
  void begin() override;
  void end() override;

 private:
  enum class State : std::uint8_t { writing, judged, given_up };

  void connect_judging();
  void connect_comparing();
  void start_over();
  void take_samples(std::span<const haptics::ServoSample> samples);
  void ask(bool finished);
  void take_grade(std::uint64_t ticket, const writing::Grade& grade);
  void tell_last_stroke();
  void tell_miss(const QString& why, bool can_be_tried_again);
  void clear_miss();
  void finish();
  void tell_grade();
  void put_aside();
  void resume();
  void undo();
  void give_hint();
  void give_up();
  void invite();
  void set_state(State state);
  [[nodiscard]] bool shows_groove() const;
  void put_groove();
  [[nodiscard]] std::vector<int> right_strokes() const;
  void show_writing();
  void refresh_actions();
  void set_strictness(double strictness);
  void set_playing(bool playing);

  /// A writing whose character left the tablet.
  struct Aside {
    char32_t character = 0;
    std::vector<practice::HandStroke> strokes;
    writing::Grade grade;
    practice::PenReport pen;
    std::vector<bool> seen;
    std::vector<int> hinted;
    int hints = 0;
    State state = State::writing;
    bool unrated = false;
  };

  WritingPanel* panel_;
  CompareView* compare_;
  practice::PenRecorder recorder_;
  std::vector<practice::HandStroke> strokes_;
  writing::Grade grade_;     ///< the newest; its strokes may lag behind
  practice::PenReport pen_;  ///< of the writing judged last as a whole
  std::vector<bool> seen_;   ///< strokes whose verdict the learner may see
  std::vector<int> hinted_;  ///< strokes of the model that are shown
  std::uint64_t live_ticket_ = 0;
  std::uint64_t whole_ticket_ = 0;
  bool tell_ = false;  ///< the answer to come is about a stroke just written
  State state_ = State::writing;
  int hints_ = 0;
  char32_t character_ = 0;  ///< that is being written
  std::optional<Aside> aside_;
  bool resumes_ = false;
  bool unrated_ = false;
  bool taught_ = false;     ///< the lesson is one of a session
  bool missed_ = false;     ///< the last stroke was refused and goes when another is written
  double replayed_s_ = -1;  ///< moment of the replay; below 0: all is shown
  practice::WritingGroove groove_;
};

}  // namespace nazori::ui
