// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <memory>
#include <vector>

#include "nazori/haptics/force_limiter.h"
#include "nazori/haptics/latest_value.h"
#include "nazori/haptics/sample_ring.h"
#include "nazori/haptics/servo.h"
#include "nazori/haptics/soft_contact.h"
#include "servo_scene.h"

namespace nazori::haptics {

/// Timing values that one thread writes and any thread reads.
struct ServoStopwatch {
  std::atomic<std::uint64_t> ticks{0};
  std::atomic<std::uint64_t> late_ticks{0};
  std::atomic<std::uint64_t> missed_ticks{0};
  std::atomic<std::uint64_t> dropped_samples{0};
  std::atomic<double> inside_s{0};
  std::atomic<double> max_tick_s{0};
  std::atomic<double> max_lateness_s{0};
};

struct Servo::Inside {
  explicit Inside(const DeviceDescription& description);

  Vec3 step(const DeviceSample& sample) noexcept;
  void record() noexcept;
  void adopt_scene() noexcept;
  void fault(const DeviceSample& sample) noexcept;
  void absent(const DeviceSample& sample) noexcept;
  void place_proxy(const Vec3& device_m) noexcept;
  Vec3 contact_force(const Vec3& device_m) noexcept;
  [[nodiscard]] bool touching() const noexcept { return contact.touching() || soft.touching(); }
  void lose_hold(bool lifted) noexcept;
  Vec3 hold(const Vec3& device_m, double period) noexcept;
  void report_guidance() noexcept;

  const DeviceDescription device;
  const double period_s;

  // Passes scenes to the servo. The servo only ever moves on to a later generation, so it cannot use a scene
  // older than the one it reports.
  std::vector<std::unique_ptr<const ServoScene>> kept;  // interface thread
  std::uint64_t generations = 0;                        // interface thread
  std::atomic<const ServoScene*> offered{nullptr};
  std::atomic<std::uint64_t> used{0};

  // Passes the recording ring to the servo. The servo announces which ring it uses while it pushes, so that
  // the interface thread knows when a ring is no longer in use.
  std::atomic<SampleRing*> recording{nullptr};
  std::atomic<SampleRing*> pushing{nullptr};

  // Servo thread.
  const ServoScene* scene = nullptr;
  SurfaceContact contact;
  SoftContact soft;
  StrokeConstraint snap;
  Guidance guidance;
  ForceLimiter limiter;
  Passivity passivity;
  ServoSample sample;
  Vec3 velocity{0, 0, 0};
  double stored_j = 0;  // energy in the springs in this tick
  double last_time_s = 0;
  bool started = false;  // last_time_s and sample.device_m are from a valid tick
  bool pushed_through = false;

  ServoStopwatch watch;
  LatestValue<ServoSample> newest{ServoSample{}};
  boost::lockfree::spsc_queue<ServoSample, boost::lockfree::capacity<8192>> samples;
};

}  // namespace nazori::haptics
