// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointer>
#include <optional>
#include <vector>

#include "characters/character_stage.h"
#include "characters/model_fit.h"
#include "pen_recorder.h"
#include "worker.h"

class QSettings;

namespace nazori::ui {

class CompareView;

/// Writing freely, judged stroke by stroke or at the end. Nothing that was written goes away unless the
/// learner takes it back: a wrong stroke is marked and explained, and writing goes on.
class MemoryStage final : public CharacterStage {
  Q_OBJECT
 public:
  /// @param compare  shows writing and model side by side when asked.
  MemoryStage(Desk& desk, CharacterActions& actions, CompareView* compare);
  ~MemoryStage() override;

  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] bool hides_character() const override;

  void load(const QSettings& settings);
  void save(QSettings& settings) const;

  [[nodiscard]] const std::vector<HandStroke>& strokes() const { return strokes_; }
  /// A stroke as if it had just been written.
  void add_stroke(HandStroke stroke);

 signals:
  /// The writing was judged as a whole.
  void judged(nazori::writing::Grade grade);
  /// What was judged goes on being written.
  void taken_back();
  void stroke_added();
  void hint_given();
  void given_up();

 protected:
  void begin() override;
  void end() override;

 private:
  enum class State : std::uint8_t { writing, judged, given_up };

  void start_over();
  void take_samples(std::span<const haptics::ServoSample> samples);
  void ask(bool finished);
  void take_grade(std::uint64_t ticket, const writing::Grade& grade);
  void tell_last_stroke();
  void tell_miss(const QString& why, bool can_be_tried_again);
  void clear_miss();
  void finish();
  void undo();
  void give_hint();
  void give_up();
  void invite();
  void set_state(State state);
  [[nodiscard]] bool shows_groove() const;
  void put_groove();
  void carve_written();
  void show_writing();
  void refresh_actions();
  [[nodiscard]] double strictness() const;

  CompareView* compare_;
  PenRecorder recorder_;
  std::vector<HandStroke> strokes_;
  writing::Grade grade_;     ///< the newest; its strokes may lag behind
  std::vector<bool> seen_;   ///< strokes whose verdict the learner may see
  std::vector<int> hinted_;  ///< strokes of the model that are shown
  std::uint64_t live_ticket_ = 0;
  std::uint64_t whole_ticket_ = 0;
  bool tell_ = false;  ///< the answer to come is about a stroke just written
  State state_ = State::writing;
  int hints_ = 0;
  bool missed_ = false;      ///< the last stroke was refused and goes when another is written
  std::vector<int> carved_;  ///< strokes whose grooves have appeared
  Worker carver_{QStringLiteral("carver")};
};

}  // namespace nazori::ui
