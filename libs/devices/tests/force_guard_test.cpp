// SPDX-License-Identifier: Apache-2.0
// Every way out of the program, each in a process of its own. What stays of the device is read afterwards
// from memory that the process shared.
#include "force_guard.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <thread>

#include "default_signals.h"
#include "felt_plane.h"
#include "nazori/devices/force_dimension.h"
#include "nazori/devices/openhaptics.h"
#include "standins/dhd_standin.h"
#include "standins/hd_standin.h"
#include "test_paths.h"

namespace nazori::devices {
namespace {

using test::comes_true;
using test::DefaultSignals;
using test::Push;
using test::Vec3;

constexpr int kDone = 7;  // exit code of a process that ran as the test expects

/// Memory that the process and the test share.
struct Shared {
  standin::Remains remains;
  std::atomic<int> signals_seen{0};
  std::atomic<bool> ready{false}, goes_on{false};
};

/// A servo that pushes, and crashes on request.
class CrashingServo final : public haptics::ServoCallback {
 public:
  Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    if (crashes) std::abort();
    return sample.present ? Vec3(0, 0, 1) : Vec3(0);
  }
  std::atomic<bool> crashes{false};
};

struct Running {
  OpenedDevice opened;
  CrashingServo servo;
};

template <class Stage>
Stage* stage_of(const char* file, const std::string& function) {
  void* library = dlopen((std::string(test_paths::kStandins) + "/" + file).c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) return nullptr;
  reinterpret_cast<void (*)()>(dlsym(library, (function + "_reset").c_str()))();
  return reinterpret_cast<Stage* (*)()>(dlsym(library, function.c_str()))();
}

/// Opens the device of that name on its stand-in, which updates `shared`, and lets it push.
void start(Running& running, const std::string& device, Shared& shared) {
  std::unique_ptr<BackEnd> back_end;
  if (device == "openhaptics") {
    auto* const stage = stage_of<standin::HdStage>("libHD.so", "nazori_standin_hd");
    stage->remains = &shared.remains;
    OpenHapticsSettings settings;
    settings.library = std::string(test_paths::kStandins) + "/libHD.so";
    back_end = openhaptics_back_end(settings);
  } else {
    auto* const stage = stage_of<standin::DhdStage>("libdhd.so", "nazori_standin_dhd");
    stage->remains = &shared.remains;
    ForceDimensionSettings settings;
    settings.library = std::string(test_paths::kStandins) + "/libdhd.so";
    back_end = force_dimension_back_end(settings);
  }
  running.opened = std::move(*back_end->open(device, {}));
  if (!running.opened.device->start(running.servo)) std::_Exit(1);
  if (!comes_true([&] { return shared.remains.force_n > 0.9 && shared.remains.output; })) std::_Exit(1);
  shared.ready = true;
}

class EveryWayOut : public testing::TestWithParam<std::string> {
 protected:
  EveryWayOut() {
    void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    shared = new (memory) Shared;
  }
  ~EveryWayOut() override { munmap(shared, sizeof(Shared)); }

  /// A process in which the device pushes; then `way_out` ends it.
  void begin(const std::function<void(Running&)>& way_out) {
    shared->ready = false;
    process = fork();
    ASSERT_GE(process, 0);
    if (process != 0) return;
    const rlimit no_core{0, 0};
    (void)setrlimit(RLIMIT_CORE, &no_core);
    (void)setpgid(0, 0);  // so that it can be suspended
    alarm(120);
    auto* running = new Running;  // it ends with the process
    start(*running, GetParam(), *shared);
    way_out(*running);
    std::_Exit(kDone);
  }
  void expect_pushing() const {
    EXPECT_TRUE(
        comes_true([&] { return shared->ready && shared->remains.force_n > 0.9 && shared->remains.output; }));
  }
  /// @return the status of waitpid.
  int end() const {
    int status = 0;
    EXPECT_EQ(waitpid(process, &status, 0), process);
    return status;
  }
  void expect_no_force() const {
    EXPECT_EQ(shared->remains.force_n, 0);
    EXPECT_FALSE(shared->remains.output);
    EXPECT_GT(shared->remains.writes, 0U);
  }
  static void wait(Running&) { test::wait_for_signals(); }

  const DefaultSignals signals;
  Shared* shared;
  pid_t process = -1;
};

TEST_P(EveryWayOut, ASignalThatEndsTheProgramLeavesNoForce) {
  for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGUSR1, SIGXCPU}) {
    begin(wait);
    expect_pushing();
    ASSERT_EQ(kill(process, number), 0);
    const int status = end();
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == number) << number;
    expect_no_force();
  }
}

TEST_P(EveryWayOut, ACrashOfAnotherThreadLeavesNoForce) {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
    begin([&](Running&) { (void)std::raise(number); });
    const int status = end();
    EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == kDone) << number;
    expect_no_force();
  }
}

TEST_P(EveryWayOut, ATrueBadAccessLeavesNoForce) {
  begin([](Running&) {
    volatile int* volatile nothing = nullptr;
    *nothing = 1;
  });
  const int status = end();
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == kDone);
  expect_no_force();
}

TEST_P(EveryWayOut, AnExceptionThatNobodyCatchesLeavesNoForce) {
  begin([](Running&) { std::thread([] { throw std::runtime_error("meant by the test"); }).join(); });
  const int status = end();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
  expect_no_force();
}

TEST_P(EveryWayOut, ACrashOfTheServoItselfLeavesNoForce) {
  begin([](Running& running) {
    running.servo.crashes = true;
    test::wait_for_signals();
  });
  const int status = end();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
  expect_no_force();
}

TEST_P(EveryWayOut, ExitInMidRunLeavesNoForce) {
  begin([](Running&) { std::exit(3); });  // NOLINT(concurrency-mt-unsafe): that is what is tried
  int status = end();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 3);
  expect_no_force();
  begin([](Running&) { std::quick_exit(4); });
  status = end();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 4);
  expect_no_force();
}

TEST_P(EveryWayOut, StoppedItLeavesNoForceAndTheSignalsAsTheyWere) {
  begin([&](Running& running) {
    struct sigaction during {};
    (void)sigaction(SIGTERM, nullptr, &during);
    running.opened.device->stop();
    struct sigaction after {};
    (void)sigaction(SIGTERM, nullptr, &after);
    const bool as_meant = (during.sa_flags & SA_SIGINFO) != 0 && after.sa_handler == SIG_DFL;
    std::_Exit(as_meant ? kDone : 1);
  });
  const int status = end();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == kDone);
  expect_no_force();
}

Shared* of_the_handler = nullptr;

TEST_P(EveryWayOut, AHandlerOfTheProgramRunsAfterTheForceIsOff) {
  of_the_handler = shared;
  struct sigaction mine {};
  mine.sa_handler = [](int) {
    if (of_the_handler->remains.force_n == 0 && !of_the_handler->remains.output)
      ++of_the_handler->signals_seen;
  };
  mine.sa_flags = static_cast<int>(SA_RESETHAND);
  struct sigaction before {};
  ASSERT_EQ(sigaction(SIGINT, &mine, &before), 0);
  begin([&](Running&) {
    shared->goes_on = comes_true([&] { return shared->signals_seen == 1; });
    test::wait_for_signals();
  });
  ASSERT_EQ(sigaction(SIGINT, &before, nullptr), 0);
  expect_pushing();
  ASSERT_EQ(kill(process, SIGINT), 0);
  EXPECT_TRUE(comes_true([&] { return shared->goes_on.load(); }));
  expect_no_force();
  // The handler was installed for one run: the second signal ends the program.
  ASSERT_EQ(kill(process, SIGINT), 0);
  const int status = end();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
}

TEST_P(EveryWayOut, ASignalThatIsIgnoredStaysIgnored) {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  begin(wait);
  (void)std::signal(SIGHUP, before);
  expect_pushing();
  ASSERT_EQ(kill(process, SIGHUP), 0);
  const std::uint64_t writes = shared->remains.writes;
  EXPECT_TRUE(comes_true([&] { return shared->remains.writes > writes + 20; }));
  EXPECT_GT(shared->remains.force_n, 0.9);
  ASSERT_EQ(kill(process, SIGTERM), 0);
  (void)end();
  expect_no_force();
}

TEST_P(EveryWayOut, SuspendedItHoldsItsForceUntilItGoesOn) {
  begin(wait);
  expect_pushing();
  for (int again = 0; again < 2; ++again) {
    ASSERT_EQ(kill(process, SIGTSTP), 0);
    int status = 0;
    ASSERT_EQ(waitpid(process, &status, WUNTRACED), process);
    ASSERT_TRUE(WIFSTOPPED(status));
    EXPECT_EQ(shared->remains.force_n, 0);
    ASSERT_EQ(kill(process, SIGCONT), 0);
    expect_pushing();
  }
  ASSERT_EQ(kill(process, SIGTERM), 0);
  (void)end();
  expect_no_force();
}

TEST_P(EveryWayOut, AServoThreadRunsNoSignalHandlers) {
  begin([&](Running& running) {
    // Every thread but the servo's blocks it, so the kernel must deliver it there.
    sigset_t all;
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_BLOCK, &all, nullptr);
    (void)kill(getpid(), SIGTERM);
    const std::uint64_t writes = shared->remains.writes;
    const bool pushed_on =
        comes_true([&] { return shared->remains.writes > writes + 20; }) && shared->remains.force_n > 0.9;
    running.opened.device->stop();
    std::_Exit(pushed_on ? kDone : 1);
  });
  const int status = end();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == kDone);
}

TEST_P(EveryWayOut, ExitCutsForcesBeforeALibraryThatWasLoadedLaterTakesItselfApart) {
  // A process in which the other device ran first.
  const std::string other_device = GetParam() == "openhaptics" ? "forcedimension" : "openhaptics";
  process = fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    const rlimit no_core{0, 0};
    (void)setrlimit(RLIMIT_CORE, &no_core);
    Shared other;
    auto* first = new Running;
    start(*first, other_device, other);
    first->opened.device->stop();
    auto* running = new Running;
    start(*running, GetParam(), *shared);
    std::exit(3);  // NOLINT(concurrency-mt-unsafe): that is what is tried
  }
  const int status = end();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 3);
  expect_no_force();
}

INSTANTIATE_TEST_SUITE_P(Of, EveryWayOut, testing::Values("openhaptics", "forcedimension"),
                         [](const auto& one) { return one.param; });

TEST(ForceGuard, WaitsForTheZerosOfAllDevicesButNotForEver) {
  const DefaultSignals signals;
  const pid_t process = fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    ForceGuard silent;
    ForceGuard prompt;
    ForceGuard gone;
    silent.watch(nullptr, nullptr);
    prompt.watch(nullptr, nullptr);
    gone.watch(nullptr, nullptr);
    gone.release();
    prompt.confirm_zero();  // too early: forces are still allowed, so more will follow
    std::atomic<bool> cut{false};
    std::thread ending([&] {
      ForceGuard::cut_all();
      cut = true;
    });
    if (!comes_true([] { return ForceGuard::forces() == Forces::cut; })) std::_Exit(1);
    prompt.confirm_off();
    ending.join();  // `silent` never confirms
    if (!cut) std::_Exit(2);
    silent.confirm_off();
    ForceGuard::cut_all();
    // A device that starts now gets no force either.
    ForceGuard late;
    late.watch(nullptr, nullptr);
    std::_Exit(ForceGuard::forces() == Forces::cut ? kDone : 3);
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), kDone);
}

}  // namespace
}  // namespace nazori::devices
