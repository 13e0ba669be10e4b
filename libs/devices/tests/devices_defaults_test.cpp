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
#include "pantograph_model.h"

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

TEST(DevicesDefaults, A2diyIsTakenForWhatTheDocumentationSays) {
  // docs/devices.md: a square of 80 mm, 100 mm in front of the motors; 1.5 N, 0.75 N for long, 400 N/m.
  EXPECT_EQ(pantograph::kReach_m, 0.040);
  EXPECT_EQ(pantograph::kMiddle_m, 0.100);
  const DeviceWorkspace reach = pantograph::plane_workspace();
  EXPECT_EQ(reach.low_m, haptics::Vec3(-0.040));
  EXPECT_EQ(reach.high_m, haptics::Vec3(0.040));
  const haptics::DeviceLimits limits = pantograph::plane_limits();
  EXPECT_EQ(limits.max_force_n, 1.5);
  EXPECT_EQ(limits.continuous_force_n, 0.75);
  EXPECT_EQ(limits.max_stiffness_n_m, 400);
  EXPECT_EQ(limits.max_damping_n_s_m, 1);
  EXPECT_EQ(limits.delay_s, 0) << "it is measured";
}

TEST(DevicesDefaults, TheBoardOfA2diyIsSetUpAsItsMakerDoes) {
  // README of HaplyHAPI 1.0.1 on PyPI, and its class Pantograph.
  using pantograph::Turn;
  struct Documented {
    const char* version;
    Turn left_turn;  ///< of the left motor and its encoder
    float right_rest_deg, left_rest_deg, steps;
    double motors_m;
  };
  constexpr std::array kTable{Documented{"3", Turn::anticlockwise, 168, 12, 4880, 0.038},
                              Documented{"2", Turn::clockwise, 241, -61, 10752, 0}};
  ASSERT_EQ(pantograph::kModels.size(), kTable.size());
  for (std::size_t i = 0; i < kTable.size(); ++i) {
    const pantograph::Model& model = pantograph::kModels.at(i);
    const Documented& d = kTable.at(i);
    const pantograph::Joint& right = model.setup.joints[0];
    const pantograph::Joint& left = model.setup.joints[1];
    EXPECT_EQ(model.version, d.version);
    EXPECT_EQ(right.port, 2) << d.version;
    EXPECT_EQ(left.port, 1) << d.version;
    EXPECT_EQ(right.motor, Turn::anticlockwise) << d.version;
    EXPECT_EQ(right.encoder, Turn::anticlockwise) << d.version;
    EXPECT_EQ(left.motor, d.left_turn) << d.version;
    EXPECT_EQ(left.encoder, d.left_turn) << d.version;
    EXPECT_EQ(right.rest_deg, d.right_rest_deg) << d.version;
    EXPECT_EQ(left.rest_deg, d.left_rest_deg) << d.version;
    EXPECT_EQ(right.steps_per_turn, d.steps) << d.version;
    EXPECT_EQ(left.steps_per_turn, d.steps) << d.version;
    EXPECT_FALSE(model.setup.has_button) << d.version;
    EXPECT_EQ(model.linkage.inner_m, 0.07) << d.version;
    EXPECT_EQ(model.linkage.outer_m, 0.09) << d.version;
    EXPECT_EQ(model.linkage.motors_m, d.motors_m) << d.version;
  }
}

}  // namespace
}  // namespace nazori::devices
