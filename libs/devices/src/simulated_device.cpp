// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "nazori/haptics/latest_value.h"

namespace nazori::devices {

using haptics::Vec3;

namespace {

constexpr Vec3 kRest{0, 0, 0.02};

double to_step(double value, double step) { return step > 0 ? std::round(value / step) * step : value; }

}  // namespace

struct SimulatedDevice::Inside {
  Inside(SimulatedHardware h, HandGrip held) : hardware(std::move(h)), grip(held) {
    const double delay = std::max(0.0, hardware.limits.delay_s) * hardware.rate_hz;
    underway.assign(static_cast<std::size_t>(std::lround(delay)) + 1, Vec3(0));
  }

  Vec3 step(double time, haptics::ServoCallback& servo) noexcept;
  void move(const Vec3& force, const Vec3& from, const Vec3& to) noexcept;

  const SimulatedHardware hardware;
  const HandGrip grip;
  haptics::LatestValue<Vec3> wanted{kRest};
  Vec3 tip = kRest, velocity{0, 0, 0}, target = kRest;
  std::vector<Vec3> underway;  // delayed forces on their way to the motors
  std::size_t oldest = 0;
  std::uint64_t ticks = 0;
  double work = 0;
  RtThread clock;  // declared last, so that it stops before the other members are destroyed
};

Vec3 SimulatedDevice::Inside::step(double time, haptics::ServoCallback& servo) noexcept {
  haptics::DeviceSample sample;
  sample.time_s = time;
  const double grain = hardware.encoder_m;
  sample.position_m = {to_step(tip.x, grain), to_step(tip.y, grain), to_step(tip.z, grain)};
  underway[oldest] = servo.tick(sample);
  oldest = (oldest + 1) % underway.size();
  Vec3 force = underway[oldest];
  const double size = glm::length(force);
  if (!(size <= hardware.limits.max_force_n))  // the motors saturate
    force = std::isfinite(size) ? force * (hardware.limits.max_force_n / size) : Vec3(0);

  const double t = static_cast<double>(++ticks) / hardware.rate_hz;
  const double turn = 2 * std::numbers::pi * grip.tremor_hz * t;
  const Vec3 tremor =
      grip.tremor_m * Vec3(std::sin(turn), std::sin(1.13 * turn + 1), std::sin(0.91 * turn + 2));
  const Vec3 to = wanted.latest() + tremor;
  move(force, target, to);
  target = to;
  return force;
}

void SimulatedDevice::Inside::move(const Vec3& force, const Vec3& from, const Vec3& to) noexcept {
  const double dt = 1 / (hardware.rate_hz * kSubsteps);
  const Vec3 pace = (to - from) * hardware.rate_hz;
  const double damping = hardware.limits.own_damping_n_s_m + grip.damping_n_s_m;
  const double lag = damping * dt / (2 * hardware.mass_kg);
  for (int i = 0; i < kSubsteps; ++i) {
    const Vec3 at = from + (to - from) * ((i + 0.5) / kSubsteps);
    const Vec3 pull = grip.stiffness_n_m * (at - tip - 0.5 * dt * velocity) + grip.damping_n_s_m * pace;
    Vec3 next = (velocity * (1 - lag) + (force + pull) * (dt / hardware.mass_kg)) / (1 + lag);
    const double speed = glm::length(next);
    const double dry = hardware.coulomb_n * dt / hardware.mass_kg;
    next *= speed > dry ? 1 - dry / speed : 0.0;
    const Vec3 moved = 0.5 * dt * (velocity + next);
    work += glm::dot(force, moved);
    tip += moved;
    velocity = next;
  }
}

SimulatedDevice::SimulatedDevice(SimulatedHardware hardware, HandGrip grip)
    : inside_(std::make_unique<Inside>(std::move(hardware), grip)) {}
SimulatedDevice::~SimulatedDevice() { stop(); }

haptics::DeviceDescription SimulatedDevice::describe() const {
  return {inside_->hardware.name, inside_->hardware.rate_hz, true, inside_->hardware.limits};
}

base::Result<void> SimulatedDevice::start(haptics::ServoCallback& servo) {
  Inside& in = *inside_;
  return in.clock.start(1 / in.hardware.rate_hz,
                        [&in, &servo](double now_s) { (void)in.step(now_s, servo); });
}

void SimulatedDevice::stop() noexcept {
  inside_->clock.stop();
  std::fill(inside_->underway.begin(), inside_->underway.end(), Vec3(0));
}

ClockStatus SimulatedDevice::clock() const { return inside_->clock.status(); }

void SimulatedDevice::set_target(const Vec3& target_m) noexcept {
  inside_->wanted.back() = target_m;
  inside_->wanted.publish();
}

void SimulatedDevice::place(const Vec3& tip_m) noexcept {
  Inside& in = *inside_;
  set_target(tip_m);
  in.tip = in.target = tip_m;
  in.velocity = Vec3(0);
  std::fill(in.underway.begin(), in.underway.end(), Vec3(0));
  in.ticks = 0;
  in.work = 0;
}

Vec3 SimulatedDevice::step(haptics::ServoCallback& servo) noexcept { return inside_->step(time_s(), servo); }

double SimulatedDevice::time_s() const noexcept {
  return static_cast<double>(inside_->ticks) / inside_->hardware.rate_hz;
}
const Vec3& SimulatedDevice::tip_m() const noexcept { return inside_->tip; }
const Vec3& SimulatedDevice::velocity_m_s() const noexcept { return inside_->velocity; }
double SimulatedDevice::work_j() const noexcept { return inside_->work; }

}  // namespace nazori::devices
