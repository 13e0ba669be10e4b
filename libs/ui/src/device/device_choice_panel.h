// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <array>
#include <vector>

#include "nazori/devices/device_setup.h"

class QAction;
class QButtonGroup;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace nazori::ui {

class ButtonLines;
class DeviceActions;
class NumberSlider;

/// Which device is used, how it stands before the learner, what its buttons do and how strong it may become.
class DeviceChoicePanel final : public QScrollArea {
  Q_OBJECT
 public:
  DeviceChoicePanel(const DeviceActions& actions, QWidget* parent);

  /// Shows that devices are being searched, until show_choices().
  void show_searching();
  /// Gives the keyboard to the device that is chosen.
  void focus_choice();
  void show_choices(const devices::DeviceChoices& choices);
  /// @param own  limits of the device; without force there is nothing to fit or limit.
  void show_device(const devices::DeviceSettings& settings, const haptics::DeviceDescription& own,
                   double scale);
  /// The next step of the calibration; empty: no calibration is running.
  void show_step(const QString& text);

 signals:
  void chosen(QString id);
  void posture_changed(nazori::devices::TabletPosture posture);
  void buttons_changed(nazori::devices::ButtonDoes first, nazori::devices::ButtonDoes second);
  void limits_changed(double max_force_n, double max_stiffness_n_m);
  void corner_shown();

 private:
  QPushButton* button_for(QAction* action);
  void add_choice(const QString& id, const QString& text, bool checked);

  QWidget* content_;
  ButtonLines* lines_;
  QVBoxLayout* column_;
  QVBoxLayout* choices_;
  QButtonGroup* group_;
  QLabel* searching_;
  QLabel* fit_text_;
  QLabel* step_;
  QPushButton* corner_;
  QComboBox* hand_;
  NumberSlider* tilt_;
  NumberSlider* yaw_;
  std::array<QComboBox*, devices::DeviceSettings::kButtons> buttons_{};
  NumberSlider* force_;
  NumberSlider* stiffness_;
  std::vector<QWidget*> only_with_force_;
  bool showing_ = false;
};

}  // namespace nazori::ui
