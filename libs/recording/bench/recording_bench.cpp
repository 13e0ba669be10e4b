// SPDX-License-Identifier: Apache-2.0
// What recording costs a tick, and how fast recordings and trajectories are read and written.
#include <benchmark/benchmark.h>

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/file.h"
#include "nazori/haptics/sample_ring.h"
#include "nazori/recording/recording_file.h"
#include "nazori/recording/sample_csv.h"
#include "nazori/recording/sample_statistics.h"
#include "nazori/recording/trajectory_csv.h"
#include "nazori/recording/trajectory_ticks.h"
#include "nazori/surface/height_map.h"

namespace nazori::recording {
namespace {

std::vector<haptics::ServoSample> some_samples() {
  std::vector<haptics::ServoSample> samples(10'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = 0.001 * static_cast<double>(i);
    samples[i].tick = i;
    samples[i].time_s = t;
    samples[i].device_m = {0.03 * std::sin(t), 0.02 * std::cos(2 * t), -0.004 + 0.002 * std::sin(3 * t)};
    samples[i].proxy_m = {0.029 * std::sin(t), 0.019 * std::cos(2 * t), -0.003};
    samples[i].force_n = {0.1 * std::cos(t), 0.2 * std::sin(t), 0.3 + 0.1 * std::sin(7 * t)};
    samples[i].touching = true;
  }
  return samples;
}

void push_into_ring(benchmark::State& state) {
  const auto ring = std::make_unique<haptics::SampleRing>();
  const haptics::ServoSample sample;
  for (auto _ : state) {
    ring->push(sample);
    ring->taken.store(ring->pushed.load(std::memory_order_relaxed), std::memory_order_relaxed);
  }
}
BENCHMARK(push_into_ring);

void encode(benchmark::State& state) {
  const auto samples = some_samples();
  std::vector<std::uint8_t> bytes;
  for (auto _ : state) {
    bytes.clear();
    for (const auto& sample : samples) encode_record(sample, bytes);
    benchmark::DoNotOptimize(bytes.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(samples.size()));
}
BENCHMARK(encode);

void write_csv(benchmark::State& state) {
  const auto samples = some_samples();
  std::string text;
  for (auto _ : state) {
    text.clear();
    for (const auto& sample : samples) append_csv_row(text, sample);
    benchmark::DoNotOptimize(text.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(samples.size()));
}
BENCHMARK(write_csv);

void read_csv(benchmark::State& state) {
  std::string text(kSampleCsvHeader);
  const auto samples = some_samples();
  for (const auto& sample : samples) append_csv_row(text, sample);
  for (auto _ : state) {
    auto reader = TrajectoryReader::from(memory_source(text, "bench"));
    TrajectoryPoint point;
    while (*reader->next(point)) benchmark::DoNotOptimize(point);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(samples.size()));
}
BENCHMARK(read_csv);

/// Ten minutes of a hand that writes over a relief with crossing grooves, mostly in contact.
std::filesystem::path write_hand() {
  const auto path = std::filesystem::temp_directory_path() / ("nazori-bench-" + std::to_string(::getpid()));
  std::ofstream file(path);
  file << "t,x,y,z\n";
  for (int i = 0; i < 600'000; ++i) {
    const double t = 0.001 * i;
    file << std::to_string(t) << ',' << std::to_string(0.03 * std::sin(0.7 * t)) << ','
         << std::to_string(0.03 * std::sin(0.9 * t + 1)) << ','
         << std::to_string(-0.006 + 0.003 * std::sin(2.3 * t)) << '\n';
  }
  return path;
}

std::shared_ptr<const haptics::HapticScene> grooves(bool friction) {
  constexpr int kSize = 512;
  surface::HeightMap map = *surface::HeightMap::create(kSize);
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const double across = std::abs(std::sin(0.05 * column)) * std::abs(std::sin(0.05 * row));
      map.set(column, row, static_cast<float>(across));
    }
  }
  auto scene = std::make_shared<haptics::HapticScene>();
  scene->surface = *surface::SmoothSurface::create(map);
  if (friction) scene->material.static_friction = scene->material.dynamic_friction = 0.3;
  return scene;
}

/// The work of nazori-cli feel: CSV from a file, the servo, CSV to a file that is flushed to the disk.
void replay_ten_minutes(benchmark::State& state) {
  const auto input = write_hand();
  const auto output = std::filesystem::path(input.string() + ".csv");
  const auto scene = grooves(state.range(0) != 0);
  for (auto _ : state) {
    auto ticks = TrajectoryTicks::create(*TrajectoryReader::open(input), {});
    haptics::Servo servo({"bench", ticks->rate_hz(), true, {}});
    servo.set_scene(scene);
    auto file = base::OutputFile::create(output);
    std::string text(kSampleCsvHeader);
    SampleStatistics statistics;
    TrajectoryPoint point;
    while (*ticks->next(point)) {
      haptics::DeviceSample pose;
      pose.time_s = point.time_s;
      pose.position_m = point.position_m;
      (void)servo.tick(pose);
      statistics.add(servo.latest());
      append_csv_row(text, servo.latest());
      if (text.size() < (std::size_t{1} << 20)) continue;
      if (!file->append(text)) std::abort();
      text.clear();
    }
    if (!file->append(text) || !file->commit()) std::abort();
    state.counters["in_contact"] =
        static_cast<double>(statistics.touching) / static_cast<double>(statistics.samples);
  }
  state.counters["real_time_factor"] = benchmark::Counter(600, benchmark::Counter::kIsIterationInvariantRate);
  std::filesystem::remove(input);
  std::filesystem::remove(output);
}
BENCHMARK(replay_ten_minutes)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("friction")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(replay_ten_minutes)->Arg(0)->Arg(1)->ArgName("friction")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::recording
