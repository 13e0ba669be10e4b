// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "nazori/devices/device_settings.h"
#include "nazori/devices/tablet_device.h"
#include "page/page.h"
#include "page/window_parts.h"

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
  /// A trial begins with this share of the device's limits, and each request adds as much.
  static constexpr double kTrialStep = 0.1;
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
  void report(const devices::DeviceEvent& event);
  void report_taken(const QString& device, bool again);
  void choose(const QString& id);
  /// Opens the device again with its current settings. @param sentence  announced when it is open.
  void reopen(const QString& sentence);
  void look_again();
  void show_findings(const std::vector<devices::BackEndFindings>& findings);
  void refresh();
  void show_device();
  void set_strength(double strength);
  /// The stored settings of the device in use, to be changed. They are made if there are none.
  devices::DeviceSettings& settings();
  void calibrate();
  void add_corner();
  void end_calibration(const QString& sentence, Feedback kind);
  void press_button(int number);

  devices::TabletDevice& stylus_;
  devices::DeviceMemory memory_;
  DeviceActions* actions_;
  DeviceChoicePanel* choice_panel_;
  FeelPanel* feel_panel_;
  std::shared_ptr<const tablet::CarvedTablet> trial_tablet_;
  QTimer posture_timer_;
  QString trouble_;                   ///< why the chosen device is not in use
  bool trouble_to_announce_ = false;  ///< trouble_ was not announced yet
  QString fitted_;                    ///< announced when the device is open again
  bool entered_ = false;
  int corner_ = -1;  ///< the next corner to show; -1: no calibration
  std::array<haptics::Vec3, 3> corners_m_{};
};

}  // namespace nazori::ui
