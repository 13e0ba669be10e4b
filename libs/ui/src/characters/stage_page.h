// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "characters/character_actions.h"
#include "characters/stage_words.h"
#include "desk.h"
#include "nazori/practice/practice_stage.h"
#include "signals.h"
#include "workplace.h"

class QSettings;

namespace nazori::ui {

/// What the window shows of a practice stage: its actions, its tools, and its sentences. Thread: interface.
class StagePage : public QObject {
  Q_OBJECT
 public:
  /// @param stage  outlives this.
  StagePage(practice::PracticeStage& stage, Desk& desk, CharacterActions& actions)
      : desk_(desk), actions_(actions), stage_(stage) {
    subscribe(stage.changed, this, [this] { refresh(); });
  }

  [[nodiscard]] practice::PracticeStage& stage() const { return stage_; }
  /// Actions that mean something in this stage only, in the order of the toolbar (nullptr: a gap).
  [[nodiscard]] virtual QList<QAction*> own_actions() const = 0;
  [[nodiscard]] virtual QList<Tool> tools() const = 0;
  virtual void load(const QSettings& /*settings*/) {}
  virtual void save(QSettings& /*settings*/) const {}

 protected:
  /// Shows the state of the stage.
  virtual void refresh() {}

  [[nodiscard]] Desk& desk() const { return desk_; }
  [[nodiscard]] CharacterActions& actions() const { return actions_; }
  [[nodiscard]] practice::TabletControl& tablet() const { return desk_.tablet(); }
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
  Desk& desk_;
  CharacterActions& actions_;
  practice::PracticeStage& stage_;
};

}  // namespace nazori::ui
