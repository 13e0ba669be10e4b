// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "nazori/haptics/haptic_device.h"
#include "nazori/haptics/haptic_scene.h"

namespace nazori::haptics {

/// Things that happen in a tick; several may at once (bits). From wrong_start on they come from guidance, in
/// every mode of Guiding but off.
enum class ServoEvent : std::uint16_t {
  none = 0,
  touch = 1,             ///< contact with the surface began
  untouch = 2,           ///< contact with the surface ended
  capture = 4,           ///< a stroke took hold; under guidance: it began to be written
  release = 8,           ///< a stroke let go; under guidance: it is no longer being written
  fault = 16,            ///< input not finite or too late: force dropped to zero, the proxy re-seated
  wrong_start = 32,      ///< the stylus came down on another stroke, or not where the stroke goes on
  wrong_direction = 64,  ///< the stylus went back along the stroke; once until it comes forwards again
  stroke_done = 128,     ///< the stroke ServoSample::done_stroke is finished
  lesson_done = 256,     ///< with stroke_done: it was the last
  resisted = 512,        ///< leading or carrying stopped: the learner resists, or lifted or lost the stylus
  resumed = 1024,        ///< the learner comes along again: leading or carrying goes on
};

/// Whether `event` is among `events`.
[[nodiscard]] constexpr bool has(std::uint16_t events, ServoEvent event) noexcept {
  return (events & static_cast<std::uint16_t>(event)) != 0;
}

/// What one tick saw and did.
struct ServoSample {
  std::uint64_t tick = 0;
  double time_s = 0;  ///< of the device
  /// When the tick began, on std::chrono::steady_clock: how old a picture of it is.
  double begun_s = 0;
  Vec3 device_m{0, 0, 0.02};
  Vec3 proxy_m{0, 0, 0.02};  ///< never below the surface (but with popthrough)
  Vec3 force_n{0, 0, 0};
  Vec3 guide_m{0, 0, 0.02};  ///< where guidance wants the tip; where none does, device_m
  double progress_m = 0;     ///< under guidance: furthest arc length of guided_stroke reached, from above
  double off_m = 0;          ///< while a guided stroke is written: distance to its line, from above
  bool touching = false;     ///< the stylus is in contact with the surface
  std::int32_t stroke = 0;   ///< number of the stroke that holds the stylus, or under guidance is being
                             ///< written; 0 none. It may be in the air: touching says so.
  std::int32_t guided_stroke = 0;  ///< under guidance: the stroke to be written, from 1; 0 none or all done
  std::int32_t done_stroke = 0;    ///< with stroke_done: which; else 0
  std::uint32_t buttons = 0;
  std::uint16_t events = 0;  ///< ServoEvent bits
};

/// Stopwatch of the servo, for the status bar.
struct ServoTiming {
  std::uint64_t ticks = 0;
  std::uint64_t late_ticks = 0;       ///< began more than half a period late
  std::uint64_t missed_ticks = 0;     ///< whole periods without a tick
  std::uint64_t dropped_samples = 0;  ///< the sample queue was full
  double mean_tick_s = 0;             ///< time spent inside a tick
  double max_tick_s = 0;
  double max_lateness_s = 0;  ///< of a tick after its due time
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

  /// Before the first tick after a rest: the time since the last tick was no lateness, and nothing is felt of
  /// it. Thread: interface, while nothing ticks.
  void begin_run() noexcept;

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
  [[nodiscard]] std::uint16_t events() const noexcept override;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::haptics
