// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "nazori/haptics/servo.h"

namespace nazori::haptics {

/// The ring through which a servo passes every sample to a recorder: one thread pushes (the servo), one
/// takes. It contains no pointers, so it can lie in memory that two processes share or that outlives a
/// process: completely pushed samples stay readable when the pushing process is killed. push() does not
/// allocate, wait or call anything. A ring of zeros is an empty ring.
struct SampleRing {
  /// 32 s at 1 kHz, 8 s at 4 kHz: longer than a disk blocks its writer.
  static constexpr std::uint64_t kCapacity = 32768;

  alignas(64) std::atomic<std::uint64_t> pushed{0};  ///< samples so far; written by the servo
  std::atomic<std::uint64_t> lost{0};  ///< samples the ring had no room for; written by the servo
  alignas(64) std::atomic<std::uint64_t> taken{
      0};  ///< samples that are stored elsewhere; written by the reader
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
