// SPDX-License-Identifier: Apache-2.0
// Against the makers' own libraries, where NAZORI_TEST_LIBHD or NAZORI_TEST_LIBDHD names one; skipped
// otherwise. No force is ever asked for: whoever sits at the device is not warned.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "felt_plane.h"
#include "nazori/devices/force_dimension.h"
#include "nazori/devices/openhaptics.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::Vec3;
using test::comes_true;

/// Counts ticks and gives no force.
class NoForce final : public haptics::ServoCallback {
 public:
  Vec3 tick(const haptics::DeviceSample&) noexcept override {
    ++ticks;
    return Vec3(0);
  }
  std::atomic<int> ticks{0};
};

std::string named_by(const char* variable) {
  const char* path =
      std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nothing here sets the environment
  return path != nullptr ? path : "";
}

/// Searches twice, and runs and stops twice the device that is found.
void run_all_that_is_there(BackEnd& back_end) {
  const BackEndFindings found = back_end.find();
  if (found.problem) {
    // The error must not be about the library or its functions, and the second search must give the same.
    EXPECT_NE(found.problem->trouble, haptics::DeviceTrouble::library_missing)
        << base::to_line(found.problem->error);
    EXPECT_NE(found.problem->trouble, haptics::DeviceTrouble::symbol_missing)
        << base::to_line(found.problem->error);
    const BackEndFindings again = back_end.find();
    ASSERT_TRUE(again.problem);
    EXPECT_EQ(base::to_line(again.problem->error), base::to_line(found.problem->error));
  }
  for (const FoundDevice& device : found.devices) {
    SCOPED_TRACE(device.name);
    auto opened = back_end.open(device.id, {});
    ASSERT_TRUE(opened) << base::to_line(opened.error().error);
    EXPECT_GT(opened->device->describe().limits.max_force_n, 0);
    for (int again = 0; again < 2; ++again) {
      NoForce servo;
      const auto started = opened->device->start(servo);
      ASSERT_TRUE(started) << base::to_line(started.error());
      EXPECT_TRUE(comes_true([&] { return servo.ticks > 500; }));
      const auto status = opened->device->status();
      // Docked, not homed or not calibrated is fine; lost is not.
      EXPECT_NE(status.state, DeviceState::lost) << status.message;
      opened->device->stop();
      const int ticks = servo.ticks;
      EXPECT_EQ(opened->device->status().state, DeviceState::stopped);
      EXPECT_EQ(servo.ticks, ticks);
    }
  }
}

TEST(RealLibrary, OpenHapticsRunsWithoutForceAndStops) {
  OpenHapticsSettings settings;
  settings.library = named_by("NAZORI_TEST_LIBHD");
  if (settings.library.empty()) GTEST_SKIP() << "NAZORI_TEST_LIBHD names no libHD.so";
  run_all_that_is_there(*openhaptics_back_end(settings));
}

TEST(RealLibrary, ForceDimensionRunsWithoutForceAndStops) {
  ForceDimensionSettings settings;
  settings.library = named_by("NAZORI_TEST_LIBDHD");
  if (settings.library.empty()) GTEST_SKIP() << "NAZORI_TEST_LIBDHD names no libdhd.so";
  run_all_that_is_there(*force_dimension_back_end(settings));
}

}  // namespace
}  // namespace nazori::devices
