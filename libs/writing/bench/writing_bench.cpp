// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/grade.h"
#include "nazori/writing/model_library.h"
#include "nazori/writing/recogniser.h"

namespace nazori::writing {
namespace {

const kanji::KanjiDatabase* database() {
  static const auto kOpened = [] {
    const char* folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe): one thread
    return kanji::KanjiDatabase::open(std::filesystem::path(folder == nullptr ? "." : folder) / "kanji.db");
  }();
  return kOpened ? &*kOpened : nullptr;
}

/// 番 and others of 12 strokes, shaken by 2 % of the box.
WrittenCharacter shaken(char32_t character) {
  std::mt19937 random(1);
  std::normal_distribution<double> deviate(0, 2.2);
  WrittenCharacter ink;
  const auto model = database()->find(character);
  for (const auto& s : model->strokes) {
    auto& stroke = ink.strokes.emplace_back();
    const double dx = deviate(random);
    const double dy = deviate(random);
    for (const auto& p : s.line.points) stroke.push_back({{p.x + dx, p.y + dy}});
  }
  return ink;
}

void BM_Grade12Strokes(benchmark::State& state) {
  if (database() == nullptr) return state.SkipWithError("NAZORI_DATA names no folder with kanji.db");
  ModelLibrary library(*database());
  const auto* entry = *library.find(U'番');
  auto ink = shaken(U'番');
  if (state.range(0) == 1) std::swap(ink.strokes[3], ink.strokes[7]);
  if (state.range(0) == 2) ink.strokes.erase(ink.strokes.begin() + 4);
  for (auto _ : state) benchmark::DoNotOptimize(grade(ink, entry->model, {}, entry->lookalikes));
}
BENCHMARK(BM_Grade12Strokes)->ArgName("mistake")->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

void BM_Recognise12Strokes(benchmark::State& state) {
  if (database() == nullptr) return state.SkipWithError("NAZORI_DATA names no folder with kanji.db");
  const auto recogniser = Recogniser::make(*database());
  const auto ink = shaken(U'番');
  for (auto _ : state) benchmark::DoNotOptimize(recogniser->recognise(ink, {10, state.range(0) == 1}));
}
BENCHMARK(BM_Recognise12Strokes)->ArgName("unfinished")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void BM_LearnAllCharacters(benchmark::State& state) {
  if (database() == nullptr) return state.SkipWithError("NAZORI_DATA names no folder with kanji.db");
  for (auto _ : state) benchmark::DoNotOptimize(Recogniser::make(*database()));
}
BENCHMARK(BM_LearnAllCharacters)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::writing
