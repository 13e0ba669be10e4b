// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <vector>

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

/// The model's strokes, each shaken by 2 % of the box.
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

enum class Fault { none, missing, extra, exchanged, reversed, joined, moved, replaced, scribble };
constexpr std::array kFaults{"right",  "missing", "extra",    "exchanged", "reversed",
                             "joined", "moved",   "replaced", "scribble"};

WrittenStroke moved(WrittenStroke stroke, double right, double down) {
  for (auto& p : stroke) p.at = {p.at.x + right, p.at.y + down};
  return stroke;
}

/// A stroke that belongs to no character.
WrittenStroke strange(std::mt19937& random) {
  std::uniform_real_distribution<double> anywhere(0, 109);
  WrittenStroke stroke;
  for (int k = 0; k < 5; ++k) stroke.push_back({{anywhere(random), anywhere(random)}});
  return stroke;
}

/// The writing with one fault at a place of chance.
WrittenCharacter spoiled(WrittenCharacter ink, Fault fault, std::mt19937& random) {
  auto& strokes = ink.strokes;
  const std::size_t k = random() % strokes.size();
  const auto at = strokes.begin() + static_cast<std::ptrdiff_t>(k);
  const bool is_last = k + 1 == strokes.size();
  if (fault == Fault::missing && strokes.size() > 1) strokes.erase(at);
  if (fault == Fault::extra) strokes.insert(at, strange(random));
  if (fault == Fault::exchanged) std::swap(*at, strokes[random() % strokes.size()]);
  if (fault == Fault::reversed) std::reverse(at->begin(), at->end());
  if (fault == Fault::joined && !is_last) {
    at->insert(at->end(), (at + 1)->begin(), (at + 1)->end());
    strokes.erase(at + 1);
  }
  if (fault == Fault::moved) *at = moved(*at, 40, -30);
  if (fault == Fault::replaced) *at = strange(random);
  if (fault == Fault::scribble)
    for (auto& stroke : strokes) stroke = strange(random);
  return ink;
}

/// Grades of 集 (12 strokes) and 鬱 (29), with each fault at eight places.
void BM_Grade(benchmark::State& state) {
  if (database() == nullptr) return state.SkipWithError("NAZORI_DATA names no folder with kanji.db");
  ModelLibrary library(*database());
  const char32_t character = state.range(0) == 12 ? U'集' : U'鬱';
  const auto* entry = *library.find(character);
  const auto fault = static_cast<Fault>(state.range(1));
  std::mt19937 random(1);
  std::vector<WrittenCharacter> writings;
  for (int k = 0; k < 8; ++k) writings.push_back(spoiled(shaken(character), fault, random));
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(grade(writings[next++ % writings.size()], entry->model, {}, entry->lookalikes));
  state.SetLabel(kFaults.at(static_cast<std::size_t>(fault)));
}
BENCHMARK(BM_Grade)
    ->ArgNames({"strokes", "fault"})
    ->ArgsProduct({{12, 29}, benchmark::CreateDenseRange(0, kFaults.size() - 1, 1)})
    ->Unit(benchmark::kMillisecond);

double milliseconds_of_processor_time() { return 1000 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Each character of the Jōyō list with one random fault; the least of three times.
void BM_GradeAnyJoyo(benchmark::State& state) {
  if (database() == nullptr) return state.SkipWithError("NAZORI_DATA names no folder with kanji.db");
  ModelLibrary library(*database());
  std::vector<double> times;
  for (auto _ : state) {
    times.clear();
    std::mt19937 random(1);
    for (const auto list :
         {kanji::List::grade_1, kanji::List::grade_2, kanji::List::grade_3, kanji::List::grade_4,
          kanji::List::grade_5, kanji::List::grade_6, kanji::List::secondary}) {
      for (const auto& summary : database()->list(list)) {
        const auto* entry = *library.find(summary.code_point);
        const auto fault = static_cast<Fault>(random() % kFaults.size());
        const auto ink = spoiled(shaken(summary.code_point), fault, random);
        double least = 1e9;
        for (int k = 0; k < 3; ++k) {
          const double start = milliseconds_of_processor_time();
          benchmark::DoNotOptimize(grade(ink, entry->model, {}, entry->lookalikes));
          least = std::min(least, milliseconds_of_processor_time() - start);
        }
        times.push_back(least);
      }
    }
  }
  std::sort(times.begin(), times.end());
  const auto at = [&times](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  state.counters["median_ms"] = at(0.5);
  state.counters["of_99_in_100_ms"] = at(0.99);
  state.counters["most_ms"] = at(1);
}
BENCHMARK(BM_GradeAnyJoyo)->Unit(benchmark::kMillisecond)->Iterations(1);

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
