// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/haptics/tablet_surface.h"

namespace nazori::haptics {

/// Coulomb friction at the proxy.
struct Friction {
  double hold = 0;   ///< static coefficient: the proxy stays while the pull is within this cone
  double slide = 0;  ///< dynamic coefficient, at most `hold`
};

/// The contact between the tip and a height field, by a god-object (proxy).
///
/// While the device is outside the material the proxy is the device. While it is inside, the proxy is the
/// point of the surface at a local minimum of distance to the device. It is found by walking downhill in
/// distance from the previous proxy (Newton steps of at most half a sample, kRidge_m or an eighth of the
/// distance), so it follows walls of any steepness. A tick makes at most ten steps, so a long walk takes
/// several ticks. With friction the walk stops as soon as the pull lies within the friction cone: lateral
/// pull <= coefficient x depth. On first contact it starts where the device's path crossed the surface.
///
/// A proxy behind a ridge crosses it once the surface above the device is nearer by kRidge_m. So it never
/// stays behind, and a wall gives way only where the hand is already nearer the other side. The caller makes
/// the input finite; whatever it is, the proxy is never below the surface.
///
/// @source C. Zilles, J. Salisbury, A constraint-based god-object method, IROS 1995 (proxy, force); S.
/// Walker, J. Salisbury, Large haptic topographic maps, I3D 2003 (walking downhill in distance); N. Melder,
/// W. Harwin, Extending the friction cone algorithm, 2004 (friction); Newton steps and the ridge rule: own
/// design, see docs/haptics.md. Thread-safe: no. Real-time-safe: yes, bounded: at most 64 evaluations of the
/// surface.
class SurfaceContact {
 public:
  /// How much nearer another part of the surface must be before the proxy crosses a ridge [m].
  static constexpr double kRidge_m = 0.0002;

  /// Moves the proxy for the device at `device_m`. @param device_m  finite.
  void update(const TabletSurface& surface, const Vec3& device_m, const Friction& friction) noexcept;

  /// Forgets the path of the device: the next update puts the proxy on the point of the surface nearest to
  /// the device.
  void forget() noexcept { known_ = touching_ = sliding_ = false; }

  /// There is no surface: the proxy is the device.
  void free_at(const Vec3& device_m) noexcept;

  [[nodiscard]] const Vec3& proxy_m() const noexcept { return proxy_; }
  [[nodiscard]] bool touching() const noexcept { return touching_; }
  /// Unit vector out of the material at the proxy; meaningful while touching.
  [[nodiscard]] const Vec3& normal() const noexcept { return normal_; }
  /// Where a ball touches the material whose lowest point is the proxy, on a surface that is made for the
  /// ball. In a groove that holds it by both walls: between the two contacts. Without contact, or with radius
  /// 0: the proxy.
  [[nodiscard]] Vec3 touched_m(double radius_m) const noexcept {
    if (!touching_ || !(radius_m > 0)) return proxy_;
    return {proxy_.x - radius_m * normal_.x, proxy_.y - radius_m * normal_.y,
            proxy_.z + radius_m * (1 - normal_.z)};
  }
  /// Whether friction keeps the proxy in place.
  [[nodiscard]] bool held() const noexcept { return touching_ && !sliding_; }

 private:
  template <bool kKeeps>
  void update_with(const TabletSurface& surface, const Vec3& device_m, const Friction& friction) noexcept;

  Vec3 proxy_{0, 0, 0};
  Vec3 device_{0, 0, 0};  // at the last update
  Vec3 normal_{0, 0, 1};
  TabletSurface surface_;  // that all that follows was read from
  TabletSurface::Patch under_device_, at_proxy_;
  TabletSurface::Place place_;  // of the proxy, while touching
  bool known_ = false;          // while it does not touch: proxy_ is its previous position
  bool touching_ = false;
  bool sliding_ = false;
};

}  // namespace nazori::haptics
