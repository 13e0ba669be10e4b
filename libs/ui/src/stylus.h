// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "device_settings.h"
#include "nazori/base/result.h"
#include "nazori/devices/device_catalogue.h"
#include "nazori/devices/pointer_device.h"
#include "nazori/haptics/servo.h"

namespace nazori::ui {

/// What the tablet is felt with: a device of the catalogue with its servo, or mouse and pen in its place.
///
/// The pointer is always there. While an opened device is paused or after it was lost, the pointer has the
/// tablet, with the same scene; when the device runs again it takes over from it, with a ramp. A device that
/// was lost, or was not there, is looked for again from time to time.
/// Thread: interface.
class Stylus final : public QObject {
  Q_OBJECT
 public:
  using BackEnds = std::vector<std::unique_ptr<devices::BackEnd>>;
  /// What is remembered of the device with this id.
  using Remembered = std::function<DeviceSettings(const std::string& id)>;

  explicit Stylus(QObject* parent = nullptr);
  ~Stylus() override;

  /// Starts the pointer.
  [[nodiscard]] base::Result<void> start();
  /// @param event_s  when it happened, on the clock of the window system; nothing: now.
  void move(const devices::PointerState& state, std::optional<double> event_s = {}) {
    if (event_s)
      pointer_.move(state, *event_s);
    else
      pointer_.move(state);
  }
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
  /// Every back end's findings; may take some seconds. The device that is open is listed too.
  [[nodiscard]] std::vector<devices::BackEndFindings> find();
  /// Closes what is open and opens `id`, or where that fails the next best; empty: the best there is;
  /// "pointer": none. What came of it is told by the signals.
  void choose(const std::string& id);
  /// What choose() was last asked for.
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  /// The device that is open, paused or not; nullptr: none. Its id, fit and reach.
  [[nodiscard]] const devices::OpenedDevice* opened() const { return device_ ? &device_->opened : nullptr; }
  /// The open device's own description, paused or not; what it says of itself before the learner's limits.
  [[nodiscard]] haptics::DeviceDescription own_description() const;
  /// What is remembered of the open device has changed: it is opened anew with it.
  void reopen();
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
  /// As device_paused, but it is closed, and looked for again.
  void device_lost(QString name, nazori::haptics::DeviceTrouble trouble, QString message);
  /// What was asked for could not be opened; what has the tablet now is said by device_taken, or it is mouse
  /// and pen.
  void device_refused(QString id, nazori::haptics::DeviceTrouble trouble, QString message);
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

  bool open(const std::string& id, bool told);
  bool open_best(const std::string& but_not);
  void close_device();
  void give_tablet_to(Seat& seat);
  [[nodiscard]] base::Result<void> start(Seat& seat) const;
  void look();
  void lose(haptics::DeviceTrouble trouble, const QString& message);
  void seek();
  void seek_later();
  [[nodiscard]] devices::OpenRequest request_for(const std::string& id) const;

  std::unique_ptr<devices::DeviceCatalogue> catalogue_;
  geometry::TabletShape shape_;
  Remembered remembered_;
  std::string chosen_ = "pointer";
  std::string lost_;  ///< id of the device that is looked for again
  haptics::DeviceTrouble trouble_ = haptics::DeviceTrouble::none;
  std::shared_ptr<const haptics::HapticScene> scene_;
  QTimer look_timer_;
  QTimer seek_timer_;
  double strength_ = 1;
  std::uint32_t buttons_ = 0;
  bool pressed_ = false;

  Seat pointer_seat_;
  devices::PointerDevice pointer_;
  std::unique_ptr<Seat> device_;
  Seat* active_ = &pointer_seat_;
};

}  // namespace nazori::ui
