// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "characters/stage_page.h"
#include "nazori/practice/memory_stage.h"

namespace nazori::ui {

class CompareView;
class WritingPanel;

/// The actions of writing from memory, and the panel beside the tablet: strictness, comparison with the
/// model, and what was found.
class MemoryPage final : public StagePage {
  Q_OBJECT
 public:
  MemoryPage(practice::MemoryStage& stage, Desk& desk, CharacterActions& actions, WritingPanel* panel);

  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  void load(const QSettings& settings) override;
  void save(QSettings& settings) const override;

 signals:
  /// MemoryStage::has_unjudged() may have changed.
  void writing_changed();

 protected:
  void refresh() override;

 private:
  void connect_writing();
  void connect_judging();
  void connect_comparing();
  void set_strictness(double strictness);
  void set_playing(bool playing);

  practice::MemoryStage& memory_;
  WritingPanel* panel_;
  CompareView* compare_;
};

}  // namespace nazori::ui
