// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/base/signal.h"
#include "nazori/devices/back_end.h"
#include "nazori/devices/device_settings.h"
#include "nazori/devices/tablet_device.h"

namespace nazori::devices {

/// What a learner hears about the device of the tablet.
enum class DeviceNewsKind : std::uint8_t {
  in_use,       ///< `device` was opened and is in use
  works_again,  ///< `device` had paused
  changed,      ///< `device` is open again with the new settings: see `change`
  replaced,     ///< `trouble` with the device that should be in use; `device` is used until then
  missing,      ///< as replaced, but nothing takes its place: mouse or pen is used until then
};

/// A change of the settings for which a device is closed and opened again.
enum class DeviceChange : std::uint8_t { none, automatic_fit, posture, corners };

/// Why the device that should be in use is not.
struct MissingDevice {
  std::string device;  ///< its name for people; of one that could not be opened, its id
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::none;
  std::string message;  ///< English, of one that could not be opened
};

/// One piece of news; the window makes a sentence of it.
struct DeviceNews {
  DeviceNewsKind kind = DeviceNewsKind::in_use;
  std::string device;                        ///< its name for people
  DeviceChange change = DeviceChange::none;  ///< of changed
  MissingDevice missing;                     ///< of replaced and missing
};

/// A row of the list from which a device is chosen.
struct DeviceChoice {
  enum class State : std::uint8_t { found, in_use, not_connected };
  std::string id;    ///< empty: the best one available
  std::string name;  ///< for people; of one that is not connected and never was, its id; empty: the best one
                     ///< available
  State state = State::found;
  bool chosen = false;
};

/// The devices to choose from, and why some were not found.
struct DeviceChoices {
  std::vector<DeviceChoice> devices;      ///< the best available first, then in the order of the back ends
  std::vector<BackEndFindings> problems;  ///< back ends with a problem that is to be shown
};

/// @param memory  the chosen device, and the names of devices that were open before. @param in_use  id of the
/// open device, "pointer" for none.
[[nodiscard]] DeviceChoices device_choices(const std::vector<BackEndFindings>& findings,
                                           const DeviceMemory& memory, const std::string& in_use,
                                           const std::string& in_use_name);

/// How a learner sets up the device of the tablet: which one, its posture, limits and buttons, a trial with
/// little force, and a calibration by three corners. Owns the saved settings of devices. Thread: the owner of
/// the device.
class DeviceSetup {
 public:
  /// A trial begins with this share of the device's limits, and each request adds as much.
  static constexpr double kTrialStep = 0.1;
  static constexpr int kCorners = 3;

  /// The result of add_corner().
  enum class Corner : std::uint8_t {
    next,       ///< corner() is to be shown next
    done,       ///< the tablet lies where the learner pointed; the device is opened again
    no_tablet,  ///< the corners are not those of a tablet; nothing was changed
    no_device,  ///< the device was disconnected; nothing was changed
  };

  /// @param device  outlives this object.
  DeviceSetup(TabletDevice& device, TabletDevice::BackEnds back_ends);

  base::Signal<const DeviceNews&> news;
  /// The device was opened, or the search for it has ended.
  base::Signal<> settled;

  [[nodiscard]] const DeviceMemory& memory() const { return *memory_; }
  void load(const base::Settings& settings) { memory_->load(settings); }
  void set_material(const haptics::Material& material) { memory_->material = material; }
  /// @param radius_m  of the ball at the tip, 0..surface::kLargestBall_m.
  void set_tip(double radius_m) { memory_->tip_radius_m = radius_m; }

  /// Opens the chosen device.
  void open_chosen() { device_.choose(memory_->chosen); }
  void choose(const std::string& id);
  /// The id of the open device, "pointer" for none.
  [[nodiscard]] std::string id_in_use() const;
  /// The saved settings of the device in use.
  [[nodiscard]] DeviceSettings settings() const { return settings_of(memory_->devices, id_in_use()); }

  /// The posture holds when apply() opens the device again. A calibration was made for another posture: it is
  /// forgotten.
  void set_posture(const TabletPosture& posture);
  void set_buttons(const std::array<ButtonDoes, DeviceSettings::kButtons>& buttons) {
    own().buttons = buttons;
  }
  void set_limits(double force_n, double stiffness_n_m);
  /// Forgets the calibration, so that the tablet is as large as the stylus can reach.
  void fit();
  /// Opens the device again with its settings. @param change  reported when it is open.
  void apply(DeviceChange change);

  /// @param strength  share of the device's limits; at least a step, at most all.
  void set_strength(double strength);
  void change_strength(int steps) { set_strength(device_.strength() + steps * kTrialStep); }
  [[nodiscard]] bool can_be_stronger() const;
  [[nodiscard]] bool can_be_weaker() const;

  /// Begins a calibration by corners: bottom left, bottom right, top left. @return false without a device.
  [[nodiscard]] bool begin_calibration();
  /// The next corner to show, from 0; -1: no calibration.
  [[nodiscard]] int corner() const { return corner_; }
  /// The tip of the stylus is at the next corner.
  Corner add_corner();
  void stop_calibration() { corner_ = -1; }

  /// What a button of the device in use does. @param number  from 0.
  [[nodiscard]] ButtonDoes action_of(int number) const;

 private:
  void follow(const DeviceEvent& event);
  void report_use(const DeviceEvent& event);
  /// The saved settings of the device in use, or of the one that is being opened again, to be changed.
  DeviceSettings& own();

  TabletDevice& device_;
  std::shared_ptr<DeviceMemory> memory_ = std::make_shared<DeviceMemory>();  ///< the device reads it, too
  std::optional<MissingDevice> missing_;      ///< nothing: the device that should be in use is
  bool missing_is_news_ = false;              ///< missing_ was not reported yet
  DeviceChange change_ = DeviceChange::none;  ///< reported when the device is open again
  int corner_ = -1;
  std::array<haptics::Vec3, kCorners> corners_m_{};
  base::Connection happened_;  // declared last, so that it ends before the other members are destroyed
};

}  // namespace nazori::devices
