// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "characters/character_actions.h"
#include "characters/stage_words.h"
#include "nazori/practice/practice_stage.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/page.h"
#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {

/// The view of a practice stage: its actions, its tools and its sentences. Thread: interface.
class StageView : public QObject {
  Q_OBJECT
 public:
  /// @param stage  outlives this.
  StageView(practice::PracticeStage& stage, WindowParts& parts, CharacterActions& actions)
      : parts_(parts), actions_(actions), stage_(stage) {
    subscribe(stage.changed, this, [this] { refresh(); });
  }

  [[nodiscard]] practice::PracticeStage& stage() const { return stage_; }
  /// Actions that mean something in this stage only, in the order of the toolbar (nullptr: a gap).
  [[nodiscard]] virtual QList<QAction*> own_actions() const = 0;
  [[nodiscard]] virtual QList<Tool> tools() const = 0;
  /// Stands above the tablet while the stage is entered; the page shows and hides it. nullptr: nothing.
  [[nodiscard]] virtual QWidget* above_tablet() const { return nullptr; }
  /// What the stage reports, for people; empty where it is not worth a sentence.
  [[nodiscard]] virtual QString sentence(const practice::StageFeedback& feedback) const {
    return StageWords::sentence(feedback);
  }
  /// Why the stage cannot be chosen with the present character; empty: nothing is said.
  [[nodiscard]] virtual QString why_unavailable() const { return {}; }
  virtual void load(const base::Settings& /*settings*/) {}
  virtual void save(base::Settings& /*settings*/) const {}

 protected:
  /// Shows the state of the stage.
  virtual void refresh() {}

  [[nodiscard]] WindowParts& parts() const { return parts_; }
  [[nodiscard]] CharacterActions& actions() const { return actions_; }
  [[nodiscard]] practice::TabletControl& tablet() const { return parts_.tablet(); }
  [[nodiscard]] bool is_entered() const { return stage_.is_entered(); }
  /// Calls `what` for an action, also while another stage is entered.
  template <class What>
  void always_on(QAction* action, What what) {
    connect(action, &QAction::triggered, this, what);
  }
  /// Calls `what` for an action that other stages have, too.
  template <class What>
  void on(QAction* action, What what) {
    connect(action, &QAction::triggered, this, [this, what] {
      if (is_entered()) what();
    });
  }

 private:
  WindowParts& parts_;
  CharacterActions& actions_;
  practice::PracticeStage& stage_;
};

}  // namespace nazori::ui
