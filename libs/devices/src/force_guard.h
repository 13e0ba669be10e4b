// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>

namespace nazori::devices {

/// Whether devices may give force, for all devices of the program together.
enum class Forces : std::uint8_t {
  allowed,
  held,  ///< the program is being suspended; forces return when it continues
  cut,   ///< the program ends; forces never return
};

/// Data that a servo thread and the signal handlers share. Only ForceGuard and its handlers use it.
struct ForceSlot {
  std::atomic<bool> in_use{false};
  std::atomic<bool> at_zero{false};
  std::atomic<bool> is_off{false};
  void (*off)(void* device) noexcept = nullptr;
  void* device = nullptr;
};

/// Takes the force off every device when the program ends, however it ends.
///
/// A running device is watched. On SIGTERM, SIGINT and every other signal that ends the program, on abort()
/// (an uncaught exception, a failed assertion), on a crash and on exit(), forces are cut: each servo thread
/// notices it in its next tick, writes zero, switches its output off and confirms. The thread that ends the
/// program waits for that, at most kMostWait_ms, and then lets the program end as it would have without this.
/// Makers' libraries are therefore called by their own servo thread only, never from a signal handler; the
/// exception is a servo thread that crashes in code of this program, while the library is idle: that thread
/// switches its own device off. After a crash inside a maker's library only the device's own watchdog can
/// stop the force.
///
/// SIGTSTP (Ctrl+Z) suspends the forces in the same way until the program continues.
class ForceGuard {
 public:
  static constexpr int kMostWait_ms = 100;
  /// Writes zero force and switches the output off. Called on the device's servo thread.
  using Off = void (*)(void* device) noexcept;

  ForceGuard() = default;
  ~ForceGuard() { release(); }
  ForceGuard(const ForceGuard&) = delete;
  ForceGuard& operator=(const ForceGuard&) = delete;

  /// Before the first force. The first device that is watched installs the signal handlers; handlers of the
  /// program run after them, and signals that it ignores stay ignored. Thread: interface.
  /// @param off  may be null: then a crash on the servo thread itself leaves the force to the device.
  void watch(Off off, void* device) noexcept;
  /// After zero has been written and the output is off. The signal handlers are removed with the last device.
  /// Thread: interface.
  void release() noexcept;

  /// Real-time-safe.
  [[nodiscard]] static Forces forces() noexcept { return forces_.load(std::memory_order_acquire); }
  /// Confirms that the device was set to zero force while forces are suspended. Real-time-safe.
  void confirm_zero() noexcept {
    if (slot_ != nullptr && forces() == Forces::held) slot_->at_zero.store(true, std::memory_order_release);
  }
  /// Confirms that the device was set to zero force, its output is off, and no force follows. Real-time-safe.
  void confirm_off() noexcept {
    if (slot_ != nullptr) slot_->is_off.store(true, std::memory_order_release);
  }

  /// While this lives, the thread runs code of this program and no maker's library. Thread: servo.
  class OwnCode {
   public:
    explicit OwnCode(const ForceGuard& guard) noexcept : before_(own_) { own_ = guard.slot_; }
    ~OwnCode() { own_ = before_; }
    OwnCode(const OwnCode&) = delete;
    OwnCode& operator=(const OwnCode&) = delete;

   private:
    ForceSlot* before_;
  };

  /// Cuts all forces and waits for the devices, at most kMostWait_ms. Safe in signal handlers; any thread.
  static void cut_all() noexcept;
  /// Whether forces are cut and every watched device has confirmed it. Any thread.
  [[nodiscard]] static bool are_all_off() noexcept;
  /// Suspends all forces, stops the process by signal `number` and allows forces again once it continues.
  /// Safe in signal handlers.
  static void hold_and_stop(int number) noexcept;

 private:
  // Private static members are named as the others are.
  // NOLINTBEGIN(readability-identifier-naming)
  static inline std::atomic<Forces> forces_{Forces::allowed};
  static inline constinit thread_local ForceSlot* own_ = nullptr;
  // NOLINTEND(readability-identifier-naming)
  ForceSlot* slot_ = nullptr;
};

/// Blocks on this thread all signals but those of its own faults, while it lives. A thread that is started
/// meanwhile keeps them blocked: a servo thread must not run signal handlers, because they wait for it.
class SignalsBlocked {
 public:
  SignalsBlocked() noexcept;
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

}  // namespace nazori::devices
