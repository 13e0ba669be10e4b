// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/haptics/haptic_device.h"
#include "nazori/haptics/soft_tip.h"

namespace nazori::haptics {

/// A SoftTip as a tick needs it: within the limits of a device, with the energy at each depth. Thread-safe:
/// yes, immutable. Real-time-safe: all but the constructors.
class SoftTipTable {
 public:
  SoftTipTable() = default;  ///< no tip
  /// @param tip  without two finite values of its push there is no tip; other values are brought into range.
  /// @param most_n_m  largest change of the push per metre, and largest stiffness sideways.
  /// @param most_n    largest push.
  SoftTipTable(const SoftTip& tip, double most_n_m, double most_n);

  [[nodiscard]] bool exists() const noexcept { return !push_.empty(); }
  /// Push [N] at `depth_m`; 0 above the sheet.
  [[nodiscard]] double push_n(double depth_m) const noexcept;
  /// Energy [J] in the bent tip at `depth_m`: the integral of the push.
  [[nodiscard]] double stored_j(double depth_m) const noexcept;
  [[nodiscard]] double friction() const noexcept { return friction_; }
  [[nodiscard]] double along_hair() const noexcept { return along_hair_; }
  [[nodiscard]] double sideways_n_m() const noexcept { return sideways_; }
  [[nodiscard]] double tow_m() const noexcept { return tow_; }

 private:
  std::vector<double> push_, stored_;
  double step_ = 1, per_m_ = 1;
  double friction_ = 0, along_hair_ = 0, sideways_ = 1, tow_ = 1;
};

/// The contact of a tip that bends. The push comes from a table over the depth, so it gives back what it
/// took. Friction is a spring along the sheet that slips at the cone (a play operator with radial return), so
/// it only takes. Where the tip trails along the lie of its hair, the cone is narrower; it changes over a
/// millimetre of the way, so the force has no steps.
/// @source the play operator: A. Mielke, T. Roubicek, Rate-Independent Systems, 2015. Thread-safe: no.
/// Real-time-safe: yes, without loops.
class SoftContact {
 public:
  /// @param device_m  finite.
  void update(const SoftTipTable& tip, const Vec3& device_m) noexcept;
  /// The tip is lifted, and its path forgotten.
  void forget() noexcept;

  [[nodiscard]] bool touching() const noexcept { return touching_; }
  /// Push and friction [N].
  [[nodiscard]] const Vec3& force_n() const noexcept { return force_; }
  /// Energy in the tip and in the spring of friction [J].
  [[nodiscard]] double stored_j() const noexcept { return stored_; }

 private:
  Vec3 force_{0, 0, 0};
  double stored_ = 0;
  double x_ = 0, y_ = 0;            // device, while touching
  double pull_x_ = 0, pull_y_ = 0;  // stretch of the spring of friction
  double tow_x_ = 0, tow_y_ = 0;    // from the device to the end of the hair
  double cone_ = 1;                 // of the coefficient
  bool touching_ = false;
};

}  // namespace nazori::haptics
