// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "nazori/carving/carve.h"
#include "nazori/geometry/svg_path.h"
#include "nazori/kanji/kanji_database.h"
#include "test_paths.h"

namespace nazori::carving {
namespace {

std::vector<kanji::StrokeLine> fixture(const std::string& character) {
  std::ifstream file(std::string(test_paths::kFixtures) + "/kanjivg.tsv");
  std::vector<kanji::StrokeLine> strokes;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string column[5];
    for (std::string& text : column) std::getline(fields, text, '\t');
    if (column[0] != character) continue;
    const auto path = geometry::parse_svg_path(column[4]);
    if (!path) continue;
    strokes.push_back({geometry::flatten(*path, 0.05),
                       column[3] == "hook"    ? kanji::StrokeEnding::hook
                       : column[3] == "taper" ? kanji::StrokeEnding::taper
                                              : kanji::StrokeEnding::stop,
                       {}});
  }
  return strokes;
}

void carve_one(benchmark::State& state, const std::string& character) {
  const auto strokes = fixture(character);
  if (strokes.empty()) return state.SkipWithError("no fixture");
  for (auto _ : state) benchmark::DoNotOptimize(carve(strokes, static_cast<int>(state.range(0))));
  state.SetItemsProcessed(state.iterations());
}

/// 休, 6 strokes. Budget: 1 ms at 128, 25 ms at 1024.
void BM_CarveKyuu(benchmark::State& state) { carve_one(state, "休"); }
BENCHMARK(BM_CarveKyuu)->Arg(128)->Arg(512)->Arg(1024)->Arg(8192)->Unit(benchmark::kMillisecond);

/// 鬱, 29 strokes. Budget: 1 ms at 128, 25 ms at 1024.
void BM_CarveUtsu(benchmark::State& state) { carve_one(state, "鬱"); }
BENCHMARK(BM_CarveUtsu)->Arg(128)->Arg(512)->Arg(1024)->Arg(8192)->Unit(benchmark::kMillisecond);

/// All 2,136 jouyou kanji at 128 samples a side. Budget: 2 s.
void BM_CarveAllJouyou(benchmark::State& state) {
  const char* folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe)
  if (folder == nullptr) return state.SkipWithError("NAZORI_DATA names no folder with kanji.db");
  auto database = kanji::KanjiDatabase::open(std::filesystem::path(folder) / "kanji.db");
  if (!database) return state.SkipWithError("kanji.db cannot be opened");
  std::vector<std::vector<kanji::StrokeLine>> characters;
  using enum kanji::List;
  for (const kanji::List list : {grade_1, grade_2, grade_3, grade_4, grade_5, grade_6, secondary}) {
    for (const kanji::Summary& summary : database->list(list)) {
      if (const auto character = database->find(summary.code_point)) characters.push_back(character->lines());
    }
  }
  for (auto _ : state)
    for (const auto& strokes : characters) benchmark::DoNotOptimize(carve(strokes, 128));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(characters.size()));
  state.counters["characters"] = static_cast<double>(characters.size());
}
BENCHMARK(BM_CarveAllJouyou)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::carving
