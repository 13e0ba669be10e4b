// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <QTimer>
#include <array>

#include "nazori/haptics/haptic_scene.h"

class QComboBox;
class QLabel;
class QProgressBar;

namespace nazori::devices {
class TabletDevice;
}  // namespace nazori::devices

namespace nazori::ui {

class DeviceActions;
class NumberSlider;

/// The panel for the feel of the tablet: the live state of the stylus, the strength of the trial, and the
/// material.
class FeelPanel final : public QScrollArea {
  Q_OBJECT
 public:
  FeelPanel(devices::TabletDevice& stylus, const DeviceActions& actions, QWidget* parent);

  /// Looks at the stylus ten times a second while `on`.
  void watch(bool on);
  void show_strength(double strength, bool has_force);
  void show_material(const haptics::Material& material);
  void show_tip(double radius_m);

 signals:
  void material_changed(nazori::haptics::Material material);
  /// Radius of the ball at the tip [m]; 0: a point.
  void tip_changed(double radius_m);

 private:
  enum Line : std::uint8_t { pose, buttons, force, rate, lateness, missed, delay, line_count };

  void look();
  void emit_material();

  devices::TabletDevice& stylus_;
  QWidget* content_;
  std::array<QLabel*, line_count> lines_{};
  QLabel* strength_;
  QWidget* trial_;
  NumberSlider *stiffness_, *damping_, *hold_, *slide_, *popthrough_, *roughness_, *tip_;
  QComboBox* texture_;
  haptics::Material material_;
  bool showing_ = false;
  QTimer timer_;
};

}  // namespace nazori::ui
