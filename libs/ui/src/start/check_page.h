// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/widgets/page/page.h"

class QFrame;
class QLabel;
class QProgressBar;

namespace nazori::ui {

/// The actions of the test.
class CheckActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit CheckActions(QWidget* window);
  QAction *done, *unknown, *undo, *clear, *end;
};

/// The test of what a learner can write: each question above the tablet, written from memory. It is not among
/// the pages of the rail.
class CheckPage final : public Page {
  Q_OBJECT
 public:
  explicit CheckPage(WindowParts& parts);
  ~CheckPage() override;

  [[nodiscard]] QWidget* above_tablet() const override;
  [[nodiscard]] QWidget* under_tablet() const override;
  [[nodiscard]] ActionSet* actions() const override { return actions_; }
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] bool is_listed() const override { return false; }

  void enter() override;
  void leave() override;
  void refresh_appearance() override;

 private:
  void make_question();
  void make_buttons();
  void show_question();
  void end();

  CheckActions* actions_;
  QFrame* question_bar_;
  QLabel *progress_, *question_;
  QProgressBar* line_;
  QFrame* buttons_;
  bool entered_ = false;
};

}  // namespace nazori::ui
