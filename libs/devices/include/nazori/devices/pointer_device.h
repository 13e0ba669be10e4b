// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nazori/devices/rt_thread.h"
#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// The state of a mouse, pen or finger on the tablet.
struct PointerState {
  double x_m = 0;  ///< tablet frame
  double y_m = 0;
  double depth_m = 0;    ///< how far the tip is pushed below the plateau, >= 0; only while pressed
  bool pressed = false;  ///< button or pen contact
  bool in_range = true;  ///< whether it is over the tablet
};

/// Mouse, pen tablet or touch screen as a stylus without force: pressing moves the tip below the plateau,
/// letting go lifts it `kHover_m` above. The tip moves there over a few milliseconds, as a hand would. Runs
/// its own 1 kHz servo thread.
class PointerDevice final : public haptics::HapticDevice {
 public:
  static constexpr double kHover_m = 0.005;

  PointerDevice();
  ~PointerDevice() override;

  [[nodiscard]] haptics::DeviceDescription describe() const override;
  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override;
  void stop() noexcept override;

  /// Sets the newest pointer state, used from the next tick on. Thread: interface. Wait-free.
  void move(const PointerState& state) noexcept;
  /// The same with the time of its event, on any steady clock. States that arrive together (from a fast pen,
  /// or because the window was busy) are played one after the other at their original pace, so that no part
  /// of a fast stroke is lost. Late states are played up to kFastest times as fast until they have caught up.
  /// A clock that jumps back restarts the playback. Thread: interface. Wait-free.
  void move(const PointerState& state, double event_s) noexcept;
  static constexpr double kFastest = 4;

  /// The timing of the servo thread. Thread: interface.
  [[nodiscard]] ClockStatus clock() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices
