// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>

#include "nazori/print/page_drawing.h"

class QPainter;

namespace nazori::ui {

/// Paints a side of paper at the origin, one millimetre a unit.
void paint_page(QPainter& painter, const print::PageDrawing& page, const QColor& paper);

/// One side of a document on paper, as large as there is room. PgUp, PgDn, Home and End turn the pages.
class PageView final : public QWidget {
  Q_OBJECT
 public:
  explicit PageView(QWidget* parent = nullptr);

  /// @param words  for a screen reader: which page it is, and what is on it.
  void show_page(std::shared_ptr<const print::PageDrawing> page, const QString& words);
  /// Shows no page.
  void clear();
  [[nodiscard]] const std::shared_ptr<const print::PageDrawing>& page() const { return page_; }
  /// Where the paper lies in the widget; empty where there is none.
  [[nodiscard]] QRectF paper() const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  /// By how many pages to turn; the smallest and the largest number mean the first and the last page.
  void turned(int pages);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  std::shared_ptr<const print::PageDrawing> page_;
  int wheel_ = 0;  ///< turned by less than a step so far
};

}  // namespace nazori::ui
