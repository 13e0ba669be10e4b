// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>
#include <cstddef>

#include "nazori/base/settings.h"
#include "nazori/practice/touch_file.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace nazori::ui {

/// The rows of a form for machines that make a tablet from a file: depth, the mill and layers for those that
/// cut, paper, cells and English braille for swell paper and embossers.
class MachineOptions final : public QObject {
  Q_OBJECT
 public:
  /// What is made, which decides the rows that are shown.
  enum class Made { raised_tablet, grooved_tablet, plot, surface };

  static constexpr std::size_t kMillRows = 7;

  /// @param form  gets the rows; lives as long as this.
  explicit MachineOptions(QFormLayout& form, QObject* parent);

  void show_for(Made made);
  [[nodiscard]] practice::TouchMachines machines() const;
  /// Depth of the deepest groove.
  [[nodiscard]] double depth_mm() const;
  void load(const base::Settings& values);
  void store(base::Settings& values) const;

 signals:
  /// The relief changes, not only what a machine makes of it.
  void depth_changed();

 private:
  QDoubleSpinBox* add_number(const char* name, const QString& text, double low, double high, double step);
  QSpinBox* add_count(const char* name, const QString& text);

  QFormLayout& form_;
  QDoubleSpinBox* depth_;
  std::array<QDoubleSpinBox*, kMillRows> mill_{};
  QSpinBox *layers_, *columns_, *lines_;
  QComboBox *paper_, *english_;
};

}  // namespace nazori::ui
