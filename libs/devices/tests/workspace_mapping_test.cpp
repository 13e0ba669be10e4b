// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/workspace_mapping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace nazori::devices {
namespace {

using haptics::Vec3;
constexpr double kPi = std::numbers::pi;

void expect_near(const Vec3& a, const Vec3& b, double within = 1e-12) {
  EXPECT_NEAR(a.x, b.x, within);
  EXPECT_NEAR(a.y, b.y, within);
  EXPECT_NEAR(a.z, b.z, within);
}

WorkspaceMapping mapping(double scale, const Vec3& centre, double tilt, double yaw, WritingHand hand) {
  WorkspaceCalibration c;
  c.scale = scale;
  c.centre_m = centre;
  c.posture = {tilt, yaw, hand};
  return *WorkspaceMapping::create(c);
}

TEST(WorkspaceMapping, AnUprightTabletHasTheAxesOfTheDevice) {
  const WorkspaceMapping m = mapping(1, {0, 0, 0}, kPi / 2, 0, WritingHand::right);
  expect_near(m.to_tablet_m({0.01, 0.02, 0.03}), {0.01, 0.02, 0.03});
  expect_near(m.to_device_n({1, 2, 3}), {1, 2, 3});
}

TEST(WorkspaceMapping, OnAFlatTabletAwayIsUpwardsAndDownIsIntoTheTablet) {
  const WorkspaceMapping m = mapping(0.5, {0, -0.05, 0}, 0, 0, WritingHand::right);
  // 20 mm away from the learner (-z of the device) at the height of the table.
  expect_near(m.to_tablet_m({0, -0.05, -0.020}), {0, 0.010, 0});
  // 10 mm below the table.
  expect_near(m.to_tablet_m({0, -0.06, 0}), {0, 0, -0.005});
  // The plateau pushes up against gravity, with unchanged force.
  expect_near(m.to_device_n({0, 0, 0.8}), {0, 0.8, 0});
}

TEST(WorkspaceMapping, WhoSitsToTheRightHasTheTabletTurnedAndTheLeftHandMirrorsIt) {
  const WorkspaceMapping right = mapping(1, {0, 0, 0}, kPi / 2, kPi / 6, WritingHand::right);
  const WorkspaceMapping left = mapping(1, {0, 0, 0}, kPi / 2, kPi / 6, WritingHand::left);
  // Out of the tablet is towards the learner: half a metre in a metre to the side.
  expect_near(right.to_device_n({0, 0, 1}), {0.5, 0, std::sqrt(0.75)});
  expect_near(left.to_device_n({0, 0, 1}), {-0.5, 0, std::sqrt(0.75)});
  expect_near(left.to_device_n({0, 1, 0}), {0, 1, 0});
}

TEST(WorkspaceMapping, PositionsAndForcesGoThereAndBackAndWorkIsScaledOnce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 500; ++i) {
    WorkspaceCalibration c;
    c.scale = std::exp(any(random));
    c.centre_m = {0.1 * any(random), 0.1 * any(random), 0.1 * any(random)};
    c.posture = {kPi / 4 * (1 + any(random)), kPi * any(random),
                 any(random) > 0 ? WritingHand::right : WritingHand::left};
    c.roll_rad = kPi * any(random);
    const WorkspaceMapping m = *WorkspaceMapping::create(c);
    const Vec3 p(any(random), any(random), any(random)), f(any(random), any(random), any(random));
    expect_near(m.to_device_m(m.to_tablet_m(p)), p);
    expect_near(m.to_tablet_n(m.to_device_n(f)), f);
    EXPECT_NEAR(glm::length(m.to_device_n(f)), glm::length(f), 1e-12);
    const Vec3 step = m.to_tablet_m(p) - m.to_tablet_m(Vec3(0));
    EXPECT_NEAR(glm::dot(f, step), c.scale * glm::dot(m.to_device_n(f), p), 1e-12);
    // Right-handed: nothing is mirrored.
    expect_near(glm::cross(m.to_device_n({1, 0, 0}), m.to_device_n({0, 1, 0})), m.to_device_n({0, 0, 1}));
  }
}

TEST(WorkspaceMapping, ASpringAtTheLimitOnTheTabletIsOneAtTheLimitAtTheStylus) {
  const WorkspaceMapping m = mapping(0.5, {0, 0, 0}, kPi / 2, 0, WritingHand::right);
  haptics::DeviceLimits touch;
  touch.max_stiffness_n_m = 500;
  const haptics::DeviceLimits seen = m.to_tablet(touch);
  const double pushed_m = 0.002;  // at the stylus
  const double force_n = seen.max_stiffness_n_m * -m.to_tablet_m({0, 0, -pushed_m}).z;
  EXPECT_NEAR(m.to_device_n({0, 0, force_n}).z, 500 * pushed_m, 1e-12);
  EXPECT_EQ(seen.max_force_n, touch.max_force_n);
  EXPECT_DOUBLE_EQ(seen.own_damping_n_s_m, touch.own_damping_n_s_m / 0.5);
  EXPECT_DOUBLE_EQ(seen.max_damping_n_s_m, touch.max_damping_n_s_m / 0.5);
  EXPECT_DOUBLE_EQ(seen.hand_damping_n_s_m, touch.hand_damping_n_s_m / 0.5);
  EXPECT_EQ(seen.max_slew_n_s, touch.max_slew_n_s);
  EXPECT_EQ(seen.continuous_force_n, touch.continuous_force_n);
}

TEST(FitWorkspace, TheWholeTabletIsWithinReachInEveryPosture) {
  const DeviceWorkspace omni{{-0.080, -0.110, -0.035}, {0.080, 0.010, 0.035}};
  const geometry::TabletShape shape;
  for (const double tilt : {0.0, 0.3, 0.8, kPi / 2}) {
    for (const double yaw : {-0.5, 0.0, 0.7}) {
      const WorkspaceCalibration fit = fit_workspace(omni, shape, {tilt, yaw, WritingHand::left});
      const WorkspaceMapping m = *WorkspaceMapping::create(fit);
      for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
          for (const double z : {-shape.depth_m, kRoomAbove_m}) {
            const Vec3 corner = m.to_device_m({x * shape.width_m, y * shape.width_m, z});
            EXPECT_GE(corner.x, omni.low_m.x);
            EXPECT_GE(corner.y, omni.low_m.y);
            EXPECT_GE(corner.z, omni.low_m.z);
            EXPECT_LE(corner.x, omni.high_m.x);
            EXPECT_LE(corner.y, omni.high_m.y);
            EXPECT_LE(corner.z, omni.high_m.z);
          }
        }
      }
    }
  }
}

TEST(FitWorkspace, TheTightestDirectionHasAMarginOfATenthAndTheMiddleIsTheMiddle) {
  const DeviceWorkspace room{{-0.10, -0.11, -0.06}, {0.08, 0.03, 0.05}};
  const Vec3 size = room.high_m - room.low_m, middle = 0.5 * (room.low_m + room.high_m);
  const geometry::TabletShape shape;
  for (const double tilt : {0.0, 0.3, 0.8, kPi / 2}) {
    for (const double yaw : {-0.5, 0.0, 0.7}) {
      const WorkspaceCalibration fit = fit_workspace(room, shape, {tilt, yaw, WritingHand::right});
      const WorkspaceMapping m = *WorkspaceMapping::create(fit);
      // By its eight corners.
      Vec3 low(1e9), high(-1e9);
      for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
          for (const double z : {-shape.depth_m, kRoomAbove_m}) {
            const Vec3 corner = m.to_device_m({x * shape.width_m, y * shape.width_m, z});
            low = glm::min(low, corner);
            high = glm::max(high, corner);
          }
        }
      }
      const Vec3 part = (high - low) / size;
      EXPECT_NEAR(std::max({part.x, part.y, part.z}), 1 / 1.1, 1e-9) << tilt << " " << yaw;
      expect_near(0.5 * (low + high), middle, 1e-9);
    }
  }
}

TEST(FitWorkspace, UprightOnATouchTheHeightOf120MillimetresDecides) {
  const WorkspaceCalibration fit = fit_workspace({}, {}, {});
  EXPECT_NEAR(fit.scale, 1.1 * 0.100 / 0.120, 1e-12);
  // Its data sheet: 160 mm wide, 120 mm high, 70 mm deep.
  const DeviceWorkspace touch;
  expect_near(touch.high_m - touch.low_m, {0.160, 0.120, 0.070});
  expect_near(touch.high_m + touch.low_m, {0, 0, 0});
}

TEST(FitWorkspace, AWorkspaceThatIsEmptyOrNotANumberIsReplaced) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const DeviceWorkspace none{{0, 0, 0}, {0, 0, 0}};
  const DeviceWorkspace bad{{nan, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(fit_workspace(none, {}, {}).scale, fit_workspace({}, {}, {}).scale);
  EXPECT_EQ(fit_workspace(bad, {}, {}).scale, fit_workspace({}, {}, {}).scale);
  for (int axis = 0; axis < 3; ++axis) {
    DeviceWorkspace flat{{0, 0, 0}, {0.3, 0.3, 0.3}};
    EXPECT_NE(fit_workspace(flat, {}, {}).scale, fit_workspace({}, {}, {}).scale);
    flat.high_m[axis] = 0;
    EXPECT_EQ(fit_workspace(flat, {}, {}).scale, fit_workspace({}, {}, {}).scale) << axis;
  }
}

TEST(CalibrateFromCorners, FindsThePostureThatTheCornersWereMadeWith) {
  const geometry::TabletShape shape;
  for (const double tilt : {0.0, 0.4, 1.0, kPi / 2}) {
    for (const WritingHand hand : {WritingHand::right, WritingHand::left}) {
      WorkspaceCalibration truth;
      truth.scale = 0.8;
      truth.centre_m = {0.01, -0.05, 0.02};
      truth.posture = {tilt, 0.3, hand};
      truth.roll_rad = tilt == 0 ? 0 : -0.1;
      const WorkspaceMapping made = *WorkspaceMapping::create(truth);
      const double half = shape.width_m / 2;
      const auto found =
          calibrate_from_corners(made.to_device_m({-half, -half, 0}), made.to_device_m({half, -half, 0}),
                                 made.to_device_m({-half, half, 0}), shape, hand);
      ASSERT_TRUE(found) << base::to_line(found.error());
      EXPECT_NEAR(found->scale, 0.8, 1e-9);
      EXPECT_NEAR(found->posture.tilt_rad, tilt, 1e-7);
      EXPECT_NEAR(found->posture.yaw_rad, 0.3, 1e-7);
      const WorkspaceMapping again = *WorkspaceMapping::create(*found);
      expect_near(again.to_tablet_m({0.03, -0.07, 0.01}), made.to_tablet_m({0.03, -0.07, 0.01}), 1e-8);
    }
  }
}

TEST(CalibrateFromCorners, RefusesCornersThatAreNoSquareInOneSentence) {
  const Vec3 o(0, 0, 0);
  struct Case {
    Vec3 right, up;
    const char* words;
  };
  const std::array<Case, 5> cases{{{{0.001, 0, 0}, {0, 0.1, 0}, "20 mm"},
                                   {{0.1, 0, 0}, {0.05, 0.08, 0}, "right angle"},
                                   {{0.1, 0, 0}, {0, 0.04, 0}, "rectangle"},
                                   {{std::nan(""), 0, 0}, {0, 0.1, 0}, "not a number"},
                                   // Bottom right and top left exchanged, on the table: face down.
                                   {{0, 0, -0.1}, {0.1, 0, 0}, "flat"}}};
  for (const Case& c : cases) {
    const auto found = calibrate_from_corners(o, c.right, c.up, {}, WritingHand::right);
    ASSERT_FALSE(found) << c.words;
    EXPECT_NE(base::to_line(found.error()).find(c.words), std::string::npos) << base::to_line(found.error());
  }
}

TEST(CalibrateFromCorners, TakesSquaresThatAreALittleOff) {
  const auto found = [](const Vec3& right, const Vec3& up) {
    return calibrate_from_corners({0, 0, 0}, right, up, {}, WritingHand::right);
  };
  const auto leaning = [](double degrees) {
    const double angle = degrees * kPi / 180;
    return Vec3(0.1 * std::sin(angle), 0.1 * std::cos(angle), 0);
  };
  EXPECT_TRUE(found({0.0201, 0, 0}, {0, 0.0201, 0}));
  EXPECT_FALSE(found({0.0199, 0, 0}, {0, 0.0201, 0}));
  EXPECT_FALSE(found({0.0201, 0, 0}, {0, 0.0199, 0}));
  EXPECT_TRUE(found({0.1, 0, 0}, {0, 0.149, 0}));
  EXPECT_FALSE(found({0.1, 0, 0}, {0, 0.151, 0}));
  EXPECT_TRUE(found({0.149, 0, 0}, {0, 0.1, 0}));
  EXPECT_FALSE(found({0.151, 0, 0}, {0, 0.1, 0}));
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(found({0.1, 0, 0}, leaning(19.9 * side)));
    EXPECT_FALSE(found({0.1, 0, 0}, leaning(20.1 * side)));
    // Both sides are turned by the same amount: an error of 10 degrees turns the tablet by 5.
    EXPECT_NEAR(found({0.1, 0, 0}, leaning(10 * side))->roll_rad, -5 * side * kPi / 180, 1e-9);
  }
  const auto oblong = found({0.1, 0, 0}, {0, 0.12, 0});
  EXPECT_NEAR(oblong->scale, geometry::TabletShape{}.width_m / 0.11, 1e-12);
  expect_near(oblong->centre_m, {0.05, 0.06, 0});
}

TEST(WorkspaceMapping, ACalibrationMayGoUpToItsBounds) {
  const auto is_taken = [](auto change) {
    WorkspaceCalibration c;
    change(c);
    return bool(WorkspaceMapping::create(c));
  };
  const auto takes_scale = [&](double s) { return is_taken([s](auto& c) { c.scale = s; }); };
  EXPECT_TRUE(takes_scale(0.02));
  EXPECT_FALSE(takes_scale(0.0199));
  EXPECT_TRUE(takes_scale(50));
  EXPECT_FALSE(takes_scale(50.1));
  const auto takes_tilt = [&](double t) { return is_taken([t](auto& c) { c.posture.tilt_rad = t; }); };
  EXPECT_TRUE(takes_tilt(-0.199));
  EXPECT_FALSE(takes_tilt(-0.201));
  EXPECT_TRUE(takes_tilt(kPi / 2 + 0.199));
  EXPECT_FALSE(takes_tilt(kPi / 2 + 0.201));
  EXPECT_TRUE(is_taken([](auto& c) { c.centre_m = {0, -1.99, 0}; }));
  EXPECT_FALSE(is_taken([](auto& c) { c.centre_m = {0, -2.01, 0}; }));
  EXPECT_TRUE(is_taken([](auto& c) { c.posture.yaw_rad = c.roll_rad = -100; }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_taken([&](auto& c) { c.centre_m.z = nan; }));
  EXPECT_FALSE(is_taken([&](auto& c) { c.posture.tilt_rad = nan; }));
  EXPECT_FALSE(is_taken([&](auto& c) { c.posture.yaw_rad = nan; }));
  EXPECT_FALSE(is_taken([&](auto& c) { c.roll_rad = nan; }));
}

TEST(WorkspaceMapping, RefusesACalibrationThatCannotBe) {
  WorkspaceCalibration c;
  c.scale = 0;
  EXPECT_FALSE(WorkspaceMapping::create(c));
  c.scale = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(WorkspaceMapping::create(c));
  c = {};
  c.centre_m.y = 5;
  EXPECT_FALSE(WorkspaceMapping::create(c));
  c = {};
  c.posture.tilt_rad = 3;
  const auto refused = WorkspaceMapping::create(c);
  ASSERT_FALSE(refused);
  EXPECT_NE(base::to_line(refused.error()).find("calibrate"), std::string::npos);
}

}  // namespace
}  // namespace nazori::devices
