// SPDX-License-Identifier: Apache-2.0
// The board has no watchdog: what it was told last stays on the motors. Each way out of the program in a
// process of its own; the board stays and is asked what torque it has.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>

#include "default_signals.h"
#include "felt_plane.h"
#include "force_guard.h"
#include "nazori/devices/pantograph.h"
#include "standins/pantograph_board.h"

namespace nazori::devices {
namespace {

using standin::PantographBoard;
using test::comes_true;
using test::Vec3;

class CrashingPush final : public haptics::ServoCallback {
 public:
  Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    if (crashes) std::abort();
    return sample.present ? Vec3(0.5, 0.5, 0) : Vec3(0);
  }
  std::atomic<bool> crashes{false};
};

// Exit codes of a process that did not run as expected. A sanitizer ends a crash with 1.
constexpr int kNeverPushed = 17;
constexpr int kWentOn = 18;

/// A program in which a pantograph pushes; then `way_out` ends it. The board starts after the process, so
/// that the fork loses no thread.
class PantographEnd : public testing::Test {
 protected:
  PantographEnd() {
    void* memory =
        mmap(nullptr, sizeof(std::atomic<bool>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    go = new (memory) std::atomic<bool>(false);
  }
  ~PantographEnd() override { munmap(go, sizeof(*go)); }

  void begin(const std::function<void(haptics::HapticDevice&, CrashingPush&)>& way_out) {
    board = std::make_unique<PantographBoard>(false);
    process = fork();
    ASSERT_GE(process, 0);
    if (process == 0) {
      const rlimit no_core{0, 0};
      (void)setrlimit(RLIMIT_CORE, &no_core);
      (void)setpgid(0, 0);  // so that it can be suspended
      alarm(120);
      PantographSettings settings;
      settings.port = board->path();
      settings.delay_s = 0.020;
      OpenRequest request;
      request.calibration.emplace();
      auto back_end = pantograph_back_end(settings);
      // They end with the process, not before it.
      static auto& device = *new DeviceResult<OpenedDevice>;
      if (!comes_true([&] { return bool(device = back_end->open("pantograph:3", request)); }))
        std::_Exit(kNeverPushed);
      static auto& servo = *new CrashingPush;
      if (!device->device->start(servo)) std::_Exit(kNeverPushed);
      way_out(*device->device, servo);
      std::_Exit(kWentOn);
    }
    board->run();
  }
  void expect_pushing() {
    EXPECT_TRUE(comes_true([&] { return board->torque_n_m[0] != 0 && board->torque_n_m[1] != 0; }));
  }
  /// Checked after the board has read everything that was written: none of it may push again.
  void expect_limp() {
    const int idle = board->idle;
    ASSERT_TRUE(comes_true([&] { return board->idle > idle + 1; }));
    EXPECT_EQ(board->torque_n_m[0], 0);
    EXPECT_EQ(board->torque_n_m[1], 0);
  }
  void end() {
    int status = 0;
    EXPECT_EQ(waitpid(process, &status, 0), process);
    EXPECT_FALSE(WIFEXITED(status) &&
                 (WEXITSTATUS(status) == kNeverPushed || WEXITSTATUS(status) == kWentOn));
    expect_limp();
  }
  static void wait(haptics::HapticDevice&, CrashingPush&) { test::wait_for_signals(); }

  const test::DefaultSignals signals;
  std::atomic<bool>* go;  // shared by the process and the test
  std::unique_ptr<PantographBoard> board;
  pid_t process = -1;
};

TEST_F(PantographEnd, ASignalLeavesNoTorque) {
  begin(wait);
  expect_pushing();
  ASSERT_EQ(kill(process, SIGTERM), 0);
  end();
}

TEST_F(PantographEnd, ACrashOfTheServoLeavesNoTorque) {
  begin([&](haptics::HapticDevice&, CrashingPush& servo) {
    (void)comes_true([&] { return go->load(); });
    servo.crashes = true;
    test::wait_for_signals();
  });
  expect_pushing();
  *go = true;
  end();
}

TEST_F(PantographEnd, ACrashOfAnotherThreadLeavesNoTorque) {
  begin([&](haptics::HapticDevice&, CrashingPush&) {
    (void)comes_true([&] { return go->load(); });
    (void)std::raise(SIGSEGV);
  });
  expect_pushing();
  *go = true;
  end();
}

TEST_F(PantographEnd, ExitInMidRunLeavesNoTorque) {
  begin([&](haptics::HapticDevice&, CrashingPush&) {
    (void)comes_true([&] { return go->load(); });
    std::exit(3);  // NOLINT(concurrency-mt-unsafe): that is what is tried
  });
  expect_pushing();
  *go = true;
  end();
}

TEST_F(PantographEnd, SuspendedItHoldsItsForceUntilItGoesOn) {
  begin(wait);
  expect_pushing();
  ASSERT_EQ(kill(process, SIGTSTP), 0);
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, WUNTRACED), process);
  ASSERT_TRUE(WIFSTOPPED(status));
  expect_limp();
  ASSERT_EQ(kill(process, SIGCONT), 0);
  expect_pushing();
  ASSERT_EQ(kill(process, SIGTERM), 0);
  end();
}

TEST_F(PantographEnd, TheThreadThatTellsZeroRunsNoSignalHandlers) {
  begin([&](haptics::HapticDevice&, CrashingPush&) {
    // Every other thread blocks it, so the kernel must deliver it to a thread of the device.
    sigset_t all;
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_BLOCK, &all, nullptr);
    (void)kill(getpid(), SIGTERM);
    *go = true;
    test::wait_for_signals();
  });
  ASSERT_TRUE(comes_true([&] { return go->load(); }));
  const int questions = board->questions;
  EXPECT_TRUE(comes_true([&] { return board->questions > questions + 50; }));
  expect_pushing();
  ASSERT_EQ(kill(process, SIGKILL), 0);
  ASSERT_EQ(waitpid(process, nullptr, 0), process);
}

TEST_F(PantographEnd, CutForcesAreConfirmedOnceTheBoardHasConfirmedZero) {
  begin([&](haptics::HapticDevice&, CrashingPush&) {
    (void)comes_true([&] { return go->load(); });
    if (ForceGuard::are_all_off()) std::_Exit(kNeverPushed);
    ForceGuard::cut_all();
    std::_Exit(comes_true(ForceGuard::are_all_off) ? 8 : kNeverPushed);
  });
  expect_pushing();
  *go = true;
  end();
}

}  // namespace
}  // namespace nazori::devices
