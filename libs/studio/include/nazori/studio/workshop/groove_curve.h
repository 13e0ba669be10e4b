// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "nazori/carving/groove.h"

namespace nazori::ui {

/// The width or the depth of a groove from its start to its end, as a curve whose points can be dragged up
/// and down, and moved by the arrow keys. It shows a groove and sends what the teacher wants; the page
/// decides.
class GrooveCurve final : public QWidget {
  Q_OBJECT
 public:
  /// What is drawn upwards (half width) or, like the groove itself, downwards (depth).
  enum class Quantity : std::uint8_t { half_width, depth };
  GrooveCurve(Quantity quantity, const char* name, QWidget* parent);

  /// @param groove  of the chosen stroke; empty: none is chosen. @param point  that is chosen.
  void show_groove(const carving::Groove& groove, std::optional<std::size_t> point);

  /// "Point 2 of 5: width 7.0", for people who do not see the curve.
  [[nodiscard]] QString value_words() const;
  /// Half width [glyph units] or depth (0..1) at the chosen point; nothing where none is chosen.
  [[nodiscard]] std::optional<double> value() const;
  /// Largest value that a point may have.
  [[nodiscard]] double largest() const;
  /// How far one press of an arrow key goes.
  [[nodiscard]] double step() const;
  /// Changes the chosen point, as a key does.
  void set_value(double value);
  /// Where a point is drawn.
  [[nodiscard]] QPointF place_of(std::size_t point) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void point_chosen(std::size_t point);
  /// @param goes_on  the same drag, or a key that is held.
  void value_moved(std::size_t point, double value, bool goes_on);
  /// A key was pressed or a drag ended: this is to be spoken.
  void said(const QString& sentence);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  [[nodiscard]] double value_of(const carving::GroovePoint& point) const;
  [[nodiscard]] QRectF room() const;
  /// @param along  share of the length. @param value  as value().
  [[nodiscard]] QPointF to_widget(double along, double value) const;
  [[nodiscard]] double value_at(double y) const;
  void step_to(std::size_t point);
  void change(double value, bool goes_on);
  void note_value();

  Quantity quantity_;
  carving::Groove groove_;
  std::vector<double> along_;  ///< of each point, share of the length
  QPolygonF line_;             ///< share of the length, value
  double top_ = 1;             ///< largest value that is shown
  std::optional<std::size_t> point_;
  bool drags_ = false;
  bool has_dragged_ = false;
  double grip_ = 0;  ///< from the pointer to the point that it drags [pixels]
};

}  // namespace nazori::ui
