// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "characters/stage_view.h"
#include "nazori/practice/guided_stage.h"

namespace nazori::ui {

/// The view of guided writing: how much is shown (only the groove, only the starting points), and whether the
/// device leads the hand.
class GuidedView final : public StageView {
  Q_OBJECT
 public:
  GuidedView(practice::GuidedStage& stage, WindowParts& parts, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  /// Whether the hand is led is saved.
  void load(const base::Settings& settings) override;
  void save(base::Settings& settings) const override;

 private:
  practice::GuidedStage& guided_;
};

}  // namespace nazori::ui
