// SPDX-License-Identifier: Apache-2.0
#include "fidelity.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "../tests/relief.h"
#include "nazori/haptics/servo.h"
#include "nazori/haptics/surface_contact.h"
#include "workload.h"

namespace nazori::haptics::fidelity {
namespace {

using test::plate;
using test::Relief;

constexpr int kTries = 1000;
constexpr std::size_t kTicks = 200'000;
constexpr double kPeriod_s = 0.001;
constexpr double kMetresPerUnit = 0.05;

/// A servo and its clock.
class Stylus {
 public:
  explicit Stylus(const std::shared_ptr<const HapticScene>& scene) { servo.set_scene(scene); }
  Vec3 at(const Vec3& p) { return servo.tick({time_s_ += kPeriod_s, p, 0, true}); }
  Servo servo{DeviceDescription{}};

 private:
  double time_s_ = 0;
};

}  // namespace

FirstTick first_tick() {
  const Relief flat(128, 0.01, plate);
  const double stiffness = flat.scene()->material.stiffness * DeviceLimits{}.max_stiffness_n_m;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> speed(0.01, 0.3), where(-0.04, 0.04), phase(0, 1);
  FirstTick found;
  for (; found.dives < kTries; ++found.dives) {
    Stylus stylus(flat.scene());
    const double x = where(random), y = where(random), step = speed(random) * kPeriod_s;
    double z = (350 + phase(random)) * step;
    Vec3 force(0);
    while (z >= 0) force = stylus.at({x, y, z -= step});
    const double share = force.z / (stiffness * -z);
    found.pushed += share > 0.999 ? 1 : 0;
    found.least = std::min(found.least, share);
  }
  return found;
}

double sideways_lag_m() {
  const Relief flat(128, 0.01, plate);
  SurfaceContact contact;
  double worst = 0;
  for (const Vec3& p : workload::to_metres(workload::scribble(workload::make_kanji(128), kTicks))) {
    const Vec3 device{p.x, p.y, -0.001};
    contact.update(flat.tablet, device, {});
    worst = std::max(worst, std::hypot(contact.proxy_m().x - device.x, contact.proxy_m().y - device.y));
  }
  return worst;
}

Behind behind_a_ridge(int size, int path) {
  const workload::Kanji kanji = workload::make_kanji(size);
  const auto smooth = *surface::SmoothSurface::create(workload::height_map(kanji));
  const TabletSurface tablet(*smooth, workload::shape());
  const auto units = path == 0   ? workload::trace(kanji, kTicks)
                     : path == 1 ? workload::sweep(kanji, kTicks)
                                 : workload::scribble(kanji, kTicks);
  SurfaceContact contact;
  Behind found;
  for (const Vec3& device : workload::to_metres(units)) {
    contact.update(tablet, device, {});
    const Vec3& proxy = contact.proxy_m();
    const double far = glm::length(proxy - device);
    ++found.ticks;
    found.behind += far > 0.05 * kMetresPerUnit ? 1 : 0;
    found.below += proxy.z < tablet.height(proxy.x, proxy.y) - 1e-15 ? 1 : 0;
    found.late += (tablet.height(device.x, device.y) > device.z) != contact.touching() ? 1 : 0;
    found.farthest_m = std::max(found.farthest_m, far);
  }
  return found;
}

Lift rising_surface() {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> any(0, 1);
  Lift found;
  for (; found.styluses < kTries; ++found.styluses) {
    const double before = -0.0095 + 0.0004 * any(random);
    const double after = before + 5e-5 + (-before - 5e-5) * any(random);
    const double tilt = 0.05 * (any(random) - 0.5);
    const Relief low(16, 0.01, [&](double x, double) { return before + tilt * 0.01 * x; });
    const Relief high(16, 0.01, [&](double x, double) { return after + tilt * 0.01 * x; });
    Stylus stylus(low.scene());
    const Vec3 rest{0.03 * (any(random) - 0.5), 0.03 * (any(random) - 0.5), before - 0.0005 * any(random)};
    for (int i = 0; i < 320; ++i) (void)stylus.at({rest.x, rest.y, rest.z + 1e-6 * std::max(0, 300 - i)});
    Vec3 force = stylus.servo.latest().force_n;
    stylus.servo.set_scene(high.scene());
    bool out = true;
    for (int i = 0; i < 400; ++i) {
      const Vec3 now = stylus.at(rest);
      found.worst_step_n = std::max(found.worst_step_n, glm::length(now - force));
      force = now;
      const ServoSample& s = stylus.servo.latest();
      out = out && s.touching && std::abs(s.proxy_m.z - high.tablet.height(s.proxy_m.x, s.proxy_m.y)) < 1e-12;
    }
    const DeviceLimits limits;
    const double wanted =
        std::min(0.8 * limits.max_stiffness_n_m * (after - rest.z), limits.continuous_force_n);
    found.lifted += out && force.z > 0.95 * wanted ? 1 : 0;
  }
  return found;
}

double ripple_m(int size) {
  const double radius = 0.02;
  const Relief ring(size, 0.01, [&](double x, double y) {
    const double d = std::abs(std::hypot(x, y) - radius);
    return d > 0.004 ? 0.0 : -0.005 * (1 + std::cos(d / 0.004 * std::numbers::pi));
  });
  SurfaceContact contact;
  double ripple = 0;
  for (int i = 0; i < 10'500; ++i) {  // once round
    const double at = 12e-6 * i / radius;
    contact.update(ring.tablet, {radius * std::cos(at), radius * std::sin(at), -0.011}, {});
    ripple = std::max(ripple, std::abs(std::hypot(contact.proxy_m().x, contact.proxy_m().y) - radius));
  }
  return ripple;
}

}  // namespace nazori::haptics::fidelity
