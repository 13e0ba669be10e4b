// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <vector>

#include "nazori/author/check.h"
#include "nazori/author/workbench.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QSpinBox;

namespace nazori::ui {

class WorkshopActions;

/// Beside the tablet in the making: the tool, the strokes in their order, what the character is called, and
/// what a check found.
class WorkshopPanel final : public QScrollArea {
  Q_OBJECT
 public:
  WorkshopPanel(const WorkshopActions& actions, QWidget* parent);

  void show_settings(const author::BenchSettings& settings);
  void show_character(const author::Workbench& bench);
  /// Findings of a check. @param checked  false: none was made, or it is no longer true.
  void show_findings(const std::vector<author::Finding>& findings, bool checked);
  void focus_name();

  [[nodiscard]] QSize sizeHint() const override;

 signals:
  // The teacher chose something.
  void tool_changed(double width, double depth, int ending, int stamp);
  void stroke_chosen(std::size_t stroke);
  /// A stroke was dragged to another place in the list.
  void stroke_dragged(std::size_t from, std::size_t to);
  /// Name, readings, meanings, licence or author were typed.
  void facts_typed(const nazori::author::Facts& facts);
  void finding_chosen(const nazori::author::Finding& finding);

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
  QLineEdit *name_, *readings_, *meanings_, *licence_, *author_;
  QLabel *source_, *findings_words_;
  QListWidget* findings_list_;
  author::Facts facts_;
  std::vector<author::Finding> findings_;
};

}  // namespace nazori::ui
