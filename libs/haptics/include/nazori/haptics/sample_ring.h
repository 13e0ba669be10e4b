// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "nazori/haptics/servo.h"

namespace nazori::haptics {

/// The ring through which a servo hands every sample to whoever records it: one thread pushes (the servo),
/// one takes. It holds no pointers, so it can lie in memory that two processes share or that outlives one:
/// what was pushed whole stays readable when the pushing process is killed. push() allocates nothing, waits
/// for nobody and calls nothing. A ring of zeros is an empty ring.
struct SampleRing {
  /// 32 s at 1 kHz, 8 s at 4 kHz: longer than a disk makes its writer wait.
  static constexpr std::uint64_t kCapacity = 32768;

  alignas(64) std::atomic<std::uint64_t> pushed{0};  ///< samples so far; written by the servo
  std::atomic<std::uint64_t> lost{0};  ///< samples the ring had no room for; written by the servo
  alignas(64) std::atomic<std::uint64_t> taken{0};  ///< samples that are safe elsewhere; written by the taker
  alignas(64) std::array<ServoSample, kCapacity> slots;

  /// Adds a sample, or counts it as lost where the ring is full. Thread: servo. Wait-free.
  void push(const ServoSample& sample) noexcept {
    constexpr auto kRelaxed = std::memory_order_relaxed;
    const std::uint64_t n = pushed.load(kRelaxed);
    if (n - taken.load(std::memory_order_acquire) >= kCapacity) {
      lost.store(lost.load(kRelaxed) + 1, kRelaxed);
      return;
    }
    slots[n % kCapacity] = sample;
    pushed.store(n + 1, std::memory_order_release);
  }
};
static_assert(std::is_trivially_copyable_v<ServoSample>);
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

}  // namespace nazori::haptics
