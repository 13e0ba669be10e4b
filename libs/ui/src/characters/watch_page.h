// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "characters/stage_page.h"
#include "nazori/practice/watch_stage.h"

class QLabel;

namespace nazori::ui {

/// Plays the character, frame by frame, and shows which stroke is written and how fast.
class WatchPage final : public StagePage {
  Q_OBJECT
 public:
  WatchPage(practice::WatchStage& stage, Desk& desk, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

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
