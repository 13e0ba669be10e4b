// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "characters/stage_view.h"
#include "nazori/practice/memory_stage.h"

namespace nazori::ui {

class CompareView;
class WritingPanel;

/// The view of writing from memory: its actions, and the panel beside the tablet with strictness, comparison
/// with the model, and report.
class MemoryView final : public StageView {
  Q_OBJECT
 public:
  MemoryView(practice::MemoryStage& stage, WindowParts& parts, CharacterActions& actions,
             WritingPanel* panel);

  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] QString sentence(const practice::StageFeedback& feedback) const override {
    return StageWords::sentence(feedback, &memory_);
  }
  void load(const base::Settings& settings) override;
  void save(base::Settings& settings) const override;

 protected:
  void refresh() override;

 private:
  void connect_writing();
  void connect_judging();
  void connect_comparing();
  void set_strictness(double strictness);
  void set_playing(bool playing);
  void show_right();

  practice::MemoryStage& memory_;
  WritingPanel* panel_;
  CompareView* compare_;
  QTimer drawing_;  ///< while the right strokes are being drawn
  QElapsedTimer since_;
};

}  // namespace nazori::ui
