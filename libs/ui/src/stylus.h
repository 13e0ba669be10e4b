// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "device_search.h"
#include "device_settings.h"
#include "nazori/base/result.h"
#include "nazori/devices/pointer_device.h"
#include "nazori/haptics/servo.h"

namespace nazori::ui {

/// What the tablet is felt with: a device of the catalogue with its servo, or mouse and pen in its place.
///
/// The pointer is always there. While an opened device is paused or after it was lost, the pointer has the
/// tablet, with the same scene; when the device runs again it takes over from it, with a ramp. In the place
/// of a device that was lost, or was chosen and is not there, comes the next best; it is looked for from time
/// to time, and has the tablet again once it is there. Looking and opening never hold up the window. Thread:
/// interface.
class Stylus final : public QObject {
  Q_OBJECT
 public:
  using BackEnds = DeviceSearch::BackEnds;
  /// What is remembered of each device, by id.
  using Remembered = std::function<DeviceSearch::Remembered()>;

  explicit Stylus(QObject* parent = nullptr);
  ~Stylus() override;

  /// Starts the pointer.
  [[nodiscard]] base::Result<void> start();
  /// @param event_s  when it happened, on the clock of the window system; nothing: now.
  void move(const devices::PointerState& state, std::optional<double> event_s = {});
  /// Keeps the servo of the pointer ticking while nothing moves, too: for a recording without gaps.
  void set_awake(bool awake);
  /// The pointer has the tablet and nothing has moved for a second, so its servo stands still. The next move
  /// starts it again.
  [[nodiscard]] bool is_resting() const { return is_pointer() && resting_; }
  void set_scene(std::shared_ptr<const haptics::HapticScene> scene);

  // Of what has the tablet now.
  [[nodiscard]] const haptics::ServoSample& latest() { return servo().latest(); }
  std::size_t take_samples(std::span<haptics::ServoSample> out);
  [[nodiscard]] haptics::ServoTiming timing() const { return active_->servo->timing(); }
  [[nodiscard]] haptics::DeviceDescription describe() const { return active_->description; }
  [[nodiscard]] haptics::DeviceStatus status() const;
  [[nodiscard]] haptics::Servo& servo() { return *active_->servo; }
  [[nodiscard]] bool is_pointer() const { return active_ == &pointer_seat_; }

  /// Which devices there can be. @param shape  of the tablets. Nothing is opened yet.
  void set_devices(BackEnds back_ends, const geometry::TabletShape& shape, Remembered remembered);
  /// Asks every back end what is there; found() answers, some seconds later at worst. The device that is open
  /// is listed too.
  void find();
  /// Closes what is open and opens `id`, or where that fails the next best; empty: the best there is;
  /// "pointer": none. What came of it is told by the signals, searched() last.
  void choose(const std::string& id);
  /// Whether a device is being looked for or opened now.
  [[nodiscard]] bool is_searching() const { return searching_; }
  /// What choose() was last asked for.
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  /// The device that is open, paused or not; nullptr: none. Its id, fit and reach.
  [[nodiscard]] const devices::OpenedDevice* opened() const { return device_ ? &device_->opened : nullptr; }
  /// The open device's own description, paused or not; what it says of itself before the learner's limits.
  [[nodiscard]] haptics::DeviceDescription own_description() const;
  /// What is remembered of the open device has changed: it is opened anew with it.
  void reopen();
  /// The device that is being opened anew; empty: none.
  [[nodiscard]] const std::string& reopening() const { return reopening_; }
  /// Its limits have changed: it starts anew, with a ramp.
  void take_limits();
  /// Share of its limits that the device is given, 0.05..1: less than 1 while something new is tried. It
  /// starts anew, with a ramp.
  void set_strength(double strength);
  [[nodiscard]] double strength() const { return strength_; }

 signals:
  /// Just before another servo has the tablet: last chance to take its samples.
  void leaving();
  /// Another servo has the tablet.
  void changed();
  /// A device has the tablet: it was opened, or it goes on after a pause.
  void device_taken(QString name, bool again);
  /// The device gives no force for now; mouse and pen have the tablet. Told again when the cause changes.
  void device_paused(QString name, nazori::haptics::DeviceTrouble trouble, QString message);
  /// As device_paused, but it is closed; the next best is looked for, and it itself again.
  void device_lost(QString name, nazori::haptics::DeviceTrouble trouble, QString message);
  /// What was asked for could not be opened; what has the tablet now is said by device_taken, or it is mouse
  /// and pen.
  void device_refused(QString id, nazori::haptics::DeviceTrouble trouble, QString message);
  /// A search that choose(), reopen() or a loss began has come to its end.
  void searched();
  /// What find() asked for.
  void found(const std::vector<nazori::devices::BackEndFindings>& findings);
  /// Samples that were just taken, in order.
  void sampled(std::span<const nazori::haptics::ServoSample> samples);
  /// Button `number` of a device (not of the mouse), from 0, went down.
  void button_pressed(int number);

 private:
  struct Seat {
    devices::OpenedDevice opened;  ///< the pointer's has no device
    haptics::DeviceDescription description;
    std::unique_ptr<haptics::Servo> servo;
  };

  void ask(DeviceWish wish, bool told);
  void take(DeviceFind found, const DeviceWish& wish, bool told);
  bool seat(devices::OpenedDevice opened, bool told);
  void close_device();
  void give_tablet_to(Seat& seat);
  [[nodiscard]] base::Result<void> start(Seat& seat) const;
  [[nodiscard]] DeviceSettings remembered(const std::string& id) const;
  [[nodiscard]] bool is_writing();
  void rest();
  [[nodiscard]] base::Result<void> start_pointer();
  void look();
  void lose(haptics::DeviceTrouble trouble, const QString& message);
  void seek();
  void seek_later(qint64 took_ms = 0);

  Remembered remembered_;
  std::string chosen_ = "pointer";
  std::string sought_;     ///< id of the device that should have the tablet and is looked for
  std::string reopening_;  ///< likewise, while it is opened anew
  bool searching_ = false;
  std::optional<devices::OpenedDevice> waiting_;  ///< found while somebody writes
  haptics::DeviceTrouble trouble_ = haptics::DeviceTrouble::none;
  std::shared_ptr<const haptics::HapticScene> scene_;
  int stalled_looks_ = 0;  ///< in a row
  QTimer look_timer_;
  QTimer seek_timer_;
  QTimer rest_timer_;
  bool resting_ = false;
  devices::PointerState moved_;  ///< the newest of move()
  bool awake_ = false;
  double strength_ = 1;
  std::uint32_t buttons_ = 0;
  bool pressed_ = false;

  Seat pointer_seat_;
  devices::PointerDevice pointer_;
  std::unique_ptr<Seat> device_;
  Seat* active_ = &pointer_seat_;
  std::unique_ptr<DeviceSearch> search_;  // last: it ends before what it opened for goes
};

}  // namespace nazori::ui
