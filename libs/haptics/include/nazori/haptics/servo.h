// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "nazori/haptics/haptic_device.h"
#include "nazori/haptics/haptic_scene.h"

namespace nazori::haptics {

/// Things that happen in a tick; several may at once (bits).
enum class ServoEvent : std::uint8_t {
  none = 0,
  touch = 1,    ///< contact began
  untouch = 2,  ///< contact ended
  capture = 4,  ///< a stroke took hold
  release = 8,  ///< a stroke let go
  fault = 16,   ///< input not finite or too late: force dropped to zero, the proxy re-seated
};

/// What one tick saw and did.
struct ServoSample {
  std::uint64_t tick = 0;
  double time_s = 0;
  Vec3 device_m{0, 0, 0.02};
  Vec3 proxy_m{0, 0, 0.02};  ///< never below the surface (but with popthrough)
  Vec3 force_n{0, 0, 0};
  bool touching = false;    ///< the proxy is on the surface, or a stroke holds it
  std::int32_t stroke = 0;  ///< number of the stroke that holds the stylus, 0 none
  std::uint32_t buttons = 0;
  std::uint8_t events = 0;  ///< ServoEvent bits
};

/// Stopwatch of the servo, for the status bar.
struct ServoTiming {
  std::uint64_t ticks = 0;
  std::uint64_t late_ticks = 0;       ///< began more than half a period late
  std::uint64_t missed_ticks = 0;     ///< whole periods without a tick
  std::uint64_t dropped_samples = 0;  ///< the sample queue was full
  double mean_tick_s = 0;             ///< time spent inside a tick
  double max_tick_s = 0;
  double max_lateness_s = 0;
};

struct SampleRing;

/// The haptic loop: takes the device's pose, holds the proxy on the surface and the strokes, and returns the
/// force.
///
/// tick() runs on the device's thread and never allocates, locks, logs, throws or waits. Scenes go in whole
/// and are freed by the thread that hands them over; the newest state and every sample come out without
/// waiting. Losses are counted.
class Servo final : public ServoCallback {
 public:
  explicit Servo(const DeviceDescription& device);
  ~Servo() override;
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  /// Makes `scene` the one that is felt from the next tick on. A proxy that would lie below the new surface
  /// is lifted out. Thread: one (interface). Wait-free for the servo; frees scenes that the servo has left.
  void set_scene(std::shared_ptr<const HapticScene> scene);

  /// Newest sample. Thread: one reader (interface). Wait-free.
  [[nodiscard]] const ServoSample& latest() noexcept;

  /// Takes samples in order, oldest first; returns how many were written to `out`. Thread: one reader.
  /// Wait-free.
  std::size_t take_samples(std::span<ServoSample> out) noexcept;

  [[nodiscard]] ServoTiming timing() const noexcept;

  /// From the next tick on, every sample is also pushed into `ring`; null: none any more. When it returns,
  /// the servo does not touch the ring it had before. Thread: one (interface); waits at most for a push that
  /// is under way. Wait-free for the servo.
  void set_recording(SampleRing* ring) noexcept;

  Vec3 tick(const DeviceSample& sample) noexcept override;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::haptics
