// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/surface_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nazori::haptics {
namespace {

using Place = TabletSurface::Place;
using Patch = TabletSurface::Patch;

constexpr double kStill_m = 1e-7;  // a lateral pull below this counts as none
// Steps need not be shorter than what a stylus can resolve (its encoders: 0.055 mm on a Touch).
constexpr double kFinest_m = 5e-5;
constexpr int kMostSteps = 10;       // of the walk from the old proxy
constexpr int kMostStepsBeyond = 6;  // of the walk beyond a ridge
constexpr int kMostMarch = 32;
constexpr double kAnyDistance = std::numeric_limits<double>::infinity();

struct Walk {
  Place place;
  bool moved;
};

/// @tparam kKeeps  keeps the patch that was read last, which is often the same one.
template <bool kKeeps>
Place place_at(const TabletSurface& surface, Patch& patch, double x, double y) noexcept {
  if constexpr (!kKeeps) return surface.at(x, y);
  if (!patch.has(x, y)) patch = surface.patch_at(x, y);
  return patch.at(x, y);
}

/// Walks downhill in distance to `d`, at most `steps` steps. Stops where the pull along the surface is within
/// `friction` times the pull into it (0: at the minimum), and where the tangent plane of the surface is
/// farther than `hopeless2` (squared), because no nearer point is to be expected there.
template <bool kKeeps>
Walk walk_towards(const TabletSurface& surface, Patch& patch, Place at, const Vec3& d, double friction,
                  int steps = kMostSteps, double hopeless2 = kAnyDistance) noexcept {
  const double far = std::max(std::abs(d.x - at.x), std::abs(d.y - at.y));
  double reach = std::max({surface.cell_m() / 2, kFinest_m, far / 8});
  // Every step that comes nearer allows a longer next step, up to the size of a ridge.
  const double longest = std::max(reach, SurfaceContact::kRidge_m);
  bool moved = false;
  double ex = at.x - d.x, ey = at.y - d.y, ez = at.z - d.z;
  double squared = ex * ex + ey * ey + ez * ez;
  for (int i = 0; i < steps; ++i) {
    const double gx = ex + ez * at.zx;
    const double gy = ey + ez * at.zy;
    const double steep = 1 + at.zx * at.zx + at.zy * at.zy;
    // |pull along the surface|^2 = g' (I + s s')^-1 g with the slope s.
    const double sg = at.zx * gx + at.zy * gy;
    const double along2 = std::max(0.0, gx * gx + gy * gy - sg * sg / steep);
    const double into = std::abs(ez - at.zx * ex - at.zy * ey);  // x sqrt(steep)
    if (into * into > hopeless2 * steep) break;
    const double allowed = friction > 0 ? friction * into / std::sqrt(steep) : 0.0;
    // A thousandth outside the cone counts as inside: no hand can feel it, and it saves many small steps.
    const double bound = std::max(kStill_m, allowed * 1.001);
    if (along2 <= bound * bound) break;
    const double part = allowed > 0 ? 1 - allowed / std::sqrt(along2) : 1.0;
    // Newton's step where the distance is convex, else Gauss-Newton's, which always leads downhill. Both are
    // kept as (nx, ny) / divisor, so that the length is known without waiting for the division.
    const double hxx = 1 + at.zx * at.zx + ez * at.zxx;
    const double hxy = at.zx * at.zy + ez * at.zxy;
    const double hyy = 1 + at.zy * at.zy + ez * at.zyy;
    const double det = hxx * hyy - hxy * hxy;
    const bool newton = hxx > 0 && det > 1e-3 * steep;
    const double nx = newton ? hxy * gy - hyy * gx : sg * at.zx - steep * gx;
    const double ny = newton ? hxy * gx - hxx * gy : sg * at.zy - steep * gy;
    const double divisor = newton ? det : steep;
    const double square = nx * nx + ny * ny, most = reach * divisor;
    double scale = part / divisor;
    if (part * part * square > most * most)
      scale = reach / static_cast<double>(std::sqrt(static_cast<float>(square)));
    const Place trial = place_at<kKeeps>(surface, patch, at.x + scale * nx, at.y + scale * ny);
    const double tx = trial.x - d.x, ty = trial.y - d.y, tz = trial.z - d.z;
    const double trial2 = tx * tx + ty * ty + tz * tz;
    if (!(trial2 < squared)) {
      // Too far, or as near as the precision allows.
      reach = 0.25 * scale * std::sqrt(square);
      if (reach < 1e-10) break;
      continue;
    }
    at = trial;
    ex = tx;
    ey = ty;
    ez = tz;
    squared = trial2;
    reach = std::min(2 * reach, longest);
    moved = true;
  }
  return {at, moved};
}

/// Where the path from `from` (outside) to `to` (inside, so below the plateau) crosses the surface, searched
/// in at most kMostMarch steps of half a sample.
Place crossing(const TabletSurface& surface, const Vec3& from, const Vec3& to) noexcept {
  // There is no surface above the plateau.
  double t0 = from.z > 0 ? from.z / (from.z - to.z) : 0.0;
  const auto gap = [&](double t) {
    return from.z + t * (to.z - from.z) -
           surface.height(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y));
  };
  double g0 = gap(t0);
  if (g0 <= 0) return surface.at(from.x + t0 * (to.x - from.x), from.y + t0 * (to.y - from.y));
  const double across = (1 - t0) * std::hypot(to.x - from.x, to.y - from.y);
  const int steps = static_cast<int>(
      std::clamp(std::ceil(across / (surface.cell_m() / 2)), 1.0, static_cast<double>(kMostMarch)));
  const double step = (1 - t0) / steps;
  double t1 = 1, g1 = 0;
  for (int i = 1; i <= steps; ++i) {
    t1 = 1 - (steps - i) * step;
    g1 = gap(t1);
    if (g1 <= 0) break;
    t0 = t1;
    g0 = g1;
  }
  for (int i = 0; i < 3 && g0 - g1 > 0; ++i) {
    const double t = t0 + (t1 - t0) * std::clamp(g0 / (g0 - g1), 0.05, 0.95);
    const double g = gap(t);
    (g > 0 ? t0 : t1) = t;
    (g > 0 ? g0 : g1) = g;
  }
  const double t = g0 - g1 > 0 ? t0 + (t1 - t0) * g0 / (g0 - g1) : t1;
  return surface.at(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y));
}

double distance2(const Place& p, const Vec3& d) noexcept {
  return (p.x - d.x) * (p.x - d.x) + (p.y - d.y) * (p.y - d.y) + (p.z - d.z) * (p.z - d.z);
}

}  // namespace

void SurfaceContact::free_at(const Vec3& device_m) noexcept {
  proxy_ = device_m;
  known_ = true;
  touching_ = sliding_ = false;
}

void SurfaceContact::update(const TabletSurface& surface, const Vec3& device_m,
                            const Friction& friction) noexcept {
  // Reading a patch takes longer than reading a place. It pays unless the stylus leaves the patch at once.
  const bool stays =
      std::max(std::abs(device_m.x - device_.x), std::abs(device_m.y - device_.y)) < surface.cell_m();
  device_ = device_m;
  if (stays)
    update_with<true>(surface, device_m, friction);
  else
    update_with<false>(surface, device_m, friction);
}

template <bool kKeeps>
void SurfaceContact::update_with(const TabletSurface& surface, const Vec3& device_m,
                                 const Friction& friction) noexcept {
  if (!surface.exists() || device_m.z >= 0) {
    free_at(device_m);
    return;
  }
  const bool is_known = surface == surface_;
  if (!is_known) {
    surface_ = surface;
    under_device_ = at_proxy_ = {};
  }
  const Place above = place_at<kKeeps>(surface, under_device_, device_m.x, device_m.y);
  const double depth = above.z - device_m.z;
  if (depth <= 0) {
    free_at(device_m);
    return;
  }
  Place start = above;
  if (touching_) {
    start = is_known ? place_ : surface.at(proxy_.x, proxy_.y);
  } else if (known_) {
    start = crossing(surface, proxy_, device_m);
  }
  const double cone = sliding_ ? std::min(friction.slide, friction.hold) : friction.hold;
  Walk walk = walk_towards<kKeeps>(surface, at_proxy_, start, device_m, cone);
  if (walk.moved && friction.hold > friction.slide && !sliding_)  // it has started to slide
    walk = walk_towards<kKeeps>(surface, at_proxy_, walk.place, device_m, friction.slide);
  sliding_ = walk.moved;

  const double near = depth * depth / (1 + above.zx * above.zx + above.zy * above.zy);  // to first order
  const double here = distance2(walk.place, device_m) / (1 + cone * cone);
  const double limit = std::sqrt(near) + kRidge_m;
  if (here > limit * limit) {
    const double nearer = std::sqrt(here) - kRidge_m;
    const Walk other =
        walk_towards<kKeeps>(surface, at_proxy_, above, device_m, 0, kMostStepsBeyond, nearer * nearer);
    if (distance2(other.place, device_m) < nearer * nearer) {
      walk = other;
      sliding_ = true;
    }
  }
  place_ = walk.place;
  proxy_ = walk.place.point();
  normal_ = walk.place.normal();
  touching_ = true;
}

}  // namespace nazori::haptics
