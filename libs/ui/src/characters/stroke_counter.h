// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace nazori::practice {
class TabletControl;
}

namespace nazori::ui {

/// Which stroke is shown, as a label of the toolbar. Keeps its width while stepping, so that the buttons
/// beside it stay under the pointer.
class StrokeCounter final : public QLabel {
  Q_OBJECT
 public:
  explicit StrokeCounter(const practice::TabletControl& controller);
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fit();

  const practice::TabletControl& controller_;
};

}  // namespace nazori::ui
