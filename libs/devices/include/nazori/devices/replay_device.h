// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "nazori/devices/rt_thread.h"
#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// A recording in place of a hand: gives its samples in order, one per tick, whatever the force. Either
/// stepped (deterministic, as fast as the machine) or played in real time on a clock thread. After the last
/// sample the stylus is absent. Thread rules: as HapticDevice; step and rewind only while it is not started;
/// finished() by any thread.
class ReplayDevice final : public haptics::HapticDevice {
 public:
  /// @param samples      in order of time. Their own times are what the servo gets.
  /// @param description  of the device they were recorded from; start() plays them at its rate.
  ReplayDevice(std::vector<haptics::DeviceSample> samples, haptics::DeviceDescription description);
  ~ReplayDevice() override;

  [[nodiscard]] haptics::DeviceDescription describe() const override;
  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override;
  void stop() noexcept override;
  [[nodiscard]] ClockStatus clock() const;

  /// Gives the next sample. @return the servo's force; zero, and no tick, when finished.
  haptics::Vec3 step(haptics::ServoCallback& servo) noexcept;
  void rewind() noexcept;
  /// All samples have been given.
  [[nodiscard]] bool finished() const noexcept;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices
