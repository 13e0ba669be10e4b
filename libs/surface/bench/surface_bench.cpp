// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "nazori/surface/ball_surface.h"
#include "nazori/surface/height_map.h"

namespace nazori::surface {
namespace {

HeightMap waves(int size) {
  HeightMap map = HeightMap::create(size).value();
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      map.set(x, y, static_cast<float>(0.5 + 0.5 * std::sin(x * 0.05) * std::cos(y * 0.03)));
  return map;
}

void BM_ParseRaw(benchmark::State& state) {
  const auto bytes = to_raw(waves(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(parse_raw(bytes));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(BM_ParseRaw)->Arg(128)->Arg(1024)->Unit(benchmark::kMicrosecond);

void BM_ToRaw(benchmark::State& state) {
  const HeightMap map = waves(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(to_raw(map));
}
BENCHMARK(BM_ToRaw)->Arg(128)->Arg(1024)->Unit(benchmark::kMicrosecond);

void BM_ParsePng16(benchmark::State& state) {
  const auto bytes = to_png(waves(static_cast<int>(state.range(0))), PngDepth::bits_16);
  for (auto _ : state) benchmark::DoNotOptimize(parse_png(bytes));
}
BENCHMARK(BM_ParsePng16)->Arg(128)->Arg(1024)->Unit(benchmark::kMicrosecond);

void BM_ToPng16(benchmark::State& state) {
  const HeightMap map = waves(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(to_png(map, PngDepth::bits_16));
}
BENCHMARK(BM_ToPng16)->Arg(128)->Arg(1024)->Unit(benchmark::kMicrosecond);

/// Six grooves with round floors, as strokes are carved, on a plateau: 6.4 mm broad, in 8 bits.
HeightMap grooves(int size) {
  struct Groove {
    double x0, y0, x1, y1;
  };
  constexpr Groove kGrooves[] = {{0.15, 0.28, 0.85, 0.28}, {0.50, 0.08, 0.50, 0.90},
                                 {0.49, 0.30, 0.12, 0.78}, {0.51, 0.30, 0.88, 0.78},
                                 {0.27, 0.85, 0.73, 0.85}, {0.67, 0.10, 0.80, 0.17}};
  constexpr double kHalfWidth = 0.032;  // of the side
  HeightMap map = HeightMap::create(size).value();
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = static_cast<double>(column) / (size - 1), y = static_cast<double>(row) / (size - 1);
      double nearest = 1;
      for (const Groove& g : kGrooves) {
        const double ex = g.x1 - g.x0, ey = g.y1 - g.y0;
        const double t = std::clamp(((x - g.x0) * ex + (y - g.y0) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(x - g.x0 - t * ex, y - g.y0 - t * ey));
      }
      const double share = std::min(nearest / kHalfWidth, 1.0);
      map.set(column, row,
              static_cast<float>(std::round(255 * (1 - std::cos(std::numbers::pi * share)) / 2) / 255));
    }
  return map;
}

/// From a map to the surface that a ball of so many tenths of a millimetre feels; 0 tenths: a point.
void prepare(benchmark::State& state, const HeightMap& map) {
  const double radius_m = 1e-4 * static_cast<double>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(surface_for_ball(map, {0.1, 0.01}, radius_m));
}

void BM_BallOnGrooves(benchmark::State& state) { prepare(state, grooves(static_cast<int>(state.range(0)))); }
void BM_BallOnWaves(benchmark::State& state) { prepare(state, waves(static_cast<int>(state.range(0)))); }
BENCHMARK(BM_BallOnGrooves)
    ->ArgsProduct({{128, 2048}, {0, 10, 30}})
    ->ArgNames({"size", "tenths_mm"})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(BM_BallOnWaves)
    ->ArgsProduct({{128, 2048}, {10, 30}})
    ->ArgNames({"size", "tenths_mm"})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace nazori::surface
