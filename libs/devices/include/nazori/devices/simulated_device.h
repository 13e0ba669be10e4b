// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nazori/devices/rt_thread.h"
#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// The mechanics and electronics of a force-feedback device, as measured at its tip. The slew limit of the
/// presets corresponds to a hand at 0.4 m/s on the largest stiffness: a lower limit would lag behind the wall
/// and generate energy.
struct SimulatedHardware {
  std::string name = "Simulated device";
  double rate_hz = 1000;
  haptics::DeviceLimits limits;  ///< own_damping_n_s_m is its viscous damping, delay_s its delay
  double mass_kg = 0.05;         ///< apparent at the tip
  double coulomb_n = 0;          ///< dry friction of its joints
  double encoder_m = 0;          ///< step of its position reading; 0 reads exactly

  /// 3D Systems Touch, SensAble PHANTOM Omni. @source data sheet; stiffness: programmer's guide.
  [[nodiscard]] static SimulatedHardware touch();
  /// 3D Systems Touch X, SensAble PHANTOM Desktop. @source data sheet; force and stiffness: CHAI3D's table.
  [[nodiscard]] static SimulatedHardware touch_x();
  /// Novint Falcon. @source CHAI3D's table for force, stiffness, damping; the rest estimated.
  [[nodiscard]] static SimulatedHardware falcon();
  /// Force Dimension omega.3, at 4 kHz. @source CHAI3D's table for force, stiffness, damping; the rest from
  /// its data sheet and estimated.
  [[nodiscard]] static SimulatedHardware omega_3();
  /// Haply Inverse3 through its service: force limited to 2 N, one tick of delay. @source vendor's
  /// documentation; mass and friction estimated.
  [[nodiscard]] static SimulatedHardware inverse3();
  /// All of the above.
  [[nodiscard]] static std::vector<SimulatedHardware> presets();
};

/// The grip of a hand: a spring and damper from the tip to the target of the hand, and a tremor.
struct HandGrip {
  double stiffness_n_m = 100;  ///< 0: no hand holds it
  double damping_n_s_m = 2;    ///< against motion relative to the target
  double tremor_m = 0;         ///< amplitude of the physiological tremor; 5e-5 is a calm hand
  double tremor_hz = 9;
};

/// A force-feedback device in software, with a hand that follows a target: mass, damping, dry friction,
/// encoder steps, saturation and delay. Either stepped tick by tick (deterministic, as fast as the machine)
/// or run in real time on a clock thread.
///
/// Within a tick the force is constant, and the motion is integrated in kSubsteps trapezoidal steps. Thread
/// rules: start, stop, set_target, clock by one thread (the interface); step, place and the state only while
/// it is not started.
class SimulatedDevice final : public haptics::HapticDevice {
 public:
  static constexpr int kSubsteps = 20;

  explicit SimulatedDevice(SimulatedHardware hardware = SimulatedHardware::touch(), HandGrip grip = {});
  ~SimulatedDevice() override;

  [[nodiscard]] haptics::DeviceDescription describe() const override;
  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override;
  void stop() noexcept override;
  [[nodiscard]] ClockStatus clock() const;

  /// Sets the target of the hand from the next tick on; the hand moves there in a straight line during the
  /// tick. Wait-free.
  void set_target(const haptics::Vec3& target_m) noexcept;
  /// Puts tip and hand at rest there, without force; the clock restarts at 0.
  void place(const haptics::Vec3& tip_m) noexcept;
  /// One tick: reads the encoders, asks the servo, moves for one period. @return the force that acted.
  haptics::Vec3 step(haptics::ServoCallback& servo) noexcept;

  [[nodiscard]] double time_s() const noexcept;
  [[nodiscard]] const haptics::Vec3& tip_m() const noexcept;  ///< true position, not the encoders' reading
  [[nodiscard]] const haptics::Vec3& velocity_m_s() const noexcept;
  /// Work that the device's force has done on the tip since place(): negative while the tablet absorbs
  /// energy.
  [[nodiscard]] double work_j() const noexcept;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::devices
