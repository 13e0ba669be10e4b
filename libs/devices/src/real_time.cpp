// SPDX-License-Identifier: Apache-2.0
#include "real_time.h"

#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>

namespace nazori::devices {
namespace {

bool may_lock_everything() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) return true;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> data{};
  if (syscall(SYS_capget, &header, data.data()) != 0) return false;
  return (data[CAP_TO_INDEX(CAP_IPC_LOCK)].effective & CAP_TO_MASK(CAP_IPC_LOCK)) != 0;
}

/// Not inlined, so that the pages lie below everything that the caller keeps on its stack.
[[gnu::noinline]] void touch_stack() noexcept {
  std::array<volatile char, kServoStack> pages;
  constexpr std::size_t kStep = 1024;
  for (std::size_t i = 0; i < pages.size(); i += kStep) pages[i] = 0;
}

}  // namespace

bool make_real_time(pthread_t thread, int priority) noexcept {
  const sched_param wanted{priority};
  return pthread_setschedparam(thread, SCHED_FIFO, &wanted) == 0;
}

ReadyStack::ReadyStack() noexcept {
  touch_stack();
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return;
  void* lowest = nullptr;
  std::size_t size = 0;
  const bool is_known = pthread_attr_getstack(&attributes, &lowest, &size) == 0;
  pthread_attr_destroy(&attributes);
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  // The stack grows downwards, so its upper end is the used part.
  const std::size_t part = (kServoStack + page - 1) / page * page;
  if (!is_known || size < part) return;
  char* const begin = static_cast<char*>(lowest) + (size - part);
  if (mlock(begin, part) != 0) return;
  begin_ = begin;
  size_ = part;
}

ReadyStack::~ReadyStack() {
  if (begin_ != nullptr) munlock(begin_, size_);
}

void keep_memory() noexcept {
  // On fault: pages that the program never uses are not loaded.
  static const bool once = may_lock_everything() && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
  (void)once;
}

}  // namespace nazori::devices
