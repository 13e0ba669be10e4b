// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "nazori/author/workbench.h"
#include "nazori/studio/parts/one_finger.h"

namespace nazori::ui {

/// The tablet on which a character is made: its relief, the strokes over it, and what is chosen. Sends
/// positions of mouse, pen and finger. Thread: interface.
class CharacterCanvas final : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kLargestZoom = 16;

  /// @param bench  what is shown; outlives this.
  CharacterCanvas(const author::Workbench& bench, QWidget* parent);

  /// Samples of the relief have changed.
  void refresh_relief(const carving::GridBox& box);
  /// Strokes, the cursor or what is chosen have changed.
  void refresh();
  void refresh_appearance();
  void set_shows_strokes(bool shows);

  /// @param factor  above 1: shows less, larger. @param around  stays where it is in the widget.
  void zoom(double factor, std::optional<QPointF> around = {});
  void show_whole();
  [[nodiscard]] double zoomed() const { return zoom_; }
  [[nodiscard]] QPointF to_widget(geometry::GlyphPoint at) const;
  [[nodiscard]] geometry::GlyphPoint to_glyph(QPointF at) const;

  [[nodiscard]] QSize sizeHint() const override { return {600, 600}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {220, 220}; }

 signals:
  void pen_moved(const nazori::geometry::WrittenPoint<nazori::geometry::GlyphFrame>& pen, bool down);
  /// A movement ends without a last position.
  void pen_lost();
  void double_clicked(nazori::geometry::GlyphPoint at);
  /// An arrow key. @param by  [glyph units].
  void moved_by_key(nazori::geometry::GlyphPoint by);
  /// The space bar. @param time_s  on the clock of the pen.
  void pressed_by_key(double time_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void touch(const QTouchEvent& event);
  void send(QPointF at, bool down, std::uint64_t event_ms, std::optional<double> pressure = {});
  void lay_out();
  void paint_strokes(QPainter& painter) const;
  void paint_stroke(QPainter& painter, std::size_t number) const;
  void paint_under_way(QPainter& painter) const;

  const author::Workbench& bench_;
  QImage relief_;                 ///< a pixel for each sample
  std::vector<QPolygonF> lines_;  ///< centre lines in glyph units
  std::vector<geometry::GlyphPoint> numbers_;
  QRectF place_;  ///< of the whole tablet, in pixels of the widget
  double zoom_ = 1;
  QPointF centre_{geometry::kGlyphSide / 2, geometry::kGlyphSide / 2};  ///< of what is shown [glyph units]
  std::optional<QPointF> panned_from_;
  bool shows_strokes_ = true;
  bool down_ = false;
  OneFinger finger_;
  QElapsedTimer clock_;
};

}  // namespace nazori::ui
