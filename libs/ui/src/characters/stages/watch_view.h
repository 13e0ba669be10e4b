// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "characters/stage_view.h"
#include "nazori/practice/watch_stage.h"

class QLabel;

namespace nazori::ui {

/// The view of watching: plays the character, and shows which stroke is written and how fast.
class WatchView final : public StageView {
  Q_OBJECT
 public:
  WatchView(practice::WatchStage& stage, WindowParts& parts, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] QString sentence(const practice::StageFeedback& feedback) const override;

 protected:
  void refresh() override;

 private:
  void show_location();

  practice::WatchStage& watch_;
  QLabel* location_label_;
  QAction* location_;
  QTimer timer_;
};

}  // namespace nazori::ui
