// SPDX-License-Identifier: Apache-2.0
// Export and import of a learner of many years: time, and the most memory that is held meanwhile.
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "../tests/big_learner.h"
#include "nazori/base/file.h"

namespace nazori::study {
namespace {

namespace fs = std::filesystem;

/// A field of /proc/self/status in MiB.
double memory_mib(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kib = 0;
    if (word == name && status >> kib) return kib / 1024;
  }
  return -1;
}

/// Resets the peak to the present value.
void forget_peak() {
  (void)::malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

/// A learner with this many entries, made at the first call and kept for the whole run.
class Learner {
 public:
  Learner() : folder_(fs::temp_directory_path() / ("nazori-exchange-bench-" + std::to_string(::getpid()))) {}
  ~Learner() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Learner(const Learner&) = delete;
  Learner& operator=(const Learner&) = delete;

  LearnerStore open(std::int64_t entries) {
    const fs::path file = folder_ / std::to_string(entries) / "learner.db";
    auto store = LearnerStore::open(file, Access::write);
    if (!store) std::abort();
    test::BigLearner big(entries);
    if (store->last_entry() == 0 && !import_json(*store, big.json())) std::abort();
    return *std::move(store);
  }
  [[nodiscard]] fs::path empty_file() const {
    std::error_code ignored;
    fs::remove_all(folder_ / "import", ignored);
    return folder_ / "import" / "learner.db";
  }
  [[nodiscard]] fs::path text_file() const { return folder_ / "out"; }

 private:
  fs::path folder_;
};

Learner& learner() {
  static Learner one;
  return one;
}

using Export = base::Result<void> (*)(const LearnerStore&, const TextSink&, const base::Progress&);

void export_to_file(benchmark::State& state, Export write) {
  const LearnerStore store = learner().open(state.range(0));
  for ([[maybe_unused]] auto _ : state) {
    forget_peak();
    auto file = base::OutputFile::create(learner().text_file());
    const auto append = [&file](std::string_view piece) { return file->append(piece); };
    if (!file || !write(store, append, {}) || !file->commit()) state.SkipWithError("not written");
    state.counters["peak_MiB"] = memory_mib("VmHWM:");
  }
}

void import(benchmark::State& state) {
  test::BigLearner big(state.range(0));
  for ([[maybe_unused]] auto _ : state) {
    auto store = LearnerStore::open(learner().empty_file(), Access::write);
    forget_peak();
    if (!store || !import_json(*store, big.json())) state.SkipWithError("not read");
    state.counters["peak_MiB"] = memory_mib("VmHWM:");
  }
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Arg(19'000)->Arg(98'000)->Arg(296'000)->Iterations(1)->Unit(benchmark::kMillisecond);
}

BENCHMARK(import)->Apply(sizes);
BENCHMARK_CAPTURE(export_to_file, json, Export(export_json))->Apply(sizes);
BENCHMARK_CAPTURE(export_to_file, csv, Export(export_csv))->Apply(sizes);

}  // namespace
}  // namespace nazori::study
