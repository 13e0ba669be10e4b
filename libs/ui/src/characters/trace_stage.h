// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "characters/character_stage.h"
#include "characters/stroke_teller.h"

namespace nazori::ui {

class StrokeCounter;

/// Tracing the grooves, with lines, arrows and numbers as the learner switches them: the program of 2005.
class TraceStage final : public CharacterStage {
  Q_OBJECT
 public:
  TraceStage(Desk& desk, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

 protected:
  void begin() override;

 private:
  void take(practice::TraceEvent event, int stroke);
  void tell(const StrokeTeller::Sentence& sentence);
  void show_state();

  StrokeCounter* counter_;
  QAction* counter_place_;
  int shown_alone_ = 0;  ///< stroke that is shown alone after too many misses
};

}  // namespace nazori::ui
