// SPDX-License-Identifier: Apache-2.0
#include "stop.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <string_view>
#include <thread>

#include "nazori/base/unfinished_file.h"

namespace nazori::cli {
namespace {

/// Time for work to end by itself.
constexpr timespec kGrace{0, 100'000'000};

std::atomic<int> stop_signal{0};
std::atomic<bool> line_is_unfinished{false};

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

/// Waits for a signal for the remaining time. @return 0 if none came.
int wait_for_signal(const sigset_t& signals, const timespec& patience) {
  for (;;) {
    const int signal = ::sigtimedwait(&signals, nullptr, &patience);
    if (signal > 0) return signal;
    if (errno != EINTR) return 0;
  }
}

void watch() {
  const sigset_t signals = stop_signals();
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0) continue;
  stop_signal = signal;
  (void)wait_for_signal(signals, kGrace);
  const auto lock = base::remove_unfinished_files();
  end_by_stop_signal();
}

}  // namespace

void watch_for_stop() {
  const sigset_t signals = stop_signals();
  // Every thread that is started later inherits this, so that only the watching one gets the signals.
  (void)::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(watch).detach();
}

bool stop_requested() { return stop_signal != 0; }

void end_by_stop_signal() {
  constexpr std::string_view kWipe = "\r\x1b[K";
  if (line_is_unfinished.exchange(false)) (void)!::write(STDERR_FILENO, kWipe.data(), kWipe.size());
  const int signal = stop_signal;
  // An installed handler has cleanup to do, such as taking the force off a device. If the signal is ignored,
  // as under nohup, it would not end the program.
  struct sigaction present {};
  if (::sigaction(signal, nullptr, &present) != 0 || present.sa_handler == SIG_IGN)
    (void)std::signal(signal, SIG_DFL);
  const sigset_t signals = stop_signals();
  (void)::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  (void)std::raise(signal);
  ::_exit(128 + signal);
}

void note_unfinished_line(bool there) { line_is_unfinished = there; }

}  // namespace nazori::cli
