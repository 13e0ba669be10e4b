// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "nazori/devices/device_setup.h"
#include "nazori/widgets/page/page.h"
#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {

class DeviceActions;
class FeelPanel;
class DeviceChoicePanel;

/// The page for devices. On the left: finding and choosing a device, fitting it to the tablet, its buttons
/// and limits. On the right: its live state, a safe trial and the material. Between them: a tablet with a
/// wall and a groove. Owns the stored settings of devices, and announces what happens to them on every page.
class DevicePage final : public Page {
  Q_OBJECT
 public:
  /// How long a slider of the posture must rest before the device is opened again with its value.
  static constexpr int kPostureRest_ms = 400;

  explicit DevicePage(WindowParts& parts);
  ~DevicePage() override;

  [[nodiscard]] Panel left() const override;
  [[nodiscard]] Panel right() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  void enter() override;
  void leave() override;
  void save(QSettings& settings) const override;

 private:
  void connect_actions();
  void connect_panels();
  void connect_stylus();
  void report(const devices::DeviceNews& news);
  [[nodiscard]] static QString change_words(devices::DeviceChange change);
  void look_again();
  void show_device();
  void set_tip(double radius_m);
  void calibrate();
  void add_corner();
  void end_calibration(const QString& sentence, Feedback kind);
  void press_button(int number);

  devices::TabletDevice& stylus_;
  devices::DeviceSetup setup_;
  DeviceActions* actions_;
  DeviceChoicePanel* choice_panel_;
  FeelPanel* feel_panel_;
  std::shared_ptr<const tablet::CarvedTablet> trial_tablet_;
  QTimer posture_timer_;
  bool entered_ = false;
};

}  // namespace nazori::ui
