// SPDX-License-Identifier: Apache-2.0
#include "force_guard.h"

#include <link.h>
#include <poll.h>
#include <pthread.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <mutex>

namespace nazori::devices {
namespace {

// These signals end the program even if they are handled.
constexpr std::array kEnds{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGSEGV,
                           SIGBUS, SIGFPE, SIGILL,  SIGABRT, SIGSYS};
// These signals end the program only if they are not handled.
constexpr std::array kEndsByDefault{SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2,   SIGXCPU,
                                    SIGXFSZ, SIGTRAP, SIGPROF, SIGVTALRM, SIGPOLL};
constexpr std::array kStops{SIGTSTP, SIGTTIN, SIGTTOU};
constexpr std::array kFaults{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP};
constexpr int kMostSignal = 65;

std::array<ForceSlot, 32> slots;

struct Handled {
  bool ours = false;
  struct sigaction before {};
};
std::array<Handled, kMostSignal> handled;
std::mutex changing;  // protects slots and handlers; never locked by a handler
int watched = 0;
unsigned long long libraries_at_exit_watch = 0;

void pass_on(int number, siginfo_t* info, void* context) {
  struct sigaction& before = handled[static_cast<std::size_t>(number)].before;
  if ((before.sa_flags & SA_SIGINFO) == 0) {
    if (before.sa_handler == SIG_IGN) return;
    if (before.sa_handler == SIG_DFL) {
      // Delivered when this handler returns, because the signal is blocked until then.
      (void)std::signal(number, SIG_DFL);
      (void)std::raise(number);
      return;
    }
  }
  const struct sigaction once = before;
  if ((once.sa_flags & static_cast<int>(SA_RESETHAND)) != 0) {
    before.sa_flags = 0;
    before.sa_handler = SIG_DFL;
  }
  if ((once.sa_flags & SA_SIGINFO) != 0)
    once.sa_sigaction(number, info, context);
  else
    once.sa_handler(number);
}

void on_end(int number, siginfo_t* info, void* context) {
  const int error = errno;
  ForceGuard::cut_all();
  errno = error;
  pass_on(number, info, context);
}

void on_stop(int number, siginfo_t*, void*) {
  const int error = errno;
  ForceGuard::hold_and_stop(number);
  errno = error;
}

using Handler = void (*)(int, siginfo_t*, void*);

void handle(int number, Handler handler, bool only_default) {
  struct sigaction before {};
  if (::sigaction(number, nullptr, &before) != 0) return;
  const bool has_info = (before.sa_flags & SA_SIGINFO) != 0;
  if (has_info && before.sa_sigaction == handler) return;
  if (!has_info && before.sa_handler == SIG_IGN) return;
  if (only_default && (has_info || before.sa_handler != SIG_DFL)) return;
  handled[static_cast<std::size_t>(number)] = {true, before};
  struct sigaction ours {};
  ours.sa_sigaction = handler;
  ours.sa_mask = before.sa_mask;
  ours.sa_flags = SA_SIGINFO | SA_ONSTACK | (before.sa_flags & static_cast<int>(SA_RESTART));
  (void)::sigaction(number, &ours, nullptr);
}

void handle_signals() {
  for (const int number : kEnds) handle(number, on_end, false);
  for (const int number : kEndsByDefault) handle(number, on_end, true);
  for (const int number : kStops) handle(number, on_stop, true);
}

void restore_signals() {
  for (std::size_t number = 1; number < handled.size(); ++number) {
    Handled& h = handled[number];
    if (!h.ours) continue;
    h.ours = false;
    struct sigaction now {};
    // A handler that was installed after this one is kept.
    if (::sigaction(static_cast<int>(number), nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) != 0 &&
        (now.sa_sigaction == on_end || now.sa_sigaction == on_stop))
      (void)::sigaction(static_cast<int>(number), &h.before, nullptr);
  }
}

/// How many libraries have been loaded so far.
unsigned long long libraries_loaded() {
  unsigned long long loaded = 0;
  (void)dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* out) {
        *static_cast<unsigned long long*>(out) = info->dlpi_adds;
        return 1;
      },
      &loaded);
  return loaded;
}

/// What is registered last runs first: forces must be cut before a maker's library that was loaded meanwhile
/// runs its exit code.
void watch_exits() {
  const unsigned long long loaded = libraries_loaded();
  if (loaded == libraries_at_exit_watch) return;
  if (libraries_at_exit_watch == 0) (void)std::at_quick_exit(&ForceGuard::cut_all);
  if (std::atexit(&ForceGuard::cut_all) == 0) libraries_at_exit_watch = loaded;
}

std::int64_t now_ms() noexcept {
  timespec t{};
  (void)clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * std::int64_t{1000} + t.tv_nsec / 1'000'000;
}

void forget_zeros() noexcept {
  for (ForceSlot& slot : slots) slot.at_zero.store(false, std::memory_order_relaxed);
}

bool may_push(const ForceSlot& slot) noexcept {
  return slot.in_use.load(std::memory_order_acquire) && !slot.is_off.load(std::memory_order_acquire);
}

void wait_for_zeros() noexcept {
  const auto waits = [](const ForceSlot& slot) {
    return may_push(slot) && !slot.at_zero.load(std::memory_order_acquire);
  };
  const std::int64_t end = now_ms() + ForceGuard::kMostWait_ms;
  while (std::any_of(slots.begin(), slots.end(), waits) && now_ms() < end) (void)::poll(nullptr, 0, 1);
}

}  // namespace

void ForceGuard::watch(Off off, void* device) noexcept {
  release();
  const SignalsBlocked undisturbed;
  const std::lock_guard lock(changing);
  const auto free = std::find_if(slots.begin(), slots.end(), [](const ForceSlot& s) { return !s.in_use; });
  // A 33rd device loses its force like the others, but its confirmation is not waited for.
  if (free == slots.end()) return;
  slot_ = &*free;
  slot_->off = off;
  slot_->device = device;
  slot_->at_zero.store(false, std::memory_order_relaxed);
  slot_->is_off.store(false, std::memory_order_relaxed);
  slot_->in_use.store(true, std::memory_order_release);
  if (watched++ == 0) handle_signals();
  watch_exits();
}

void ForceGuard::release() noexcept {
  if (slot_ == nullptr) return;
  const SignalsBlocked undisturbed;
  const std::lock_guard lock(changing);
  slot_->in_use.store(false, std::memory_order_release);
  slot_ = nullptr;
  if (--watched == 0) restore_signals();
}

void ForceGuard::cut_all() noexcept {
  forget_zeros();
  forces_.store(Forces::cut, std::memory_order_release);
  if (ForceSlot* const own = own_; own != nullptr) {
    own_ = nullptr;  // a second fault here must not re-enter
    if (own->off != nullptr) own->off(own->device);
    own->is_off.store(true,
                      std::memory_order_release);  // this thread does not tick any more: do not wait for it
  }
  wait_for_zeros();
}

bool ForceGuard::are_all_off() noexcept {
  return forces() == Forces::cut && std::none_of(slots.begin(), slots.end(), may_push);
}

void ForceGuard::hold_and_stop(int number) noexcept {
  forget_zeros();
  Forces expected = Forces::allowed;
  (void)forces_.compare_exchange_strong(expected, Forces::held);
  wait_for_zeros();

  struct sigaction ours {};
  (void)::sigaction(number, nullptr, &ours);
  (void)std::signal(number, SIG_DFL);
  sigset_t one;
  sigset_t before;
  (void)sigemptyset(&one);
  (void)sigaddset(&one, number);
  (void)std::raise(number);
  (void)pthread_sigmask(SIG_UNBLOCK, &one, &before);  // the process stops here
  (void)pthread_sigmask(SIG_SETMASK, &before, nullptr);
  (void)::sigaction(number, &ours, nullptr);

  expected = Forces::held;
  (void)forces_.compare_exchange_strong(expected, Forces::allowed);
}

SignalsBlocked::SignalsBlocked() noexcept {
  sigset_t blocked;
  (void)sigfillset(&blocked);
  for (const int number : kFaults) (void)sigdelset(&blocked, number);
  (void)pthread_sigmask(SIG_SETMASK, &blocked, &before_);
}

SignalsBlocked::~SignalsBlocked() { (void)pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace nazori::devices
