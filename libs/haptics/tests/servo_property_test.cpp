// SPDX-License-Identifier: Apache-2.0
// Random, hostile and human-like input against what a servo must never do. NAZORI_PROPERTY_TICKS sets how
// many ticks of each kind are run; the suite runs 300,000, the full run is 10,000,000.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <string>

#include "nazori/haptics/servo.h"
#include "relief.h"

namespace nazori::haptics {
namespace {

using test::Relief;

long property_ticks() {
  const char* set = std::getenv("NAZORI_PROPERTY_TICKS");  // NOLINT(concurrency-mt-unsafe): one thread
  return set != nullptr ? std::stol(set) : 300'000;
}

Relief carved(int size, double offset) {
  return Relief(size, 0.01, [offset](double x, double y) {
    const auto groove = [](double d) {
      return d > 0.006 ? 0.0 : -0.005 * (1 + std::cos(d / 0.006 * 3.14159265));
    };
    return std::min({groove(std::abs(x - 0.3 * y - offset)), groove(std::abs(y + offset)),
                     groove(std::abs(std::hypot(x, y) - 0.03))});
  });
}

std::vector<std::shared_ptr<const HapticScene>> scenes(const std::vector<Relief>& reliefs) {
  std::vector<std::shared_ptr<const HapticScene>> made;
  for (const Relief& r : reliefs)
    for (int kind = 0; kind < 6; ++kind) {
      auto scene = r.scene();
      if (kind == 1) scene->material = {1, 0.3, 0.4, 0.3, 0};
      if (kind == 5) scene->material.texture = Texture::stone;
      if (kind >= 3) {
        constexpr GuidingMode kModes[] = {GuidingMode::lesson, GuidingMode::lead, GuidingMode::disturb};
        scene->guiding.mode = kModes[kind - 3];
      }
      if (kind >= 2) {
        scene->snapping = {true, 0.2, 0.004, 0};
        StrokePath ring;
        for (int i = 0; i <= 60; ++i)
          ring.points.emplace_back(0.03 * std::cos(0.1 * i), 0.03 * std::sin(0.1 * i), -0.01);
        scene->strokes = {ring, {{{-0.04, 0, -0.01}, {0.04, 0, -0.01}}}};
      }
      made.push_back(scene);
    }
  return made;
}

TEST(ServoProperty, HostileInputNeverGetsTooMuchForceNorThroughTheSurface) {
  const std::vector<Relief> reliefs{carved(128, 0), carved(200, 0.004)};
  const auto all = scenes(reliefs);
  const DeviceDescription device;
  Servo servo(device);
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> any(0, 1), wide(-0.08, 0.08), high(-0.04, 0.02);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  DeviceSample sample;
  std::size_t current = 0;
  Vec3 before(0);
  Vec3 velocity(0);
  for (long i = 0; i < property_ticks(); ++i) {
    const double what = any(random);
    if (what < 0.0005) {
      current = static_cast<std::size_t>(any(random) * static_cast<double>(all.size()));
      servo.set_scene(all[current]);
    }
    sample.time_s += 0.001 * (what < 0.001 ? 100 * any(random) : 0.7 + 0.6 * any(random));
    if (what > 0.999) sample.time_s -= any(random);
    if (what < 0.01) {
      sample.position_m = {wide(random), wide(random), high(random)};
      velocity = Vec3(0);
    } else if (what < 0.02) {
      velocity = 50.0 * Vec3(any(random) - 0.5, any(random) - 0.5, any(random) - 0.5);
    } else {
      velocity *= 0.98;
      velocity += 0.02 * Vec3(any(random) - 0.5, any(random) - 0.5, any(random) - 0.5);
    }
    sample.position_m += 0.001 * velocity;
    if (glm::length(sample.position_m) > 0.15) sample.position_m = {0, 0, -0.002};
    sample.present = what < 0.02 || any(random) > 0.0005;
    DeviceSample given = sample;
    if (what > 0.998) given.position_m = {what > 0.9985 ? nan : 0.0, what > 0.9992 ? -inf : 0.0, 1e300};
    const Vec3 force = servo.tick(given);
    const ServoSample& s = servo.latest();

    ASSERT_TRUE(std::isfinite(force.x) && std::isfinite(force.y) && std::isfinite(force.z)) << i;
    ASSERT_LE(glm::length(force), device.limits.max_force_n * (1 + 1e-12)) << i;
    const bool dropped = (s.events & static_cast<unsigned>(ServoEvent::fault)) != 0 || !given.present;
    if (dropped) {
      ASSERT_EQ(force, Vec3(0)) << i;
    } else {
      ASSERT_LE(glm::length(force - before), device.limits.max_slew_n_s * 0.001 * (1 + 1e-9)) << i;
    }
    before = force;
    if (i > 0 && all[current] != nullptr && servo.timing().ticks > 0) {
      const TabletSurface surface(*all[current]->surface, all[current]->shape);
      if (s.touching) {
        ASSERT_GE(s.proxy_m.z, surface.height(s.proxy_m.x, s.proxy_m.y) - 1e-12) << i;
      }
    }
  }
}

// A hand of mass, spring and damper that wanders over the tablet and presses; what it gets out of the tablet
// over any stretch of time is at most what it put in before, but for the tick that is always ahead of the
// controller.
TEST(ServoProperty, AHandGetsNoNetEnergyOut) {
  const std::vector<Relief> reliefs{carved(128, 0)};
  for (const auto& scene : scenes(reliefs)) {
    if (scene->guiding.mode != GuidingMode::off && scene->guiding.mode != GuidingMode::lesson)
      continue;  // they mean to give energy; how much is tested with guidance
    DeviceDescription device;
    Servo servo(device);
    servo.set_scene(scene);
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0, 1);
    Vec3 at{0, 0, 0.004}, velocity(0), target{0, 0, 0.004}, force(0);
    double taken = 0;  // by the hand from the tablet
    double worst = 0;
    const long ticks = property_ticks() / 3;
    for (long i = 0; i < ticks; ++i) {
      if (i % 400 == 0)
        target = {0.02 * noise(random), 0.02 * noise(random), std::min(0.005, 0.003 * noise(random) - 0.004)};
      const Vec3 was = at;
      for (int k = 0; k < 5; ++k) {  // 0.05 kg, 100 N/m, 2 N s/m, in steps of 0.2 ms
        velocity += 2e-4 / 0.05 * (force + 100.0 * (target - at) - 2.0 * velocity);
        at += 2e-4 * velocity;
      }
      taken += glm::dot(force, at - was);
      force = servo.tick({0.001 * static_cast<double>(i + 1), at, 0, true});
      worst = std::max(worst, taken);
    }
    // A lesson carries the hand to where a stroke begins, which is allowed 0.6 of the cap x the way.
    EXPECT_LT(worst, scene->guiding.mode == GuidingMode::lesson ? 0.48 * 0.1 : 2e-4);
    EXPECT_LT(taken, 0);
  }
}

}  // namespace
}  // namespace nazori::haptics
