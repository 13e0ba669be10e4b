// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>

#include "nazori/author/character_editor.h"
#include "nazori/author/character_file.h"
#include "nazori/author/check.h"

namespace nazori::author {
namespace {

/// Twelve strokes in the box of a character.
OwnCharacter twelve_strokes() {
  std::vector<kanji::StrokeLine> lines;
  for (int i = 0; i < 6; ++i) {
    const double at = 15 + 16 * i;
    lines.push_back({{{10, at}, {50, at + 2}, {98, at}}, kanji::StrokeEnding::stop, {}});
    lines.push_back({{{at, 10}, {at - 2, 60}, {at - 8, 98}}, kanji::StrokeEnding::taper, {}});
  }
  return from_strokes(own_strokes(lines));
}

CharacterEditor editor() { return *CharacterEditor::create(twelve_strokes()); }

/// A point is dragged: its stroke is carved again in 1024 x 1024 samples.
void drag_point(benchmark::State& state) {
  CharacterEditor edited = editor();
  double y = 0;
  for (auto _ : state) {
    y = y > 5 ? 0 : y + 0.1;
    benchmark::DoNotOptimize(edited.move_point(4, 1, {50, 49 + y}, true));
  }
}
BENCHMARK(drag_point)->Unit(benchmark::kMillisecond);

/// A groove of 40 glyph units is cut by hand, and undone.
void cut_and_undo(benchmark::State& state) {
  CharacterEditor edited = editor();
  for (auto _ : state) {
    benchmark::DoNotOptimize(edited.use_tool(ReliefTool::groove, {}, {{.at = {30, 40}}, {.at = {70, 44}}}));
    (void)edited.undo();
  }
}
BENCHMARK(cut_and_undo)->Unit(benchmark::kMillisecond);

void carve_whole(benchmark::State& state) {
  const OwnCharacter character = twelve_strokes();
  for (auto _ : state) benchmark::DoNotOptimize(carve(character, kMapSize));
}
BENCHMARK(carve_whole)->Unit(benchmark::kMillisecond);

void check_character(benchmark::State& state) {
  const OwnCharacter character = twelve_strokes();
  for (auto _ : state) benchmark::DoNotOptimize(check(character));
}
BENCHMARK(check_character)->Unit(benchmark::kMillisecond);

/// A document with a relief by hand is written and read.
void save_and_open(benchmark::State& state) {
  CharacterEditor edited = editor();
  (void)edited.use_tool(ReliefTool::groove, {}, {{.at = {30, 40}}, {.at = {70, 44}}});
  for (auto _ : state) {
    const auto bytes = to_bytes(edited.character());
    benchmark::DoNotOptimize(parse_character(*bytes));
  }
}
BENCHMARK(save_and_open)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::author
