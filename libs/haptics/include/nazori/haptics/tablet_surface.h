// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "nazori/geometry/frames.h"
#include "nazori/haptics/haptic_device.h"
#include "nazori/surface/smooth_surface.h"

namespace nazori::haptics {

/// The carved surface as the height field z = H(x, y) in metres, tablet frame. It has no outer edge: the
/// plateau (and a groove that runs into the edge) continues level without end. Does not own `surface`, which
/// must outlive it. Real-time-safe: yes.
class TabletSurface {
 public:
  /// Height, slope and curvature, in metres.
  struct Place {
    double x = 0, y = 0;               ///< [m]
    double z = 0;                      ///< H [m], <= 0
    double zx = 0, zy = 0;             ///< slope
    double zxx = 0, zxy = 0, zyy = 0;  ///< bend [1/m]

    [[nodiscard]] Vec3 point() const { return {x, y, z}; }
    /// Unit vector out of the material.
    [[nodiscard]] Vec3 normal() const {
      const double s = 1 / std::sqrt(1 + zx * zx + zy * zy);
      return {-zx * s, -zy * s, s};
    }
  };

  /// A part of the surface that is one polynomial, so that points near each other are found without reading
  /// samples again. Its points are those of at() but for the last bits.
  class Patch {
   public:
    Patch() = default;
    [[nodiscard]] bool has(double x, double y) const {
      return std::abs(x - x_) <= reach_ && std::abs(y - y_) <= reach_;
    }
    [[nodiscard]] Place at(double x, double y) const {
      const double u = x - x_, v = y - y_, u2 = 2 * u, v2 = 2 * v;
      const double a = of_[0][0] + v * (of_[0][1] + v * of_[0][2]), av = of_[0][1] + v2 * of_[0][2];
      const double b = of_[1][0] + v * (of_[1][1] + v * of_[1][2]), bv = of_[1][1] + v2 * of_[1][2];
      const double c = of_[2][0] + v * (of_[2][1] + v * of_[2][2]), cv = of_[2][1] + v2 * of_[2][2];
      return {x,
              y,
              a + u * (b + u * c),
              b + u2 * c,
              av + u * (bv + u * cv),
              2 * c,
              bv + u2 * cv,
              2 * (of_[0][2] + u * (of_[1][2] + u * of_[2][2]))};
    }

   private:
    friend class TabletSurface;
    double x_ = 0, y_ = 0;  // its middle
    double reach_ = -1;     // to each side; below 0: has() nothing
    double of_[3][3] = {};
  };

  TabletSurface() = default;
  TabletSurface(const surface::SmoothSurface& surface, const geometry::TabletShape& shape)
      : surface_(&surface),
        serial_(surface.serial()),
        half_m_(shape.width_m / 2),
        per_m_((surface.size() - 1) / shape.width_m),
        depth_m_(shape.depth_m),
        cell_m_(shape.width_m / (surface.size() - 1)) {}

  [[nodiscard]] bool exists() const { return surface_ != nullptr; }
  /// Distance between two samples [m].
  [[nodiscard]] double cell_m() const { return cell_m_; }

  /// Whether it is the same surface in the same size.
  friend bool operator==(const TabletSurface& a, const TabletSurface& b) {
    return a.serial_ == b.serial_ && a.half_m_ == b.half_m_ && a.depth_m_ == b.depth_m_;
  }

  /// H(x, y) [m].
  [[nodiscard]] double height(double x, double y) const {
    return (surface_->at((x + half_m_) * per_m_, (half_m_ - y) * per_m_).height - 1) * depth_m_;
  }
  [[nodiscard]] Place at(double x, double y) const {
    const surface::CurvedPoint p = surface_->curved_at((x + half_m_) * per_m_, (half_m_ - y) * per_m_);
    const double slope = per_m_ * depth_m_;
    const double bend = per_m_ * slope;
    return {x,
            y,
            (p.height - 1) * depth_m_,
            p.d_column * slope,
            -p.d_row * slope,
            p.d_column_column * bend,
            -p.d_column_row * bend,
            p.d_row_row * bend};
  }
  /// The patch in which a point lies. Beyond the edge of the map it holds only for that point.
  [[nodiscard]] Patch patch_at(double x, double y) const {
    const surface::SurfacePatch p = surface_->patch_at((x + half_m_) * per_m_, (half_m_ - y) * per_m_);
    Patch patch;
    patch.x_ = p.column * cell_m_ - half_m_;
    patch.y_ = half_m_ - p.row * cell_m_;
    if (!p.is_outside) patch.reach_ = cell_m_ / 2;
    double along = depth_m_;
    for (int a = 0; a < 3; ++a, along *= per_m_) {
      double scale = along;
      for (int b = 0; b < 3; ++b, scale *= -per_m_) patch.of_[a][b] = scale * p.of[a][b];
    }
    patch.of_[0][0] = (p.of[0][0] - 1) * depth_m_;
    return patch;
  }

 private:
  const surface::SmoothSurface* surface_ = nullptr;
  std::uint64_t serial_ = 0;  // serial number of the surface; 0 none
  double half_m_ = 0, per_m_ = 0, depth_m_ = 0, cell_m_ = 1;
};

}  // namespace nazori::haptics
