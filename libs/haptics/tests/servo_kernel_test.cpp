// SPDX-License-Identifier: Apache-2.0
// Ticks in a process that the kernel ends at its first system call.
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "nazori/haptics/servo.h"
#include "relief.h"

namespace nazori::haptics {
namespace {

using test::Relief;

/// From here on this process may only end itself.
bool forbid_system_calls() {
  sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
  };
  const sock_fprog program{static_cast<unsigned short>(std::size(rules)), rules};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define NAZORI_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(NAZORI_SANITIZED)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Runs `work` in a child that may make no system call; true when it came to its end.
template <class Work>
bool ends_without_system_call(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    if (!forbid_system_calls()) _exit(2);
    work();
    _exit(0);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(ServoTick, NeverEntersTheKernelEvenWhenScenesChangeFaultsComeAndTheQueueIsFull) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer makes system calls of its own";
  if (!ends_without_system_call([] { (void)std::chrono::steady_clock::now(); }))
    GTEST_SKIP() << "no seccomp here, or the clock of this machine is read by a system call";
  ASSERT_FALSE(ends_without_system_call([] { (void)syscall(SYS_getpid); }));

  const Relief groove(128, 0.01, [](double, double y) { return -0.01 * std::exp(-1e5 * y * y); });
  Servo servo{DeviceDescription{}};
  for (const GuidingMode mode :
       {GuidingMode::off, GuidingMode::lesson, GuidingMode::lead, GuidingMode::disturb}) {
    auto scene = groove.scene();
    scene->material = {0.8, 0.2, 0.4, 0.3, 0.5};
    scene->strokes.push_back({{{-0.04, 0, -0.01}, {0.04, 0, -0.01}}});
    scene->snapping.enabled = mode == GuidingMode::off;
    scene->guiding.mode = mode;
    servo.set_scene(scene);
    EXPECT_TRUE(ends_without_system_call([&] {
      double time_s = 0;
      for (int i = 0; i < 20'000; ++i) {
        time_s += i % 1000 == 999 ? 0.1 : 0.001;
        const double z =
            i % 500 == 499 ? std::numeric_limits<double>::quiet_NaN() : 0.01 * std::sin(0.05 * i);
        (void)servo.tick(
            {time_s, {0.03 * std::sin(0.01 * i), 0.01 * std::sin(0.02 * i), -0.008 + z}, 0, i % 700 != 0});
      }
    }));
  }
}

}  // namespace
}  // namespace nazori::haptics
