// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "nazori/haptics/haptic_device.h"

namespace nazori::haptics {

/// The last stage of every force on its way to a device: the force is finite, within the peak, within what
/// the motors can give continuously, changes no faster than the slew limit, and rises over kRamp_s after
/// every start, error or change of the scene.
///
/// Heat is modelled as the mean square of the force over kThermal_s. Up to 80 % of the heat of the continuous
/// force, the peak is allowed; from there the limit falls linearly to the continuous force.
///
/// @source limits and ramp: the vendor's advice on kick and buzz in the OpenHaptics programmer's guide; one
/// function for all limits: libfranka's control loop. Thread-safe: no. Real-time-safe: yes.
class ForceLimiter {
 public:
  static constexpr double kRamp_s = 0.3;
  static constexpr double kThermal_s = 20.0;

  explicit ForceLimiter(const DeviceLimits& limits) : limits_(limits) {}

  /// @param wanted_n   any value; not finite gives zero and starts the ramp again.
  /// @param period_s   since the last call, > 0.
  /// @return the force to send to the device.
  [[nodiscard]] Vec3 limit(const Vec3& wanted_n, double period_s) noexcept;

  /// Sets the force to zero at once, regardless of the slew limit, and restarts the ramp. For faults and lost
  /// devices.
  void drop() noexcept;
  /// Restarts the ramp; the force falls no faster than the slew limit.
  void restart_ramp() noexcept { ramp_ = 0; }

  [[nodiscard]] const Vec3& last_n() const noexcept { return last_; }
  /// 0 just started .. 1 full force.
  [[nodiscard]] double ramp() const noexcept { return ramp_; }
  /// Heat as a fraction of the heat of the continuous force.
  [[nodiscard]] double heat() const noexcept;

 private:
  DeviceLimits limits_;
  Vec3 last_{0, 0, 0};
  double ramp_ = 0;
  double mean_square_ = 0;  // [N^2]
};

/// Energy that the device received from the hand, minus what it gave back, and the damping that keeps it from
/// giving back more: a time-domain passivity observer and controller.
///
/// The force of one tick acts until the next, so the energy is known exactly one tick late: W += -F[n-1] .
/// (x[n] - x[n-1]), plus what the device's own damping dissipated. W is limited to the energy stored in the
/// springs at that moment, so that energy lost to friction earlier does not allow pushing later.
///
/// @source B. Hannaford, J.-H. Ryu, Time-domain passivity control of haptic interfaces, IEEE Trans. Robotics
/// and Automation 18(1), 2002. Thread-safe: no. Real-time-safe: yes.
class Passivity {
 public:
  /// Largest debt that is recorded [J]; otherwise paying off a jump of the position would take minutes.
  static constexpr double kMostDebt_j = 0.01;

  /// @param period_s  of the servo: the device's delay counts in whole periods of it, at most kMostDelay.
  Passivity(const DeviceLimits& limits, double period_s);

  /// Adds the energy of the last tick. @param moved_m  since the last tick.  @param commanded_n  force in
  /// between, before the device's delay.
  /// @param stored_j  energy in the springs now.
  void observe(const Vec3& moved_m, const Vec3& commanded_n, double period_s, double stored_j) noexcept;

  /// Energy that leading intentionally gives to the hand in this tick; it does not count as debt. Call before
  /// observe().
  void grant(double energy_j) noexcept { energy_ += energy_j; }

  /// Damping force that pays off the debt; zero without debt. Never more than most_damping * speed.
  [[nodiscard]] Vec3 correction(const Vec3& moved_m, double period_s) const noexcept;

  [[nodiscard]] double energy_j() const noexcept { return energy_; }
  void forget() noexcept;

 private:
  static constexpr std::size_t kMostDelay = 32;

  double own_damping_, most_damping_;
  double energy_ = 0;
  std::array<Vec3, kMostDelay + 1> commanded_{};  // ring: the forces commanded in the last ticks
  std::size_t delay_, newest_ = 0;
};

/// Largest stiffness that a sampled wall may have and still be passive:
/// b > K T / 2 + |B|, and with a delay b > K (T / 2 + delay) + |B|.
/// @param damping_n_s_m        b: of the device and of the hand that holds it.
/// @param wall_damping_n_s_m   B: rendered.
/// @return [N/m], >= 0.
/// @source J. Colgate, G. Schenkel, Passivity of a class of sampled-data systems, J. Robotic Systems 14(1),
/// 1997; with delay T. Hulin, C. Preusche, G. Hirzinger, IROS 2006.
[[nodiscard]] double passive_stiffness_n_m(double damping_n_s_m, double wall_damping_n_s_m, double period_s,
                                           double delay_s) noexcept;

}  // namespace nazori::haptics
