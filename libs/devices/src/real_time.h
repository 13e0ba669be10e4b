// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pthread.h>

#include <cstddef>

/// System settings of a servo thread before its first tick.
namespace nazori::devices {

/// Above ordinary threads, below the kernel's own (50) and audio servers.
constexpr int kServoPriority = 40;

/// Bytes of a servo thread's stack that are in memory before its first tick.
constexpr std::size_t kServoStack = std::size_t{128} * 1024;

/// Schedules a thread as SCHED_FIFO. @return false where the system's rtprio limit does not allow it.
bool make_real_time(pthread_t thread, int priority) noexcept;

/// Writes to kServoStack of the calling thread's stack, so that no tick waits for memory, and keeps that part
/// from being paged out while it lives. Thread: the one whose stack it is.
class ReadyStack {
 public:
  ReadyStack() noexcept;
  ~ReadyStack();
  ReadyStack(const ReadyStack&) = delete;
  ReadyStack& operator=(const ReadyStack&) = delete;
  /// False where the system's memlock limit does not allow it.
  [[nodiscard]] bool is_locked() const noexcept { return begin_ != nullptr; }

 private:
  void* begin_ = nullptr;
  std::size_t size_ = 0;
};

/// Keeps the program's memory from being paged out from now on, if the system lets the program lock any
/// amount. A smaller limit would make it run out of memory later, so nothing is locked then. It stays locked:
/// locking and unlocking walk through all pages, and a pointer's servo starts and rests with each character.
/// Any thread.
void keep_memory() noexcept;

}  // namespace nazori::devices
