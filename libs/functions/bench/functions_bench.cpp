// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "nazori/functions/plate.h"

namespace {

using namespace nazori::functions;  // NOLINT

struct Case {
  const char* expression;
  Window window;
};
const Case kCases[] = {{"y = tan(x)", {-6, 6, -4, 4}},
                       {"y = sin(1/x)", {-1, 1, -1.5, 1.5}},
                       {"y = sin(100x)", {-10, 10, -2, 2}},
                       {"x^2 + y^2 = 1", {-2, 2, -2, 2}},
                       {"sin(x^2+y^2) = cos(xy)", {-5, 5, -5, 5}},
                       {"x/sin(x) + y/sin(y) = x*y/sin(x*y)", {-10, 10, -10, 10}}};

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
  for (auto _ : state) benchmark::DoNotOptimize(draw(*plot, c.window, settings));
  state.SetLabel(c.expression);
}
BENCHMARK(BM_Draw)->ArgsProduct({{0, 1, 2, 3, 4, 5}, {128, 256, 1024}})->Unit(benchmark::kMillisecond);

void BM_Parse(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(parse("y = 2sin^2 x + sqrt(|x|) - e^-x^2 / (1 + x^2)"));
}
BENCHMARK(BM_Parse);

}  // namespace
