// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "nazori/writing/written_character.h"

namespace nazori::ui {

/// A square of paper to draw on with mouse, pen or finger.
class DrawingPad final : public QWidget {
  Q_OBJECT
 public:
  explicit DrawingPad(QWidget* parent = nullptr);

  [[nodiscard]] const writing::WrittenCharacter& ink() const { return ink_; }
  void undo();
  void clear();

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override { return width; }
  [[nodiscard]] QSize sizeHint() const override { return {220, 220}; }

 signals:
  /// A stroke has grown, was added or was removed.
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;

 private:
  void begin(QPointF at, double pressure);
  void go_on(QPointF at, double pressure);
  void finish();
  void add(QPointF at, double pressure);

  writing::WrittenCharacter ink_;  ///< in sides of the pad
  bool down_ = false;
  QElapsedTimer clock_;
};

}  // namespace nazori::ui
