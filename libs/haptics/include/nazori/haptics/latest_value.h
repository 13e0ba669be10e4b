// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace nazori::haptics {

/// Passes the newest value from one writer thread to one reader thread (triple buffer). The reader may miss
/// values, but never sees an incomplete or an older one. All three slots exist from construction: no call
/// here allocates (beyond what T's assignment does), locks or waits.
template <class T>
class LatestValue {
 public:
  explicit LatestValue(const T& initial) : slots_{initial, initial, initial} {}
  LatestValue(const LatestValue&) = delete;
  LatestValue& operator=(const LatestValue&) = delete;

  /// Slot to fill before publish(). Thread: writer. Wait-free.
  T& back() noexcept { return slots_[back_]; }

  /// Makes back() the newest value; back() is then another slot with an old value. Thread: writer. Wait-free.
  void publish() noexcept {
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }

  /// Newest published value; valid until the next latest(). Thread: reader. Wait-free.
  const T& latest() noexcept {
    if (middle_.load(std::memory_order_relaxed) & kFresh)
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);
  std::array<T, 3> slots_;
  alignas(64) std::atomic<std::uint8_t> middle_{1};  // shared
  alignas(64) std::uint8_t back_ = 0;                // writer only
  alignas(64) std::uint8_t front_ = 2;               // reader only
};

}  // namespace nazori::haptics
