// SPDX-License-Identifier: Apache-2.0
// How long a booklet of 80 characters takes, and a sheet for each of the 2,136 characters in daily use.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>

#include "nazori/kanji/kanji_database.h"
#include "nazori/print/worksheet.h"

namespace nazori::print {
namespace {

std::vector<SheetCharacter> daily(std::size_t most) {
  const auto path = kanji::KanjiDatabase::locate();
  const auto database = kanji::KanjiDatabase::open(path.value());
  std::vector<SheetCharacter> all;
  for (const auto list :
       {kanji::List::grade_1, kanji::List::grade_2, kanji::List::grade_3, kanji::List::grade_4,
        kanji::List::grade_5, kanji::List::grade_6, kanji::List::secondary}) {
    for (const kanji::Summary& one : database->list(list)) {
      if (all.size() < most)
        all.push_back({database->find(one.code_point).value(), database->words(one.code_point, 3)});
    }
  }
  return all;
}

void BM_Sheets(benchmark::State& state) {
  const auto characters = daily(static_cast<std::size_t>(state.range(0)));
  SheetSettings settings;
  settings.whole_page = true;
  settings.cell_mm = 22;
  for (auto _ : state)
    state.counters["bytes"] = static_cast<double>(worksheet_pdf(characters, settings)->size());
  state.counters["sheets"] = static_cast<double>(characters.size());
}
BENCHMARK(BM_Sheets)->Arg(80)->Arg(2136)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::print
