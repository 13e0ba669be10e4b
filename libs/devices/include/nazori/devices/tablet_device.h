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

/// What happens to devices at the tablet.
enum class DeviceEventKind : std::uint8_t {
  taken,     ///< a device was opened and has the tablet
  resumed,   ///< a device that had paused has the tablet again
  paused,    ///< the device gives no force for now; the pointer has the tablet. Also when the cause changes.
  lost,      ///< as paused, but it is closed; the next best is being looked for, and it is retried
  refused,   ///< what was asked for could not be opened; what has the tablet now is reported by taken, or it
             ///< is the pointer
  searched,  ///< a search that choose(), reopen() or a loss began has ended
};

/// One event; the window makes a sentence of it.
struct DeviceEvent {
  DeviceEventKind kind = DeviceEventKind::searched;
  std::string device;  ///< its name for people; refused: the id that was asked for; searched: empty
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::none;  ///< paused, lost, refused
  std::string message;                                            ///< English, for the same
};

/// What the tablet is felt with: a device of the catalogue with its servo, or mouse and pen in its place.
///
/// The pointer is always there. While an opened device is paused or after it was lost, the pointer has the
/// tablet, with the same scene; when the device runs again it takes over from it, with a ramp. If a device
/// was lost, or was chosen and is not there, the next best takes its place; the device itself is retried from
/// time to time, and has the tablet again once it is there. Looking and opening happen on a thread of their
/// own. Thread: the owner of the inbox, for everything, signals too.
class TabletDevice {
 public:
  using BackEnds = DeviceSearch::BackEnds;
  /// What is remembered of each device, asked when one is opened or started.
  using Remembered = std::function<RememberedDevices()>;
  /// Has update() called at this time of the clock, or soon after; a later call takes the place of an earlier
  /// one.
  using WakeAt = std::function<void(base::Clock::Steady at)>;

  /// @param inbox, clock  outlive this object. @param wake_at  may be empty if update() is called anyway.
  TabletDevice(base::Inbox& inbox, const base::Clock& clock, WakeAt wake_at);
  ~TabletDevice();
  TabletDevice(const TabletDevice&) = delete;
  TabletDevice& operator=(const TabletDevice&) = delete;

  /// Just before another servo has the tablet: last chance to take its samples.
  base::Signal<> leaving;
  /// Another servo has the tablet.
  base::Signal<> changed;
  base::Signal<const DeviceEvent&> happened;
  /// The answer to find().
  base::Signal<const std::vector<BackEndFindings>&> found;
  /// Samples that were just taken, in order.
  base::Signal<std::span<const haptics::ServoSample>> sampled;
  /// Button `number` of a device (not of the mouse), from 0, went down. Emitted while samples are taken: what
  /// opens or closes a device must wait until that is over.
  base::Signal<int> button_pressed;

  /// Starts the pointer.
  [[nodiscard]] base::Result<void> start();
  /// Does what is due: looks after the device, retries what is missing, lets a pointer that does not move
  /// rest.
  void update();
  /// The pointer is there. @param event_s  when it happened, on the clock of the window system; nothing: now.
  void move(const PointerState& state, std::optional<double> event_s = {});
  /// Keeps the servo of the pointer ticking while nothing moves, too: for a recording without gaps.
  void set_awake(bool awake);
  /// The pointer has the tablet and nothing has moved for a second, so its servo stands still. The next move
  /// starts it again.
  [[nodiscard]] bool is_resting() const { return is_pointer() && resting_; }
  void set_scene(std::shared_ptr<const haptics::HapticScene> scene);

  // Of what has the tablet now.
  [[nodiscard]] const haptics::ServoSample& latest() { return servo().latest(); }
  /// Reads samples in order, and emits sampled and button_pressed. @return how many were written to `out`.
  std::size_t take_samples(std::span<haptics::ServoSample> out);
  [[nodiscard]] haptics::ServoTiming timing() const { return active_->servo->timing(); }
  [[nodiscard]] haptics::DeviceDescription describe() const { return active_->description; }
  [[nodiscard]] haptics::Servo& servo() { return *active_->servo; }
  [[nodiscard]] bool is_pointer() const { return active_ == &pointer_run_; }
  /// Of the device that is open, paused or not; else of the pointer.
  [[nodiscard]] haptics::DeviceStatus status() const;

  /// Which devices there can be. @param shape  of the tablets. Nothing is opened yet.
  void set_devices(BackEnds back_ends, const geometry::TabletShape& shape, Remembered remembered);
  /// Asks every back end what is there; `found` answers, some seconds later at worst. The device that is open
  /// is listed too.
  void find();
  /// Closes what is open and opens `id`, or if that fails the next best; empty: the best there is;
  /// "pointer": none. What came of it is reported by `happened`, DeviceEventKind::searched last.
  void choose(const std::string& id);
  /// Whether a device is being looked for or opened now.
  [[nodiscard]] bool is_searching() const { return searching_; }
  /// What choose() was last asked for.
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  /// The device that is open, paused or not; nullptr: none. Its id, fit and reach.
  [[nodiscard]] const OpenedDevice* opened() const { return device_ ? &device_->opened : nullptr; }
  /// The open device's own description, paused or not: before the learner's limits.
  [[nodiscard]] haptics::DeviceDescription own_description() const;
  /// What is remembered of the open device has changed: it is closed, and opened with that.
  void reopen();
  /// The device that is being opened again; empty: none.
  [[nodiscard]] const std::string& reopening() const { return reopening_; }
  /// Its limits have changed: it is started again, with a ramp.
  void take_limits();
  /// Share of its limits that the device is given, 0.05..1: less than 1 while something new is tried. It
  /// is started again, with a ramp.
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
  std::string sought_;     ///< id of the device that should have the tablet and is looked for
  std::string reopening_;  ///< likewise, while it is opened again
  bool searching_ = false;
  std::optional<OpenedDevice> waiting_;  ///< found while a stroke is being written
  haptics::DeviceTrouble trouble_ = haptics::DeviceTrouble::none;
  std::shared_ptr<const haptics::HapticScene> scene_;
  int stalled_looks_ = 0;  ///< in a row
  Deadline look_at_;
  Deadline seek_at_;
  Deadline rest_at_;
  Deadline woken_at_;  ///< what wake_at_ was last asked for
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
  std::unique_ptr<DeviceSearch> search_;  // declared last, so that it ends before what it opened for goes
};

}  // namespace nazori::devices
