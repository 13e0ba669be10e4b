// SPDX-License-Identifier: Apache-2.0
// How long a solid model takes, beside the grid of samples with two triangles a cell that it replaces.
#include <benchmark/benchmark.h>

#include <cmath>

#include "nazori/model/mesh.h"
#include "nazori/model/mesh_file.h"

namespace nazori::model {
namespace {

/// Raised rings, one in the other: as many lines as a character of twenty strokes has.
Plate rings(double size_mm) {
  Plate plate = Plate::create(size_mm, size_mm, 0.125, 3).value();
  for (int ring = 1; ring <= 6; ++ring) {
    PlateLine line;
    for (int i = 0; i <= 120; ++i) {
      const double angle = i * 3.14159265358979 / 60;
      line.push_back({size_mm / 2 + ring * 7 * std::cos(angle), size_mm / 2 + ring * 7 * std::sin(angle)});
    }
    plate.add_line(line, {});
  }
  return plate;
}

void BM_Mesh(benchmark::State& state) {
  const Plate plate = rings(100);
  for (auto _ : state) {
    const auto made = mesh_of(plate, {0.02, 99'000});
    state.counters["triangles"] = static_cast<double>(made->mesh.triangles.size());
    state.counters["error_um"] = made->error_mm * 1000;
    state.counters["of_the_grid"] =
        static_cast<double>(made->mesh.triangles.size()) / (2.0 * (plate.columns() - 1) * (plate.rows() - 1));
  }
}
BENCHMARK(BM_Mesh)->Unit(benchmark::kMillisecond);

void BM_Stl(benchmark::State& state) {
  const Mesh mesh = mesh_of(rings(100), {0.02, 99'000}).value().mesh;
  for (auto _ : state) state.counters["bytes"] = static_cast<double>(to_stl(mesh).size());
}
BENCHMARK(BM_Stl)->Unit(benchmark::kMillisecond);

void BM_ThreeMf(benchmark::State& state) {
  const Mesh mesh = mesh_of(rings(100), {0.02, 99'000}).value().mesh;
  for (auto _ : state) state.counters["bytes"] = static_cast<double>(to_3mf(mesh, "rings")->size());
}
BENCHMARK(BM_ThreeMf)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::model
