// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/rt_thread.h"

#include <atomic>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <system_error>
#include <thread>
#include <utility>

#include "force_guard.h"
#include "real_time.h"

namespace nazori::devices {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::int64_t now_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * kSecond_ns + t.tv_nsec;
}

void sleep_until(std::int64_t due_ns) noexcept {
  const timespec t{static_cast<time_t>(due_ns / kSecond_ns), static_cast<long>(due_ns % kSecond_ns)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

}  // namespace

struct RtThread::Inside {
  void run() noexcept;

  std::thread thread;
  Tick tick;
  std::int64_t period_ns = 0;
  bool real_time = false;
  std::atomic<bool> stopping{false}, stack_locked{false};
  std::atomic<std::uint64_t> ticks{0}, missed{0};
  std::atomic<std::int64_t> max_lateness_ns{0};
};

void RtThread::Inside::run() noexcept {
  const ReadyStack stack;
  stack_locked.store(stack.is_locked(), std::memory_order_relaxed);
  const std::int64_t start_ns = now_ns();
  std::int64_t due_ns = start_ns;
  while (!stopping.load(std::memory_order_acquire)) {
    const std::int64_t now = now_ns();
    const std::int64_t late = now - due_ns;
    if (late > max_lateness_ns.load(std::memory_order_relaxed))
      max_lateness_ns.store(late, std::memory_order_relaxed);
    tick(static_cast<double>(now - start_ns) * 1e-9);
    ticks.fetch_add(1, std::memory_order_relaxed);
    due_ns += period_ns;
    const std::int64_t behind = now_ns() - due_ns;
    if (behind >= period_ns) {
      const std::int64_t whole = behind / period_ns;
      due_ns += whole * period_ns;
      missed.fetch_add(static_cast<std::uint64_t>(whole), std::memory_order_relaxed);
    }
    sleep_until(due_ns);
  }
}

RtThread::RtThread() : inside_(std::make_unique<Inside>()) {}
RtThread::~RtThread() { stop(); }

base::Result<void> RtThread::start(double period_s, Tick tick) {
  if (!(period_s >= 1e-5 && period_s <= 1))
    return base::fail(base::Errc::bad_argument, "must be between 10 us and 1 s", "period_s");
  Inside& in = *inside_;
  if (in.thread.joinable()) return base::fail(base::Errc::device, "the clock thread is already running");
  in.tick = std::move(tick);
  in.period_ns = std::llround(period_s * 1e9);
  in.stopping = false;
  in.ticks = in.missed = 0;
  in.max_lateness_ns = 0;
  in.stack_locked = false;
  keep_memory();
  try {
    const SignalsBlocked inherited;
    in.thread = std::thread([&in] { in.run(); });
  } catch (const std::system_error& e) {
    return base::fail(base::Errc::device, std::string("the servo thread cannot be started: ") + e.what());
  }
  in.real_time = make_real_time(in.thread.native_handle(), kServoPriority);
  return {};
}

void RtThread::stop() noexcept {
  if (!inside_->thread.joinable()) return;
  inside_->stopping.store(true, std::memory_order_release);
  inside_->thread.join();
}

ClockStatus RtThread::status() const {
  const Inside& in = *inside_;
  ClockStatus s;
  s.running = in.thread.joinable();
  s.real_time = s.running && in.real_time;
  s.stack_locked = s.running && in.stack_locked.load(std::memory_order_relaxed);
  if (s.running && !in.real_time)
    s.message = "The servo runs without real-time priority because of the system's rtprio limit.";
  s.ticks = in.ticks.load(std::memory_order_relaxed);
  s.missed = in.missed.load(std::memory_order_relaxed);
  s.max_lateness_s = static_cast<double>(in.max_lateness_ns.load(std::memory_order_relaxed)) * 1e-9;
  return s;
}

}  // namespace nazori::devices
