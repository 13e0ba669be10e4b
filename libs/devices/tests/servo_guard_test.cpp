// SPDX-License-Identifier: Apache-2.0
// What every back end does around a tick of the servo, on the servo's thread: no memory is asked for, and the
// kernel is only entered to sleep until the next tick.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "alloc_guard.h"
#include "felt_plane.h"
#include "nazori/devices/force_dimension.h"
#include "nazori/devices/inverse_service.h"
#include "nazori/devices/openhaptics.h"
#include "nazori/devices/pantograph.h"
#include "nazori/devices/pointer_device.h"
#include "nazori/devices/replay_device.h"
#include "nazori/devices/simulated_device.h"
#include "sdl_back_end.h"
#include "standins/inverse_standin.h"
#include "standins/pantograph_board.h"
#include "standins/sdl_standin.h"
#include "system_calls.h"
#include "test_paths.h"

namespace nazori::devices {
namespace {

using haptics::DeviceSample;
using haptics::Vec3;
using test::comes_true;

constexpr int kTicks = 300;
constexpr unsigned kForbidden = SYS_getpid;

/// Pushes, and counts what was allocated on the servo's thread from one tick to the next.
class AllocationCount final : public haptics::ServoCallback {
 public:
  Vec3 tick(const DeviceSample&) noexcept override {
    if (!guard_) guard_.emplace();
    calls = guard_->calls();
    ++ticks;
    return {0.1, 0.2, 0.3};
  }
  std::atomic<long> calls{0};
  std::atomic<int> ticks{0};

 private:
  std::optional<haptics::test::AllocGuard> guard_;  // of the servo's thread
};

/// Pushes; from its first tick on the only system calls allowed to the thread are those that make it sleep.
class KernelGuard final : public haptics::ServoCallback {
 public:
  /// @param breaks  makes a forbidden call, to test the guard.
  explicit KernelGuard(bool breaks) : breaks_(breaks) {}
  Vec3 tick(const DeviceSample&) noexcept override {
    if (ticks == 0 && !nazori::test::forbid_system_calls({SYS_clock_nanosleep, SYS_nanosleep, SYS_futex}))
      _exit(2);
    if (breaks_ && ticks > 10) (void)syscall(kForbidden);
    ++ticks;
    return {0.1, 0.2, 0.3};
  }
  std::atomic<int> ticks{0};

 private:
  const bool breaks_;
};

/// A back end, and what it needs to run.
struct Guarded {
  const char* name;
  std::function<std::unique_ptr<haptics::HapticDevice>()> open;
};

void PrintTo(const Guarded& guarded, std::ostream* out) { *out << guarded.name; }

std::unique_ptr<haptics::HapticDevice> opened(BackEnd& back_end, const char* id) {
  OpenRequest request;
  request.calibration.emplace();
  std::unique_ptr<haptics::HapticDevice> device;
  (void)comes_true([&] {
    auto found = back_end.open(id, request);
    if (found) device = std::move(found->device);
    return device != nullptr;
  });
  return device;
}

/// The path of a stand-in, reset to its state after loading.
std::string reset(const char* file, const char* function) {
  const std::string path = test_paths::kStandins + std::string(file);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  EXPECT_NE(library, nullptr) << dlerror();
  reinterpret_cast<void (*)()>(dlsym(library, function))();
  return path;
}

std::vector<Guarded> all_back_ends() {
  return {
      {"pointer",
       [] {
         auto pointer = std::make_unique<PointerDevice>();
         // Both modes of a pointer: direct, and played at the times of its events.
         pointer->move({0.01, 0.02, 0.004, true, true}, 10.0);
         for (int i = 1; i < 200; ++i) pointer->move({0.01, 0.02, 0.004, true, true}, 10.0 + 0.005 * i);
         return pointer;
       }},
      {"simulated", [] { return std::make_unique<SimulatedDevice>(SimulatedHardware::touch()); }},
      {"replay",
       [] {
         haptics::DeviceDescription description;
         return std::make_unique<ReplayDevice>(std::vector<DeviceSample>(kTicks / 2), description);
       }},
      {"stick",
       [] {
         static const auto port = std::make_shared<standin::StickPort>();
         port->plugged.clear();
         port->plug_in("Stick", standin::kForceStick);
         return opened(*sdl::back_end(port), "sdl");
       }},
      {"openhaptics",
       [] {
         OpenHapticsSettings settings;
         settings.library = reset("/libHD.so", "nazori_standin_hd_reset");
         settings.device_folder = "/nowhere";
         return opened(*openhaptics_back_end(settings), "openhaptics");
       }},
      {"forcedimension",
       [] {
         ForceDimensionSettings settings;
         settings.library = reset("/libdhd.so", "nazori_standin_dhd_reset");
         return opened(*force_dimension_back_end(settings), "forcedimension");
       }},
  };
}

class ServoGuard : public testing::TestWithParam<Guarded> {};

TEST_P(ServoGuard, NothingIsAllocatedFromOneTickToTheNext) {
  const auto device = GetParam().open();
  ASSERT_TRUE(device);
  AllocationCount servo;
  ASSERT_TRUE(device->start(servo));
  EXPECT_TRUE(comes_true([&] { return servo.ticks > kTicks; }));
  EXPECT_EQ(servo.calls, 0);
  device->stop();
}

TEST_P(ServoGuard, TheKernelIsOnlyEnteredToSleep) {
  if (!nazori::test::sees_system_calls()) GTEST_SKIP() << "no seccomp here, or a clock that needs the kernel";
  const auto runs = [](bool breaks) {
    return nazori::test::ends_in_a_child([breaks] {
      const auto device = GetParam().open();
      KernelGuard servo(breaks);
      if (!device || !device->start(servo)) _exit(3);
      if (!comes_true([&] { return servo.ticks > kTicks; })) _exit(4);
      _exit(0);  // a guarded thread cannot end normally
    });
  };
  EXPECT_TRUE(runs(false));
  EXPECT_FALSE(runs(true)) << "the guard sees nothing";
}

INSTANTIATE_TEST_SUITE_P(EveryBackEnd, ServoGuard, testing::ValuesIn(all_back_ends()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(InverseServoGuard, TheServoNeitherAllocatesNorEntersTheKernel) {
  standin::InverseService service;
  InverseServiceSettings settings;
  settings.port = service.port();
  settings.delay_s = 0.020;
  const auto device = opened(*inverse_service_back_end(settings), "inverse3");
  ASSERT_TRUE(device);
  AllocationCount servo;
  ASSERT_TRUE(device->start(servo));
  EXPECT_TRUE(comes_true([&] { return servo.ticks > kTicks && service.last_command_n > 0.1; }));
  EXPECT_EQ(servo.calls, 0);
  device->stop();
}

TEST(PantographServoGuard, TheServoNeitherAllocatesNorEntersTheKernel) {
  standin::PantographBoard board;
  PantographSettings settings;
  settings.port = board.path();
  settings.delay_s = 0.020;
  const auto device = opened(*pantograph_back_end(settings), "pantograph:3");
  ASSERT_TRUE(device);
  AllocationCount servo;
  ASSERT_TRUE(device->start(servo));
  EXPECT_TRUE(comes_true([&] { return servo.ticks > kTicks && board.torque_n_m[0] != 0; }));
  EXPECT_EQ(servo.calls, 0);
  device->stop();
}

}  // namespace
}  // namespace nazori::devices
