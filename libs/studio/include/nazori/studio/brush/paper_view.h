// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/calligraphy/advice.h"
#include "nazori/calligraphy/brush_writing.h"
#include "nazori/calligraphy/ruling.h"
#include "nazori/studio/brush/brush_cursor.h"
#include "nazori/studio/parts/one_finger.h"

namespace nazori::ui {

/// Where the model stands.
enum class ModelPlace : std::uint8_t { none, beneath, beside };

/// The sheet of paper in the window: shows its picture, model, ruling and brush, and makes samples of a pen
/// from mouse, pen tablet and finger. Thread: interface.
class PaperView final : public QWidget {
  Q_OBJECT
 public:
  explicit PaperView(QWidget* parent);

  /// Starts with an empty picture. @param side  in pixels.
  void set_picture_side(int side);
  void show_frame(const calligraphy::BrushFrame& frame);
  /// @param strokes  of all models, where they are on the sheet. @param squares  that are ruled.
  void show_model(std::vector<calligraphy::ModelStroke> strokes,
                  std::vector<calligraphy::RuledSquare> squares, ModelPlace place);
  /// Corrections over the sheet; they are no part of it.
  void show_marks(std::vector<calligraphy::CorrectionMark> marks);
  void set_left_hand(bool left);
  void set_shows_brush(bool shows);
  void refresh_appearance();

  /// Moves the brush without a pointer. However fast it is called, the brush does not move faster than a calm
  /// hand. @param pressure  0..1, while it is down.
  void move_brush(geometry::PaperPoint at, bool down, double pressure);
  /// Shows the brush there, without writing.
  void show_brush_at(geometry::PaperPoint at) { move_cursor(place_.to_widget(at)); }
  /// Now, on the clock of the samples of pen_moved().
  [[nodiscard]] double pen_clock_s() const;
  /// The brush is no longer above the paper.
  void take_brush_away() { move_cursor({}); }

  [[nodiscard]] const SheetPlace& place() const { return place_; }
  /// What is shown of the sheet, without model and brush.
  [[nodiscard]] const QImage& picture() const { return picture_; }
  [[nodiscard]] const std::vector<calligraphy::CorrectionMark>& marks() const { return marks_; }
  [[nodiscard]] const std::vector<calligraphy::ModelStroke>& model() const { return model_; }
  [[nodiscard]] QSize sizeHint() const override { return {600, 600}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {220, 220}; }

 signals:
  /// The pen moved on the paper or just above it. Times are in seconds on one clock.
  void pen_moved(const nazori::brush::PenSample& sample);
  /// A stroke ends without a last position.
  void pen_lost();
  /// The other end of a pen was used.
  void eraser_used();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void touch(const QTouchEvent& event);
  void lay_out();
  void draw_scaled(const QRect& pixels);
  void draw_guides();
  void paint_beside(QPainter& painter) const;
  void write(QPointF at, bool down, double time_s, const calligraphy::HolderTilt& tilt,
             std::optional<double> pressure = {}, double twist_rad = 0);
  /// The time of an event of the window system.
  double seconds_of(std::uint64_t event_ms);
  void move_cursor(std::optional<QPointF> to);
  void update_brush();

  SheetPlace place_;
  QRectF beside_;   ///< where the model stands beside the sheet
  QImage picture_;  ///< a pixel for each cell
  QImage scaled_;   ///< the same in pixels of the screen
  QImage guides_;   ///< model and ruling, multiplied with the sheet
  std::vector<calligraphy::ModelStroke> model_;
  std::vector<calligraphy::RuledSquare> squares_;
  std::vector<calligraphy::CorrectionMark> marks_;
  ModelPlace model_place_ = ModelPlace::beneath;
  calligraphy::BrushShape brush_;
  QColor ink_;  ///< in the brush
  std::optional<QPointF> cursor_;
  QRectF drawn_brush_;  ///< what the brush covered in the last picture
  bool left_hand_ = false;
  bool shows_brush_ = true;
  bool down_ = false;
  OneFinger finger_;
  QElapsedTimer clock_;
  geometry::PaperPoint moved_to_{0, 0};  ///< by move_brush()
  double moved_s_ = 0;                   ///< when, on the clock of the pen
  qint64 clock_begins_ms_ = 0;           ///< of clock_, on the clock of the window system's events
};

}  // namespace nazori::ui
