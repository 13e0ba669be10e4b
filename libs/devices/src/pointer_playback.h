// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstddef>
#include <limits>

#include "nazori/devices/pointer_device.h"
#include "nazori/haptics/latest_value.h"

namespace nazori::devices {

/// What a pointer did, played at the pace of its events, as the tip of a stylus. Thread rules: move() and
/// restart() by the interface, tick() by the clock thread. Real-time-safe: yes.
class PointerPlayback {
 public:
  static constexpr double kPeriod_s = 0.001;

  /// As PointerDevice::move().
  void move(const PointerState& state) noexcept;
  void move(const PointerState& state, double event_s) noexcept;
  /// Drops what is queued: only the newest state matters. While nothing ticks.
  void restart() noexcept;
  /// The tip one period later. @return all but its time.
  haptics::DeviceSample tick() noexcept;

 private:
  /// A state at its time.
  struct TimedState {
    PointerState state;
    double at_s = 0;
    bool is_restart = false;  ///< playback starts over with it: it applies at once
  };
  PointerState play() noexcept;
  /// Takes the next state out of the queue, which is not empty.
  TimedState taken() noexcept;

  static constexpr std::size_t kQueue = 4096;
  haptics::LatestValue<PointerState> newest_{PointerState{0, 0, 0, false, false}};
  boost::lockfree::spsc_queue<TimedState, boost::lockfree::capacity<kQueue>> events_;
  std::atomic<double> last_event_s_{0};  // of the newest in the queue
  std::atomic<bool> timed_{false};       // whether the newest state has a time
  std::atomic<int> restarts_{0};         // states in the queue from which playback starts over
  std::atomic<bool> is_full_{false};     // the newest state is not in the queue
  double told_s_ = -std::numeric_limits<double>::infinity();  // interface: time of the last event
  // Clock thread.
  TimedState played_{PointerState{0, 0, 0, false, false}, 0};
  double clock_s_ = 0;         // of the events
  double step_s_ = kPeriod_s;  // time of the events that passed in this tick
  haptics::Vec3 halfway_{0, 0, PointerDevice::kHover_m}, at_{0, 0, PointerDevice::kHover_m};
  bool present_ = false;
};

}  // namespace nazori::devices
