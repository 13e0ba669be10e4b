// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <utility>
#include <vector>

#include "nazori/author/check.h"
#include "nazori/author/workbench.h"
#include "nazori/studio/workshop/part_words.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QSpinBox;

namespace nazori::ui {

class GrooveCurve;
class PartsEditor;
class WorkshopActions;

/// Beside the tablet in the making: the tool, the strokes in their order, what the character is called, and
/// what a check found.
class WorkshopPanel final : public QScrollArea {
  Q_OBJECT
 public:
  WorkshopPanel(const WorkshopActions& actions, QWidget* parent);

  /// How forms of radicals that are typed are read.
  void set_radicals(RadicalOfForm of_form) { radical_of_form_ = std::move(of_form); }
  void show_settings(const author::BenchSettings& settings);
  void show_character(const author::Workbench& bench);
  /// Findings of a check. @param checked  false: none was made, or it is no longer true.
  void show_findings(const std::vector<author::Finding>& findings, bool checked);
  void focus_name();
  /// Gives the keyboard to the curve of the width along the stroke.
  void focus_curve();
  /// Adds a part of the strokes that are chosen in the list, else of those that are in no part.
  void add_part();
  /// Removes the chosen part. @return whether one is chosen.
  bool remove_part();

  [[nodiscard]] QSize sizeHint() const override;

 signals:
  // The teacher chose something.
  void tool_changed(double width, double depth, int ending, int stamp);
  void stroke_chosen(std::size_t stroke);
  /// In a curve of the chosen stroke, of which the half width or depth at a point is moved.
  void point_chosen(std::size_t point);
  void half_width_moved(std::size_t point, double half_width, bool goes_on);
  void depth_moved(std::size_t point, double depth, bool goes_on);
  void curve_said(const QString& sentence);
  /// A stroke was dragged to another place in the list.
  void stroke_dragged(std::size_t from, std::size_t to);
  /// Name, readings, meanings, radical, parts, licence or author were typed.
  void facts_typed(const nazori::author::Facts& facts);
  /// What was typed into a field cannot be read. The field shows what it had before.
  void text_refused(const QString& sentence);
  void finding_chosen(const nazori::author::Finding& finding);
  /// Enter ended a field, or Escape was pressed anywhere in the panel: the keyboard belongs to the drawing.
  void left();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void send_facts();
  void send_tool();

  QWidget* content_;
  QDoubleSpinBox* width_;
  QSpinBox* depth_;
  QComboBox *ending_, *stamp_;
  QFormLayout* tool_form_;
  QLabel* selection_;
  QListWidget* strokes_;
  GrooveCurve *width_curve_, *depth_curve_;
  QLineEdit *name_, *readings_, *meanings_, *radical_, *licence_, *author_;
  PartsEditor* parts_;
  QLabel *source_, *findings_words_;
  QListWidget* findings_list_;
  RadicalOfForm radical_of_form_;
  author::Facts facts_;
  std::vector<author::Finding> findings_;
};

}  // namespace nazori::ui
