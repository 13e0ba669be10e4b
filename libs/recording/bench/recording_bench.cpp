// SPDX-License-Identifier: Apache-2.0
// What recording costs a tick, and how fast recordings and trajectories are read and written.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "nazori/haptics/sample_ring.h"
#include "nazori/recording/recording_file.h"
#include "nazori/recording/sample_csv.h"
#include "nazori/recording/trajectory_csv.h"

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

}  // namespace
}  // namespace nazori::recording
