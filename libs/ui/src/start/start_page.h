// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/practice/learning_choices.h"
#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class InputPause;
class StartView;

/// The actions of the first start.
class StartActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit StartActions(QWidget* window);
  QAction *write, *skip;
};

/// What the learner wants to write, knows already, and how long a day: asked at the first start, and again
/// whenever the learner wishes. It is not among the pages of the rail.
class StartPage final : public Page {
  Q_OBJECT
 public:
  explicit StartPage(WindowParts& parts);
  ~StartPage() override;

  [[nodiscard]] QWidget* instead_of_tablet() const override;
  [[nodiscard]] ActionSet* actions() const override { return actions_; }
  [[nodiscard]] bool is_listed() const override { return false; }
  [[nodiscard]] bool comes_first() const override;

  void enter() override;
  void leave() override;

 private:
  /// Only what the learner changed; at the first start everything that is chosen.
  [[nodiscard]] practice::LearningAnswers changed_answers() const;
  void begin_again();
  void show_plan();
  void show_input();
  void go_on();
  void start_check();
  void write();
  void skip();

  StartActions* actions_;
  StartView* view_;
  InputPause* pause_;
  practice::LearningAnswers before_;
  bool is_first_ = true;
  bool is_open_ = false;  ///< the answers are not saved yet, and stay
  bool entered_ = false;
};

}  // namespace nazori::ui
