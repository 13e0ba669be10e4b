// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <initializer_list>
#include <vector>

/// Runs code in a process that the kernel ends at the first system call that is not allowed.
namespace nazori::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define NAZORI_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(NAZORI_SANITIZED)
inline constexpr bool kSanitized = true;  // a sanitizer makes system calls of its own
#else
inline constexpr bool kSanitized = false;
#endif

/// From here on the calling thread may only end the process, or make one of `allowed`; another call ends the
/// process with SIGSYS. Other threads are not restricted; those that this one starts are.
inline bool forbid_system_calls(std::initializer_list<unsigned> allowed = {}) {
  std::vector<sock_filter> rules{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  const auto allow = [&](unsigned call) {
    rules.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1));
    rules.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  };
  allow(SYS_exit_group);
  for (const unsigned call : allowed) allow(call);
  rules.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  const sock_fprog program{static_cast<unsigned short>(rules.size()), rules.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Runs `work` in a child process; true when it ended normally.
template <class Work>
bool ends_in_a_child(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// The same for `work` without any allowed system call.
template <class Work>
bool ends_without_system_call(Work work) {
  return ends_in_a_child([&] {
    if (!forbid_system_calls()) _exit(2);
    work();
  });
}

/// Whether this test is possible here: seccomp is available, and the clock is read without a system call.
inline bool sees_system_calls() {
  return !kSanitized && ends_without_system_call([] { (void)std::chrono::steady_clock::now(); }) &&
         !ends_without_system_call([] { (void)syscall(SYS_getpid); });
}

}  // namespace nazori::test
