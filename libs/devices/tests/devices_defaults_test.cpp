// SPDX-License-Identifier: Apache-2.0
// The default values of the structs of this room, as their headers say them.
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "nazori/devices/device_settings.h"
#include "nazori/devices/device_trial.h"
#include "nazori/devices/force_dimension.h"
#include "nazori/devices/inverse_service.h"
#include "nazori/devices/openhaptics.h"
#include "nazori/devices/pantograph.h"
#include "nazori/devices/pointer_device.h"
#include "nazori/devices/rt_thread.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/devices/simulated_hand.h"
#include "nazori/devices/workspace_mapping.h"

namespace nazori::devices {
namespace {

TEST(DevicesDefaults, BackEndsLookWhereTheMakersSay) {
  EXPECT_EQ(OpenHapticsSettings{}.rate_hz, 1000U);
  EXPECT_EQ(ForceDimensionSettings{}.rate_hz, 1000);
  const InverseServiceSettings inverse;
  EXPECT_EQ(inverse.host, "127.0.0.1");
  EXPECT_EQ(inverse.port, 10001);
  EXPECT_EQ(inverse.force_cap_n, 2);
  EXPECT_EQ(inverse.give_up_s, 15);
  EXPECT_FALSE(inverse.force_gate_gain || inverse.delay_s);
  const PantographSettings pantograph;
  EXPECT_EQ(pantograph.give_up_s, 3);
  EXPECT_FALSE(pantograph.has_button || pantograph.delay_s);
  EXPECT_EQ(pantograph.device_folder, "/dev");
  EXPECT_EQ(pantograph.system_folder, "/sys");
}

TEST(DevicesDefaults, ATabletStandsUprightInTheReachOfATouch) {
  const WorkspaceCalibration calibration;
  EXPECT_EQ(calibration.scale, 1);
  EXPECT_EQ(calibration.centre_m, haptics::Vec3(0));
  EXPECT_EQ(calibration.roll_rad, 0);
  EXPECT_EQ(calibration.posture.tilt_rad, std::numbers::pi / 2);
  EXPECT_EQ(calibration.posture.yaw_rad, 0);
  EXPECT_EQ(calibration.posture.hand, WritingHand::right);
  EXPECT_EQ(kRoomAbove_m, 0.020);
  EXPECT_EQ(DeviceSettings{}.max_force_n, 0);
  EXPECT_EQ(DeviceSettings{}.max_stiffness_n_m, 0);
}

TEST(DevicesDefaults, NothingWasCountedOrMeasuredYet) {
  const TrialResult trial;
  EXPECT_EQ(trial.ticks, 0U);
  EXPECT_EQ(trial.absent, 0U);
  EXPECT_EQ(trial.buttons_seen, 0U);
  EXPECT_EQ(trial.rest_noise_m, -1) << "not measured";
  for (const double value : {trial.seconds, trial.rate_hz, trial.max_lateness_s}) EXPECT_EQ(value, 0);
  EXPECT_EQ(TrialResult::kEdges_s, (std::array{5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3}));
  const RealTimeReadiness ready;
  EXPECT_EQ(ready.priority_limit, 0);
  EXPECT_EQ(ready.locked_bytes, 0);
  EXPECT_FALSE(ready.kernel_preempts);
  const ClockStatus clock;
  EXPECT_EQ(clock.ticks, 0U);
  EXPECT_EQ(clock.missed, 0U);
  EXPECT_EQ(clock.max_lateness_s, 0);
  const HandReport report;
  for (const double value : {report.work_on_hand_j, report.p999_tick_s, report.p999_lateness_s})
    EXPECT_EQ(value, 0);
  const FollowedStroke stroke;
  EXPECT_EQ(stroke.stroke, 0);
  EXPECT_EQ(stroke.slips, 0);
  for (const double value :
       {stroke.length_m, stroke.duration_s, stroke.aim_rms_m, stroke.aim_max_m, stroke.tip_rms_m,
        stroke.tip_max_m, stroke.mean_force_n, stroke.peak_force_n, stroke.contact_share,
        stroke.snapped_share, stroke.mean_depth_m, stroke.followed_share})
    EXPECT_EQ(value, 0);
  const PointerState pointer;
  for (const double value : {pointer.x_m, pointer.y_m, pointer.depth_m}) EXPECT_EQ(value, 0);
}

TEST(DevicesDefaults, ASimulatedHandIsCalmAndItsDeviceLight) {
  const SimulatedHardware hardware;
  EXPECT_EQ(hardware.rate_hz, 1000);
  EXPECT_EQ(hardware.mass_kg, 0.05);
  EXPECT_EQ(hardware.coulomb_n, 0);
  EXPECT_EQ(hardware.encoder_m, 0);
  const HandGrip grip;
  EXPECT_EQ(grip.stiffness_n_m, 100);
  EXPECT_EQ(grip.damping_n_s_m, 2);
  EXPECT_EQ(grip.tremor_m, 0);
  EXPECT_EQ(grip.tremor_hz, 9);
  const HandHabits habits;
  EXPECT_EQ(habits.speed_m_s, 0.05);
  EXPECT_EQ(habits.wander_m, 0.0008);
  EXPECT_EQ(habits.press_m, 0.006);
  EXPECT_EQ(habits.hover_m, 0.006);
}

}  // namespace
}  // namespace nazori::devices
