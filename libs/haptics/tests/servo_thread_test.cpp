// SPDX-License-Identifier: Apache-2.0
// Hand-over between threads; the thread sanitizer watches these.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <thread>
#include <vector>

#include "nazori/haptics/latest_value.h"
#include "nazori/haptics/sample_ring.h"
#include "nazori/haptics/servo.h"
#include "relief.h"

namespace nazori::haptics {
namespace {

TEST(LatestValue, NeverTearsAndNeverGoesBackUnderContention) {
  struct Pair {
    std::uint64_t a, b;
  };
  LatestValue<Pair> value{{0, 0}};
  constexpr std::uint64_t kLast = 200'000;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kLast; ++i) {
      value.back() = {i, ~i};
      value.publish();
    }
  });
  std::uint64_t before = 0;
  while (before < kLast) {
    const Pair p = value.latest();
    if (p.a == 0) continue;
    ASSERT_EQ(p.b, ~p.a);
    ASSERT_GE(p.a, before);
    before = p.a;
  }
  writer.join();
}

TEST(LatestValue, ReadsTheInitialValueBeforeAnyIsPublished) {
  LatestValue<int> value{7};
  EXPECT_EQ(value.latest(), 7);
  value.back() = 8;
  EXPECT_EQ(value.latest(), 7);
  value.publish();
  EXPECT_EQ(value.latest(), 8);
}

TEST(Servo, ScenesAreHandedOverWholeAndFreedByTheInterface) {
  Servo servo{DeviceDescription{}};
  std::atomic<bool> stop{false};
  std::atomic<bool> below{false};
  std::thread device([&] {
    double time_s = 0;
    for (int i = 0; !stop; ++i) {
      time_s += 0.001;
      const Vec3 force = servo.tick({time_s, {0.02 * std::sin(0.01 * i), 0, -0.006}, 0, true});
      if (!(glm::length(force) <= 3.3 * (1 + 1e-9))) below = true;
    }
  });
  std::vector<ServoSample> taken(500);
  std::uint64_t next = 0;
  bool in_order = true;
  std::vector<std::weak_ptr<HapticScene>> given;
  for (int i = 0; i < 200; ++i) {
    const double depth = -0.0001 * (i % 80);
    const test::Relief relief(32, 0.01, [&](double, double) { return depth; });
    auto scene = relief.scene();
    scene->snapping.enabled = i % 2 == 0;
    scene->strokes.push_back({{{-0.04, 0, depth}, {0.04, 0, depth}}});
    given.push_back(scene);
    servo.set_scene(std::move(scene));
    const ServoSample& newest = servo.latest();
    EXPECT_GE(newest.proxy_m.z, -0.0081);
    for (std::size_t n = servo.take_samples(taken); n > 0; n = servo.take_samples(taken))
      for (std::size_t k = 0; k < n; ++k) {
        in_order = in_order && taken[k].tick >= next;
        next = taken[k].tick + 1;
      }
    std::this_thread::yield();
  }
  // Once the servo uses the last scene, passing the next one frees all earlier ones.
  const std::uint64_t ticks = servo.timing().ticks;
  while (servo.timing().ticks < ticks + 3) std::this_thread::yield();
  servo.set_scene(nullptr);
  for (std::size_t i = 0; i + 1 < given.size(); ++i) EXPECT_TRUE(given[i].expired()) << i;
  stop = true;
  device.join();
  EXPECT_FALSE(below);
  EXPECT_TRUE(in_order);
}

TEST(Servo, ARecordingThatWasTakenAwayIsNotTouchedAnyMore) {
  Servo servo{DeviceDescription{}};
  std::atomic<bool> runs{true};
  std::thread ticks([&] {
    for (double time_s = 0.001; runs.load(std::memory_order_relaxed); time_s += 0.001)
      (void)servo.tick({time_s, {0, 0, 0.01}, 0, true});
  });
  const auto ring = std::make_unique<SampleRing>();
  // Rounds without a tick of the servo prove nothing; on a busy machine most are of this kind.
  int recorded = 0;
  for (int i = 0; recorded == 0 || (recorded < 5'000 && i < 200'000); ++i) {
    servo.set_recording(ring.get());
    for (int k = 0; k < i % 50; ++k) std::atomic_signal_fence(std::memory_order_seq_cst);
    servo.set_recording(nullptr);
    const std::uint64_t pushed = ring->pushed.load();
    recorded += pushed > 0 ? 1 : 0;
    for (int k = 0; k < 20; ++k) std::atomic_signal_fence(std::memory_order_seq_cst);
    EXPECT_EQ(ring->pushed.load(), pushed) << "in round " << i;
    if (HasFailure()) break;
    ring->pushed = 0;
    ring->taken = 0;
  }
  runs = false;
  ticks.join();
}

}  // namespace
}  // namespace nazori::haptics
