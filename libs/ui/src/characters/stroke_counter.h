// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace nazori::ui {

class TabletController;

/// Which stroke is shown, as a label of the toolbar. Keeps its width while stepping, so that the buttons
/// beside it stay under the pointer.
class StrokeCounter final : public QLabel {
  Q_OBJECT
 public:
  explicit StrokeCounter(const TabletController& controller);
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fit();

  const TabletController& controller_;
};

}  // namespace nazori::ui
