// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <vector>

#include "../tests/sheet_under_test.h"
#include "nazori/paint/history.h"
#include "nazori/paint/relief.h"
#include "nazori/paint/sheet_file.h"
#include "nazori/paint/sheet_picture.h"

namespace nazori::paint {
namespace {

using namespace test;

/// Five broad strokes as those of a large character, half a second each.
void write_character(Sheet& sheet, InkLoad& load) {
  const std::array<Stroke, 5> strokes{Stroke{{-0.03, 0.03}, {0.03, 0.03}}, Stroke{{0, 0.042}, {0, -0.04}},
                                      Stroke{{0, 0.03}, {-0.038, -0.02}}, Stroke{{0, 0.03}, {0.038, -0.02}},
                                      Stroke{{-0.015, -0.015}, {0.015, -0.015}}};
  for (const Stroke& stroke : strokes) write(sheet, load, stroke, [&] { sheet.step(); });
}

Sheet written(int size, const char* paper) {
  Sheet sheet = sheet_of(size, find_paper(paper).value());
  InkLoad load = full_of();
  write_character(sheet, load);
  return sheet;
}

/// The steps of ten seconds after the last stroke.
void BM_StepOfACharacter(benchmark::State& state) {
  const char* paper = state.range(1) == 0 ? "hanshi" : "gasenshi";
  const Sheet begin = written(static_cast<int>(state.range(0)), paper);
  const auto bytes = to_bytes(begin, {});
  auto saved = parse_sheet(bytes).value();
  int steps = 0;
  double awake = 0;
  for (auto _ : state) {
    saved.sheet.step({static_cast<int>(state.range(2)), true});
    awake += saved.sheet.tiles_awake();
    if (++steps % 600 != 0) continue;
    state.PauseTiming();
    saved = parse_sheet(bytes).value();
    state.ResumeTiming();
  }
  state.SetLabel(paper);
  state.counters["awake"] = awake / static_cast<double>(state.iterations());
}
BENCHMARK(BM_StepOfACharacter)
    ->Args({1024, 0, 1})
    ->Args({1024, 1, 1})
    ->Args({1024, 1, 2})
    ->Args({512, 1, 1})
    ->Iterations(600)
    ->Unit(benchmark::kMillisecond);

/// Every tile wet and flowing. Last argument: 1 where water also stands on every cell.
void BM_StepOfAFullSheet(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const bool stands = state.range(2) != 0;
  Sheet sheet = sheet_of(size, find_paper(stands ? "board" : "gasenshi").value());
  const Amount more = stands ? kOne : 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      sheet.drop(column, row, more + ((column / 4 + row / 4) % 2 == 0 ? kOne : kOne / 3), {kOne / 3, 0, 0});
  for (int i = 0; i < 10; ++i) sheet.step();
  for (auto _ : state) sheet.step({static_cast<int>(state.range(1)), true});
  state.counters["awake"] = sheet.tiles_awake();
}
BENCHMARK(BM_StepOfAFullSheet)
    ->Args({512, 1, 0})
    ->Args({1024, 1, 0})
    ->Args({1024, 1, 1})
    ->Args({1024, 2, 0})
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);

/// 400 bristles over a patch of 9 mm, moved by 0.5 mm: 120 mm/s at 240 events a second.
void BM_DepositOfAnEvent(benchmark::State& state) {
  const double speed = static_cast<double>(state.range(0)) * 1e-3;
  const double move = speed / 240;
  Sheet sheet = sheet_of(1024, find_paper("gasenshi").value());
  InkLoad load = dipped(1e-5, 1, {1, 0, 0}, {1, 0, 0}, 3e-7);
  std::vector<geometry::BristleSegment> segments;
  double x = -0.045, y = 0.04;
  for (auto _ : state) {
    state.PauseTiming();
    if (x + move > 0.045) {
      x = -0.045;
      y = y < -0.03 ? 0.04 : y - 0.01;
    }
    segments.clear();
    for (int i = 0; i < 400; ++i)
      segments.push_back(
          {{x, y + i * 9e-3 / 400}, {x + move, y + i * 9e-3 / 400}, 0.7, 0.0003, 0.008, speed, 1, 1});
    x += move;
    state.ResumeTiming();
    sheet.touch(segments, load);
  }
}
BENCHMARK(BM_DepositOfAnEvent)->Arg(50)->Arg(120)->Arg(400)->Iterations(2000)->Unit(benchmark::kMicrosecond);

void BM_PictureOfTheTilesThatChanged(benchmark::State& state) {
  Sheet sheet = written(1024, "gasenshi");
  SheetPicture picture;
  picture.update(sheet);
  double tiles = 0;
  for (auto _ : state) {
    state.PauseTiming();
    sheet.step();
    state.ResumeTiming();
    tiles += static_cast<double>(picture.update(sheet).size());
  }
  state.counters["tiles"] = tiles / static_cast<double>(state.iterations());
}
BENCHMARK(BM_PictureOfTheTilesThatChanged)->Iterations(100)->Unit(benchmark::kMillisecond);

/// A whole sheet of 1024 x 1024: 0 ink on paper, 1 two pigments, 2 over dry layers.
void BM_PictureOfAFullSheet(benchmark::State& state) {
  Sheet sheet = sheet_of(1024);
  for (int row = 0; row < 1024; ++row)
    for (int column = 0; column < 1024; ++column)
      sheet.drop(column, row, kOne, {kOne / 1024 * column, state.range(0) > 0 ? kOne / 1024 * row : 0, 0});
  if (state.range(0) == 2) {
    sheet.dry_now();
    for (int row = 0; row < 1024; ++row)
      for (int column = 0; column < 1024; ++column) sheet.drop(column, row, kOne, {0, kOne / 4, 0});
  }
  const Sheet other = sheet_of(128);
  SheetPicture picture;
  for (auto _ : state) {
    state.PauseTiming();
    picture.update(other);
    state.ResumeTiming();
    picture.update(sheet);
  }
}
BENCHMARK(BM_PictureOfAFullSheet)->Arg(0)->Arg(1)->Arg(2)->Iterations(20)->Unit(benchmark::kMillisecond);

/// Undo of the last stroke of a character while the whole character bleeds.
void BM_Undo(benchmark::State& state) {
  Sheet sheet = written(1024, "gasenshi");
  InkLoad load = full_of();
  History history;
  for (auto _ : state) {
    state.PauseTiming();
    history.remember(sheet, load);
    for (int i = 0; i < 3; ++i) sheet.step();
    state.ResumeTiming();
    history.undo(sheet, load);
  }
  state.counters["bytes"] = static_cast<double>(history.bytes());
}
BENCHMARK(BM_Undo)->Iterations(50)->Unit(benchmark::kMillisecond);

void BM_Remember(benchmark::State& state) {
  Sheet sheet = written(1024, "gasenshi");
  InkLoad load = full_of();
  History history;
  for (auto _ : state) {
    state.PauseTiming();
    sheet.step();
    state.ResumeTiming();
    history.remember(sheet, load);
  }
}
BENCHMARK(BM_Remember)->Iterations(50)->Unit(benchmark::kMillisecond);

void BM_SaveAndOpen(benchmark::State& state) {
  const Sheet sheet = written(1024, "gasenshi");
  for (auto _ : state) benchmark::DoNotOptimize(parse_sheet(to_bytes(sheet, {})));
  state.counters["bytes"] = static_cast<double>(to_bytes(sheet, {}).size());
}
BENCHMARK(BM_SaveAndOpen)->Iterations(3)->Unit(benchmark::kMillisecond);

void BM_Relief(benchmark::State& state) {
  const Sheet sheet = written(1024, "gasenshi");
  for (auto _ : state) benchmark::DoNotOptimize(relief_of(sheet));
}
BENCHMARK(BM_Relief)->Iterations(10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::paint
