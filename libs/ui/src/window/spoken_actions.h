// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QObject>

namespace nazori::ui {

class FeedbackLine;

/// Speaks what a key did where nothing else is said about it: a key without an answer is silence for somebody
/// who does not see the window. An action that is switched is spoken with its state, one of several to choose
/// from and any other by its name. What is chosen in a menu was read there. Thread: interface.
class SpokenActions final : public QObject {
  Q_OBJECT
 public:
  /// @param window  its actions with keys are followed; they and their handlers exist already.
  SpokenActions(QWidget& window, FeedbackLine& feedback);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  FeedbackLine& feedback_;
  const QAction* pressed_ = nullptr;  ///< the action whose key was pressed and that has not answered yet
  int spoken_before_ = 0;
};

/// "Numbers: on", "Slate".
[[nodiscard]] QString spoken_name(const QAction& action);

}  // namespace nazori::ui
