// SPDX-License-Identifier: Apache-2.0
// Cost of a servo tick. The budget of a tick at 1 kHz is 1,000,000 ns.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <ctime>
#include <map>
#include <stdexcept>
#include <vector>

#include "nazori/haptics/servo.h"
#include "nazori/haptics/surface_contact.h"
#include "nazori/surface/ball_surface.h"
#include "workload.h"

namespace nazori::haptics {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kTicks = 200'000;
constexpr std::size_t kPasses = 9;

/// CPU time of this thread, so that other work on the machine does not count.
double cpu_s() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Work {
  explicit Work(int size) {
    const workload::Kanji kanji = workload::make_kanji(size);
    const auto t = workload::trace(kanji, kTicks), s = workload::sweep(kanji, kTicks),
               c = workload::scribble(kanji, kTicks);
    const std::vector<std::uint64_t> found{workload::checksum(kanji), workload::checksum(t),
                                           workload::checksum(s), workload::checksum(c)};
    const std::map<int, std::vector<std::uint64_t>> agreed{
        {128, {0xb19ad546c7ced0a7, 0x4a4aac82dfc69037, 0x74094b2f65ce5153, 0xe62d3d094f4a1d9c}},
        {2048, {0x5dff4e08a5c89bab, 0x99cf730f121b9437, 0x6065b925642f5b40, 0x75bf7ad5650879bb}}};
    if (agreed.at(size) != found) throw std::runtime_error("the workload's checksums do not agree");
    map = workload::height_map(kanji);
    smooth = *surface::SmoothSurface::create(map);
    tablet = TabletSurface(*smooth, workload::shape());
    paths = {workload::to_metres(t), workload::to_metres(s), workload::to_metres(c)};
  }
  static const Work& of(int size) {
    static std::map<int, Work> made;
    const auto at = made.find(size);
    return at != made.end() ? at->second : made.emplace(size, Work(size)).first->second;
  }
  surface::HeightMap map;
  std::shared_ptr<const surface::SmoothSurface> smooth;
  TabletSurface tablet;
  std::vector<std::vector<Vec3>> paths;  // trace, sweep, scribble
};

double quantile(std::vector<double>& values, double q) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Runs `tick(i)` over the path, timed as a whole (the best mean, including the work in between) and kPasses
/// times tick by tick. Every pass does the same work in the same order. For each tick the median of its
/// passes counts, less the cost of the clock, so that a short interruption by other work does not count.
template <class Reset, class Tick, class Between>
void measure(benchmark::State& state, Reset reset, Tick tick, Between between) {
  double best = 1e9;
  for ([[maybe_unused]] auto _ : state) {
    reset();
    const double begin = cpu_s();
    for (std::size_t i = 0; i < kTicks; ++i) {
      tick(i);
      between(i);
    }
    best = std::min(best, cpu_s() - begin);
  }
  std::vector<double> ns(kTicks);
  for (double& n : ns) {
    const auto begin = Clock::now();
    n = std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
  }
  const double empty = quantile(ns, 0.5);
  std::vector<std::array<float, kPasses>> passes(kTicks);
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    reset();
    for (std::size_t i = 0; i < kTicks; ++i) {
      const auto begin = Clock::now();
      tick(i);
      passes[i][pass] = std::chrono::duration<float, std::nano>(Clock::now() - begin).count();
      between(i);
    }
  }
  for (std::size_t i = 0; i < kTicks; ++i) {
    std::sort(passes[i].begin(), passes[i].end());
    ns[i] = static_cast<double>(passes[i][kPasses / 2]) - empty;
  }
  state.counters["mean_ns"] = best / kTicks * 1e9;
  state.counters["p99_ns"] = quantile(ns, 0.99);
  state.counters["p99.9_ns"] = quantile(ns, 0.999);
  state.counters["max_ns"] = quantile(ns, 1);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kTicks));
}

// Contact alone: proxy and force direction. Arguments: map size, path (0 trace, 1 sweep, 2 scribble),
// friction.
void BM_SurfaceContact(benchmark::State& state) {
  const Work& work = Work::of(static_cast<int>(state.range(0)));
  const std::vector<Vec3>& path = work.paths[static_cast<std::size_t>(state.range(1))];
  const Friction friction = state.range(2) != 0 ? Friction{0.3, 0.2} : Friction{};
  SurfaceContact contact;
  measure(
      state, [&] { contact = SurfaceContact(); },
      [&](std::size_t i) {
        contact.update(work.tablet, path[i], friction);
        benchmark::DoNotOptimize(contact.proxy_m());
      },
      [](std::size_t) {});
}
BENCHMARK(BM_SurfaceContact)
    ->ArgsProduct({{128, 2048}, {0, 1, 2}, {0, 1}})
    ->ArgNames({"size", "path", "friction"})
    ->Unit(benchmark::kMillisecond);

/// Contact of a ball beside that of a point in the same run: the ball's own surface, and the hand as deep
/// below it as it is below the map in the workload. Arguments: map size, path, tenths of a millimetre of the
/// radius; 0 is the point.
void BM_BallContact(benchmark::State& state) {
  const Work& work = Work::of(static_cast<int>(state.range(0)));
  const auto felt =
      *surface::surface_for_ball(work.map, workload::shape(), 1e-4 * static_cast<double>(state.range(2)));
  const TabletSurface tablet(*felt, workload::shape());
  std::vector<Vec3> path = work.paths[static_cast<std::size_t>(state.range(1))];
  for (Vec3& p : path) p.z += tablet.height(p.x, p.y) - work.tablet.height(p.x, p.y);
  SurfaceContact contact;
  measure(
      state, [&] { contact = SurfaceContact(); },
      [&](std::size_t i) {
        contact.update(tablet, path[i], Friction{});
        benchmark::DoNotOptimize(contact.proxy_m());
      },
      [](std::size_t) {});
}
BENCHMARK(BM_BallContact)
    ->ArgsProduct({{128, 2048}, {0, 1, 2}, {0, 10, 30}})
    ->ArgNames({"size", "path", "tenths_mm"})
    ->Unit(benchmark::kMillisecond);

/// The strokes of the workload's kanji in metres, at the floor of their grooves.
std::vector<StrokePath> strokes() {
  std::vector<StrokePath> made;
  for (const auto& line : workload::centre_lines()) {
    StrokePath path;
    for (const Vec3& p : workload::to_metres(line)) path.points.push_back(p);
    made.push_back(std::move(path));
  }
  return made;
}

/// Everything a tick does at once: contact with friction, the strokes, passivity, limits, recording, and
/// every 1,000 ticks a new scene on another copy of the surface, which is not yet in the cache. Last
/// argument: 0 no help, 1 snapping to all strokes, 2 a lesson.
void BM_ServoTick(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const Work& work = Work::of(size);
  const std::vector<Vec3>& path = work.paths[static_cast<std::size_t>(state.range(1))];
  auto scene = std::make_shared<HapticScene>();
  scene->surface = work.smooth;
  scene->shape = workload::shape();
  scene->material.static_friction = 0.25;
  scene->material.dynamic_friction = 0.2;
  if (state.range(2) != 0) scene->strokes = strokes();
  scene->snapping.enabled = state.range(2) == 1;
  scene->snapping.snap_distance_m = 0.004;
  if (state.range(2) == 2) scene->guiding.mode = GuidingMode::lesson;
  auto other = std::make_shared<HapticScene>(*scene);
  other->surface = *surface::SmoothSurface::create(work.map);
  std::unique_ptr<Servo> servo;
  std::vector<ServoSample> taken(1000);
  std::vector<std::byte> record(taken.size() * sizeof(ServoSample));
  measure(
      state,
      [&] {
        servo = std::make_unique<Servo>(DeviceDescription{});
        servo->set_scene(scene);
      },
      [&](std::size_t i) {
        const DeviceSample sample{static_cast<double>(i) * 0.001, path[i], 0, true};
        benchmark::DoNotOptimize(servo->tick(sample));
      },
      [&](std::size_t i) {  // the work of other threads: not part of the servo's time
        if (i % 500 == 499) {
          const std::size_t count = servo->take_samples(taken);
          std::memcpy(record.data(), taken.data(), count * sizeof(ServoSample));
          benchmark::DoNotOptimize(record.data());
        }
        if (i % 1000 == 999) servo->set_scene(i / 1000 % 2 == 0 ? other : scene);
      });
}
BENCHMARK(BM_ServoTick)
    ->ArgsProduct({{128, 2048}, {0, 1, 2}, {0, 1, 2}})
    ->ArgNames({"size", "path", "help"})
    ->Unit(benchmark::kMillisecond);

/// Bytes that are allocated now.
std::size_t allocated() {
  const auto now = mallinfo2();
  return now.uordblks + now.hblkhd;
}

// From an existing height map to a scene with strokes that was passed to the servo.
void BM_ReadyToTouch(benchmark::State& state) {
  const Work& work = Work::of(static_cast<int>(state.range(0)));
  const std::vector<StrokePath> lines = strokes();
  Servo servo{DeviceDescription{}};
  const std::size_t before = allocated();
  std::size_t most = 0;
  for ([[maybe_unused]] auto _ : state) {
    auto scene = std::make_shared<HapticScene>();
    scene->surface = *surface::SmoothSurface::create(work.map);
    scene->shape = workload::shape();
    scene->strokes = lines;
    scene->snapping.enabled = true;
    servo.set_scene(std::move(scene));
    (void)servo.tick({0, Vec3(0), 0, true});  // adopts it, so that the previous one is freed
    most = std::max(most, allocated() - before);
  }
  // The current scene and the previous one, which lives until the next scene is passed to the servo.
  state.counters["MiB"] = static_cast<double>(most) / (1 << 20);
}
BENCHMARK(BM_ReadyToTouch)->Arg(128)->Arg(2048)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nazori::haptics
