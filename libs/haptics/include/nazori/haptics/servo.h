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
  touch = 1,         ///< contact with the surface began
  untouch = 2,       ///< contact with the surface ended
  capture = 4,       ///< a stroke captured the stylus; under guidance: the stroke was begun
  release = 8,       ///< a stroke released the stylus; under guidance: it is no longer being written
  fault = 16,        ///< input not finite or too late: the force was set to zero and the proxy placed again
  wrong_start = 32,  ///< the stylus came down on another stroke, or not where the stroke continues
  wrong_direction = 64,  ///< the stylus went back along the stroke; once until it moves forwards again
  stroke_done = 128,     ///< the stroke ServoSample::done_stroke is finished
  lesson_done = 256,     ///< with stroke_done: it was the last
  resisted = 512,  ///< leading or carrying has stopped: the learner resists, or lifted or lost the stylus
  resumed = 1024,  ///< the learner follows again: leading or carrying continues
};

/// Whether `event` is among `events`.
[[nodiscard]] constexpr bool has(std::uint16_t events, ServoEvent event) noexcept {
  return (events & static_cast<std::uint16_t>(event)) != 0;
}

/// The input and the result of one tick.
struct ServoSample {
  std::uint64_t tick = 0;
  double time_s = 0;  ///< of the device
  /// When the tick began, on std::chrono::steady_clock, to tell the age of what is drawn.
  double begun_s = 0;
  Vec3 device_m{0, 0, 0.02};
  Vec3 proxy_m{0, 0, 0.02};  ///< never below the surface (except with popthrough)
  Vec3 force_n{0, 0, 0};
  Vec3 guide_m{0, 0, 0.02};  ///< target of guidance for the tip; without one, device_m
  double progress_m =
      0;             ///< under guidance: furthest arc length of guided_stroke reached, as seen from above
  double off_m = 0;  ///< while a guided stroke is written: distance to its line, as seen from above
  bool touching = false;    ///< the stylus is in contact with the surface
  std::int32_t stroke = 0;  ///< number of the stroke that attracts the stylus, or under guidance is being
                            ///< written; 0 none. The tip may be above the surface: see touching.
  std::int32_t guided_stroke = 0;  ///< under guidance: the stroke to be written, from 1; 0 none or all done
  std::int32_t done_stroke = 0;    ///< with stroke_done: its number; else 0
  std::uint32_t buttons = 0;
  std::uint16_t events = 0;  ///< ServoEvent bits
};

/// Timing of the servo, for the status bar.
struct ServoTiming {
  std::uint64_t ticks = 0;
  std::uint64_t late_ticks = 0;       ///< ticks that began more than half a period late
  std::uint64_t missed_ticks = 0;     ///< whole periods without a tick
  std::uint64_t dropped_samples = 0;  ///< samples lost because the queue was full
  double mean_tick_s = 0;             ///< time spent inside a tick
  double max_tick_s = 0;
  double max_lateness_s = 0;  ///< of a tick after its due time
};

struct SampleRing;

/// The haptic loop: takes the device's pose, keeps the proxy on the surface and the strokes, and returns the
/// force.
///
/// tick() runs on the device's thread and never allocates, locks, logs, throws or waits. Scenes are passed to
/// it as a whole and freed by the thread that passed them. The newest state and every sample can be read
/// without waiting. Losses are counted.
class Servo final : public ServoCallback {
 public:
  explicit Servo(const DeviceDescription& device);
  ~Servo() override;
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  /// Uses `scene` from the next tick on. A proxy that would lie below the new surface is moved onto it.
  /// Thread: one (interface). Wait-free for the servo; frees scenes that the servo no longer uses.
  void set_scene(std::shared_ptr<const HapticScene> scene);

  /// Call before the first tick after a pause: the time since the last tick then does not count as lateness
  /// and has no effect on the force. Thread: interface, while nothing ticks.
  void begin_run() noexcept;

  /// Newest sample. Thread: one reader (interface). Wait-free.
  [[nodiscard]] const ServoSample& latest() noexcept;

  /// Reads samples in order, oldest first; returns how many were written to `out`. Thread: one reader.
  /// Wait-free.
  std::size_t take_samples(std::span<ServoSample> out) noexcept;

  [[nodiscard]] ServoTiming timing() const noexcept;

  /// From the next tick on, every sample is also pushed into `ring`; null: stop recording. After it returns,
  /// the servo does not use the previous ring. Thread: one (interface); waits at most for a push in progress.
  /// Wait-free for the servo.
  void set_recording(SampleRing* ring) noexcept;

  Vec3 tick(const DeviceSample& sample) noexcept override;
  [[nodiscard]] std::uint16_t events() const noexcept override;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::haptics
