// SPDX-License-Identifier: Apache-2.0
// What the interface thread does with a servo; the tick is in servo_tick.cpp.
#include "nazori/haptics/servo.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "nazori/surface/ball_surface.h"
#include "servo_inside.h"

namespace nazori::haptics {
namespace {

double fraction(double value) { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0; }

// Friction coefficients over 10 would fix the stylus as firmly as a hole.
double coefficient(double value) { return std::isfinite(value) ? std::clamp(value, 0.0, 10.0) : 0.0; }

double positive(double value, double otherwise) {
  return std::isfinite(value) && value > 0 ? value : otherwise;
}

double period_of(const DeviceDescription& device) { return 1 / positive(device.rate_hz, 1000); }

double within(double value, double low, double high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

constexpr double kPullOff_n = 5.0;  // the 2005 program's
// Guidance is as soft as snapping is by default, and never as stiff as a wall.
constexpr double kGuide = 0.2;
constexpr double kMostGuide_n_m = 250;
constexpr double kCarryDamping_n_s_m = 1.5;

/// Whether the zones fit the surface and each zone has a coefficient.
bool usable(const FrictionZones& zones, int size) {
  const auto samples = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  return zones.size == size && zones.zone.size() == samples &&
         std::all_of(zones.zone.begin(), zones.zone.end(),
                     [&](std::uint8_t zone) { return zone <= zones.added.size(); });
}

/// The strokes as the lowest point of a ball can follow them: not below the surface that is made for it.
std::vector<StrokePath> above(std::vector<StrokePath> strokes, const TabletSurface& surface) {
  for (StrokePath& stroke : strokes)
    for (Vec3& p : stroke.points) p.z = std::max(p.z, surface.height(p.x, p.y));
  return strokes;
}

bool same_lesson(const HapticScene& a, const HapticScene& b) {
  return a.tip_radius_m == b.tip_radius_m && a.guiding.mode == b.guiding.mode &&
         a.guiding.stroke == b.guiding.stroke && a.guiding.attempt == b.guiding.attempt &&
         a.guiding.seed == b.guiding.seed &&
         std::equal(a.strokes.begin(), a.strokes.end(), b.strokes.begin(), b.strokes.end(),
                    [](const StrokePath& p, const StrokePath& q) { return p.points == q.points; });
}

}  // namespace

ServoScene::ServoScene(std::shared_ptr<const HapticScene> from, const DeviceDescription& device,
                       std::uint64_t number, const ServoScene* before)
    : scene(std::move(from)), generation(number), frictions(1), lesson(number) {
  if (!scene) return;
  const Material& material = scene->material;
  const Snapping& snapping = scene->snapping;
  const Guiding& guiding = scene->guiding;
  const DeviceLimits& limits = device.limits;
  if (scene->surface && !scene->soft_tip && scene->shape.width_m > 0 && scene->shape.depth_m > 0)
    surface = TabletSurface(*scene->surface, scene->shape);
  if (surface.exists()) tip_radius_m = within(scene->tip_radius_m, 0, surface::kLargestBall_m);
  const std::vector<StrokePath> raised =
      tip_radius_m > 0 ? above(scene->strokes, surface) : std::vector<StrokePath>();
  const std::vector<StrokePath>& followed = tip_radius_m > 0 ? raised : scene->strokes;
  const auto with = [&material](double added) {
    const double hold = coefficient(material.static_friction + added);
    return Friction{hold, std::min(coefficient(material.dynamic_friction + added), hold)};
  };
  frictions[0] = with(0);
  if (scene->friction_zones && surface.exists() && usable(*scene->friction_zones, scene->surface->size())) {
    zones = scene->friction_zones.get();
    for (const double added : zones->added) frictions.push_back(with(std::max(0.0, added)));
    half_m = scene->shape.width_m / 2;
    zones_per_m = (zones->size - 1) / scene->shape.width_m;
  }
  popthrough_n = fraction(material.popthrough) * limits.max_force_n;
  roughness = fraction(material.roughness);
  texture = roughness > 0 ? material.texture : Texture::none;

  const double b = limits.own_damping_n_s_m + limits.hand_damping_n_s_m;
  damping_n_s_m = std::min(fraction(material.damping) * limits.max_damping_n_s_m, b / 2);
  stiffness_n_m = fraction(material.stiffness) * limits.max_stiffness_n_m;
  const bool held_by_guidance = guiding.mode == GuidingMode::lesson || guiding.mode == GuidingMode::lead;
  const bool snaps = snapping.enabled && !held_by_guidance;
  double pull_n_m = snaps              ? fraction(snapping.stiffness) * limits.max_stiffness_n_m
                    : held_by_guidance ? std::min(kGuide * limits.max_stiffness_n_m, kMostGuide_n_m)
                                       : 0;
  // Surface and stroke pull at once: together they must stay within what the device can render and what is
  // passive.
  const double most = std::min(limits.max_stiffness_n_m,
                               passive_stiffness_n_m(b, damping_n_s_m, period_of(device), limits.delay_s));
  if (scene->soft_tip) stiffness_n_m = damping_n_s_m = 0;
  if (stiffness_n_m + pull_n_m > most) {
    const double part = most / (stiffness_n_m + pull_n_m);
    stiffness_n_m *= part;
    pull_n_m *= part;
  }

  if (scene->soft_tip) {
    soft = SoftTipTable(*scene->soft_tip, std::max(0.0, most - pull_n_m), limits.max_force_n);
    if (soft.exists()) soft_tip = scene->soft_tip.get();
  }

  if (guiding.mode != GuidingMode::off) {
    plan = GuidancePlan(followed, within(guiding.speed_m_s, 0.005, 0.2));
    first_stroke = std::max(1, guiding.stroke);
    guide.mode = guiding.mode;
    guide.strength = fraction(guiding.strength);
    guide.cap_n = std::min(fraction(guiding.cap_n), limits.max_force_n);
    guide.stiffness_n_m = held_by_guidance ? pull_n_m : 0;
    guide.damping_n_s_m =
        std::clamp(b / 2 - damping_n_s_m, 0.0, std::min(kCarryDamping_n_s_m, limits.max_damping_n_s_m));
    guide.disturbance_n = std::min(fraction(guiding.disturbance_n), limits.max_force_n);
    disturbance = Disturbance(guiding.seed, period_of(device));
    if (before != nullptr && before->scene && same_lesson(*scene, *before->scene)) lesson = before->lesson;
  }

  if (!snaps) return;
  strokes = StrokeIndex(followed, std::max(0, snapping.stroke));
  snap.stiffness_n_m = pull_n_m;
  snap.snap_distance_m =
      positive(snapping.snap_distance_m, kPullOff_n / positive(limits.max_stiffness_n_m, 500));
  // A margin, so that a hand at the very edge is not captured and released in turn.
  snap.release_distance_m = 1.05 * snap.snap_distance_m;
  if (pull_n_m > 0)
    snap.release_distance_m =
        std::max(snap.release_distance_m, positive(snapping.release_force_n, 0) / pull_n_m);
}

Servo::Inside::Inside(const DeviceDescription& description)
    : device(description),
      period_s(period_of(description)),
      limiter(description.limits),
      passivity(description.limits, period_of(description)) {}

Servo::Servo(const DeviceDescription& device) : inside_(std::make_unique<Inside>(device)) {}
Servo::~Servo() = default;

void Servo::set_scene(std::shared_ptr<const HapticScene> scene) {
  Inside& in = *inside_;
  const ServoScene* before = in.kept.empty() ? nullptr : in.kept.back().get();
  in.kept.push_back(
      std::make_unique<const ServoScene>(std::move(scene), in.device, ++in.generations, before));
  in.offered.store(in.kept.back().get(), std::memory_order_release);
  const std::uint64_t used = in.used.load(std::memory_order_acquire);
  std::erase_if(in.kept, [used](const auto& s) { return s->generation < used; });
}

void Servo::begin_run() noexcept {
  inside_->started = false;
  inside_->velocity = Vec3(0);
}

const ServoSample& Servo::latest() noexcept { return inside_->newest.latest(); }

std::size_t Servo::take_samples(std::span<ServoSample> out) noexcept {
  return inside_->samples.pop(out.data(), out.size());
}

ServoTiming Servo::timing() const noexcept {
  const ServoStopwatch& w = inside_->watch;
  constexpr auto kRelaxed = std::memory_order_relaxed;
  ServoTiming t;
  t.ticks = w.ticks.load(kRelaxed);
  t.late_ticks = w.late_ticks.load(kRelaxed);
  t.missed_ticks = w.missed_ticks.load(kRelaxed);
  t.dropped_samples = w.dropped_samples.load(kRelaxed);
  t.mean_tick_s = t.ticks > 0 ? w.inside_s.load(kRelaxed) / static_cast<double>(t.ticks) : 0;
  t.max_tick_s = w.max_tick_s.load(kRelaxed);
  t.max_lateness_s = w.max_lateness_s.load(kRelaxed);
  return t;
}

void Servo::set_recording(SampleRing* ring) noexcept {
  Inside& in = *inside_;
  const SampleRing* old = in.recording.exchange(ring);
  while (old != nullptr && in.pushing.load() == old) std::this_thread::yield();
}

}  // namespace nazori::haptics
