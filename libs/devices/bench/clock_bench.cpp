// SPDX-License-Identifier: Apache-2.0
// How punctual the servo is while other work keeps every core busy, beside a bare timer loop in the same run.
#include <benchmark/benchmark.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>
#include <vector>

#include "nazori/devices/rt_thread.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/haptics/servo.h"

namespace nazori::devices {
namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr std::size_t kTicks = 5000;

std::int64_t now_ns() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1'000'000'000 + t.tv_nsec;
}

double quantile_us(std::vector<double> late_ns, double q) {
  std::sort(late_ns.begin(), late_ns.end());
  return late_ns[static_cast<std::size_t>(q * static_cast<double>(late_ns.size() - 1))] * 1e-3;
}

/// The least a program can do: sleep to an absolute time, note how late it woke.
std::vector<double> bare_loop() {
  std::vector<double> late(kTicks);
  const sched_param priority{40};
  (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
  std::int64_t due = now_ns();
  for (double& l : late) {
    due += kPeriod_ns;
    const timespec t{static_cast<time_t>(due / 1'000'000'000), static_cast<long>(due % 1'000'000'000)};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr);
    l = static_cast<double>(now_ns() - due);
  }
  return late;
}

/// A servo on a plate, whose ticks' lateness against the clock's grid is noted.
class Watched final : public haptics::ServoCallback {
 public:
  explicit Watched(const haptics::DeviceDescription& device) : servo_(device) {
    auto scene = std::make_shared<haptics::HapticScene>();
    scene->surface = *surface::SmoothSurface::create(*surface::HeightMap::create(128));
    servo_.set_scene(scene);
    late.reserve(2 * kTicks);
  }
  haptics::Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    const double periods = sample.time_s * 1e9 / kPeriod_ns;
    if (late.size() < late.capacity())
      late.push_back((periods - static_cast<double>(static_cast<long>(periods))) * kPeriod_ns);
    return servo_.tick(sample);
  }
  std::vector<double> late;
  [[nodiscard]] haptics::ServoTiming timing() const { return servo_.timing(); }

 private:
  haptics::Servo servo_;
};

void BM_ServoLatenessUnderLoad(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    std::atomic<bool> stop{false};
    std::vector<std::thread> load;
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
      load.emplace_back([&stop] {
        double x = 1;
        while (!stop.load(std::memory_order_relaxed)) benchmark::DoNotOptimize(x = x * 1.0000001 + 1e-9);
      });
    SimulatedDevice device;
    Watched watched(device.describe());
    if (!device.start(watched)) state.SkipWithError("no servo thread");
    std::vector<double> bare;
    std::thread beside([&bare] { bare = bare_loop(); });
    beside.join();
    const ClockStatus clock = device.clock();
    device.stop();
    stop = true;
    for (std::thread& t : load) t.join();
    state.counters["bare_p99.9_us"] = quantile_us(bare, 0.999);
    state.counters["servo_p99.9_us"] = quantile_us(watched.late, 0.999);
    state.counters["bare_median_us"] = quantile_us(bare, 0.5);
    state.counters["servo_median_us"] = quantile_us(watched.late, 0.5);
    state.counters["ticks"] = static_cast<double>(clock.ticks);
    state.counters["missed"] = static_cast<double>(clock.missed);
    state.counters["real_time"] = clock.real_time ? 1 : 0;
  }
}
BENCHMARK(BM_ServoLatenessUnderLoad)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace nazori::devices
