// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "characters/stage_page.h"
#include "nazori/practice/trace_stage.h"

namespace nazori::ui {

class StrokeCounter;

/// The switches of tracing: which strokes are shown, with lines, numbers and arrows, and snapping.
class TracePage final : public StagePage {
  Q_OBJECT
 public:
  TracePage(practice::TraceStage& stage, Desk& desk, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

 protected:
  void refresh() override;

 private:
  StrokeCounter* counter_;
  QAction* counter_action_;
};

}  // namespace nazori::ui
