// SPDX-License-Identifier: Apache-2.0
// What a learner with a long history waits for. The argument is the number of entries of the log.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <map>
#include <vector>

#include "../tests/learner_fixture.h"
#include "nazori/study/day_plan.h"

namespace nazori::study {
namespace {

using test::must;

/// A store on disk, made once per number of entries.
struct History {
  explicit History(int entries) : file(folder / "learner.db") {
    auto store = must(LearnerStore::open(file, Access::write, clock.clock()));
    if (!store.fill(test::long_history(entries))) std::abort();
  }
  [[nodiscard]] LearnerStore open() const {
    return must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later));
  }
  test::TemporaryFolder folder;
  test::MovedClock clock{"2041-06-01T09:00:00Z"};
  std::filesystem::path file;
};

const History& history(int entries) {
  static std::map<int, History> all;
  return all.try_emplace(entries, entries).first->second;
}

void opening(benchmark::State& state) {
  const History& long_one = history(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(long_one.open());
}

void step_and_undo(benchmark::State& state) {
  LearnerStore store = history(static_cast<int>(state.range(0))).open();
  for (auto _ : state) {
    (void)must(store.add_writing(U'一', 8, test::review(Rating::good)));
    (void)must(store.undo());
  }
}

void plan(benchmark::State& state) {
  const LearnerStore store = history(static_cast<int>(state.range(0))).open();
  for (auto _ : state) benchmark::DoNotOptimize(must(plan_day(store, {})));
}

const std::vector<std::int64_t> kLengths{300, 3'000, 30'000, 300'000};
BENCHMARK(opening)->ArgsProduct({kLengths})->Unit(benchmark::kMillisecond);
BENCHMARK(step_and_undo)->ArgsProduct({kLengths})->Unit(benchmark::kMillisecond);
BENCHMARK(plan)->ArgsProduct({kLengths})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::study
