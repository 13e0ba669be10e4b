// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>

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

}  // namespace
}  // namespace nazori::surface
