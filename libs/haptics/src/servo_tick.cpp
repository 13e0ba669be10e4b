// SPDX-License-Identifier: Apache-2.0
// The servo thread's side of Servo.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "servo_inside.h"
#include "texture.h"

namespace nazori::haptics {
namespace {

constexpr double kTooLate_s = 0.005;
constexpr double kVelocityFilter_s = 0.002;
// Farther than this no hand can be; below it sums of squares are exact enough.
constexpr double kFarthest_m = 100.0;

bool usable(const DeviceSample& s) noexcept {
  return std::isfinite(s.time_s) && std::abs(s.position_m.x) < kFarthest_m &&
         std::abs(s.position_m.y) < kFarthest_m && std::abs(s.position_m.z) < kFarthest_m;
}

template <class T>
void add(std::atomic<T>& to, T value) noexcept {  // one writer: no read-modify-write needed
  to.store(to.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);
}
void raise(std::atomic<double>& to, double value) noexcept {
  if (value > to.load(std::memory_order_relaxed)) to.store(value, std::memory_order_relaxed);
}
void mark(std::uint16_t& events, ServoEvent event) noexcept {
  events = static_cast<std::uint16_t>(events | static_cast<std::uint16_t>(event));
}

}  // namespace

Vec3 Servo::tick(const DeviceSample& sample) noexcept {
  using Clock = std::chrono::steady_clock;  // read from the vDSO: no system call
  Inside& in = *inside_;
  const auto begin = Clock::now();
  in.sample.begun_s = std::chrono::duration<double>(begin.time_since_epoch()).count();
  const Vec3 force = in.step(sample);
  in.newest.back() = in.sample;
  in.newest.publish();
  if (!in.samples.push(in.sample)) add<std::uint64_t>(in.watch.dropped_samples, 1);
  in.record();
  ++in.sample.tick;
  const double spent = std::chrono::duration<double>(Clock::now() - begin).count();
  add<std::uint64_t>(in.watch.ticks, 1);
  add(in.watch.inside_s, spent);
  raise(in.watch.max_tick_s, spent);
  return force;
}

std::uint16_t Servo::events() const noexcept { return inside_->sample.events; }

void Servo::Inside::record() noexcept {
  SampleRing* ring = recording.load(std::memory_order_relaxed);
  if (ring == nullptr) return;
  // Sequentially consistent with set_recording: either that sees that this ring is in use, or this sees that
  // it was removed.
  pushing.store(ring);
  if (recording.load() == ring) ring->push(sample);
  pushing.store(nullptr, std::memory_order_release);
}

/// Puts the proxy at the device, or onto the surface if the device is inside the material.
void Servo::Inside::place_proxy(const Vec3& device_m) noexcept {
  contact.forget();
  soft.forget();
  if (scene != nullptr)
    contact.update(scene->surface, device_m, Friction{});
  else
    contact.free_at(device_m);
  sample.proxy_m = contact.proxy_m();
  contact.forget();
}

void Servo::Inside::adopt_scene() noexcept {
  const ServoScene* next = offered.load(std::memory_order_acquire);
  if (next == scene) return;
  // Compared without reading the HapticScene, which is not in the cache.
  const bool same_surface = scene != nullptr && scene->surface == next->surface;
  const bool same_material = scene != nullptr && scene->stiffness_n_m == next->stiffness_n_m &&
                             scene->damping_n_s_m == next->damping_n_s_m;
  const bool same_tip = scene == nullptr || scene->soft_tip == next->soft_tip;
  if (!same_tip) soft.forget();
  if (!same_surface || !same_tip || (!same_material && contact.touching())) limiter.restart_ramp();
  if (!same_surface) pushed_through = false;
  snap.let_go();
  if (scene == nullptr || scene->lesson != next->lesson)
    guidance.begin(next->plan, next->first_stroke, next->disturbance);
  scene = next;
  used.store(next->generation, std::memory_order_release);
}

/// Invalid input: no force, and the newest valid pose is kept for display.
void Servo::Inside::fault(const DeviceSample& from) noexcept {
  mark(sample.events, ServoEvent::fault);
  if (usable(from)) {
    sample.device_m = from.position_m;
    last_time_s = from.time_s;
  } else {
    started = false;
  }
  lose_hold(false);
}

void Servo::Inside::absent(const DeviceSample& from) noexcept {
  sample.device_m = from.position_m;
  lose_hold(true);
}

void Servo::Inside::lose_hold(bool lifted) noexcept {
  place_proxy(sample.device_m);
  snap.forget();
  if (scene != nullptr) {
    guidance.lose(scene->plan, scene->guide, lifted);
    report_guidance();
  }
  limiter.drop();
  passivity.forget();
  velocity = Vec3(0);
  pushed_through = false;
}

void Servo::Inside::report_guidance() noexcept {
  sample.events = static_cast<std::uint16_t>(sample.events | guidance.events());
  sample.done_stroke = guidance.done_stroke();
  sample.guided_stroke = guidance.stroke();
  sample.progress_m = guidance.progress_m();
  sample.off_m = guidance.off_m();
}

/// The pull of strokes and guidance.
Vec3 Servo::Inside::hold(const Vec3& device_m, double period) noexcept {
  const Vec3 before = snap.force_n();
  snap.update(scene->strokes, scene->snap, device_m, period);
  if (snap.stroke() != 0) {
    sample.proxy_m = snap.point_m();
    if (scene->surface.exists())
      sample.proxy_m.z =
          std::max(sample.proxy_m.z, scene->surface.height(sample.proxy_m.x, sample.proxy_m.y));
    const Vec3 lag = snap.point_m() - device_m;
    stored_j += 0.5 * scene->snap.stiffness_n_m * glm::dot(lag, lag);
  }
  // Both may change at once; together they must not make a step either.
  const double snap_change_n = glm::length(snap.force_n() - before);
  const double left = std::max(0.1 * Guidance::kMostStep_n, Guidance::kMostStep_n - snap_change_n);
  guidance.update(scene->plan, scene->guide, {device_m, velocity, touching(), period, left});
  report_guidance();
  sample.guide_m = guidance.guide_m();
  passivity.grant(guidance.granted_j());
  Vec3 pull = snap.force_n();
  // The surface supports the tip. A shallow stroke that runs over a deeper groove must not lift it off.
  if ((scene->surface.exists() || scene->soft.exists()) && pull.z > 0) pull.z = 0;
  return pull + guidance.force_n();
}

Vec3 Servo::Inside::contact_force(const Vec3& device_m) noexcept {
  const Vec3& normal = contact.normal();
  const Vec3 lag = contact.proxy_m() - device_m;
  Vec3 force = scene->stiffness_n_m * lag;
  if (scene->damping_n_s_m > 0) {
    // Damps the motion that stretches the spring: into the material, and with friction also sideways.
    const Vec3 into = glm::dot(velocity, normal) * normal;
    force -= scene->damping_n_s_m * (contact.held() ? velocity : into);
    const double push = glm::dot(force, normal);
    if (push < 0) force -= push * normal;  // a surface does not pull
  }
  return textured(force, normal, contact.touched_m(scene->tip_radius_m), scene->texture, scene->roughness);
}

Vec3 Servo::Inside::step(const DeviceSample& from) noexcept {
  const bool was_touching = sample.touching;
  const std::int32_t was_held = sample.stroke;
  sample.events = 0;
  sample.buttons = from.buttons;
  sample.force_n = Vec3(0);
  sample.done_stroke = 0;
  adopt_scene();

  double period = period_s;
  bool fine = usable(from);
  if (fine && started) {
    const double elapsed = from.time_s - last_time_s;
    const double late = elapsed - period_s;
    if (elapsed <= 0) {
      fine =
          elapsed > -kTooLate_s;  // a repeated time is due to the clock's resolution; going back is a fault
    } else {
      period = std::clamp(elapsed, 0.5 * period_s, 2 * period_s);
    }
    raise(watch.max_lateness_s, late);
    if (late > 0.5 * period_s) {
      add<std::uint64_t>(watch.late_ticks, 1);
      // A tick that is late by less than a period is late but not missed; a hundredth allows for the clock's
      // resolution.
      const double periods = std::floor(late / period_s + 0.01);
      if (periods < 1e9) add(watch.missed_ticks, static_cast<std::uint64_t>(periods));
    }
    if (late > kTooLate_s) fine = false;
  }
  if (std::isfinite(from.time_s)) sample.time_s = from.time_s;

  if (!fine) {
    fault(from);
  } else if (!from.present) {
    absent(from);
    last_time_s = from.time_s;
    started = true;
  } else {
    const Vec3 device_m = from.position_m;
    const Vec3 moved = started ? device_m - sample.device_m : Vec3(0);
    if (!started) limiter.drop();
    const double pass = period / (period + kVelocityFilter_s);
    velocity += (moved / period - velocity) * pass;
    sample.device_m = device_m;
    last_time_s = from.time_s;
    started = true;

    Vec3 wanted(0);
    sample.proxy_m = device_m;
    if (scene == nullptr) {
      contact.free_at(device_m);
    } else {
      contact.update(scene->surface, device_m, scene->friction_at(contact.touched_m(scene->tip_radius_m)));
      if (pushed_through) {
        if (contact.touching())
          contact.free_at(device_m);
        else
          pushed_through = false;
      }
      stored_j = 0;
      if (contact.touching()) {
        wanted = contact_force(device_m);
        if (scene->popthrough_n > 0 && glm::dot(wanted, wanted) > scene->popthrough_n * scene->popthrough_n) {
          pushed_through = true;
          contact.free_at(device_m);
          wanted = Vec3(0);
        }
        const Vec3 lag = contact.proxy_m() - device_m;
        stored_j = 0.5 * scene->stiffness_n_m * glm::dot(lag, lag);
      }
      sample.proxy_m = contact.proxy_m();
      if (scene->soft.exists()) {
        soft.update(scene->soft, device_m);
        wanted = textured(soft.force_n(), Vec3(0, 0, 1), device_m, scene->texture, scene->roughness);
        stored_j = soft.stored_j();
        sample.proxy_m.z = std::max(0.0, device_m.z);
      }
      wanted += hold(device_m, period);

      passivity.observe(moved, limiter.last_n(), period, stored_j);
      const Vec3 brake = passivity.correction(moved, period);
      const double strength = glm::dot(wanted, wanted);
      if (strength > 0) {
        // Braking may remove a force but not reverse it: a surface must not feel sticky.
        const double opposed = glm::dot(brake, wanted);
        if (opposed < 0) wanted *= std::max(0.0, 1 + opposed / strength);
      }
    }
    sample.force_n = limiter.limit(wanted, period_s);
  }

  sample.touching = touching();
  const bool guided = scene != nullptr && scene->guide.mode != GuidingMode::off;
  sample.stroke = !guided ? snap.stroke() : guidance.writing() ? guidance.stroke() : 0;
  if (!fine || !from.present || !guided) sample.guide_m = sample.device_m;
  if (sample.touching != was_touching)
    mark(sample.events, sample.touching ? ServoEvent::touch : ServoEvent::untouch);
  if (was_held != 0 && sample.stroke != was_held) mark(sample.events, ServoEvent::release);
  if (sample.stroke != 0 && sample.stroke != was_held) mark(sample.events, ServoEvent::capture);
  return sample.force_n;
}

}  // namespace nazori::haptics
