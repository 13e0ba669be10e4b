// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <array>
#include <vector>

#include "nazori/functions/plate.h"
#include "nazori/functions/plot.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QSlider;

namespace nazori::ui {

class ExpressionLine;
class FieldRow;
class ParameterSliders;

/// The left panel: the expression and how it was read, the range, what is shown on the plate, and the sound.
/// It only shows values and emits signals; the page decides.
class PlotPanel final : public QScrollArea {
  Q_OBJECT
 public:
  explicit PlotPanel(QWidget* parent = nullptr);

  [[nodiscard]] ExpressionLine* line() const { return line_; }

  void show_words(const QString& words);
  /// Marks the position of an error and says what is wrong, instead of the sentence before.
  void show_error(const functions::SyntaxError& error);
  /// A slider for each of them.
  void show_parameters(const std::vector<functions::Parameter>& parameters);
  void show_window(const functions::Window& window);
  void show_plate(const functions::PlateSettings& plate);
  void show_volume(int percent, bool muted);
  /// Whether the expression is a surface, which has a range of heights.
  void show_surface(bool surface);
  /// Progress of the drawing, 0 to 1; below 0: nothing is being drawn.
  void show_progress(double done);
  /// Uses the current colours.
  void refresh_appearance();

 signals:
  void expression_typed(QString expression);
  /// A slider was moved. @param letter  the parameter
  void parameter_moved(QString letter, double value);
  void example_chosen(QString expression, nazori::functions::Window window);
  void window_typed(nazori::functions::Window window);
  /// A border that is not a number. @param text  what was typed.
  void window_refused(QString text);
  /// Heights that are not a range. @param text  what was typed.
  void heights_refused(QString text);
  void plate_changed(nazori::functions::PlateSettings plate);
  void volume_changed(int percent);
  void mute_changed(bool muted);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fit();
  void order_tabs();
  void read_window();
  void read_heights();
  void read_plate();

  QWidget* content_;
  ExpressionLine* line_;
  QLabel* words_;
  QWidget* error_row_;
  QLabel* error_sign_;
  QLabel* error_;
  QProgressBar* progress_;
  ParameterSliders* parameters_;
  QComboBox* examples_;
  std::vector<FieldRow*> rows_;
  std::array<QLineEdit*, 4> borders_{};  ///< x0, x1, y0, y1
  std::array<QLineEdit*, 2> heights_{};  ///< z0, z1
  QCheckBox* axes_;
  QCheckBox* ticks_;
  QCheckBox* grid_;
  QCheckBox* rim_;
  QDoubleSpinBox* width_;
  QComboBox* size_;
  QSlider* volume_;
  QCheckBox* mute_;
  functions::Window window_;
  functions::PlateSettings plate_;
};

}  // namespace nazori::ui
