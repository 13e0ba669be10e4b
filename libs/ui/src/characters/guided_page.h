// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "characters/stage_page.h"
#include "nazori/practice/guided_stage.h"

namespace nazori::ui {

/// The choices of guided writing: only the groove, only the starting points, and whether the hand is led.
class GuidedPage final : public StagePage {
  Q_OBJECT
 public:
  GuidedPage(practice::GuidedStage& stage, Desk& desk, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  /// Whether the hand is led is saved.
  void load(const QSettings& settings) override;
  void save(QSettings& settings) const override;

 private:
  practice::GuidedStage& guided_;
};

}  // namespace nazori::ui
