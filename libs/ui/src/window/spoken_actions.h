// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QObject>

namespace nazori::ui {

class FeedbackLine;

/// Speaks the action of a key where nothing else is said about it, for people who do not see the window. An
/// action that can be on or off is spoken with its state, every other one by its name. What is chosen in a
/// menu is not spoken, because the screen reader has read it there. Thread: interface.
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
