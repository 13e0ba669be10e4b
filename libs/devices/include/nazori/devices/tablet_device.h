// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/clock.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/devices/device_search.h"
#include "nazori/devices/device_settings.h"
#include "nazori/devices/pointer_device.h"
#include "nazori/haptics/servo.h"

namespace nazori::devices {

/// What can happen to the tablet's device.
enum class DeviceEventKind : std::uint8_t {
  taken,     ///< a device was opened and is now active
  resumed,   ///< a device that had paused is active again
  paused,    ///< the device gives no force for now; the pointer is active. Also sent when the cause changes.
  lost,      ///< as paused, but the device is closed; the next best is searched for, and this one is retried
  refused,   ///< the requested device could not be opened; if another one is active now, `taken` reports it,
             ///< else it is the pointer
  searched,  ///< a search that choose(), reopen() or a loss began has ended
};

/// One event; the window turns it into a sentence.
struct DeviceEvent {
  DeviceEventKind kind = DeviceEventKind::searched;
  std::string device;  ///< its name for people; refused: the requested id; searched: empty
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::none;  ///< paused, lost, refused
  std::string message;                                            ///< English, for the same
};

/// The input of the tablet: a device of the catalogue with its servo, or mouse and pen in its place. The
/// input that drives the tablet is called active.
///
/// The pointer is always available. While an opened device is paused or after it was lost, the pointer is
/// active, with the same scene. When the device runs again it becomes active again, with a force ramp. If a
/// device was lost, or was chosen and is missing, the next best takes its place. The missing device is
/// retried from time to time and becomes active once it is back. Searching and opening happen on a separate
/// thread. Thread: the owner of the inbox, for everything, signals too.
class TabletDevice {
 public:
  using BackEnds = DeviceSearch::BackEnds;
  /// Returns the saved settings of each device; called when one is opened or started.
  using Remembered = std::function<RememberedDevices()>;
  /// Requests a call of update() at this time of the clock or soon after; a later request replaces an earlier
  /// one.
  using WakeAt = std::function<void(base::Clock::Steady at)>;

  /// @param inbox, clock  outlive this object. @param wake_at  may be empty if update() is called regularly
  ///   anyway.
  TabletDevice(base::Inbox& inbox, const base::Clock& clock, WakeAt wake_at);
  ~TabletDevice();
  TabletDevice(const TabletDevice&) = delete;
  TabletDevice& operator=(const TabletDevice&) = delete;

  /// Emitted just before another servo becomes active: the last chance to read samples of the present one.
  base::Signal<> leaving;
  /// Another servo has become active.
  base::Signal<> changed;
  base::Signal<const DeviceEvent&> happened;
  /// The answer to find().
  base::Signal<const std::vector<BackEndFindings>&> found;
  /// Samples that were just read, in order.
  base::Signal<std::span<const haptics::ServoSample>> sampled;
  /// Button `number` of a device (not of the mouse), from 0, went down. Emitted while samples are read: a
  /// function that opens or closes a device must wait until that is finished.
  base::Signal<int> button_pressed;

  /// Starts the pointer.
  [[nodiscard]] base::Result<void> start();
  /// Does all work that is due: checks the device, retries a missing one, lets an idle pointer rest.
  void update();
  /// Sets the pointer state. @param event_s  when it happened, on the clock of the window system; nothing:
  /// now.
  void move(const PointerState& state, std::optional<double> event_s = {});
  /// Keeps the pointer's servo ticking also while nothing moves, for a recording without gaps.
  void set_awake(bool awake);
  /// Whether the pointer is active and has not moved for a second, so that its servo stands still. The next
  /// move starts it again.
  [[nodiscard]] bool is_resting() const { return is_pointer() && resting_; }
  void set_scene(std::shared_ptr<const haptics::HapticScene> scene);

  // The active servo.
  [[nodiscard]] const haptics::ServoSample& latest() { return servo().latest(); }
  /// Reads samples in order, and emits sampled and button_pressed. @return how many were written to `out`.
  std::size_t take_samples(std::span<haptics::ServoSample> out);
  [[nodiscard]] haptics::ServoTiming timing() const { return active_->servo->timing(); }
  [[nodiscard]] haptics::DeviceDescription describe() const { return active_->description; }
  [[nodiscard]] haptics::Servo& servo() { return *active_->servo; }
  [[nodiscard]] bool is_pointer() const { return active_ == &pointer_run_; }
  /// The description of the open device, paused or not; else of the pointer.
  [[nodiscard]] haptics::DeviceStatus status() const;

  /// Sets the catalogue of devices. @param shape  of the tablets. Nothing is opened yet.
  void set_devices(BackEnds back_ends, const geometry::TabletShape& shape, Remembered remembered);
  /// Asks every back end for its devices; `found` receives the answer, some seconds later at worst. The open
  /// device is listed too.
  void find();
  /// Closes the open device and opens `id`, or if that fails the next best; empty: the best one available;
  /// "pointer": none. `happened` reports the result, DeviceEventKind::searched last.
  void choose(const std::string& id);
  /// Whether a device is being searched for or opened.
  [[nodiscard]] bool is_searching() const { return searching_; }
  /// The id of the last choose().
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  /// The device that is open, paused or not; nullptr: none. With its id, calibration and workspace.
  [[nodiscard]] const OpenedDevice* opened() const { return device_ ? &device_->opened : nullptr; }
  /// The open device's own description, paused or not: before the learner's limits.
  [[nodiscard]] haptics::DeviceDescription own_description() const;
  /// The saved settings of the open device have changed: closes it and opens it again with them.
  void reopen();
  /// The device that is being opened again; empty: none.
  [[nodiscard]] const std::string& reopening() const { return reopening_; }
  /// Its limits have changed: starts it again, with a force ramp.
  void apply_limits();
  /// Sets the share of its limits that the device may use, 0.05..1: less than 1 while something new is tried.
  /// Starts it again, with a force ramp.
  void set_strength(double strength);
  [[nodiscard]] double strength() const { return strength_; }

 private:
  using Deadline = std::optional<base::Clock::Steady>;

  /// A device with the servo that it runs.
  struct DeviceRun {
    OpenedDevice opened;  ///< the pointer's has no device
    haptics::DeviceDescription description;
    std::unique_ptr<haptics::Servo> servo;
  };

  void search_for(DeviceWish wish, bool announced);
  void use(DeviceFind result, const DeviceWish& wish, bool announced);
  bool run(OpenedDevice opened, bool announced);
  void close_device();
  void give_tablet_to(DeviceRun& run);
  [[nodiscard]] base::Result<void> start(DeviceRun& run) const;
  [[nodiscard]] bool is_writing();
  [[nodiscard]] base::Result<void> start_pointer();
  void rest();
  void look();
  void lose(haptics::DeviceTrouble trouble, const std::string& message);
  void seek();
  void seek_later(std::chrono::milliseconds took = {});
  void set_deadline(Deadline& deadline, std::chrono::milliseconds from_now);
  [[nodiscard]] bool is_past(Deadline& deadline) const;

  const base::Clock& clock_;
  base::Inbox& inbox_;
  WakeAt wake_at_;
  Remembered remembered_;
  std::string chosen_ = "pointer";
  std::string sought_;     ///< id of the device that should be active and is searched for
  std::string reopening_;  ///< likewise, while it is opened again
  bool searching_ = false;
  std::optional<OpenedDevice> waiting_;  ///< found while a stroke was being written
  haptics::DeviceTrouble trouble_ = haptics::DeviceTrouble::none;
  std::shared_ptr<const haptics::HapticScene> scene_;
  int stalled_looks_ = 0;  ///< in a row
  Deadline look_at_;
  Deadline seek_at_;
  Deadline rest_at_;
  Deadline woken_at_;  ///< the time last passed to wake_at_
  bool resting_ = false;
  PointerState moved_;  ///< the newest of move()
  bool awake_ = false;
  double strength_ = 1;
  std::uint32_t buttons_ = 0;
  bool pressed_ = false;

  DeviceRun pointer_run_;
  PointerDevice pointer_;
  std::unique_ptr<DeviceRun> device_;
  DeviceRun* active_ = &pointer_run_;
  std::unique_ptr<DeviceSearch> search_;  // declared last, so that it is destroyed before the members it uses
};

}  // namespace nazori::devices
