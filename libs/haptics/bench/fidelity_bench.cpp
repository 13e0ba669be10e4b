// SPDX-License-Identifier: Apache-2.0
// The figures of fidelity.h, at the sizes that the tests run and at the largest.
#include "fidelity.h"

#include <benchmark/benchmark.h>

namespace nazori::haptics {
namespace {

void BM_FirstTickInside(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const fidelity::FirstTick found = fidelity::first_tick();
    state.counters["dives"] = found.dives;
    state.counters["pushed_at_once"] = found.pushed;
    state.counters["least_share"] = found.least;
  }
}
BENCHMARK(BM_FirstTickInside)->Iterations(1)->Unit(benchmark::kMillisecond);

void BM_SidewaysLag(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) state.counters["worst_m"] = fidelity::sideways_lag_m();
}
BENCHMARK(BM_SidewaysLag)->Iterations(1)->Unit(benchmark::kMillisecond);

// Arguments: map size, path (0 trace, 1 sweep, 2 scribble).
void BM_BehindARidge(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const fidelity::Behind found =
        fidelity::behind_a_ridge(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    state.counters["ticks"] = found.ticks;
    state.counters["behind"] = found.behind;
    state.counters["below"] = found.below;
    state.counters["late"] = found.late;
    state.counters["farthest_mm"] = found.farthest_m * 1e3;
  }
}
BENCHMARK(BM_BehindARidge)
    ->ArgsProduct({{128, 2048}, {0, 1, 2}})
    ->ArgNames({"size", "path"})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void BM_RisingSurface(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const fidelity::Lift found = fidelity::rising_surface();
    state.counters["styluses"] = found.styluses;
    state.counters["lifted"] = found.lifted;
    state.counters["worst_step_n"] = found.worst_step_n;
  }
}
BENCHMARK(BM_RisingSurface)->Iterations(1)->Unit(benchmark::kMillisecond);

void BM_Ripple(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state)
    state.counters["ripple_um"] = fidelity::ripple_m(static_cast<int>(state.range(0))) * 1e6;
}
BENCHMARK(BM_Ripple)->Arg(128)->Arg(512)->Arg(2048)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::haptics
