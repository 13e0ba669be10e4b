// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>

#include "desk.h"
#include "nazori/devices/device_settings.h"
#include "nazori/devices/tablet_device.h"
#include "workplace.h"

namespace nazori::ui {

class DeviceActions;
class FeelPanel;
class SeatPanel;

/// The workplace for what the tablet is felt with: finding and choosing a device, fitting it to the tablet,
/// its buttons and limits on the left; its live state, a safe trial and the material on the right; between
/// them a tablet with a wall and a groove. Owns what is remembered of devices, and says what happens to them
/// wherever the learner is.
class DevicePlace final : public Workplace {
  Q_OBJECT
 public:
  /// A trial begins with this share of the device's limits, and each request adds as much.
  static constexpr double kTrialStep = 0.1;
  /// So long a slider of the posture rests before the device is opened anew with it.
  static constexpr int kPostureRest_ms = 400;

  explicit DevicePlace(Desk& desk);
  ~DevicePlace() override;

  [[nodiscard]] QString id() const override;
  [[nodiscard]] QString name() const override;
  [[nodiscard]] QString purpose() const override;
  [[nodiscard]] Icon drawing() const override;
  [[nodiscard]] Panel left() const override;
  [[nodiscard]] Panel right() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;
  [[nodiscard]] QString tablet_description() const override;
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
  /// The device is opened anew with what is remembered of it now. @param sentence  said once it is.
  void reopen(const QString& sentence);
  void look_again();
  void show_findings(const std::vector<devices::BackEndFindings>& findings);
  void refresh();
  void show_device();
  void set_strength(double strength);
  /// What is remembered of the device in use, to be changed; made where there is none.
  devices::DeviceSettings& settings();
  void calibrate();
  void take_corner();
  void end_calibration(const QString& sentence, Feedback kind);
  void press_button(int number);

  devices::TabletDevice& stylus_;
  devices::DeviceMemory memory_;
  DeviceActions* actions_;
  SeatPanel* seat_panel_;
  FeelPanel* feel_panel_;
  std::shared_ptr<const tablet::CarvedTablet> trial_tablet_;
  QTimer posture_timer_;
  QString trouble_;      ///< why the device that was asked for does not have the tablet
  bool untold_ = false;  ///< and it was not said yet
  QString fitted_;       ///< to be said once the device is open anew
  bool entered_ = false;
  int corner_ = -1;  ///< the next to be shown, -1: no calibration
  std::array<haptics::Vec3, 3> corners_m_{};
};

/// The tablet of the trial: a wall on the left, a groove on the right.
[[nodiscard]] std::shared_ptr<const tablet::CarvedTablet> wall_and_groove(const geometry::TabletShape& shape);

}  // namespace nazori::ui
