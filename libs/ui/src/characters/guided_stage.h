// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "characters/character_stage.h"
#include "nazori/practice/pen_recorder.h"
#include "nazori/practice/traced_ink.h"

class QSettings;

namespace nazori::ui {

/// Tracing with less and less help: only the groove, or only where strokes start. Strokes hold the stylus, or
/// a device with force leads the hand along them, and lines are still faintly there; both fade each time the
/// character was traced without a slip.
class GuidedStage final : public CharacterStage {
  Q_OBJECT
 public:
  GuidedStage(Desk& desk, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  /// Whether the hand is led is kept.
  void load(const QSettings& settings);
  void save(QSettings& settings) const;
  /// How often this character was traced without a slip since it came to the desk.
  [[nodiscard]] int successes() const { return successes_; }
  /// How much help there is, 0..1, where a course of lessons decides it; nothing: by successes().
  void set_help(std::optional<double> help) { help_ = help; }

 protected:
  void begin() override;
  void end() override;

 private:
  void lay_out();
  [[nodiscard]] TabletGuides guides() const;
  void show_alone(int stroke);
  void clear();
  void invite();
  void take(practice::TraceEvent event, int stroke);
  void note_giving_way(std::span<const haptics::ServoSample> samples);
  void take_samples(std::span<const haptics::ServoSample> samples);

  practice::PenRecorder recorder_;
  std::vector<view::WrittenStroke> written_;
  char32_t character_ = 0;
  int successes_ = 0;
  std::optional<double> help_;
  int shown_alone_ = 0;  ///< stroke that is shown after too many misses
  bool slipped_ = false;
  bool told_giving_way_ = false;  ///< once for each time the character is gone through
};

}  // namespace nazori::ui
