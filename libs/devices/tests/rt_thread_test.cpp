// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/rt_thread.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <thread>

#include "system_calls.h"

namespace nazori::devices {
namespace {

using std::chrono::milliseconds;

TEST(RtThread, CallsUntilItIsStoppedAndNotAfterwards) {
  RtThread thread;
  std::atomic<int> calls{0};
  ASSERT_TRUE(thread.start(0.001, [&](double) { ++calls; }));
  while (calls < 5) std::this_thread::sleep_for(milliseconds(1));
  thread.stop();
  const int at_stop = calls;
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(calls, at_stop);
  EXPECT_EQ(thread.status().ticks, static_cast<std::uint64_t>(at_stop));
  EXPECT_FALSE(thread.status().running);
}

TEST(RtThread, TimeOnlyGoesForwardAndNoPeriodIsLostUncounted) {
  RtThread thread;
  std::atomic<double> first{-1}, last{-1};
  std::atomic<bool> backwards{false};
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(thread.start(0.001, [&](double now_s) {
    if (first < 0) first = now_s;
    if (now_s < last) backwards = true;
    last = now_s;
  }));
  // Over the turn of a second.
  while (thread.status().ticks < 1100) std::this_thread::sleep_for(milliseconds(1));
  const ClockStatus running = thread.status();
  EXPECT_TRUE(running.running);
  EXPECT_NE(running.real_time, !running.message.empty());
  thread.stop();
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_FALSE(backwards);
  const ClockStatus s = thread.status();
  const double periods = static_cast<double>(s.ticks + s.missed);
  // All periods up to the last tick are counted, and no others.
  EXPECT_GE(periods, (last - s.max_lateness_s) / 0.001);
  EXPECT_LE(periods, elapsed_s / 0.001 + 1);
}

TEST(RtThread, CountsThePeriodsThatASlowTickSwallowed) {
  RtThread thread;
  std::atomic<int> calls{0};
  ASSERT_TRUE(thread.start(0.001, [&](double) {
    if (calls++ == 0) std::this_thread::sleep_for(milliseconds(30));
  }));
  while (calls < 3) std::this_thread::sleep_for(milliseconds(1));
  thread.stop();
  EXPECT_GE(thread.status().missed, 28U);
}

/// The kernel's information about the memory at an address: the flags of /proc/self/smaps, "lo" for locked.
std::string flags_of_memory_at(std::uintptr_t address) {
  std::ifstream maps("/proc/self/smaps");
  std::string line;
  bool inside = false;
  while (std::getline(maps, line)) {
    unsigned long begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2) inside = address >= begin && address < end;
    if (inside && line.rfind("VmFlags:", 0) == 0) return line;
  }
  return {};
}

TEST(RtThread, ItsStackIsThereBeforeTheFirstTickAndStaysInMemory) {
  RtThread thread;
  std::atomic<std::uintptr_t> here{0};
  std::atomic<int> missing{-1};
  constexpr int kPages = 24;  // fewer than are prepared, because of what lies between
  ASSERT_TRUE(thread.start(0.001, [&](double) {
    if (here != 0) return;
    const char local = 0;
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto top = reinterpret_cast<std::uintptr_t>(&local) / page * page;
    std::array<unsigned char, kPages> resident{};
    int absent = 0;
    // Below what the tick uses itself.
    if (mincore(reinterpret_cast<void*>(top - kPages * page), kPages * page, resident.data()) != 0)
      absent = kPages;
    for (const unsigned char one : resident) absent += (one & 1U) == 0 ? 1 : 0;
    missing = absent;
    here = top;
  }));
  while (here == 0) std::this_thread::sleep_for(milliseconds(1));
  EXPECT_EQ(missing, 0) << "pages of the stack that a tick would have to wait for";
  const ClockStatus status = thread.status();
  const std::string flags = flags_of_memory_at(here);
  thread.stop();
  EXPECT_FALSE(thread.status().stack_locked);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_MEMLOCK, &limit), 0);
  if (nazori::test::kSanitized) GTEST_SKIP() << "a sanitizer locks nothing";
  if (limit.rlim_cur < 1024 * 1024 && geteuid() != 0) GTEST_SKIP() << "no memory may be locked here";
  EXPECT_TRUE(status.stack_locked);
  EXPECT_NE(flags.find(" lo"), std::string::npos) << flags;
}

TEST(RtThread, WhereEverythingMayBeLockedTheProgramIsFromTheFirstServoOn) {
  if (nazori::test::kSanitized) GTEST_SKIP() << "a sanitizer locks nothing";
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_MEMLOCK, &limit), 0);
  if (limit.rlim_cur != RLIM_INFINITY && geteuid() != 0) GTEST_SKIP() << "not everything may be locked here";
  const auto heap = std::make_unique<std::array<char, 1 << 20>>();
  const auto locked = [&] {
    return flags_of_memory_at(reinterpret_cast<std::uintptr_t>(heap->data() + 4096)).find(" lo") !=
           std::string::npos;
  };
  RtThread one;
  ASSERT_TRUE(one.start(0.001, [](double) {}));
  if (!locked()) GTEST_SKIP() << "the system does not let this user lock everything";
  one.stop();
  EXPECT_TRUE(locked()) << "a pointer's servo rests often, and locking takes long";
}

TEST(RtThread, RefusesAbsurdPeriodsAndASecondStart) {
  RtThread thread;
  const auto nothing = [](double) {};
  EXPECT_EQ(thread.start(0, nothing).error().code, base::Errc::bad_argument);
  EXPECT_EQ(thread.start(5, nothing).error().code, base::Errc::bad_argument);
  EXPECT_EQ(thread.start(0.99e-5, nothing).error().code, base::Errc::bad_argument);
  EXPECT_EQ(thread.start(1.0001, nothing).error().code, base::Errc::bad_argument);
  EXPECT_EQ(thread.start(std::numeric_limits<double>::quiet_NaN(), nothing).error().code,
            base::Errc::bad_argument);
  EXPECT_FALSE(thread.status().running);
  for (const double end_s : {1e-5, 1.0}) {
    EXPECT_TRUE(thread.start(end_s, nothing)) << end_s;
    thread.stop();
  }
  ASSERT_TRUE(thread.start(0.001, nothing));
  EXPECT_EQ(thread.start(0.001, nothing).error().code, base::Errc::device);
  thread.stop();
  EXPECT_TRUE(thread.start(0.001, nothing));
}

}  // namespace
}  // namespace nazori::devices
