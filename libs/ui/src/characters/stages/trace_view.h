// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "characters/stage_view.h"
#include "nazori/practice/trace_stage.h"

namespace nazori::ui {

class StrokeCounter;

/// The view of tracing: which strokes are shown, with lines, numbers and arrows, and snapping.
class TraceView final : public StageView {
  Q_OBJECT
 public:
  TraceView(practice::TraceStage& stage, WindowParts& parts, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

 protected:
  void refresh() override;

 private:
  StrokeCounter* counter_;
  QAction* counter_action_;
};

}  // namespace nazori::ui
