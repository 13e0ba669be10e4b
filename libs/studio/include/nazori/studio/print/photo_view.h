// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPolygonF>
#include <QWidget>

#include "nazori/surface/colour_picture.h"

namespace nazori::ui {

/// A photograph, as large as there is room, with one place of it marked.
class PhotoView final : public QWidget {
  Q_OBJECT
 public:
  explicit PhotoView(QWidget* parent = nullptr);

  /// @param words  for a screen reader.
  void show_picture(const surface::ColourPicture& picture, const QString& words);
  /// Shows nothing.
  void clear();
  /// Marks a place. @param corners  in pixels of the picture; empty: none.
  void mark(const QPolygonF& corners);
  [[nodiscard]] const QImage& picture() const { return picture_; }
  [[nodiscard]] const QPolygonF& marked() const { return marked_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {140, 140}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage picture_;    ///< smaller than the photograph where that is large
  QSizeF whole_;      ///< of the photograph, in its pixels
  QPolygonF marked_;  ///< likewise
};

}  // namespace nazori::ui
