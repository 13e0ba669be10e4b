// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>

#include "nazori/practice/solid_model.h"

namespace nazori::ui {

/// A plate seen from above, as large as there is room.
class ReliefView final : public QWidget {
  Q_OBJECT
 public:
  explicit ReliefView(QWidget* parent = nullptr);

  /// @param words  for a screen reader.
  void show_picture(const practice::ReliefPicture& picture, const QString& words);
  /// Shows nothing.
  void clear();
  [[nodiscard]] const QImage& picture() const { return picture_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {140, 140}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage picture_;
};

}  // namespace nazori::ui
