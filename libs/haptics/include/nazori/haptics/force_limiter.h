// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "nazori/haptics/haptic_device.h"

namespace nazori::haptics {

/// The one gate that every force passes on its way to a device: finite, within the peak, within what the
/// motors bear for long, changing no faster than the slew limit, and rising over kRamp_s after every start,
/// error or change of what is felt.
///
/// Heat is followed as the mean square of the force over kThermal_s. Up to 80 % of what the continuous force
/// heats, the peak is allowed; from there the allowance falls in a straight line to the continuous force.
///
/// @source limits and ramp: the vendor's advice on kick and buzz in the OpenHaptics programmer's guide;
/// gate in one function: libfranka's control loop. Thread-safe: no. Real-time-safe: yes.
class ForceLimiter {
 public:
  static constexpr double kRamp_s = 0.3;
  static constexpr double kThermal_s = 20.0;

  explicit ForceLimiter(const DeviceLimits& limits) : limits_(limits) {}

  /// @param wanted_n   any value; not finite gives zero and starts the ramp again.
  /// @param period_s   since the last call, > 0.
  /// @return what the device may be given.
  [[nodiscard]] Vec3 limit(const Vec3& wanted_n, double period_s) noexcept;

  /// Zero at once, whatever the slew limit says, and the ramp starts again. For faults and lost devices.
  void drop() noexcept;
  /// The ramp starts again; the force falls no faster than the slew limit.
  void restart_ramp() noexcept { ramp_ = 0; }

  [[nodiscard]] const Vec3& last_n() const noexcept { return last_; }
  /// 0 just started .. 1 full force.
  [[nodiscard]] double ramp() const noexcept { return ramp_; }
  /// Heat as a fraction of what the continuous force leads to.
  [[nodiscard]] double heat() const noexcept;

 private:
  DeviceLimits limits_;
  Vec3 last_{0, 0, 0};
  double ramp_ = 0;
  double mean_square_ = 0;  // [N^2]
};

/// Energy that the device has been given by the hand less what it gave back, and the damping that keeps it
/// from giving back more: a time-domain passivity observer and controller.
///
/// What is commanded in one tick acts until the next, so the energy is known exactly one tick late:
/// W += -F[n-1] . (x[n] - x[n-1]), plus what the device's own damping ate. W is held to at most the energy
/// stored in the spring at that moment, so that energy lost to friction earlier is no licence to push later.
///
/// @source B. Hannaford, J.-H. Ryu, Time-domain passivity control of haptic interfaces, IEEE Trans. Robotics
/// and Automation 18(1), 2002. Thread-safe: no. Real-time-safe: yes.
class Passivity {
 public:
  /// Deepest debt that is remembered [J]; a teleport would otherwise be paid for during minutes.
  static constexpr double kMostDebt_j = 0.01;

  /// @param period_s  of the servo: the device's delay is booked in whole periods of it, at most kMostDelay.
  Passivity(const DeviceLimits& limits, double period_s);

  /// Books the last tick. @param moved_m  since the last tick.  @param commanded_n  force in between, before
  /// the device's delay.
  /// @param stored_j  energy in the springs now.
  void observe(const Vec3& moved_m, const Vec3& commanded_n, double period_s, double stored_j) noexcept;

  /// Energy that is meant to be given to the hand in this tick, by leading: no debt. Before observe().
  void grant(double energy_j) noexcept { energy_ += energy_j; }

  /// Damping force that pays the debt back, zero while there is none. Never more than most_damping * speed.
  [[nodiscard]] Vec3 correction(const Vec3& moved_m, double period_s) const noexcept;

  [[nodiscard]] double energy_j() const noexcept { return energy_; }
  void forget() noexcept;

 private:
  static constexpr std::size_t kMostDelay = 32;

  double own_damping_, most_damping_;
  double energy_ = 0;
  std::array<Vec3, kMostDelay + 1> commanded_{};  // ring: what was commanded in the last ticks
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
