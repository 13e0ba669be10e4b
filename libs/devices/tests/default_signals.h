// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <poll.h>
#include <pthread.h>

#include <csignal>
#include <vector>

namespace nazori::devices::test {

/// While this lives no signal is ignored or blocked, whatever the test program inherited: nohup ignores
/// SIGHUP, and a shell ignores SIGINT and SIGQUIT for what it runs in the background.
class DefaultSignals {
 public:
  DefaultSignals() {
    for (int number = 1; number < kSignals; ++number) {
      struct sigaction now {};
      if (::sigaction(number, nullptr, &now) != 0 || (now.sa_flags & SA_SIGINFO) != 0 ||
          now.sa_handler != SIG_IGN)
        continue;
      ignored_.push_back(number);
      (void)std::signal(number, SIG_DFL);
    }
    sigset_t none;
    (void)sigemptyset(&none);
    (void)pthread_sigmask(SIG_SETMASK, &none, &blocked_);
  }
  ~DefaultSignals() {
    (void)pthread_sigmask(SIG_SETMASK, &blocked_, nullptr);
    for (const int number : ignored_) (void)std::signal(number, SIG_IGN);
  }
  DefaultSignals(const DefaultSignals&) = delete;
  DefaultSignals& operator=(const DefaultSignals&) = delete;

 private:
  static constexpr int kSignals = 32;  // real-time signals follow
  std::vector<int> ignored_;
  sigset_t blocked_{};
};

/// Waits until a signal ends the process. The thread sanitizer delays a signal between two system calls until
/// the next one returns, so a single endless wait could miss it.
[[noreturn]] inline void wait_for_signals() {
  for (;;) (void)::poll(nullptr, 0, 10);
}

}  // namespace nazori::devices::test
