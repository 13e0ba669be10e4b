// SPDX-License-Identifier: Apache-2.0
// Cost of a brush: one report of a pen with 400 bristles, one move of the spine, one tick of the force, one
// table.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "nazori/brush/force_table.h"
#include "nazori/brush/tuft.h"
#include "nazori/haptics/soft_contact.h"

namespace nazori::brush {
namespace {

// A report of a pen on a circle of 30 mm at 0.2 m/s, the pressure rising and falling. Argument: reports a
// second.
void BM_PenReport(benchmark::State& state) {
  const double per_s = static_cast<double>(state.range(0));
  Tuft tuft(*tuft_form(4));
  std::vector<geometry::BristleSegment> swept;
  double i = 0, bands = 0;
  for ([[maybe_unused]] auto _ : state) {
    swept.clear();
    const double way = 0.2 * i / per_s;
    HolderPose pose;
    pose.time_s = i / per_s;
    pose.at = {0.03 * std::cos(way / 0.03), 0.03 * std::sin(way / 0.03)};
    pose.depth_m = 0.012 + 0.004 * std::sin(50 * way);
    pose.lean_rad = 0.2;
    tuft.move_to(pose, swept);
    benchmark::DoNotOptimize(swept.data());
    bands += static_cast<double>(swept.size());
    ++i;
  }
  state.counters["bands"] = bands / i;
}
BENCHMARK(BM_PenReport)->Arg(60)->Arg(240)->Arg(1000)->Unit(benchmark::kMicrosecond);

// One step of 0.25 mm of a dragged spine.
void BM_SpineStep(benchmark::State& state) {
  const TuftForm form = *tuft_form(4);
  Spine spine(form.spine, form.friction(1));
  spine.place({{0, 0.8}, 0.1});
  double i = 0;
  for ([[maybe_unused]] auto _ : state) {
    spine.move_to({{-0.005 * i, 0.75 + 0.1 * std::sin(0.02 * i)}, 0.1});
    benchmark::DoNotOptimize(spine.push());
    ++i;
  }
}
BENCHMARK(BM_SpineStep)->Unit(benchmark::kMicrosecond);

void BM_ForceTable(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const ForceTable table(*tuft_form(4));
    benchmark::DoNotOptimize(table.push_n(0.01, 0.2));
  }
}
BENCHMARK(BM_ForceTable)->Unit(benchmark::kMillisecond);

// What the force of a brush adds to a tick.
void BM_ForceTick(benchmark::State& state) {
  const ForceTable table(*tuft_form(4));
  const haptics::SoftTipTable tip(soft_tip(table, 0.2, 1, Feel::strengthened), 500, 3.3);
  constexpr std::size_t kTicks = 4096;
  std::vector<haptics::Vec3> path;
  for (std::size_t i = 0; i < kTicks; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / kTicks;
    path.emplace_back(0.03 * std::cos(turn), 0.03 * std::sin(2 * turn), -0.010 + 0.012 * std::sin(5 * turn));
  }
  haptics::SoftContact contact;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    contact.update(tip, path[i++ % kTicks]);
    benchmark::DoNotOptimize(contact.force_n());
  }
}
BENCHMARK(BM_ForceTick);

}  // namespace
}  // namespace nazori::brush
