// SPDX-License-Identifier: Apache-2.0
// Budgets: a look-up by character under 1 ms, any search under 20 ms.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "nazori/kanji/kanji_database.h"
#include "nazori/kanji/part_picker.h"
#include "nazori/kanji/query_text.h"

namespace nazori::kanji {
namespace {

std::filesystem::path database_path() {
  const char* const folder = std::getenv("NAZORI_DATA");  // NOLINT(concurrency-mt-unsafe)
  return std::filesystem::path(folder == nullptr ? "build/data" : folder) / "kanji.db";
}

/// Runs `work` on the database until there are enough measurements.
template <class Work>
void measure(benchmark::State& state, Work work) {
  const auto database = KanjiDatabase::open(database_path());
  if (!database) {
    state.SkipWithError(base::to_line(database.error()).c_str());
    return;
  }
  for (auto step : state) {
    (void)step;
    benchmark::DoNotOptimize(work(*database));
  }
}

void BM_Open(benchmark::State& state) {
  for (auto step : state) {
    (void)step;
    benchmark::DoNotOptimize(KanjiDatabase::open(database_path()));
  }
}
BENCHMARK(BM_Open)->Unit(benchmark::kMillisecond);

void BM_Find(benchmark::State& state, char32_t character) {
  measure(state, [&](const KanjiDatabase& database) { return database.find(character); });
}
BENCHMARK_CAPTURE(BM_Find, rest_6_strokes, U'休')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Find, melancholy_29_strokes, U'鬱')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Find, life_many_readings, U'生')->Unit(benchmark::kMicrosecond);

void BM_Search(benchmark::State& state, const char* text) {
  measure(state, [&](const KanjiDatabase& database) {
    Query query;
    query.text = text;
    return database.search(query);
  });
}
BENCHMARK_CAPTURE(BM_Search, character, "休")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Search, romaji, "kyuu")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Search, kana, "やす")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Search, english, "rest")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Search, one_letter_s, "s")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Search, one_letter_n, "n")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Search, one_kana, "し")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Search, everything, "")->Unit(benchmark::kMicrosecond);

/// What a key costs while a search is typed: characters with their reasons, and words.
void BM_Key(benchmark::State& state, const char* text) {
  measure(state, [&](const KanjiDatabase& database) {
    const Query query = read_query(text).query;
    return std::pair(database.matches(query), database.search_words(query.text, 12));
  });
}
BENCHMARK_CAPTURE(BM_Key, one_letter_s, "s")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, three_letters, "sho")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, three_letters_of_meanings, "con")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, one_kana, "し")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, two_kana, "しょ")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, word_in_romaji, "kyuujitsu")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, word_in_english, "holiday")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, skip, "1-2-4")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, beginning_of_skip, "skip:1")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, four_corner, "2429")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, parts, "parts:口日")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Key, strokes, "strokes:8-12")->Unit(benchmark::kMicrosecond);

void BM_TableOfParts(benchmark::State& state) {
  measure(state, [](const KanjiDatabase& database) { return database.parts(15); });
}
BENCHMARK(BM_TableOfParts)->Unit(benchmark::kMillisecond);

void BM_ChoosePart(benchmark::State& state) {
  const auto database = KanjiDatabase::open(database_path());
  if (!database) {
    state.SkipWithError(base::to_line(database.error()).c_str());
    return;
  }
  const PartPicker picker(database->parts(15));
  for (auto step : state) {
    (void)step;
    benchmark::DoNotOptimize(picker.choose({"口"}));
  }
}
BENCHMARK(BM_ChoosePart)->Unit(benchmark::kMicrosecond);

void BM_SearchWholeDictionary(benchmark::State& state) {
  measure(state, [](const KanjiDatabase& database) {
    Query query;
    query.drawn_only = false;
    query.limit = 20'000;
    return database.search(query);
  });
}
BENCHMARK(BM_SearchWholeDictionary)->Unit(benchmark::kMillisecond);

void BM_ListAll(benchmark::State& state) {
  measure(state, [](const KanjiDatabase& database) { return database.list(List::all); });
}
BENCHMARK(BM_ListAll)->Unit(benchmark::kMillisecond);

void BM_Words(benchmark::State& state) {
  measure(state, [](const KanjiDatabase& database) { return database.words(U'日', 20); });
}
BENCHMARK(BM_Words)->Unit(benchmark::kMicrosecond);

void BM_Containing(benchmark::State& state) {
  measure(state, [](const KanjiDatabase& database) { return database.containing("口", 500); });
}
BENCHMARK(BM_Containing)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace nazori::kanji
