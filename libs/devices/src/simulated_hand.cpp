// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/simulated_hand.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <thread>
#include <utility>

#include "due_times.h"
#include "hand_corrections.h"
#include "hand_plan.h"
#include "stroke_measures.h"
#include "tick_durations.h"

namespace nazori::devices {
namespace {

using geometry::TabletPoint;
using haptics::Vec3;

// Without a clock, the number of ticks between two progress calls.
constexpr std::uint64_t kBetweenQuestions = 256;
constexpr std::chrono::milliseconds kBetweenLooks{20};

TabletPoint from_above(const Vec3& p) { return {p.x, p.y}; }

/// A hand with a loose grip and a little tremor.
HandGrip loose_grip() {
  HandGrip grip;
  grip.stiffness_n_m = 120;
  grip.damping_n_s_m = 3;
  grip.tremor_m = 5e-5;
  return grip;
}

}  // namespace

/// Wraps the servo of a device: each tick moves the hand's target, then lets the servo answer.
class SimulatedHand::Inside final : public haptics::ServoCallback {
 public:
  Inside(std::span<const haptics::StrokePath> strokes,
         std::vector<std::shared_ptr<const haptics::HapticScene>> scenes, const SimulatedHardware& hardware,
         HandObserver* observer, const HandHabits& habits)
      : plan_(strokes, habits),
        device_(hardware, loose_grip()),
        servo_(device_.describe()),
        observer_(observer),
        period_s_(1 / hardware.rate_hz),
        due_times_(period_s_),
        scenes_(std::move(scenes)) {
    assert(scenes_.size() == strokes.size() + 1);
    device_.place(plan_.at(0).target_m);
    for (const haptics::StrokePath& path : strokes) {
      geometry::Polyline<geometry::TabletFrame> line;
      for (const Vec3& p : path.points) line.push_back(from_above(p));
      if (line.empty()) line.push_back({});
      measures_.emplace_back(std::move(line));
    }
    attend();
  }

  /// Gives the servo the scene of the hand's present stroke. Thread: the one that does not tick, or the same.
  void attend() {
    const int next = next_.load(std::memory_order_relaxed);
    if (next == scene_) return;
    scene_ = next;
    servo_.set_scene(scenes_[static_cast<std::size_t>(next)]);
  }

  /// Neither allocates nor waits.
  Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    HandIntent intent = plan_.at(sample.time_s);
    const TabletPoint aim = from_above(intent.target_m);
    const TabletPoint tip = from_above(servo_.latest().proxy_m);
    const bool following = intent.stroke > 0;
    const double off_m = following ? measures_of(intent.stroke).off_m(tip) : 0;
    intent.target_m.z += sight_.lift_m(off_m, geometry::distance(tip, aim), following, period_s_);
    if (following) {
      const Vec3 wrong_m = intent.line_m - servo_.latest().proxy_m;
      intent.target_m += pull_.lead_m(wrong_m, intent.along, intent.movement, period_s_);
    }
    device_.set_target(intent.target_m);
    const auto begin = std::chrono::steady_clock::now();
    const Vec3 force = servo_.tick(sample);
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    tick_times_.add(took_s);
    lateness_.add(due_times_.lateness_s(sample.time_s));
    due_times_.ended(sample.time_s + took_s);
    if (observer_ != nullptr) observer_->see(servo_.latest());
    if (following)
      measures_of(intent.stroke).add(intent.stroke, aim, sight_.take_slips(), servo_.latest(), force);
    next_.store(intent.next, std::memory_order_relaxed);
    done_.store(sample.time_s / plan_.duration_s(), std::memory_order_relaxed);
    return force;
  }
  [[nodiscard]] std::uint16_t events() const noexcept override { return servo_.events(); }

  [[nodiscard]] SimulatedDevice& device() { return device_; }
  [[nodiscard]] const SimulatedDevice& device() const { return device_; }
  [[nodiscard]] haptics::Servo& servo() { return servo_; }
  [[nodiscard]] bool finished() const { return done() >= 1; }
  /// Progress, 0..1 and beyond at the end. Thread-safe: yes.
  [[nodiscard]] double done() const { return done_.load(std::memory_order_relaxed); }
  void set_clock(const ClockStatus& clock) { clock_ = clock; }

  [[nodiscard]] HandReport report() const {
    HandReport report;
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      FollowedStroke followed;
      followed.stroke = static_cast<int>(i) + 1;
      followed.length_m = plan_.length_m(followed.stroke);
      followed.duration_s = plan_.following_s(followed.stroke);
      measures_[i].report_to(followed);
      report.strokes.push_back(followed);
    }
    report.work_on_hand_j = device_.work_j();
    report.timing = servo_.timing();
    report.p999_tick_s = tick_times_.quantile_s(0.999);
    report.p999_lateness_s = lateness_.quantile_s(0.999);
    report.clock = clock_;
    return report;
  }

 private:
  StrokeMeasures& measures_of(int stroke) noexcept { return measures_[static_cast<std::size_t>(stroke) - 1]; }

  HandPlan plan_;
  SimulatedDevice device_;
  haptics::Servo servo_;
  HandObserver* observer_;
  double period_s_;
  DueTimes due_times_;
  HandSight sight_;
  HandPull pull_;
  std::vector<StrokeMeasures> measures_;
  TickDurations tick_times_, lateness_;
  ClockStatus clock_;
  std::atomic<double> done_{0};
  std::vector<std::shared_ptr<const haptics::HapticScene>> scenes_;
  std::atomic<int> next_{0};
  int scene_ = -1;
};

SimulatedHand::SimulatedHand(std::span<const haptics::StrokePath> strokes,
                             std::vector<std::shared_ptr<const haptics::HapticScene>> scenes,
                             const SimulatedHardware& hardware, HandObserver* observer,
                             const HandHabits& habits)
    : inside_(std::make_unique<Inside>(strokes, std::move(scenes), hardware, observer, habits)) {}
SimulatedHand::~SimulatedHand() { inside_->device().stop(); }

haptics::DeviceDescription SimulatedHand::describe() const { return inside_->device().describe(); }
haptics::Servo& SimulatedHand::servo() { return inside_->servo(); }
HandReport SimulatedHand::report() const { return inside_->report(); }

base::Result<void> SimulatedHand::run(HandClock clock, const base::Progress& progress) {
  SimulatedDevice& device = inside_->device();
  const auto go_on = [&progress](double done) { return !progress || progress(done, "tracing"); };
  bool goes_on = true;
  if (clock == HandClock::none) {
    for (std::uint64_t tick = 0; goes_on && !inside_->finished(); ++tick) {
      (void)device.step(*inside_);
      inside_->attend();
      if (tick % kBetweenQuestions == 0) goes_on = go_on(inside_->done());
    }
  } else {
    if (auto started = device.start(*inside_); !started) return tl::unexpected(std::move(started.error()));
    while (goes_on && !inside_->finished()) {
      std::this_thread::sleep_for(kBetweenLooks);
      inside_->attend();
      goes_on = go_on(std::min(inside_->done(), 1.0));
    }
    inside_->set_clock(device.clock());
    device.stop();
  }
  if (!goes_on) return base::fail(base::Errc::cancelled, "stopped");
  return {};
}

}  // namespace nazori::devices
