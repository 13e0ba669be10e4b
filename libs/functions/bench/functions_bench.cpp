// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <ctime>

#include "nazori/functions/plate.h"
#include "nazori/functions/points.h"
#include "nazori/functions/tone_generator.h"

namespace {

using namespace nazori::functions;  // NOLINT

struct Case {
  const char* expression;
  Window window;
  /// The time of a prototype with compiled-in functions for tracing and carving at 128, 256 and 1024 samples
  /// [ms], one thread; 0: not known.
  double prototype_ms[3];
};
const Case kCases[] = {
    {"y = tan(x)", {-6, 6, -4, 4}, {0.4, 2.1, 24.2}},
    {"y = sin(1/x)", {-1, 1, -1.5, 1.5}, {2.4, 10.6, 152}},
    {"y = sin(100x)", {-10, 10, -2, 2}, {7, 28, 389}},
    {"x^2 + y^2 = 1", {-2, 2, -2, 2}, {0.4, 2.2, 41.6}},
    {"sin(x^2+y^2) = cos(xy)", {-5, 5, -5, 5}, {29, 75, 730}},
    {"x/sin(x) + y/sin(y) = x*y/sin(x*y)", {-10, 10, -10, 10}, {364, 838, 3960}},
    {"y = x^2 - 3x + 2; y = sqrt(x); y = e^-x", {-5, 5, -5, 5}, {0, 0, 0}},
    {"r = 1 + cos(theta)", {-1, 3, -2, 2}, {0, 0, 0}},
    {"1 < x^2 + y^2 < 4", {-3, 3, -3, 3}, {0, 0, 0}},
    {"z = sin(x)cos(y)", {-4, 4, -4, 4}, {0, 0, 0}},
    {"z = sqrt(4-x^2-y^2)", {-3, 3, -3, 3}, {0, 0, 0}},
};
constexpr int kCount = static_cast<int>(std::size(kCases));

void BM_Trace(benchmark::State& state) {
  const Case& c = kCases[state.range(0)];
  const auto plot = parse(c.expression);
  TraceSettings settings;
  settings.resolution = static_cast<int>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(trace(*plot, c.window, settings));
  state.SetLabel(c.expression);
}
BENCHMARK(BM_Trace)->ArgsProduct({{0, 1, 2, 3, 4, 5}, {256, 1024}})->Unit(benchmark::kMillisecond);

void BM_Draw(benchmark::State& state) {
  const Case& c = kCases[state.range(0)];
  const auto plot = parse(c.expression);
  PlateSettings settings;
  settings.size = static_cast<int>(state.range(1));
  settings.layers = Layers::none();
  const std::clock_t start = std::clock();
  for (auto _ : state) benchmark::DoNotOptimize(draw(*plot, c.window, settings));
  const double took_ms = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double known = c.prototype_ms[settings.size == 128 ? 0 : settings.size == 256 ? 1 : 2];
  if (known > 0) state.counters["of_prototype"] = took_ms / static_cast<double>(state.iterations()) / known;
  state.SetLabel(c.expression);
}
BENCHMARK(BM_Draw)
    ->ArgsProduct({benchmark::CreateDenseRange(0, kCount - 1, 1), {128, 256, 1024}})
    ->Unit(benchmark::kMillisecond);

/// Time until the first picture of a plate of 1024 samples is ready, including ridges and rim.
void BM_FirstPicture(benchmark::State& state) {
  const Case& c = kCases[state.range(0)];
  const auto plot = parse(c.expression);
  PlateSettings settings;
  settings.size = 1024;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        draw_coarse_to_fine(*plot, c.window, settings, [](Picture&&, bool) { return false; }));
  }
  state.SetLabel(c.expression);
}
BENCHMARK(BM_FirstPicture)
    ->ArgsProduct({benchmark::CreateDenseRange(0, kCount - 1, 1)})
    ->Unit(benchmark::kMillisecond);

void BM_PointsOfInterest(benchmark::State& state) {
  const Case& c = kCases[state.range(0)];
  const auto plot = parse(c.expression);
  const auto tracing = trace(*plot, c.window);
  for (auto _ : state) benchmark::DoNotOptimize(points_of_interest(*plot, *tracing));
  state.SetLabel(c.expression);
}
BENCHMARK(BM_PointsOfInterest)->ArgsProduct({{0, 1, 3, 4, 6}})->Unit(benchmark::kMillisecond);

void BM_Parse(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(parse("y = 2sin^2 x + sqrt(|x|) - e^-x^2 / (1 + x^2)"));
}
BENCHMARK(BM_Parse);

/// One block of 256 frames at 48 kHz, 5.3 ms of sound.
void BM_ToneBlock(benchmark::State& state) {
  SoundSettings settings;
  settings.sample_rate = 48'000;
  ToneGenerator tone(settings);
  tone.set({440, 0.3, 0.2, 1});
  std::vector<float> block(512);
  for (auto _ : state) {
    tone.fill(block);
    benchmark::DoNotOptimize(block.data());
  }
}
BENCHMARK(BM_ToneBlock)->Unit(benchmark::kMicrosecond);

}  // namespace
