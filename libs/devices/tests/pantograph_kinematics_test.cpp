// SPDX-License-Identifier: Apache-2.0
#include "pantograph_kinematics.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "pantograph_model.h"
#include "pantograph_truth.h"

namespace nazori::devices::pantograph {
namespace {

/// Points of the square that is used, its edge included.
std::vector<Vec2> reach(const Linkage& linkage) {
  constexpr int kSteps = 10;
  std::vector<Vec2> points;
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int j = -kSteps; j <= kSteps; ++j)
      points.emplace_back(linkage.motors_m / 2 + kReach_m * i / kSteps, kMiddle_m + kReach_m * j / kSteps);
  }
  return points;
}

class Pantograph : public testing::TestWithParam<int> {
 protected:
  const Model& model = kModels.at(static_cast<std::size_t>(GetParam()));
  const Linkage& linkage = model.linkage;
};

TEST_P(Pantograph, ComesBackToTheHandleFromItsAngles) {
  for (const Vec2& handle : reach(linkage)) {
    const auto angles = truth::angles_at(linkage, handle);
    ASSERT_TRUE(angles);
    const LinkagePose pose = pose_at(linkage, *angles);
    ASSERT_EQ(pose.kind, PoseKind::regular);
    EXPECT_LT(glm::distance(pose.handle_m, handle), 1e-12);
  }
}

TEST_P(Pantograph, AtRestItsHandleIsInTheMiddleAsFarAsTwoTrianglesSay) {
  const double angle = model.setup.joints[0].rest_deg * truth::kDegree;
  const LinkagePose pose = pose_at(linkage, {model.setup.joints[0].rest_deg, model.setup.joints[1].rest_deg});
  ASSERT_EQ(pose.kind, PoseKind::regular);
  const double aside = linkage.motors_m / 2 - linkage.inner_m * std::cos(angle);
  const double far =
      linkage.inner_m * std::sin(angle) + std::sqrt(linkage.outer_m * linkage.outer_m - aside * aside);
  // The rest angles are floats and exactly symmetric.
  EXPECT_NEAR(pose.handle_m.x, linkage.motors_m / 2, 1e-12);
  EXPECT_NEAR(pose.handle_m.y, far, 1e-12);
  EXPECT_GT(pose.handle_m.y, 0);
}

TEST_P(Pantograph, IsItsOwnMirrorImage) {
  for (const Vec2& handle : reach(linkage)) {
    const PerJoint angles = *truth::angles_at(linkage, handle);
    const LinkagePose pose = pose_at(linkage, angles);
    const LinkagePose image = pose_at(linkage, {180 - angles[1], 180 - angles[0]});
    EXPECT_NEAR(image.handle_m.x, linkage.motors_m - pose.handle_m.x, 1e-12);
    EXPECT_NEAR(image.handle_m.y, pose.handle_m.y, 1e-12);
    EXPECT_NEAR(image.per_first_m.x, pose.per_second_m.x, 1e-12);
    EXPECT_NEAR(image.per_first_m.y, -pose.per_second_m.y, 1e-12);
  }
}

TEST_P(Pantograph, TorquesDoTheWorkOfTheForce) {
  for (const Vec2& handle : reach(linkage)) {
    const LinkagePose pose = pose_at(linkage, *truth::angles_at(linkage, handle));
    for (const Vec2& force : {Vec2(0.7, 0), Vec2(0, -0.9), Vec2(-0.4, 0.3)}) {
      const PerJoint torques = torques_for(pose, force, kMostTorque_n_m);
      const PerJoint worked = truth::torques_for(linkage, handle, force);
      EXPECT_NEAR(torques[0], worked[0], 1e-8);
      EXPECT_NEAR(torques[1], worked[1], 1e-8);
    }
  }
}

TEST_P(Pantograph, NearStretchedArmsTheWorkIsStillRight) {
  // Almost at the end of both arms: a small turn moves the handle little along them.
  const Vec2 handle(linkage.motors_m / 2, 0.15);
  const LinkagePose pose = pose_at(linkage, *truth::angles_at(linkage, handle));
  ASSERT_EQ(pose.kind, PoseKind::regular);
  const PerJoint torques = torques_for(pose, {0.2, 0.1}, kMostTorque_n_m);
  const PerJoint worked = truth::torques_for(linkage, handle, {0.2, 0.1});
  EXPECT_NEAR(torques[0], worked[0], 1e-8);
  EXPECT_NEAR(torques[1], worked[1], 1e-8);
}

TEST_P(Pantograph, EveryDirectionHasThePromisedForceWhereverTheTabletLies) {
  for (const Vec2& handle : reach(linkage)) {
    const LinkagePose pose = pose_at(linkage, *truth::angles_at(linkage, handle));
    const double least = force_in_every_direction_n(pose, kMostTorque_n_m);
    EXPECT_GE(least, kMostForce_n);
    for (int i = 0; i < 36; ++i) {
      const Vec2 force = least * Vec2(std::cos(i * 10 * truth::kDegree), std::sin(i * 10 * truth::kDegree));
      const PerJoint worked = truth::torques_for(linkage, handle, force);
      EXPECT_LE(std::max(std::abs(worked[0]), std::abs(worked[1])), kMostTorque_n_m * (1 + 1e-6));
    }
  }
}

TEST_P(Pantograph, AForceBeyondTheMotorsKeepsItsDirection) {
  const Vec2 handle(linkage.motors_m / 2 + 0.02, 0.09);
  const LinkagePose pose = pose_at(linkage, *truth::angles_at(linkage, handle));
  const PerJoint wanted = truth::torques_for(linkage, handle, {30, -40});
  const PerJoint given = torques_for(pose, {30, -40}, kMostTorque_n_m);
  EXPECT_NEAR(std::max(std::abs(given[0]), std::abs(given[1])), kMostTorque_n_m, 1e-12);
  EXPECT_NEAR(given[0] * wanted[1], given[1] * wanted[0], 1e-7);
  EXPECT_GT(given[0] * wanted[0], 0);
}

TEST_P(Pantograph, ItsFrameIsThatOfTheLearner) {
  // A handle to the learner's right and far from the motors, which is near the learner, is right and low.
  const Vec2 at = to_device_frame(linkage, {linkage.motors_m / 2 - 0.01, kMiddle_m + 0.02});
  EXPECT_NEAR(at.x, 0.01, 1e-12);
  EXPECT_NEAR(at.y, -0.02, 1e-12);
  // A force does the same work in both frames.
  const Vec2 moved = to_device_frame(linkage, {0.003, 0.004}) - to_device_frame(linkage, {0, 0});
  const Vec2 force = to_linkage_frame({0.5, -0.25, 9});
  EXPECT_NEAR(glm::dot(force, Vec2(0.003, 0.004)), glm::dot(Vec2(0.5, -0.25), moved), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(OfEveryVersion, Pantograph, testing::Range(0, static_cast<int>(kModels.size())),
                         [](const auto& one) {
                           return "Version" +
                                  std::string(kModels.at(static_cast<std::size_t>(one.param)).version);
                         });

void expect_zero(const LinkagePose& pose) {
  EXPECT_EQ(pose.handle_m, Vec2(0, 0));
  EXPECT_EQ(torques_for(pose, {1, 1}, 1), (PerJoint{0, 0}));
  EXPECT_EQ(force_in_every_direction_n(pose, 1), 0);
}

TEST(PantographPose, WhereArmsLieOnEachOtherOrInALineOrCannotMeetThereIsNoForce) {
  const Linkage one_axis{0.07, 0.09, 0};
  const auto kind = [&](const Linkage& linkage, const PerJoint& angles) {
    const LinkagePose pose = pose_at(linkage, angles);
    if (pose.kind != PoseKind::regular) expect_zero(pose);
    return pose.kind;
  };
  EXPECT_EQ(kind(one_axis, {90, 90}), PoseKind::singular);  // both elbows at one place
  EXPECT_EQ(kind(one_axis, {91, 89}), PoseKind::singular);
  EXPECT_EQ(kind(one_axis, {150, 30}), PoseKind::regular);
  // Elbows 0.18 m apart, but for a hair: the outer arms are a line.
  EXPECT_EQ(kind({0.07, 0.09, 0.04}, {179, 1}), PoseKind::singular);
  EXPECT_EQ(kind({0.07, 0.09, 0.041}, {180, 0}), PoseKind::apart);
  // Crossed arms meet on the other side.
  EXPECT_EQ(kind({0.07, 0.09, 0.038}, {60, 120}), PoseKind::behind);
}

TEST(PantographPose, AForceTooLargeToMultiplyGivesNoTorqueAtAll) {
  const LinkagePose pose{PoseKind::regular, {0, 0.1}, {2, 0}, {0, 2}};
  constexpr double kLargest = std::numeric_limits<double>::max();
  EXPECT_EQ(torques_for(pose, {kLargest, 0}, 1), (PerJoint{0, 0}));
  EXPECT_EQ(torques_for(pose, {0, -kLargest}, 1), (PerJoint{0, 0}));
  EXPECT_EQ(torques_for(pose, {0.25, -0.5}, 1), (PerJoint{0.5, -1}));
  EXPECT_EQ(torques_for(pose, {0.5, -1}, 1), (PerJoint{0.5, -1})) << "held to the most, in its direction";
}

TEST(PantographPose, NothingIsEverNotANumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const Model& model : kModels) {
    for (const double first : {0.0, 90.0, 180.0, 270.0, -1e9, 1e300, kNan, kInfinite}) {
      for (const double second : {0.0, 90.0, 180.0, -45.0, 1e17, -kInfinite, kNan}) {
        const LinkagePose pose = pose_at(model.linkage, {first, second});
        EXPECT_TRUE(std::isfinite(glm::length(pose.handle_m)));
        for (const double force : {1.0, 1e300, kNan, kInfinite}) {
          const PerJoint torques = torques_for(pose, {force, -force}, kMostTorque_n_m);
          EXPECT_LE(std::abs(torques[0]), kMostTorque_n_m);
          EXPECT_LE(std::abs(torques[1]), kMostTorque_n_m);
        }
        EXPECT_GE(force_in_every_direction_n(pose, 1), 0);
      }
    }
  }
}

}  // namespace
}  // namespace nazori::devices::pantograph
