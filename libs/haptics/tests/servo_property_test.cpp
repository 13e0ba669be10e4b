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

constexpr int kUnguided = 4, kAllKinds = 7;

std::vector<std::shared_ptr<const HapticScene>> scenes(const std::vector<Relief>& reliefs, int kinds) {
  std::vector<std::shared_ptr<const HapticScene>> made;
  for (const Relief& r : reliefs)
    for (int kind = 0; kind < kinds; ++kind) {
      auto scene = r.scene();
      if (kind == 1) scene->material = {1, 0.3, 0.4, 0.3, 0};
      if (kind == 3) {
        scene->material.texture = Texture::stone;
        scene->material.roughness = 1;
      }
      if (kind == 4) scene->guiding.mode = GuidingMode::lesson;
      if (kind == 5) scene->guiding.mode = GuidingMode::lead;
      if (kind == 6) scene->guiding.mode = GuidingMode::disturb;
      if (kind == 2 || kind >= kUnguided) {
        scene->snapping = {kind == 2, 0.2, 0.004, 0};
        StrokePath ring;
        for (int i = 0; i <= 60; ++i)
          ring.points.emplace_back(0.03 * std::cos(0.1 * i), 0.03 * std::sin(0.1 * i), -0.01);
        scene->strokes = {ring, {{{-0.04, 0, -0.01}, {0.04, 0, -0.01}}}};
      }
      made.push_back(scene);
    }
  return made;
}

/// A Touch, a strong device at 4 kHz, and one with a tick of delay.
std::vector<DeviceDescription> devices() {
  DeviceDescription touch, strong, delayed;
  strong.rate_hz = 4000;
  strong.limits = {12, 12, 5000, 30, 0.1, 2000, 0, 2};
  delayed.limits = {2, 2, 1000, 5, 0.05, 400, 0.001, 2};
  return {touch, strong, delayed};
}

/// The proxy is on the surface or above it, never below; without contact it is the device.
bool is_out(const ServoSample& s, const HapticScene& scene) {
  const TabletSurface surface(*scene.surface, scene.shape);
  return s.proxy_m.z >= surface.height(s.proxy_m.x, s.proxy_m.y) - 1e-12;
}

void hostile(const DeviceDescription& device, unsigned seed, long ticks) {
  const std::vector<Relief> reliefs{carved(128, 0), carved(200, 0.004)};
  const auto all = scenes(reliefs, kAllKinds);
  const double period = 1 / device.rate_hz;
  Servo servo(device);
  servo.set_scene(all[0]);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(0, 1), wide(-0.08, 0.08), high(-0.04, 0.02);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  DeviceSample sample;
  std::size_t current = 0;
  Vec3 before(0);
  Vec3 velocity(0);
  for (long i = 0; i < ticks; ++i) {
    const double what = any(random);
    if (what < 0.0005) {
      current = static_cast<std::size_t>(any(random) * static_cast<double>(all.size()));
      servo.set_scene(all[current]);
    }
    sample.time_s += what < 0.001 ? 0.1 * any(random) : period * (0.7 + 0.6 * any(random));
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
    sample.position_m += period * velocity;
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
      ASSERT_LE(glm::length(force - before), device.limits.max_slew_n_s * period * (1 + 1e-9)) << i;
    }
    before = force;
    ASSERT_TRUE(is_out(s, *all[current])) << i;
  }
}

TEST(ServoProperty, HostileInputNeverGetsTooMuchForceNorThroughTheSurface) {
  unsigned seed = 42;
  for (const DeviceDescription& device : devices()) {
    SCOPED_TRACE(device.rate_hz);
    ASSERT_NO_FATAL_FAILURE(hostile(device, seed++, property_ticks() / 3));
  }
}

// A hand of mass, spring and damper that wanders over the tablet and presses; what it receives from the
// tablet over any period is at most what it put in before, except for the ticks that the controller has not
// yet seen: the present one, and those within the delay.
TEST(ServoProperty, AHandGetsNoNetEnergyOut) {
  const std::vector<Relief> reliefs{carved(128, 0)};
  const auto all = scenes(reliefs, kUnguided);
  for (const DeviceDescription& device : devices())
    for (const auto& scene : all) {
      SCOPED_TRACE(device.rate_hz);
      const double period = 1 / device.rate_hz, part = period / 5;
      Servo servo(device);
      servo.set_scene(scene);
      std::mt19937_64 random(7);
      std::normal_distribution<double> noise(0, 1);
      Vec3 at{0, 0, 0.004}, velocity(0), target{0, 0, 0.004}, force(0), next(0);
      double received_j = 0;  // energy that the hand received from the tablet
      double worst = 0, most_in_a_tick = 0;
      const long ticks = property_ticks() / (3 * kUnguided);
      const int hold = static_cast<int>(0.4 * device.rate_hz);
      for (long i = 0; i < ticks; ++i) {
        if (i % hold == 0)
          target = {0.02 * noise(random), 0.02 * noise(random),
                    std::min(0.005, 0.003 * noise(random) - 0.004)};
        const Vec3 was = at;
        for (int k = 0; k < 5; ++k) {  // 0.05 kg, 100 N/m, 2 N s/m with the device's own
          velocity += part / 0.05 * (force + 100.0 * (target - at) - 2.0 * velocity);
          at += part * velocity;
        }
        const Vec3 moved = at - was;
        const double work = glm::dot(force, moved);
        received_j += work - device.limits.own_damping_n_s_m * glm::dot(moved, moved) / period;
        worst = std::max(worst, received_j);
        most_in_a_tick = std::max(most_in_a_tick, std::abs(work));
        const Vec3 answer = servo.tick({period * static_cast<double>(i + 1), at, 0, true});
        force = device.limits.delay_s > 0 ? next : answer;
        next = answer;
        ASSERT_TRUE(is_out(servo.latest(), *scene)) << i;
      }
      EXPECT_LT(worst, (1 + device.limits.delay_s / period) * most_in_a_tick);
      EXPECT_LT(received_j, 0);
    }
}

}  // namespace
}  // namespace nazori::haptics
