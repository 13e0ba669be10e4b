// SPDX-License-Identifier: Apache-2.0
// How punctual the servo is while other work keeps every core busy, beside a bare timer loop in the same run.
#include <benchmark/benchmark.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <thread>
#include <vector>

#include "nazori/devices/rt_thread.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/haptics/servo.h"

namespace nazori::devices {
namespace {

constexpr double kRun_s = 10;

std::int64_t now_ns() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1'000'000'000 + t.tv_nsec;
}

double quantile_us(std::vector<double> late_ns, double q) {
  std::sort(late_ns.begin(), late_ns.end());
  return late_ns[static_cast<std::size_t>(q * static_cast<double>(late_ns.size() - 1))] * 1e-3;
}

/// The minimum a program can do: sleep until an absolute time and record how late it woke. A period that was
/// slept through is recorded too, with its lateness when it is noticed.
std::vector<double> bare_loop(std::int64_t period_ns) {
  std::vector<double> late(static_cast<std::size_t>(kRun_s * 1e9) / static_cast<std::size_t>(period_ns));
  const sched_param priority{40};
  (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
  std::int64_t due = now_ns();
  for (double& l : late) {
    due += period_ns;
    const timespec t{static_cast<time_t>(due / 1'000'000'000), static_cast<long>(due % 1'000'000'000)};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr);
    l = static_cast<double>(now_ns() - due);
  }
  return late;
}

/// A servo on a plate. Records how late each period of the clock's grid was served; periods without a tick
/// are as late as the following tick, as in the bare loop.
class Watched final : public haptics::ServoCallback {
 public:
  explicit Watched(const haptics::DeviceDescription& device)
      : servo_(device), period_ns_(1e9 / device.rate_hz) {
    auto scene = std::make_shared<haptics::HapticScene>();
    scene->surface = *surface::SmoothSurface::create(*surface::HeightMap::create(128));
    servo_.set_scene(scene);
    late.reserve(static_cast<std::size_t>(2 * kRun_s * device.rate_hz));
  }
  haptics::Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    const double now_ns = sample.time_s * 1e9;
    for (; static_cast<double>(next_) * period_ns_ <= now_ns && late.size() < late.capacity(); ++next_)
      late.push_back(now_ns - static_cast<double>(next_) * period_ns_);
    return servo_.tick(sample);
  }
  [[nodiscard]] haptics::ServoTiming timing() const { return servo_.timing(); }

  std::vector<double> late;

 private:
  haptics::Servo servo_;
  double period_ns_;
  std::int64_t next_ = 0;  // period of the grid that no tick has served yet
};

// Argument: rate [Hz].
void BM_ServoLatenessUnderLoad(benchmark::State& state) {
  SimulatedHardware hardware =
      state.range(0) == 4000 ? SimulatedHardware::omega_3() : SimulatedHardware::touch();
  for ([[maybe_unused]] auto _ : state) {
    std::atomic<bool> stop{false};
    std::vector<std::thread> load;
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
      load.emplace_back([&stop] {
        double x = 1;
        while (!stop.load(std::memory_order_relaxed)) benchmark::DoNotOptimize(x = x * 1.0000001 + 1e-9);
      });
    // Both threads on one core, so that whatever takes that core away (another machine on the same host)
    // affects both.
    cpu_set_t all, one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<unsigned>(sched_getcpu()), &one);
    (void)sched_getaffinity(0, sizeof all, &all);
    (void)sched_setaffinity(0, sizeof one, &one);
    SimulatedDevice device(hardware);
    Watched watched(device.describe());
    if (!device.start(watched)) state.SkipWithError("no servo thread");
    std::vector<double> bare;
    std::thread beside([&] { bare = bare_loop(std::llround(1e9 / hardware.rate_hz)); });
    (void)sched_setaffinity(0, sizeof all, &all);
    beside.join();
    const bool real_time = device.clock().real_time;
    device.stop();
    stop = true;
    for (std::thread& t : load) t.join();
    const ClockStatus clock = device.clock();
    state.counters["bare_p99.9_us"] = quantile_us(bare, 0.999);
    state.counters["servo_p99.9_us"] = quantile_us(watched.late, 0.999);
    state.counters["more_p99.9_us"] = quantile_us(watched.late, 0.999) - quantile_us(bare, 0.999);
    state.counters["bare_median_us"] = quantile_us(bare, 0.5);
    state.counters["servo_median_us"] = quantile_us(watched.late, 0.5);
    state.counters["servo_max_us"] = quantile_us(watched.late, 1);
    state.counters["missed"] = static_cast<double>(clock.missed);
    state.counters["servo_counts_missed"] = static_cast<double>(watched.timing().missed_ticks);
    // Every period of the grid either had its tick or was counted as missed.
    state.counters["unnoticed"] =
        static_cast<double>(watched.late.size()) - static_cast<double>(clock.ticks + clock.missed);
    state.counters["real_time"] = real_time ? 1 : 0;
  }
}
BENCHMARK(BM_ServoLatenessUnderLoad)
    ->Arg(1000)
    ->Arg(4000)
    ->ArgNames({"rate"})
    ->Iterations(1)
    ->Repetitions(5)
    ->ReportAggregatesOnly()
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace nazori::devices
